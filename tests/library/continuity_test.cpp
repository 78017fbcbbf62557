// SPDX-License-Identifier: BSD-3-Clause
/// No jumps that physics does not have: kinks, but no steps.

#include <cmath>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// A step small enough for a straight line, large enough to stand out from rounding.
template <class Real>
Real small_step() {
  return std::is_same_v<Real, float> ? Real(1e-4) : Real(1e-7);
}

/// Over `x` a continuous function changes no faster than beside it, on one side or the other.
template <class Real, class Function>
void check_no_step(const Function& f, const Real& x) {
  using std::abs;
  const Real h = small_step<Real>();
  const Real left = f(Real(x - h));
  const Real right = f(Real(x + h));
  const Real beside = abs(left - f(Real(x - 3 * h))) + abs(f(Real(x + 3 * h)) - right);
  CAPTURE(x, left, right, f(x), beside);
  CHECK(abs(right - left) <= 2 * beside + 200 * epsilon<Real>());
  CHECK(abs(f(x) - left) <= 2 * beside + 200 * epsilon<Real>());
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("reflectance has no step where the aperture is a fraction of π", "", HardwareReals) {
  using Real = TestType;
  const Conductor<Real> metal(Real(1.17), Real(2.4));
  for (int k = 2; k <= 9; ++k)
    for (const double theta_deg : {0.0, 13.0, 44.0, 71.0, 88.0})
      for (const double phi_deg : {0.0, 50.0, 90.0}) {
        const Vec3<Real> e = direction(radians(Real(theta_deg)), radians(Real(phi_deg)));
        CAPTURE(k, theta_deg, phi_deg);
        check_no_step(
            [&](const Real& aperture) { return directional_reflectance(Cavity<Real>(aperture), e, metal); },
            pi<Real>() / Real(k));
      }
}

TEMPLATE_LIST_TEST_CASE("reflectance has no step where a lobe appears", "", HardwareReals) {
  using Real = TestType;
  const Conductor<Real> metal(Real(1.17), Real(2.4));
  for (const double aperture_deg : {10.0, 33.0, 45.0, 60.0, 77.0, 120.0, 170.0})
    for (int quarter = 1; quarter <= 8; ++quarter)
      for (const double phi_deg : {0.0, 50.0}) {
        const Cavity<Real> cavity(radians(Real(aperture_deg)));
        const Real theta = Real(quarter) * cavity.aperture() / Real(4);
        if (theta > Real(1.5)) continue;
        CAPTURE(aperture_deg, quarter, phi_deg);
        const auto reflectance = [&](const Real& angle) {
          return directional_reflectance(cavity, direction(angle, radians(Real(phi_deg))), metal);
        };
        check_no_step(reflectance, theta);
        check_no_step(reflectance, Real(pi<Real>() / 2 - theta));
      }
}

TEMPLATE_LIST_TEST_CASE("facets have no step where absorption or contrast vanishes", "", HardwareReals) {
  using Real = TestType;
  using std::abs;
  const Real h = small_step<Real>();
  for (const double cosine : {1.0, 0.8, 0.3}) {
    const Real c = static_cast<Real>(cosine);
    // Where n = 0.9 reflects totally, 1 − R starts like 20 k.
    for (const double n : {0.9, 1.5, 4.0})
      CHECK(abs(Conductor<Real>(Real(n), h)(c) - Dielectric<Real>(Real(n))(c)) < 40 * h);
    CHECK(Dielectric<Real>(Real(1) + h)(c) < 400 * h * h);
    CHECK(Dielectric<Real>(Real(1) - h)(c) < 400 * h * h);
    CHECK(Dielectric<Real>(Real(1) + h)(c) > 0);
  }
}

TEMPLATE_LIST_TEST_CASE("an almost flat groove is almost a plane", "", HardwareReals) {
  using Real = TestType;
  using std::abs;
  const Conductor<Real> metal(Real(1.17), Real(2.4));
  const Real h = small_step<Real>();
  for (const double theta_deg : {0.0, 30.0, 60.0, 85.0}) {
    const Vec3<Real> e = direction(radians(Real(theta_deg)), radians(Real(20)));
    const Real plane = directional_reflectance(Cavity<Real>(pi<Real>()), e, metal);
    CHECK(abs(directional_reflectance(Cavity<Real>(pi<Real>() - h), e, metal) - plane) < 8 * h);
  }
}

TEMPLATE_LIST_TEST_CASE("at grazing incidence the groove has its limit", "", HardwareReals) {
  using Real = TestType;
  using std::abs;
  const Conductor<Real> metal(Real(1.17), Real(2.4));
  const Real h = small_step<Real>();
  for (const double aperture_deg : {20.0, 60.0, 110.0, 160.0})
    for (const Real& side : {Real(-1), Real(1)}) {
      const Cavity<Real> cavity(radians(Real(aperture_deg)));
      const Real limit = directional_reflectance(cavity, Vec3<Real>{Real(0), side, Real(0)}, metal);
      const Real near = directional_reflectance(cavity, Vec3<Real>{Real(0), side, h}, metal);
      CHECK(abs(near - limit) < 20 * h);
      CHECK(abs(limit - metal(cavity.cos_half())) < 4 * epsilon<Real>());
    }
}
