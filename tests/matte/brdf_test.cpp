// SPDX-License-Identifier: BSD-3-Clause
/// The BRDF of matte grooves.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vcavity/matte/lambertian_cavity.hpp>
#include <vector>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

Vec3<double> across(double theta) {
  return {0, std::sin(theta), std::cos(theta)};
}

}  // namespace

TEST_CASE("the BRDF is symmetric in light and viewer (Helmholtz)") {
  for (const double aperture_deg : {5.0, 45.0, 90.0, 140.0})
    for (const auto& [one, two] : {std::pair{0.8, 0.8}, {0.9, 0.3}}) {
      const LambertianCavity<double> matte(Cavity<double>(radians(aperture_deg)), one, two);
      for (const double theta : {0.0, 0.4, 0.9, 1.4})
        for (const double phi : {0.1, 1.3, 2.9}) {
          const Vec3<double> light = direction(theta, phi), viewer = direction(0.8, 0.5);
          CAPTURE(aperture_deg, one, two, theta, phi);
          CHECK(std::abs(matte.brdf(light, viewer) - matte.brdf(viewer, light)) <=
                2 * matte.brdf_error(light, viewer) + 1e-15);
        }
    }
}

TEST_CASE("what the BRDF sends into all directions is the directional reflectance") {
  const auto rule = gauss_legendre<double>(24);
  for (const double aperture_deg : {20.0, 60.0, 120.0})
    for (const auto& [one, two] : {std::pair{1.0, 1.0}, {0.7, 0.7}, {0.9, 0.2}})
      for (const double theta_deg : {-25.0, 5.0, 50.0, 80.0}) {
        CAPTURE(aperture_deg, one, two, theta_deg);
        const double theta = radians(theta_deg), half = radians(aperture_deg) / 2;
        const LambertianCavity<double> matte(Cavity<double>(2 * half), one, two);
        // The BRDF depends on the angle across the groove alone, and has a kink where the viewer passes the light.
        const double quarter_turn = pi<double>() / 2;
        std::vector<double> ends{-quarter_turn, -half, half, quarter_turn};
        if (std::abs(theta) > half) ends.push_back(theta);
        std::sort(ends.begin(), ends.end());
        double sum = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
          for (const auto& node : rule) {
            const double width = ends[i + 1] - ends[i];
            const double viewer = ends[i] + width * (1 + node.x) / 2;
            sum += node.weight * width / 2 * std::cos(viewer) * matte.brdf(across(theta), across(viewer));
          }
        // ∫ cos²ψ dψ = π/2. Just beyond the aperture the BRDF is a power of the angle, which the outer rule takes less well
        // the narrower the groove.
        CHECK(std::abs(sum * quarter_turn - matte.directional_reflectance(across(theta))) <
              (aperture_deg < 30 ? 4e-6 : 4e-8));
      }
}

TEST_CASE("no error of the BRDF exceeds its estimate") {
  for (const double aperture_deg : {2.0, 20.0, 60.0, 120.0})
    for (const double albedo : {0.3, 0.9}) {
      const double aperture = radians(aperture_deg);
      const LambertianCavity<double> matte(Cavity<double>(aperture), albedo);
      const LambertianCavity<long double> finer(Cavity<long double>(static_cast<long double>(aperture)),
                                                static_cast<long double>(albedo));
      for (const double light_deg : {aperture_deg / 2 + 1, 65.0, 88.0})
        for (const double viewer_deg : {-80.0, -aperture_deg / 2 - 3, 0.0, aperture_deg / 2 + 2, 70.0}) {
          CAPTURE(aperture_deg, albedo, light_deg, viewer_deg);
          const Vec3<double> light = across(radians(light_deg)), viewer = across(radians(viewer_deg));
          const auto expected = finer.brdf(Vec3<long double>(light), Vec3<long double>(viewer));
          CHECK(std::abs(matte.brdf(light, viewer) - static_cast<double>(expected)) <=
                matte.brdf_error(light, viewer) + 1e-14);
        }
    }
}

TEST_CASE("a black panel is seen only as what it takes from the other") {
  const LambertianCavity<double> matte(Cavity<double>(radians(90.0)), 0.0, 0.6);
  // From beyond the aperture at +y panel one alone is seen, and it is black.
  CHECK(std::abs(matte.brdf(across(1.2), across(1.3))) < 1e-15);
  CHECK(std::abs(matte.directional_reflectance(across(1.2))) < 1e-14);
  // From the other side panel two reflects like a Lambertian plane of which a part shows.
  const double length = 1 - std::sin(1.2 - radians(45.0)) / std::sin(1.2 + radians(45.0));
  CHECK(matte.brdf(across(-1.2), across(-1.2)) ==
        Approx(2 * std::sin(radians(45.0)) * 0.6 / pi<double>() / length).epsilon(1e-13));
}
