// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <stdexcept>
#include <string>
#include <vcavity/numbers/gauss_legendre.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/mixed_slopes.hpp>
#include <vcavity/rough/tabulated_slopes.hpp>
#include <vector>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

/// A distribution behind functions, so that one test serves all.
struct Slopes {
  std::string name;
  std::function<double(Vec3<double>)> density;
  std::function<Vec3<double>(Vec2<double>)> sample;
};

template <SlopeDistribution Distribution>
Slopes named(const std::string& name, const Distribution& distribution) {
  return {name, [=](const Vec3<double>& m) { return distribution.density(m); },
          [=](const Vec2<double>& u) { return distribution.sample(u); }};
}

const TabulatedSlopes<double> table({{0.1, 2}, {0.2, 3}, {0.5, 1}, {0.6, 1}, {1, 0}});

/// All kinds, each so broad that the quadrature below resolves it.
std::vector<Slopes> all_slopes() {
  const GgxSlopes<double> ggx(0.4);
  const BeckmannSlopes<double> beckmann(0.6);
  return {named("ggx", ggx),
          named("anisotropic ggx", GgxSlopes<double>(0.2, 0.7)),
          named("beckmann", beckmann),
          named("anisotropic beckmann", BeckmannSlopes<double>(0.8, 0.3)),
          named("brushed", BrushedSlopes(beckmann, 8.0)),
          named("brushed with slopes of ggx", BrushedSlopes(ggx, 3.0)),
          named("brushed in no direction", BrushedSlopes(ggx, 0.0)),
          named("tabulated", table),
          named("mixed", MixedSlopes(ggx, BrushedSlopes(table, 20.0), 0.3))};
}

/// ∫ D(m) cos θ_m dω_m over the normals from azimuth 0 to `azimuth` and up to the tangent `slope`.
double share(const Slopes& slopes, double slope, double azimuth) {
  const auto rule = gauss_legendre<double>(150);
  double sum = 0;
  for (const auto& [x, x_weight] : rule) {
    const double theta = std::atan(slope) * (1 + x) / 2;
    for (const auto& [y, y_weight] : rule) {
      const double psi = azimuth * (1 + y) / 2;
      const Vec3<double> m{std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta)};
      sum += x_weight * y_weight * slopes.density(m) * m.z * std::sin(theta);
    }
  }
  return sum * std::atan(slope) * azimuth / 4;
}

}  // namespace

TEST_CASE("the facets of every distribution project to the mean area") {
  for (const Slopes& slopes : all_slopes()) {
    CAPTURE(slopes.name);
    // Tables have kinks, which plain quadrature finds hard.
    const bool has_kinks = slopes.name == "tabulated" || slopes.name == "mixed";
    CHECK(share(slopes, 1e30, 2 * pi<double>()) == Approx(1).epsilon(has_kinks ? 1e-3 : 1e-10));
  }
}

TEST_CASE("a groove has two facets of one density") {
  for (const Slopes& slopes : all_slopes()) {
    CAPTURE(slopes.name);
    for (double theta = 0.1; theta < 1.5; theta += 0.2)
      for (double psi = 0; psi < 3; psi += 0.5) {
        const Vec3<double> m{std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi),
                             std::cos(theta)};
        CHECK(slopes.density(m) == slopes.density({-m.x, -m.y, m.z}));
      }
  }
}

TEST_CASE("normals are drawn as the density says") {
  // The share of the normals drawn up to a slope and an azimuth, by counting over a grid of random numbers.
  constexpr int size = 400;
  for (const Slopes& slopes : all_slopes()) {
    CAPTURE(slopes.name);
    const double slope = 0.5, azimuth = 0.9;
    int count = 0;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) {
        const Vec3<double> m = slopes.sample({(i + 0.5) / size, (j + 0.5) / size});
        // Of the facets of a groove the one that leans towards +y.
        const double turn = m.y < 0 ? -1 : 1;
        count += std::hypot(m.x, m.y) < slope * m.z && std::atan2(turn * m.y, turn * m.x) < azimuth;
      }
    CHECK(count / double(size * size) == Approx(2 * share(slopes, slope, azimuth)).margin(3e-3));
  }
}

