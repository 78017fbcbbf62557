// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "support/catch.hpp"
#include "tracer/comparisons.hpp"

// The model speaks of infinitely many, infinitely long grooves; real ones end. What is lost shrinks in
// proportion.

using namespace agreement;
using tracer::Ending;
using tracer::Path;
using tracer::Tracer;

namespace {

constexpr int rays = 1 << 17;
constexpr double aperture = std::numbers::pi / 9;

// Mean of `value(u)` over points u of the unit cube.
template <class Value>
double mean_over_cube(Value value) {
  const ShiftedLattice lattice(7, 0);
  double sum = 0;
  for (int i = 0; i < rays; ++i) sum += value(lattice[i]);
  return sum / rays;
}

// Fraction of the diffuse light that falls all along the middle groove and is lost through its ends.
double lost_through_ends(double length) {
  const Tracer grooves(tracer::groove_array(aperture, 9, length));
  Uniform uniform(1);
  return mean_over_cube([&](const std::array<double, 3>& u) {
    const LightRay ray = diffuse_ray(aperture, u);
    const glm::dvec3 light = towards_light(ray);
    const double along = (uniform() - 0.5) * length;
    const glm::dvec3 start = entrance(ray) + glm::dvec3(along, 0, 0) + 1e-3 * light;
    return grooves.trace(start, -light).ending == Ending::upwards ? 0.0 : 1.0;
  });
}

// Fraction of a beam as wide as the array that passes beside it, and the mean reflectance of silver of all of
// the beam.
struct Beam {
  double missed;
  double reflectance;
};

Beam beam_on_array(int count, const LightRay& direction, double height) {
  const Tracer grooves(tracer::groove_array(aperture, count, 4000));
  const glm::dvec3 light = towards_light(direction);
  const Material silver = tracer::example_materials()[1];
  const double width = grooves.relief().profile.back().x - grooves.relief().profile.front().x;
  Beam beam{0, 0};
  beam.missed = mean_over_cube([&](const std::array<double, 3>& u) {
    const Path path = grooves.trace({0, (u[0] - 0.5) * width, grooves.relief().top() + height}, -light);
    if (path.ending == Ending::upwards) beam.reflectance += tracer::reflectance(path, silver) / rays;
    return path.ending == Ending::missed ? 1.0 : 0.0;
  });
  return beam;
}

}  // namespace

TEST_CASE("light lost through the ends of the grooves is the mean way along them over their length") {
  // Every path that travels a way w along a groove of length L is lost for a fraction w/L of its starting
  // points.
  const Tracer endless(tracer::groove_array(aperture, 9, 1e6));
  const double mean_way = mean_over_cube([&](const std::array<double, 3>& u) {
    return std::abs(trace(endless, diffuse_ray(aperture, u)).top.x);
  });
  for (const double length : {100.0, 200.0, 400.0, 800.0}) {
    INFO("length " << length << ", mean way " << mean_way);
    const double expected = mean_way / length;
    CHECK(std::abs(lost_through_ends(length) - expected) < 5 * std::sqrt(expected / rays));
  }
}

TEST_CASE("light lost beside the array is one over the number of grooves, and so is its bias") {
  const double opening = 2 * std::sin(aperture / 2);
  const LightRay direction{aperture, std::numbers::pi / 3, 0.4, 0};
  // From this height the slanted beam is shifted by just one groove when it arrives.
  const double height = opening / (std::tan(direction.theta) * std::cos(direction.phi));
  const double theory = closed_form_directional(direction, tracer::example_materials()[1]);
  for (const int grooves : {5, 15, 45, 135}) {
    INFO(grooves << " grooves");
    const auto [missed, reflectance] = beam_on_array(grooves, direction, height);
    CHECK(std::abs(missed - 1.0 / grooves) < 1e-4);
    CHECK(std::abs(reflectance / theory - (1 - 1.0 / grooves)) < 1e-4);
  }
}
