// SPDX-License-Identifier: BSD-3-Clause
/// Matte panels of unequal slope.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <utility>
#include <vcavity/matte/asymmetric_lambertian.hpp>
#include <vector>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

Vec3<double> across(double theta) {
  return {0, std::sin(theta), std::cos(theta)};
}

AsymmetricGroove<double> groove(double aperture_deg, double tilt_deg) {
  return {radians(aperture_deg), radians(tilt_deg)};
}

/// ∫ f(θ') cos θ' dθ' over all angles across the groove, in pieces that shrink towards the angles where the light begins
/// to miss a panel, and towards a kink.
template <class Function>
double over_angles(const AsymmetricGroove<double>& shape, double kink, int pieces, const Function& f) {
  const double quarter_turn = pi<double>() / 2;
  std::vector<double> marks{-quarter_turn, kink, quarter_turn};
  for (const double side : {-1.0, 1.0}) {
    const double mark = side * shape.aperture() / 2 + shape.tilt();
    if (std::abs(mark) < quarter_turn) marks.push_back(mark);
  }
  std::sort(marks.begin(), marks.end());
  const auto rule = gauss_legendre<double>(12);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < marks.size(); ++i)
    for (const double side : {-1.0, 1.0}) {
      const double mark = side < 0 ? marks[i] : marks[i + 1];
      double to = (marks[i + 1] - marks[i]) / 2;
      for (int piece = 0; piece < pieces; ++piece) {
        const double from = piece + 1 < pieces ? to / 2 : 0;
        for (const auto& node : rule) {
          const double angle = mark - side * (from + (to - from) * (1 + node.x) / 2);
          sum += node.weight * (to - from) / 2 * std::cos(angle) * f(angle);
        }
        to = from;
      }
    }
  return sum;
}

}  // namespace

TEST_CASE("panels of unequal slope have the reference reflectance") {
  const auto data = nlohmann::json::parse(std::ifstream(VCAVITY_TEST_DATA "/lambertian_cases.json"));
  REQUIRE(data.at("lambertian_asymmetric").size() == 2);
  for (const auto& row : data.at("lambertian_asymmetric")) {
    CAPTURE(row.dump());
    const double one = row.at("albedo1"), two = row.at("albedo2");
    // The references are given to 13 decimals.
    for (const double side : {-1.0, 1.0}) {
      const AsymmetricLambertianCavity<double> matte(
          groove(row.at("aperture_deg"), side * row.at("tilt_deg").get<double>()), one, two);
      CHECK(std::abs(matte.bihemispherical_reflectance() - row.at("R_bihemispherical").get<double>()) <
            5e-13);
    }
  }
}

TEST_CASE("without a tilt matte panels are those of the symmetric groove") {
  for (const double aperture_deg : {3.0, 45.0, 110.0})
    for (const auto& [one, two] : {std::pair{0.8, 0.8}, {0.9, 0.2}, {0.0, 0.7}, {1.0, 1.0}}) {
      CAPTURE(aperture_deg, one, two);
      const AsymmetricLambertianCavity<double> matte(groove(aperture_deg, 0), one, two);
      const LambertianCavity<double> symmetric(Cavity<double>(radians(aperture_deg)), one, two);
      CHECK(std::abs(matte.bihemispherical_reflectance() - symmetric.bihemispherical_reflectance()) < 1e-12);
      for (const double light : {-1.4, -0.3, 0.005, 1.1, 1.57})
        for (const double viewer : {-1.0, 0.0, 1.3}) {
          CAPTURE(light, viewer);
          CHECK(std::abs(matte.directional_reflectance(across(light)) -
                         symmetric.directional_reflectance(across(light))) < 1e-11);
          CHECK(std::abs(matte.brdf(across(light), across(viewer)) -
                         symmetric.brdf(across(light), across(viewer))) <=
                matte.brdf_error(across(light), across(viewer)) +
                    symmetric.brdf_error(across(light), across(viewer)));
        }
    }
}

TEST_CASE("a groove seen from its other side has tilt and panels exchanged") {
  const AsymmetricLambertianCavity<double> matte(groove(50, 25), 0.9, 0.4), turned(groove(50, -25), 0.4, 0.9);
  CHECK(std::abs(matte.bihemispherical_reflectance() - turned.bihemispherical_reflectance()) < 1e-14);
  for (const double theta : {-1.2, -0.2, 0.7, 1.5}) {
    CHECK(std::abs(matte.directional_reflectance(across(theta)) -
                   turned.directional_reflectance(across(-theta))) < 1e-14);
    CHECK(std::abs(matte.radiosity(Panel::one, 0.6) - turned.radiosity(Panel::two, 0.6)) < 1e-14);
  }
}

TEST_CASE("the BRDF of unequal panels is symmetric in light and viewer (Helmholtz)") {
  for (const double aperture_deg : {10.0, 60.0, 110.0})
    for (const double tilt_share : {0.3, 0.9}) {
      const double tilt_deg = tilt_share * (180 - aperture_deg) / 2;
      const AsymmetricLambertianCavity<double> matte(groove(aperture_deg, tilt_deg), 0.9, 0.3);
      for (const double theta : {0.0, 0.9, 1.4})
        for (const double phi : {0.1, 1.3, 2.9}) {
          const Vec3<double> light = direction(theta, phi), viewer = direction(0.8, 0.5);
          CAPTURE(aperture_deg, tilt_deg, theta, phi);
          CHECK(std::abs(matte.brdf(light, viewer) - matte.brdf(viewer, light)) <=
                2 * matte.brdf_error(light, viewer));
          CHECK(matte.brdf_error(light, viewer) < 1e-5);
        }
    }
}

