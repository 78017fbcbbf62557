// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vcavity/groove/unfolding.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEMPLATE_LIST_TEST_CASE("thousands of turns do not drift", "", HardwareReals) {
  using Real = TestType;
  for (const double aperture_deg : {0.01, 0.0137, 0.3, 7.0}) {
    const Cavity<Real> cavity(radians(Real(aperture_deg)));
    const Digits50 turn(cavity.aperture());
    const Vec3<Real> e{Real(0), Real(-0.8), Real(0.6)};
    UnfoldedRay<Real> ray(cavity, e, Panel::one);
    double worst = 0;
    for (int j = 1; j <= cavity.max_bounces(); ++j) {
      ray.advance();
      if (j % 100 != 0 && j != cavity.max_bounces()) continue;
      const Digits50 cosine = cos(Digits50((j + Digits50(0.5)) * turn));
      const Digits50 sine = sin(Digits50((j + Digits50(0.5)) * turn));
      worst =
          std::max({worst, error_in_epsilons(ray.tangent_component(), Digits50(e.z * cosine - e.y * sine), 1),
                    error_in_epsilons(ray.normal_component(), Digits50(e.y * cosine + e.z * sine), 1)});
    }
    CAPTURE(aperture_deg, worst);
    CHECK(worst < 8);
  }
}
