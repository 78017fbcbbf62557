// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vcavity/groove/cavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEMPLATE_LIST_TEST_CASE("an aperture that is not positive or exceeds π is refused with its value", "",
                        Reals) {
  using Real = TestType;
  for (const Real& aperture :
       {Real(0), Real(-1), Real(3.2), Real(1e30), Real(1.9e-9), std::numeric_limits<Real>::denorm_min(),
        std::numeric_limits<Real>::quiet_NaN()})
    CHECK_THROWS_AS(Cavity<Real>(aperture), std::invalid_argument);
  CHECK_THROWS_WITH(Cavity<Real>(Real(-1)), Catch::Matchers::ContainsSubstring("2e-09, π]") &&
                                                Catch::Matchers::ContainsSubstring("-1"));
  CHECK_NOTHROW(Cavity<Real>(pi<Real>()));
}

TEMPLATE_LIST_TEST_CASE("an aperture that rounding has lifted above π is a flat surface", "", Reals) {
  using Real = TestType;
  const Cavity<Real> flat(pi<Real>() * (Real(1) + Real(2) * epsilon<Real>()));
  CHECK(flat.aperture() == pi<Real>());
  CHECK(flat.max_bounces() == 1);
  CHECK_THROWS_AS(Cavity<Real>(pi<Real>() * (Real(1) + Real(16) * epsilon<Real>())), std::invalid_argument);
}

TEMPLATE_LIST_TEST_CASE("panel normals are unit vectors that face each other across the groove", "", Reals) {
  using Real = TestType;
  const Cavity<Real> cavity(radians(Real(70)));
  for (const Panel panel : {Panel::one, Panel::two}) {
    const Vec3<Real> n = cavity.normal(panel);
    const Vec3<Real> t = cavity.tangent(panel);
    CHECK(error_in_epsilons(Real(n.y * n.y + n.z * n.z), 1) < 4);
    CHECK(error_in_epsilons(Real(n.y * t.y + n.z * t.z), 0, 1) < 2);
    CHECK(n.z > Real(0));
    CHECK(t.z > Real(0));
  }
  CHECK(cavity.normal(Panel::one).y > Real(0));
  CHECK(cavity.tangent(Panel::one).y < Real(0));
  CHECK(cavity.normal(Panel::two).y == -cavity.normal(Panel::one).y);
}

TEMPLATE_LIST_TEST_CASE("at an aperture of π/k and a rounding error beside it there are at most k bounces",
                        "", Reals) {
  using Real = TestType;
  for (int k = 1; k <= 1000; ++k) {
    const Real aperture = pi<Real>() / Real(k);
    CHECK(Cavity<Real>(aperture).max_bounces() == k);
    CHECK(Cavity<Real>(Real(aperture * (Real(1) - epsilon<Real>()))).max_bounces() == k);
  }
  CHECK(Cavity<Real>(radians(Real(59))).max_bounces() == 4);
  CHECK(Cavity<Real>(radians(Real(61))).max_bounces() == 3);
  CHECK(Cavity<Real>(radians(Real(0.01))).max_bounces() == 18000);
}

TEMPLATE_LIST_TEST_CASE("a flat surface has no depth", "", HardwareReals) {
  using Real = TestType;
  const Cavity<Real> flat(pi<Real>());
  CHECK(flat.cos_half() >= Real(0));
  CHECK(flat.cos_half() < epsilon<Real>());
  CHECK(flat.max_bounces() == 1);
}

