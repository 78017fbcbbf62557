// SPDX-License-Identifier: BSD-3-Clause
/// The Mueller matrix of all light that a rough surface reflects.

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/polarization/polarization.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/rough_albedo.hpp>
#include <vcavity/rough/rough_bsdf.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

constexpr int most_bounces = 8;

/// The mean weight of samples of the BSDF, and the largest standard error of its elements.
template <class Bsdf>
std::pair<Mueller<double>, double> mean_of_samples(const Bsdf& bsdf, const Vec3<double>& e, int samples) {
  std::mt19937 random(20261126);
  std::uniform_real_distribution<double> unit(0, 1);
  Mueller<double> sum(0);
  double squares = 0;
  for (int i = 0; i < samples; ++i) {
    const double u = unit(random), u_slope = unit(random), u_azimuth = unit(random);
    const auto sample = bsdf.sample(e, u, {u_slope, u_azimuth}, Transport::importance);
    if (!sample) continue;
    sum = sum + sample->weight;
    squares += largest(sample->weight) * largest(sample->weight);
  }
  return {(1.0 / samples) * sum, std::sqrt(squares) / samples};
}

}  // namespace

TEST_CASE("the polarised albedo is the mean of the samples of the polarised BSDF") {
  const auto check = [](const auto& slopes, const auto& facet, const Vec3<double>& e) {
    const auto found = polarized_albedo(slopes, e, polarized(facet), 1e-4, most_bounces);
    const auto [mean, deviation] =
        mean_of_samples(RoughGrooveBsdf(slopes, polarized(facet), most_bounces), e, 40000);
    CHECK(found.error < 2e-4);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        CAPTURE(i, j);
        CHECK(std::abs(found.value(i, j) - mean(i, j)) < 4.5 * deviation + found.error);
      }
    // More than noise: the matrix is not that of facets without polarisation.
    CHECK(diattenuation(found.value) * found.value(0, 0) > 20 * deviation);
  };
  check(GgxSlopes<double>(0.3), Conductor<double>(1.5, 0), direction(radians(55.0), 0.7));
  check(BrushedSlopes(GgxSlopes<double>(0.4), 3.0), Conductor<double>(1.5, 0), direction(radians(60.0), 0.5));
}

TEST_CASE("unpolarised light is reflected as the albedo of unpolarised light says") {
  const GgxSlopes<double> slopes(0.4, 0.2);
  const auto facet = polarized(Conductor<double>(0.2, 3));
  const Vec3<double> e = direction(0.9, 0.4);
  const auto matrix = polarized_albedo(slopes, e, facet, 1e-4);
  const auto number = directional_albedo(slopes, e, facet, 1e-5);
  CHECK(std::abs(matrix.value(0, 0) - number.value) <= matrix.error + number.error);
}

TEST_CASE("perfect mirrors reflect light of every polarisation") {
  const auto perfect = polarized(Conductor<double>(0, 1e8));
  const auto found = polarized_albedo(GgxSlopes<double>(0.5), direction(0.8, 0.3), perfect, 1e-2);
  CHECK(std::abs(found.value(0, 0) - 1) < 1e-4);
  for (std::size_t j = 1; j < 4; ++j) CHECK(std::abs(found.value(0, j)) < 1e-4);
}

TEST_CASE("along the normal an isotropic surface has no preferred polarisation") {
  const auto found =
      polarized_albedo(GgxSlopes<double>(0.3), {0, 0, 1}, polarized(Conductor<double>(1.5, 0)), 1e-4);
  for (std::size_t j = 1; j < 4; ++j) CHECK(std::abs(found.value(0, j)) < 2e-4);
}

TEST_CASE("the tolerance of a polarised albedo must be positive") {
  CHECK_THROWS_AS(
      polarized_albedo(GgxSlopes<double>(0.3), {0, 0, 1}, polarized(Conductor<double>(1.5, 0)), 0.0),
      std::invalid_argument);
}
