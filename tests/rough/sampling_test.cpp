// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdlib>
#include <random>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/rough_albedo.hpp>
#include <vcavity/rough/rough_bsdf.hpp>
#include <vector>

#include "bsdf/chi_square.hpp"
#include "support/catch.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// Rough surfaces and directions of all kinds, up to grazing.
class Situations {
 public:
  explicit Situations(unsigned seed) : random_(seed) {}
  float uniform() { return std::uniform_real_distribution<float>(0, 1)(random_); }
  float roughness() { return std::pow(10.0f, -3 + 3.5f * uniform()); }
  Vec2<float> point() {
    const float x = uniform();
    return {x, uniform()};
  }
  Vec3<float> direction() {
    const float azimuth = 2 * pi<float>() * uniform();
    const float tilt = uniform() < 0.5f ? uniform() : std::pow(10.0f, -8 * uniform());
    const float across = std::sqrt(1 - tilt * tilt);
    return {across * std::sin(azimuth), across * std::cos(azimuth), tilt};
  }

 private:
  std::mt19937 random_;
};

/// As many samples as the environment asks for, for a run of hours: 1e8 for a release.
int samples_of(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

const Conductor<double> metal(0.2, 3);

/// χ² of the directions that are drawn for light from θ against the integral of `evaluate` over bins. These are parts of
/// rings and sectors about the mirror direction in the projected disc, h = e + o: so quadrature takes the pole at
/// h = 0 away.
template <class Distribution>
double p_of_directions(const Distribution& distribution, double theta, unsigned seed) {
  constexpr int rings = 6, sectors = 8, samples = 40000;
  const auto white = [](double) { return 1.0; };
  const RoughGrooveBsdf bsdf(distribution, white, 32, LongWays::without_loss);
  const Vec3<double> e = direction(radians(theta), 0.0);
  const double largest_size = 1 + std::hypot(e.x, e.y);
  const auto ring_end = [&](int ring) { return largest_size * ring * ring / (rings * rings); };
  const auto bin = [](int ring, int sector) {
    return static_cast<std::size_t>(std::min(ring, rings - 1) * sectors + std::min(sector, sectors - 1));
  };
  std::vector<double> counts(rings * sectors, 0), expected(rings * sectors, 0);

  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < samples; ++i) {
    const double u = unit(random), u_slope = unit(random), u_azimuth = unit(random);
    const auto sample = bsdf.sample(e, u, {u_slope, u_azimuth});
    if (!sample) continue;
    const double x = sample->direction.x + e.x, y = sample->direction.y + e.y;
    const double turns = std::atan2(x, y) / (2 * pi<double>()) + 0.5;
    const double size = std::hypot(x, y) / largest_size;
    ++counts[bin(static_cast<int>(rings * std::sqrt(size)), static_cast<int>(sectors * turns))];
  }

  // ∫ f cos θ_o dω_o = ∫∫ f cos θ_o |h|/o_z d|h| dψ, with nodes crowded at both ends for the root at the horizon.
  constexpr int radii = 40, angles = 160;
  for (int i = 0; i < angles; ++i) {
    const double turns = (i + 0.5) / angles;
    const Vec2<double> y{std::sin(2 * pi<double>() * (turns - 0.5)),
                         std::cos(2 * pi<double>() * (turns - 0.5))};
    const double toward = e.x * y.x + e.y * y.y;
    const double end = toward + std::sqrt(toward * toward + e.z * e.z);
    for (int ring = 0; ring < rings; ++ring)
      for (int j = 0; j < radii; ++j) {
        const double low = ring_end(ring), high = std::min(ring_end(ring + 1), end);
        if (!(low < high)) break;
        const double u = (j + 0.5) / radii;
        const double size = low + (high - low) * u * u * (3 - 2 * u);
        const double weight = (high - low) * 6 * u * (1 - u) / radii * 2 * pi<double>() / angles;
        const Vec2<double> flat{size * y.x - e.x, size * y.y - e.y};
        const double height2 = 1 - flat.x * flat.x - flat.y * flat.y;
        if (!(height2 > 0)) continue;
        const Vec3<double> o{flat.x, flat.y, std::sqrt(height2)};
        expected[bin(ring, static_cast<int>(sectors * turns))] +=
            samples * bsdf.evaluate(e, o) * size / o.z * weight;
      }
  }
  return p_value(counts, expected);
}

}  // namespace

