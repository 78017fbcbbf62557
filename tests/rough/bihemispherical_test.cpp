// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/rough_albedo_table.hpp>
#include <vcavity/rough/rough_bihemispherical.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

const Dielectric<double> glass(1.5);
const auto half = [](double) { return 0.5; };

/// Whether an integral is as close to a value as its error estimate says; the value has seven digits.
void check(const Integral<double>& integral, double expected) {
  CHECK(integral.error < 1e-6);
  CHECK(std::abs(integral.value - expected) < integral.error + 5e-8);
}

}  // namespace

TEST_CASE("the bi-hemispherical reflectance of rough surfaces agrees with published digits") {
  struct Row {
    double roughness, ggx_glass, ggx_half, beckmann_glass, beckmann_half;
  };
  for (const Row& row : {Row{0.1, 0.0838333, 0.4936794, 0.0881579, 0.4987562},
                         Row{1.0, 0.0373337, 0.3574882, 0.0445340, 0.4108435}}) {
    CAPTURE(row.roughness);
    check(bihemispherical_reflectance(GgxSlopes<double>(row.roughness), glass, 1e-6), row.ggx_glass);
    check(bihemispherical_reflectance(GgxSlopes<double>(row.roughness), half, 1e-6), row.ggx_half);
    check(bihemispherical_reflectance(BeckmannSlopes<double>(row.roughness), glass, 1e-6),
          row.beckmann_glass);
    check(bihemispherical_reflectance(BeckmannSlopes<double>(row.roughness), half, 1e-6), row.beckmann_half);
  }
}

TEST_CASE("shares of apertures add up to the whole, wherever their range is cut") {
  for (const double roughness : {0.1, 0.3, 1.0}) {
    double whole = 0, high = pi<double>();
    for (int k = 2; k < 8; ++k) {
      const double low = pi<double>() / k;
      whole += detail::aperture_moments(GgxSlopes<double>(roughness), low, high, 1e-13).value[0];
      high = low;
    }
    whole += detail::aperture_moments(GgxSlopes<double>(roughness), 0.0, high, 1e-13).value[0];
    CAPTURE(roughness);
    CHECK(std::abs(whole - 1) < 1e-12);
  }
}

TEST_CASE("diffuse light knows nothing of the azimuth of the grooves") {
  const BeckmannSlopes<double> slopes(0.5);
  const auto isotropic = bihemispherical_reflectance(slopes, glass, 1e-7);
  const auto brushed = bihemispherical_reflectance(BrushedSlopes(slopes, 30.0), glass, 1e-7);
  CHECK(brushed.value == Approx(isotropic.value).epsilon(1e-12));
}

TEST_CASE("two distributions side by side reflect as their shares say") {
  const BeckmannSlopes<double> rough(0.8);
  const GgxSlopes<double> smooth(0.1, 0.3);
  const auto value = [](const auto& distribution) {
    return bihemispherical_reflectance(distribution, half, 1e-6).value;
  };
  CHECK(value(MixedSlopes(rough, smooth, 0.3)) ==
        Approx(0.3 * value(rough) + 0.7 * value(smooth)).margin(2e-6));
}

TEST_CASE("the bi-hemispherical reflectance is the mean of the albedo in diffuse light") {
  // The midpoint rule over sin²θ, in steps of 1/12, for an integrand with a root at grazing incidence.
  const BeckmannSlopes<double> slopes(0.6);
  constexpr int size = 12;
  double sum = 0;
  for (int i = 0; i < size; ++i) {
    const double sine2 = (i + 0.5) / size;
    sum += directional_albedo(slopes, {std::sqrt(sine2), 0, std::sqrt(1 - sine2)}, half, 1e-4).value;
  }
  CHECK(sum / size == Approx(bihemispherical_reflectance(slopes, half, 1e-6).value).margin(1e-3));
}

TEST_CASE("a table of the albedo is close to the albedo, isotropic or not") {
  const auto check = [](const auto& distribution, double tolerance) {
    const RoughAlbedoTable<double> table(distribution, glass, tolerance);
    for (const double theta : {5.0, 50.0, 80.0, 88.0}) {
      const Vec3<double> e = direction(radians(theta), 0.7);
      CAPTURE(theta);
      CHECK(std::abs(table(e) - directional_albedo(distribution, e, glass, 1e-5).value) < 1e-3);
      CHECK(table(e) == Approx(table({-e.x, -e.y, e.z})).margin(1e-12));
    }
  };
  check(BeckmannSlopes<double>(0.4), 1e-4);
  check(BeckmannSlopes<double>(0.2, 0.5), 1e-2);
}

TEST_CASE("a tolerance that is not positive is refused") {
  for (const double tolerance : {0.0, -1.0, std::nan("")}) {
    CHECK_THROWS_AS(bihemispherical_reflectance(GgxSlopes<double>(0.3), half, tolerance),
                    std::invalid_argument);
    CHECK_THROWS_AS(directional_albedo(GgxSlopes<double>(0.3), {0, 0, 1}, half, tolerance),
                    std::invalid_argument);
  }
}
