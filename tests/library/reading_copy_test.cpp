// SPDX-License-Identifier: BSD-3-Clause
/// The page that shows the model says what the library computes.

#include <vcavity/vcavity.hpp>

#include "examples/plain_reflectance.hpp"
#include "support/catch.hpp"

using namespace vcavity;

TEST_CASE("the reading copy of the model gives the reflectance of the library") {
  const Conductor<double> silver(0.1249, 3.3391);
  const Dielectric<double> glass(1.5);
  int compared = 0;
  for (const double aperture_deg : {180.0, 150.0, 90.0, 59.0, 45.0, 20.0, 3.0, 0.4}) {
    const Cavity<double> groove(radians(aperture_deg));
    const examples::PlainReflectance metal(groove, silver);
    const examples::PlainReflectance window(groove, glass);
    for (int i = 0; i < 200; ++i) {
      const Vec3<double> e = direction(0.00783 * i, 0.37 * i);
      CAPTURE(aperture_deg, i);
      CHECK(metal(e) == Approx(directional_reflectance(groove, e, silver)).epsilon(0).margin(1e-12));
      CHECK(window(e) == Approx(directional_reflectance(groove, e, glass)).epsilon(0).margin(1e-12));
      ++compared;
    }
  }
  CHECK(compared == 1600);
}
