// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vcavity/groove/fan.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEMPLATE_LIST_TEST_CASE("thousands of turns do not drift", "", HardwareReals) {
  using Real = TestType;
  for (const double aperture_deg : {0.01, 0.0137, 0.3, 7.0}) {
    const Cavity<Real> cavity(radians(Real(aperture_deg)));
    const Digits50 turn(cavity.aperture());
    FanVector<Real> vector(cavity, Real(0.6), Real(-0.8));
    const Digits50 x(Real(0.6)), y(Real(-0.8));
    double worst = 0;
    for (int j = 1; j <= cavity.max_bounces(); ++j) {
      vector.turn(2);
      if (j % 100 != 0 && j != cavity.max_bounces()) continue;
      const Digits50 cosine = cos(Digits50(j * turn));
      const Digits50 sine = sin(Digits50(j * turn));
      worst = std::max({worst, error_in_epsilons(vector.x(), Digits50(x * cosine - y * sine), 1),
                        error_in_epsilons(vector.y(), Digits50(y * cosine + x * sine), 1)});
    }
    CAPTURE(aperture_deg, worst);
    CHECK(worst < 8);
  }
}