TEST_CASE("what the BRDF of unequal panels sends into all directions is the directional reflectance") {
  const AsymmetricGroove<double> shape = groove(70, 30);
  for (const auto& [one, two] : {std::pair{0.9, 0.3}, {1.0, 1.0}}) {
    const AsymmetricLambertianCavity<double> matte(shape, one, two);
    for (const double theta : {-1.0, 0.9}) {
      CAPTURE(one, two, theta);
      const double sum = over_angles(shape, theta, 5,
                                     [&](double angle) { return matte.brdf(across(theta), across(angle)); });
      // ∫ cos²ψ dψ = π/2
      CHECK(std::abs(sum * pi<double>() / 2 - matte.directional_reflectance(across(theta))) < 1e-6);
    }
  }
}

TEST_CASE("the mean of the directional reflectance of unequal panels is the bi-hemispherical one") {
  for (const double aperture_deg : {20.0, 60.0, 110.0})
    for (const double tilt_share : {0.2, 0.7})
      for (const auto& [one, two] : {std::pair{0.8, 0.8}, {0.9, 0.2}}) {
        CAPTURE(aperture_deg, tilt_share, one, two);
        const AsymmetricGroove<double> shape = groove(aperture_deg, tilt_share * (180 - aperture_deg) / 2);
        const AsymmetricLambertianCavity<double> matte(shape, one, two);
        const double sum = over_angles(
            shape, 0, 25, [&](double angle) { return matte.directional_reflectance(across(angle)); });
        CHECK(std::abs(sum / 2 - matte.bihemispherical_reflectance()) < 1e-9);
      }
}

TEST_CASE("unequal panels: white ones lose no light, black ones return none") {
  for (const double tilt_deg : {10.0, 55.0}) {
    const AsymmetricLambertianCavity<double> white(groove(50, tilt_deg), 1.0, 1.0),
        black(groove(50, tilt_deg), 0.0, 0.0);
    CHECK(white.bihemispherical_reflectance() == 1);
    CHECK(std::abs(black.bihemispherical_reflectance()) < 1e-13);
    for (const double theta : {-1.5, 0.0, 0.9}) {
      CHECK(white.directional_reflectance(across(theta)) == 1);
      CHECK(std::abs(black.directional_reflectance(across(theta))) < 1e-13);
      CHECK(black.brdf(across(theta), across(0.3)) == 0);
    }
  }
}

TEST_CASE("no error of unequal panels exceeds its estimate, and the estimates are small") {
  for (const double aperture_deg : {3.0, 30.0, 100.0})
    for (const double tilt_share : {0.05, 0.6, 0.98})
      for (const double albedo : {0.3, 0.95}) {
        if (aperture_deg < 10 && tilt_share > 0.6) continue;  // long double takes long
        CAPTURE(aperture_deg, tilt_share, albedo);
        const AsymmetricGroove<double> shape = groove(aperture_deg, tilt_share * (180 - aperture_deg) / 2);
        const AsymmetricGroove<long double> same(static_cast<long double>(shape.aperture()),
                                                 static_cast<long double>(shape.tilt()));
        const auto long_albedo = static_cast<long double>(albedo);
        const AsymmetricLambertianCavity<double> matte(shape, albedo, albedo);
        const AsymmetricLambertianCavity<long double> finer(same, long_albedo, long_albedo);
        const auto error = [](double found, long double expected) {
          return std::abs(found - static_cast<double>(expected));
        };
        CHECK(error(matte.bihemispherical_reflectance(), finer.bihemispherical_reflectance()) <=
              matte.bihemispherical_error());
        CHECK(matte.bihemispherical_error() < 1e-9);
        for (const double theta : {-0.9, 0.1, 1.2}) {
          CAPTURE(theta);
          const Vec3<double> e = across(theta);
          CHECK(error(matte.directional_reflectance(e),
                      finer.directional_reflectance(Vec3<long double>(e))) <= matte.directional_error(e));
          const Vec3<double> viewer = across(1.0);
          CHECK(error(matte.brdf(e, viewer), finer.brdf(Vec3<long double>(e), Vec3<long double>(viewer))) <=
                matte.brdf_error(e, viewer));
        }
      }
}

TEST_CASE("colours of unequal panels are computed component by component") {
  const auto shape = groove(60, 20);
  const AsymmetricLambertianCavity<double, glm::dvec3> colours(shape, glm::dvec3(0.9, 0.5, 0.2),
                                                               glm::dvec3(0.8));
  const AsymmetricLambertianCavity<double> blue(shape, 0.2, 0.8);
  CHECK(bihemispherical_reflectance(colours).z == bihemispherical_reflectance(blue));
  CHECK(directional_reflectance(colours, across(0.9)).z == directional_reflectance(blue, across(0.9)));
  CHECK_THROWS_AS((AsymmetricLambertianCavity<double>(shape, 0.5, 1.5)), std::invalid_argument);
}
