// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vcavity/profiles/rounding.hpp>

#include "profiles/random_profiles.hpp"
#include "support/catch.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// The fraction of light of a direction that touches given stretches of the panels, each from its apex outwards, by rays
/// followed one after the other in real space.
template <class Touches>
double touched_fraction(const Cavity<double>& cavity, const Vec3<double>& e, int rays,
                        const Touches& touches) {
  int touched = 0;
  for (int i = 0; i < rays; ++i) {
    const double position = (2.0 * i + 1) / rays - 1;
    Vec2<double> at{position * cavity.sin_half(), cavity.cos_half()}, travel{-e.y, -e.z};
    bool has_touched = false;
    for (;;) {
      double nearest = 1e300, along = 0;
      const Vec3<double>* hit = nullptr;
      static thread_local Vec3<double> normals[2], tangents[2];
      for (const Panel panel : {Panel::one, Panel::two}) {
        const auto p = static_cast<std::size_t>(panel) - 1;
        normals[p] = cavity.normal(panel);
        tangents[p] = cavity.tangent(panel);
        const double approach = travel.x * normals[p].y + travel.y * normals[p].z;
        if (approach >= 0) continue;
        const double distance = -(at.x * normals[p].y + at.y * normals[p].z) / approach;
        const double outwards =
            (at.x + distance * travel.x) * tangents[p].y + (at.y + distance * travel.y) * tangents[p].z;
        if (outwards > 0 && outwards < 1 && distance < nearest) {
          nearest = distance;
          along = outwards;
          hit = &normals[p];
        }
      }
      if (!hit) break;
      if (touches(along)) has_touched = true;
      at += nearest * travel;
      const double approach = travel.x * hit->y + travel.y * hit->z;
      travel -= 2 * approach * Vec2<double>{hit->y, hit->z};
    }
    if (has_touched) ++touched;
  }
  return static_cast<double>(touched) / rays;
}

}  // namespace

TEST_CASE("for one direction the bounds of rounding are the light that touches what is rounded") {
  Dice dice(31);
  for (int trial = 0; trial < 60; ++trial) {
    const Cavity<double> cavity(radians(dice.between(20, 150)));
    const Vec3<double> e = dice.light(80);
    const double part = dice.between(0.02, 0.4);
    const double radius = part * std::tan(cavity.aperture() / 2);
    const auto bound = rounding_bound(cavity, e, radius);
    constexpr int rays = 4000;
    const double slack = 8.0 / rays;  // a ray at each end of a stretch of light
    CHECK(std::abs(bound.rims - touched_fraction(cavity, e, rays, [&](double s) { return s > 1 - part; })) <
          slack);
    CHECK(std::abs(bound.apex - touched_fraction(cavity, e, rays, [&](double s) { return s < part; })) <
          slack);
  }
}

TEST_CASE("under diffuse light the bounds are the mean of those of the directions, or above it") {
  const Cavity<double> cavity(radians(60.0));
  const double radius = 0.02;
  const auto diffuse = rounding_bound(cavity, radius);
  CHECK(diffuse.apex == Approx(radius / std::tan(radians(30.0))).epsilon(1e-14));
  CHECK(diffuse.rims == Approx(radius * std::cos(radians(30.0)) / 0.25).epsilon(1e-14));
  double rims = 0, apex = 0;
  constexpr int steps = 400;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 20; ++j) {
      const double theta = pi<double>() * ((i + 0.5) / steps - 0.5);
      const double psi = pi<double>() / 2 * (j + 0.5) / 20;
      const Vec3<double> e{std::sin(psi), std::cos(psi) * std::sin(theta), std::cos(psi) * std::cos(theta)};
      const auto bound = rounding_bound(cavity, e, radius);
      const double weight = std::cos(psi) * std::cos(psi) * std::cos(theta) * pi<double>() / steps / 20;
      rims += weight * bound.rims;
      apex += weight * bound.apex;
    }
  CHECK(apex == Approx(diffuse.apex).epsilon(1e-3));
  CHECK(rims <= diffuse.rims);
  CHECK(rims > 0.5 * diffuse.rims);
}

TEST_CASE("nothing rounded changes nothing, and a fillet that is larger than the panels is refused") {
  const Cavity<double> cavity(radians(60.0));
  CHECK(rounding_bound(cavity, 0.0).both() == 0);
  CHECK(rounding_bound(cavity, direction(0.5, 0.3), 0.0).both() == 0);
  CHECK(rounding_bound(cavity, 0.57).both() == 1);
  CHECK_THROWS_AS(rounding_bound(cavity, 0.58), std::invalid_argument);
  CHECK_THROWS_AS(rounding_bound(cavity, -0.01), std::invalid_argument);
  CHECK_THROWS_AS(rounding_bound(cavity, std::nan("")), std::invalid_argument);
}
