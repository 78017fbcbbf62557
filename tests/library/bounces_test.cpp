// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEMPLATE_LIST_TEST_CASE(
    "a ray straight down the middle of a quarter-turn groove comes back after two bounces", "", Reals) {
  using Real = TestType;
  const Cavity<Real> cavity(pi<Real>() / Real(2));
  for (const double position : {-0.5, 0.5}) {
    const Vec3<Real> e = direction(radians(Real(20)), Real(0));
    const RayPath path = ray_path(cavity, e, Real(position));
    if (path.bounces != 2) continue;  // the far rim sends some rays back up at once
    const Vec3<Real> out = ray_exit_direction(cavity, e, path);
    CHECK(error_in_epsilons(out.y, Digits50(e.y)) < 16);
    CHECK(error_in_epsilons(out.z, Digits50(e.z)) < 16);
  }
  CHECK(ray_path(cavity, direction(Real(0), Real(0)), Real(0.5)).bounces == 2);
}

TEMPLATE_LIST_TEST_CASE("the panel away from the light is met first beyond the shadow of the rim only", "",
                        Reals) {
  using Real = TestType;
  const Cavity<Real> cavity(radians(Real(60)));
  const Vec3<Real> from_right = direction(radians(Real(10)), Real(0));  // from +y
  CHECK(ray_path(cavity, from_right, Real(-0.9)).first_panel == Panel::one);
  CHECK(ray_path(cavity, from_right, Real(0.9)).first_panel == Panel::two);
  const Vec3<Real> low = direction(radians(Real(40)), Real(0));
  CHECK(ray_path(cavity, low, Real(0.9)).first_panel == Panel::one);
}

TEMPLATE_LIST_TEST_CASE("no ray has zero bounces or more than the maximum, hard cases included", "", Reals) {
  using Real = TestType;
  std::vector<Real> apertures{pi<Real>(), radians(Real(0.01)), radians(Real(179.999)), radians(Real(50))};
  for (int k = 1; k <= 12; ++k)
    for (const int ulps : {-2, -1, 0})
      apertures.push_back(pi<Real>() / Real(k) * (Real(1) + Real(ulps) * epsilon<Real>()));
  const Real rim = Real(1) - epsilon<Real>();
  for (const Real& aperture : apertures) {
    if (aperture > pi<Real>()) continue;
    const Cavity<Real> cavity(aperture);
    std::vector<Real> angles{Real(0), epsilon<Real>(), pi<Real>() / Real(4),
                             pi<Real>() / Real(2) - epsilon<Real>()};
    for (int k = 1; k <= 12; ++k) angles.push_back(Real(k) * aperture / Real(4));
    for (const Real& theta : angles)
      for (const Real& phi : {Real(0), pi<Real>() / Real(2), pi<Real>(), Real(1)}) {
        Vec3<Real> e = direction(theta, phi);
        if (!(e.z >= Real(0))) continue;
        for (const Real& y :
             {Real(-1), Real(-rim), Real(-epsilon<Real>()), Real(0), epsilon<Real>(), rim, Real(1)}) {
          const RayPath path = ray_path(cavity, e, y);
          CHECK(path.bounces >= 1);
          CHECK(path.bounces <= cavity.max_bounces());
        }
      }
  }
}

TEMPLATE_LIST_TEST_CASE("light along the horizon and along the groove is answered", "", Reals) {
  using Real = TestType;
  const Cavity<Real> cavity(radians(Real(45)));
  const Vec3<Real> along{Real(1), Real(0), Real(0)};
  // The same as light from straight above.
  const Vec3<Real> above{Real(0), Real(0), Real(1)};
  for (const Real& position : {Real(-0.9), Real(-0.2), Real(0.3), Real(1)}) {
    const RayPath path = ray_path(cavity, along, position);
    CHECK(path.bounces == ray_path(cavity, above, position).bounces);
    CHECK(path.first_panel == ray_path(cavity, above, position).first_panel);
  }
  const Vec3<Real> across{Real(0), Real(1), Real(0)};
  CHECK(ray_path(cavity, across, Real(0.3)).bounces == 1);
  CHECK(ray_path(cavity, across, Real(0.3)).first_panel == Panel::one);
}

TEMPLATE_LIST_TEST_CASE("which panel counts as met first where the geometry leaves it open", "",
                        HardwareReals) {
  using Real = TestType;
  const Cavity<Real> cavity(radians(Real(45)));
  // Light along the groove meets the panel below its place on the opening.
  const Vec3<Real> along{Real(1), Real(0), Real(0)};
  CHECK(ray_path(cavity, along, Real(-0.3)).first_panel == Panel::one);
  CHECK(ray_path(cavity, along, Real(0.3)).first_panel == Panel::two);
  // A ray through the apex counts as meeting panel two.
  CHECK(ray_path(cavity, {Real(0), Real(0), Real(1)}, Real(0)).first_panel == Panel::two);
}

TEST_CASE("stepping over several bounces at once is stepping over each of them, odd numbers included") {
  const Cavity<double> cavity(radians(25.0));
  const Vec3<double> e = direction(0.4, 0.7);
  for (const Panel first : {Panel::one, Panel::two})
    for (const int steps : {0, 1, 2, 3, 4, 5}) {
      auto at_once = unfold(cavity, e, first);
      auto apart = unfold(cavity, e, first);
      at_once.advance(steps);
      for (int i = 0; i < steps; ++i) apart.advance();
      CHECK(at_once.number() == apart.number());
      CHECK(at_once.bounce().panel == apart.bounce().panel);
      CHECK(at_once.bounce().cosine == Approx(apart.bounce().cosine).epsilon(1e-13));
      CHECK(exit_direction(cavity, at_once).y == Approx(exit_direction(cavity, apart).y).epsilon(1e-13));
    }
}

TEST_CASE("the mean number of bounces is that of single rays, in narrow grooves too") {
  for (const double aperture_deg : {9.0, 20.0, 40.0, 130.0})
    for (const double theta : {0.1, 0.5, 1.1}) {
      const Cavity<double> cavity(radians(aperture_deg));
      const Vec3<double> e = direction(theta, 0.6);
      constexpr int rays = 20000;
      double sum = 0;
      for (int i = 0; i < rays; ++i) sum += ray_path(cavity, e, (2 * i + 1.0) / rays - 1).bounces;
      // A step of the number of bounces falls between two rays.
      CHECK(std::abs(sum / rays - mean_bounces(cavity, e)) < 10.0 / rays);
    }
}

TEST_CASE("a recorded direction starts each first panel with all of the light") {
  const Conductor<double> copper(1.1, 2.6);
  for (const double aperture_deg : {15.0, 50.0, 95.0})
    for (const double theta : {0.05, 0.4, 1.3}) {
      const Cavity<double> cavity(radians(aperture_deg));
      const Vec3<double> e = direction(theta, 0.9);
      const RecordedDirection<double> recorded(cavity, e);
      CHECK(recorded.reflectance(copper) ==
            Approx(directional_reflectance(cavity, e, copper)).epsilon(1e-14));
    }
}
