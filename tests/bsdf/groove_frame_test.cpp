// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
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

TEMPLATE_TEST_CASE("a groove direction close to the normal, of any length, makes an orthonormal frame too",
                   "", float, double) {
  using Real = TestType;
  using V = glm::vec<3, Real>;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(0, -std::log10(std::numeric_limits<Real>::epsilon()) + 1);
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  Real worst = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const V normal = glm::normalize(V(random_unit_vector(random)));
    const Real angle = static_cast<Real>(std::pow(10, -exponent(random)));
    const Real length = trial % 3 == 0 ? Real(1e30) : trial % 3 == 1 ? Real(1e-30) : Real(1);
    const GrooveFrame<Real> frame(normal, length * (normal + angle * V(random_unit_vector(random))));
    const V x = frame.to_world({1, 0, 0}), y = frame.to_world({0, 1, 0}), z = frame.to_world({0, 0, 1});
    for (const Real& product :
         {glm::dot(x, y), glm::dot(y, z), glm::dot(z, x), Real(glm::dot(x, x) - 1), Real(glm::dot(y, y) - 1)})
      worst = std::max(worst, std::abs(product));
  }
  CAPTURE(worst / epsilon);
  CHECK(worst < 8 * epsilon);
}