TEST_CASE("no sample is lost and none weighs more than 1, in float, from smooth to rough and up to grazing") {
  Situations situations(1);
  const auto check = [&](const auto& distribution, int draws, int& lost, int& heavy) {
    const RoughGrooveBsdf bsdf(distribution, Conductor<float>(0.2f, 3.0f), 32, LongWays::without_loss);
    for (int draw = 0; draw < draws; ++draw) {
      const auto sample = bsdf.sample(situations.direction(), situations.uniform(), situations.point());
      lost += !sample;
      heavy += sample && !(sample->weight <= 1 + 1e-6f);
    }
  };
  int lost = 0, heavy = 0;
  constexpr int draws = 200;
  const int trials = samples_of("VCAVITY_ROUGH_SAMPLES", 1'000'000) / (2 * draws);
  for (int trial = 0; trial < trials; ++trial) {
    check(GgxSlopes<float>(situations.roughness(), situations.roughness()), draws, lost, heavy);
    check(BeckmannSlopes<float>(situations.roughness(), situations.roughness()), draws, lost, heavy);
  }
  CHECK(lost == 0);
  CHECK(heavy == 0);
}

TEST_CASE("directions are drawn as the BRDF says") {
  // 24 tests, each with its part of the false alarms.
  unsigned seed = 1;
  for (const double theta : {0.0, 30.0, 60.0, 85.0})
    for (const double roughness : {0.3, 0.6, 1.0}) {
      CAPTURE(theta, roughness);
      CHECK(p_of_directions(BeckmannSlopes<double>(roughness), theta, seed++) > false_alarm_rate / 24);
      CHECK(p_of_directions(GgxSlopes<double>(roughness), theta, seed++) > false_alarm_rate / 24);
    }
}

TEST_CASE("the mean weight of samples is the albedo") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto check = [&](const auto& distribution, double theta) {
    CAPTURE(theta);
    const RoughGrooveBsdf bsdf(distribution, metal, 256);
    const Vec3<double> e = direction(radians(theta), 0.8);
    constexpr int samples = 10000;
    double sum = 0, squares = 0;
    for (int i = 0; i < samples; ++i) {
      const double u = unit(random), u_slope = unit(random), u_azimuth = unit(random);
      const auto sample = bsdf.sample(e, u, {u_slope, u_azimuth});
      const double weight = sample ? sample->weight : 0;
      sum += weight;
      squares += weight * weight;
    }
    const double mean = sum / samples;
    const double deviation = std::sqrt((squares / samples - mean * mean) / samples);
    const double expected = directional_albedo(distribution, e, metal, 5e-4).value;
    // Six normal deviates beyond 4.5 of their deviations: a false alarm in 2e4 runs.
    CHECK(std::abs(mean - expected) < 4.5 * deviation + 1e-4);
  };
  for (const double theta : {0.0, 80.0}) {
    check(GgxSlopes<double>(0.8), theta);
    check(BeckmannSlopes<double>(0.2, 0.6), theta);
  }
  check(BrushedSlopes(BeckmannSlopes<double>(0.5), 6.0), 30);
  check(BrushedSlopes(GgxSlopes<double>(0.3), 100.0), 70);
}

TEST_CASE("samples carry the BRDF and the density of their direction") {
  Situations situations(3);
  const RoughGrooveBsdf bsdf(GgxSlopes<float>(0.5f), Conductor<float>(0.2f, 3.0f));
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3<float> wo = situations.direction();
    const auto sample = bsdf.sample(wo, situations.uniform(), situations.point());
    if (!sample || sample->probability > 1e6f) continue;  // next to the focus rounding is all
    const auto both = bsdf.evaluate_with_pdf(wo, sample->direction);
    CHECK(sample->probability == Approx(both.pdf));
    CHECK(sample->probability * sample->weight == Approx(both.value));
    CHECK(bsdf.pdf(wo, sample->direction) == Approx(both.pdf));
    CHECK(bsdf.evaluate(wo, sample->direction) == Approx(both.value));
  }
}