TEST_CASE(
    "the larger the first random number, the steeper the facet, and the second one decides the azimuth") {
  for (const Slopes& slopes : all_slopes()) {
    CAPTURE(slopes.name);
    for (double v = 0; v <= 1; v += 0.125) {
      Vec3<double> last = slopes.sample({1e-3, v});
      for (double u = 0.01; u < 1; u += 0.01) {
        const Vec3<double> m = slopes.sample({u, v});
        CHECK(m.z < last.z);
        CHECK(m.x * last.y == Approx(m.y * last.x).margin(1e-12));
        last = m;
      }
    }
  }
}

TEST_CASE("unit normals come out of every random number, in float too") {
  const auto check = [](const auto& distribution) {
    for (const float u : {0.0f, 1e-30f, 0.5f, std::nextafter(1.0f, 0.0f), 1.0f})
      for (const float v : {0.0f, 1e-30f, 0.25f, 0.5f, std::nextafter(1.0f, 0.0f), 1.0f}) {
        const Vec3<float> m = distribution.sample({u, v});
        CHECK(m.x * m.x + m.y * m.y + m.z * m.z == Approx(1).epsilon(1e-5));
        CHECK(m.z >= 0);
        CHECK(distribution.density(m) >= 0);
        CHECK(distribution.density(m) <= std::numeric_limits<float>::max());
      }
  };
  for (const float roughness : {1e-6f, 1e-3f, 1.0f, 1e3f}) {
    check(GgxSlopes<float>(roughness));
    check(BeckmannSlopes<float>(roughness));
    for (const float concentration : {0.0f, 1.0f, 1e3f, 1e6f})
      check(BrushedSlopes(BeckmannSlopes<float>(roughness), concentration));
  }
  check(TabulatedSlopes<float>({{0.1f, 2}, {0.5f, 0}, {0.7f, 0}, {1, 1}}));
}

TEST_CASE("the azimuths of brushed metal are as concentrated as they should be") {
  // The mean of cos 2χ is I_1(κ)/I_0(κ): 0, 0.446398, 0.940243 (Abramowitz & Stegun, table 9.8), 1 − 1/(2κ).
  const auto mean_cosine = [](double concentration) {
    const AxialVonMises<double> azimuths(concentration);
    double sum = 0;
    constexpr int size = 2000;
    for (int i = 0; i < size; ++i) sum += std::cos(2 * azimuths.quantile((i + 0.5) / size));
    return sum / size;
  };
  CHECK(mean_cosine(0) == Approx(0).margin(1e-12));
  CHECK(mean_cosine(1) == Approx(0.4463899658965345).epsilon(1e-6));
  CHECK(mean_cosine(1e4) == Approx(1 - 0.5e-4).epsilon(1e-6));
}

TEST_CASE("a distribution out of its range is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double roughness : {0.0, -1.0, 1e-7, 2e3, nan}) {
    CHECK_THROWS_AS(GgxSlopes<double>(roughness), std::invalid_argument);
    CHECK_THROWS_AS(BeckmannSlopes<double>(0.1, roughness), std::invalid_argument);
  }
  for (const double concentration : {-1.0, 2e6, nan})
    CHECK_THROWS_AS(BrushedSlopes(GgxSlopes<double>(0.1), concentration), std::invalid_argument);
  for (const double part : {-0.1, 1.1, nan})
    CHECK_THROWS_AS(MixedSlopes(GgxSlopes<double>(0.1), table, part), std::invalid_argument);
  using Rows = std::vector<TabulatedSlope<double>>;
  for (const Rows& rows : {Rows{}, Rows{{0, 1}}, Rows{{1, 0}}, Rows{{1, -1}}, Rows{{1, nan}}, Rows{{nan, 1}},
                           Rows{{1, 1}, {1, 1}}, Rows{{2, 1}, {1, 1}}, Rows{{-1, 0}, {1, 1}}})
    CHECK_THROWS_AS(TabulatedSlopes<double>(rows), std::invalid_argument);
}
