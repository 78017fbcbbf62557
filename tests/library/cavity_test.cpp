// SPDX-License-Identifier: BSD-3-Clause
#include <vcavity/groove/cavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEMPLATE_LIST_TEST_CASE("an aperture that is not positive or exceeds π is refused with its value", "",
                        Reals) {
  using Real = TestType;
  for (const Real& aperture :
       {Real(0), Real(-1), Real(3.2), Real(1e30), std::numeric_limits<Real>::quiet_NaN()})
    CHECK_THROWS_AS(Cavity<Real>(aperture), std::invalid_argument);
  CHECK_THROWS_WITH(Cavity<Real>(Real(-1)),
                    Catch::Matchers::ContainsSubstring("(0, π]") && Catch::Matchers::ContainsSubstring("-1"));
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
