// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "bsdf/chi_square.hpp"
#include "support/catch.hpp"

using namespace vcavity;

namespace {

Vec3<double> some_direction(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double theta = std::acos(std::sqrt(unit(random)));
  return direction(theta, 2 * pi<double>() * unit(random));
}

}  // namespace

TEST_CASE("a matte BSDF is the BRDF times the cosine, to within its table") {
  std::mt19937 random(1);
  for (const auto& [aperture_deg, allowed] :
       {std::pair{3.0, 2e-2}, {30.0, 2e-4}, {60.0, 3e-5}, {120.0, 2e-6}})
    for (const double albedo : {0.3, 1.0}) {
      const LambertianCavity<double> matte(Cavity<double>(radians(aperture_deg)), albedo, 0.8 * albedo);
      const LambertianGrooveBsdf<double> bsdf(matte);
      for (int i = 0; i < 200; ++i) {
        const Vec3<double> wo = some_direction(random), wi = some_direction(random);
        CAPTURE(aperture_deg, albedo, wo.y, wo.z, wi.y, wi.z);
        CHECK(std::abs(bsdf.evaluate(wo, wi) / (matte.brdf(wi, wo) * wi.z) - 1) < allowed);
        // Symmetric, as light goes, but for what the nodes of the quadrature leave in narrow grooves.
        CHECK(bsdf.evaluate(wo, wi) * wo.z == Approx(bsdf.evaluate(wi, wo) * wi.z).epsilon(1e-3 * allowed));
      }
    }
}

TEST_CASE("white matte grooves lose no light: the mean weight of samples is the albedo") {
  for (const float aperture_deg : {10.0f, 60.0f, 120.0f}) {
    const LambertianGrooveBsdf<float, glm::vec3> bsdf(
        LambertianCavity<float, glm::vec3>(Cavity<float>(radians(aperture_deg)), glm::vec3(1, 0.5, 0.2)));
    for (const Vec3<float>& wo : {direction(0.1f, 0.0f), direction(1.2f, 0.3f), direction(1.5f, 3.0f)}) {
      constexpr int steps = 300;
      glm::dvec3 sum(0);
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
          const auto sample = bsdf.sample(wo, {(float(i) + 0.5f) / steps, (float(j) + 0.5f) / steps});
          REQUIRE(sample);
          CHECK(sample->probability == Approx(bsdf.pdf(wo, sample->direction)));
          const glm::vec3 value = bsdf.evaluate(wo, sample->direction) / sample->probability;
          if (i % 50 == 0) CHECK(sample->weight.x == Approx(value.x).epsilon(1e-4));
          sum += glm::dvec3(sample->weight);
        }
      const glm::vec3 albedo = bsdf.albedo(wo);
      CHECK(albedo.x == Approx(1).epsilon(1e-5));
      for (int c = 0; c < 3; ++c) CHECK(sum[c] / (steps * steps) == Approx(albedo[c]).epsilon(2e-3));
    }
  }
}

TEST_CASE("matte directions are drawn with the density that pdf tells") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  const LambertianGrooveBsdf<double> bsdf(LambertianCavity<double>(Cavity<double>(radians(60.0)), 0.5));
  const Vec3<double> wo = direction(1.1, 2.0);
  constexpr int thetas = 8, phis = 12, samples = 100000;
  std::vector<double> counts(thetas * phis, 0), expected(thetas * phis, 0);
  for (int i = 0; i < samples; ++i) {
    const auto sample = bsdf.sample(wo, {unit(random), unit(random)});
    REQUIRE(sample);
    const double theta = std::acos(sample->direction.z);
    double phi = std::atan2(sample->direction.x, sample->direction.y);
    if (phi < 0) phi += 2 * pi<double>();
    const int bin = std::min(static_cast<int>(theta / pi<double>() * 2 * thetas), thetas - 1) * phis +
                    std::min(static_cast<int>(phi / (2 * pi<double>()) * phis), phis - 1);
    counts[static_cast<std::size_t>(bin)] += 1;
  }
  const auto rule = gauss_legendre<double>(6);
  for (int i = 0; i < thetas; ++i)
    for (int j = 0; j < phis; ++j)
      for (const auto& a : rule)
        for (const auto& b : rule) {
          const double theta = (i + (1 + a.x) / 2) * pi<double>() / 2 / thetas;
          const double phi = (j + (1 + b.x) / 2) * 2 * pi<double>() / phis;
          expected[static_cast<std::size_t>(i * phis + j)] +=
              samples * a.weight / 2 * b.weight / 2 * (pi<double>() / 2 / thetas) *
              (2 * pi<double>() / phis) * std::sin(theta) * bsdf.pdf(wo, direction(theta, phi));
        }
  CHECK(test::p_value(counts, expected) > test::false_alarm_rate);
}

TEST_CASE("nothing of a matte groove is seen from below the horizon") {
  const LambertianGrooveBsdf<double> bsdf(LambertianCavity<double>(Cavity<double>(radians(60.0)), 0.5));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vec3<double> up{0, 0, 1};
  for (const Vec3<double>& below : {Vec3<double>{0, 0.6, -0.8}, {0, 0, -1}, {1, 0, 0}, {nan, nan, nan}}) {
    CHECK_FALSE(bsdf.sample(below, {0.3, 0.3}));
    CHECK(bsdf.evaluate(below, up) == 0);
    CHECK(bsdf.evaluate(up, below) == 0);
    CHECK(bsdf.pdf(below, up) == 0);
    CHECK(bsdf.pdf(up, below) == 0);
  }
  CHECK(bsdf.albedo({0, 0.6, -0.8}) == 0);
}