TEMPLATE_LIST_TEST_CASE("of the multiples of half the aperture only those are kept that the bounces need", "",
                        HardwareReals) {
  using Real = TestType;
  for (const double aperture_deg : {180.0, 100.0, 60.0, 45.0, 30.0, 20.0, 1.0}) {
    const Cavity<Real> cavity(radians(Real(aperture_deg)));
    CAPTURE(aperture_deg);
    CHECK(cavity.multiples().tabulated() == std::min(2 * cavity.max_bounces() + 1, 15));
    for (int k = 0; k <= 40; ++k) {
      const Real angle = Real(k) * (cavity.aperture() / Real(2));
      CHECK(cavity.multiple(k).sine == std::sin(angle));
      CHECK(cavity.multiple(k).cosine == (k == 1 ? cavity.cos_half() : std::cos(angle)));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("a groove of given facets is that of their aperture, to the error of the normal", "",
                        HardwareReals) {
  using Real = TestType;
  double worst = 0;
  for (int i = 1; i < 2000; ++i) {
    const Real aperture = pi<Real>() * Real(i) / Real(2000);
    const Real up = std::sin(aperture / Real(2)), across = std::cos(aperture / Real(2));
    const Digits50 half = atan2(Digits50(up), Digits50(across));
    const Cavity<Real> expected(static_cast<Real>(Digits50(2 * half)));
    for (const Real& length : {Real(1), Real(0.3), Real(-7)}) {
      const Cavity<Real> cavity = Cavity<Real>::from_normal(length * across, std::abs(length) * up);
      CAPTURE(i, length);
      CHECK(cavity.aperture() == Approx(expected.aperture()).epsilon(1e-5));
      CHECK(cavity.max_bounces() == expected.max_bounces());
      CHECK(cavity.multiples().tabulated() == expected.multiples().tabulated());
      if (length != Real(1)) continue;
      CHECK(error_in_epsilons(cavity.versine_half(), Digits50(1 - cos(half))) < 8);
      for (int k = 1; k <= cavity.multiples().tabulated(); ++k) {
        const auto turn = cavity.multiple(k);
        worst = std::max({worst, error_in_epsilons(turn.sine, Digits50(sin(Digits50(k * half))), 1) / k,
                          error_in_epsilons(turn.cosine, Digits50(cos(Digits50(k * half))), 1) / k});
      }
    }
    const Real slope = across / up;
    CHECK(Cavity<Real>::from_slope(slope).sin_half() == Approx(up).epsilon(1e-6));
    CHECK(Cavity<Real>::from_slope(slope).cos_half() == Approx(across).epsilon(1e-6));
  }
  CAPTURE(worst);
  CHECK(worst < 1);
}

TEMPLATE_LIST_TEST_CASE("multiples of an aperture that are added up are those of its sines", "",
                        HardwareReals) {
  using Real = TestType;
  double worst = 0;
  for (int i = 1; i <= 2000; ++i) {
    const Real aperture = pi<Real>() * Real(i) / Real(2000);
    const Cavity<Real> expected(aperture), cavity = Cavity<Real>::by_addition(aperture);
    CAPTURE(i);
    CHECK(cavity.aperture() == expected.aperture());
    CHECK(cavity.max_bounces() == expected.max_bounces());
    CHECK(cavity.multiples().tabulated() == expected.multiples().tabulated());
    CHECK(cavity.inverse_sin_half() == expected.inverse_sin_half());
    CHECK(error_in_epsilons(cavity.versine_half(), Digits50(expected.versine_half())) < 8);
    const Digits50 half = Digits50(aperture) / 2;
    for (int k = 2; k <= cavity.multiples().tabulated(); ++k) {
      const auto turn = cavity.multiple(k);
      worst = std::max({worst, error_in_epsilons(turn.sine, Digits50(sin(Digits50(k * half))), 1) / k,
                        error_in_epsilons(turn.cosine, Digits50(cos(Digits50(k * half))), 1) / k});
    }
  }
  CAPTURE(worst);
  CHECK(worst < 1);
  CHECK_THROWS_AS(Cavity<Real>::by_addition(Real(0)), std::invalid_argument);
}

TEMPLATE_LIST_TEST_CASE("facets at an angle of π/k bounce light at most k times", "", HardwareReals) {
  using Real = TestType;
  for (int k = 1; k <= 1000; ++k) {
    const Real half = pi<Real>() / Real(2 * k);
    CAPTURE(k);
    CHECK(Cavity<Real>::from_normal(std::cos(half), std::sin(half)).max_bounces() == k);
  }
  CHECK(Cavity<Real>::from_slope(Real(0)).max_bounces() == 1);
  CHECK(Cavity<Real>::from_slope(Real(0)).cos_half() == Real(0));
}

TEMPLATE_LIST_TEST_CASE("facets that are vertical, overhang or are no numbers are refused", "",
                        HardwareReals) {
  using Real = TestType;
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  for (const auto& [across, up] : std::initializer_list<std::pair<Real, Real>>{
           {1, 0}, {0, 0}, {1, -1}, {1, Real(1e-10)}, {nan, 1}, {1, nan}, {infinity, 1}, {1, infinity}})
    CHECK_THROWS_WITH(Cavity<Real>::from_normal(across, up),
                      Catch::Matchers::ContainsSubstring("less steep than vertical"));
  CHECK_THROWS_AS(Cavity<Real>::from_slope(infinity), std::invalid_argument);
  CHECK_THROWS_AS(Cavity<Real>::from_slope(nan), std::invalid_argument);
}
