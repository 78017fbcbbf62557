// SPDX-License-Identifier: BSD-3-Clause
#include <glm/geometric.hpp>
#include <random>
#include <vcavity/render/groove_frame.hpp>

#include "support/catch.hpp"

using vcavity::GrooveFrame;
using Vec = glm::dvec3;

namespace {

Vec random_unit_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(Vec(normal(random), normal(random), normal(random)));
}

}  // namespace

TEST_CASE("the frame of a groove is right-handed, with the groove along x and the normal along z") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec normal = random_unit_vector(random);
    const Vec along = 3.0 * random_unit_vector(random);
    const GrooveFrame<double> frame(normal, along);
    const Vec x = frame.to_world({1, 0, 0}), y = frame.to_world({0, 1, 0}), z = frame.to_world({0, 0, 1});
    CHECK(glm::length(glm::cross(x, y) - z) < 1e-12);
    CHECK(glm::length(z - normal) < 1e-12);
    CHECK(std::abs(glm::length(x) - 1) < 1e-12);
    CHECK(glm::dot(y, along) == Approx(0).margin(1e-12));
    CHECK(glm::dot(x, along) > 0);
    const Vec v = random_unit_vector(random);
    CHECK(glm::length(frame.to_world(frame.to_local(v)) - v) < 1e-12);
  }
}

TEST_CASE("without a groove direction in the tangent plane some tangent serves") {
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec normal = trial < 3 ? Vec(trial == 0, trial == 1, trial == 2) : random_unit_vector(random);
    for (const Vec& along : {Vec(0), normal, -2.0 * normal}) {
      const GrooveFrame<double> frame(normal, along);
      const Vec x = frame.to_world({1, 0, 0});
      CHECK(glm::length(x) == Approx(1));
      CHECK(glm::dot(x, normal) == Approx(0).margin(1e-12));
    }
  }
}
