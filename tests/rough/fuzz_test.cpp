// SPDX-License-Identifier: BSD-3-Clause
/// Directions of every kind, those of rounding and those of mistakes included.

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/rough_bsdf.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

using Rgb = Pack<float, 3>;

/// Random directions and surfaces, hard ones more often than chance would have it.
class Fuzz {
 public:
  float unit() { return std::uniform_real_distribution<float>(0, 1)(random_); }
  unsigned pick(unsigned size) { return static_cast<unsigned>(random_()) % size; }
  float log_uniform(float low, float high) { return low * std::pow(high / low, unit()); }

  Vec3<float> direction() {
    const float azimuth =
        pick(3) == 0 ? static_cast<float>(pick(8)) * pi<float>() / 4 : 2 * pi<float>() * unit();
    const std::array heights{
        0.0f, 1e-45f, 1e-38f, 1.0f, unit(), log_uniform(1e-38f, 1), 1 - log_uniform(1e-8f, 1)};
    const float height = heights[pick(heights.size())];
    const float across = std::sqrt(1 - height * height);
    return {across * std::sin(azimuth), across * std::cos(azimuth), height};
  }

  /// Another one: any, the same, in the mirror direction or the fraction of a rounding error beside these.
  Vec3<float> other(const Vec3<float>& e) {
    const float nudge = 1 + static_cast<float>(pick(5)) * std::numeric_limits<float>::epsilon();
    switch (pick(4)) {
      case 0:
        return {e.x, e.y * nudge, e.z};
      case 1:
        return {-e.x * nudge, -e.y, e.z};
      case 2:
        return {-e.x, -e.y, e.z * nudge};
      default:
        return direction();
    }
  }

 private:
  std::mt19937 random_{20261126};
};

template <class Distribution>
void check(Fuzz& fuzz, const Distribution& distribution) {
  const Conductor<Rgb> metal(Rgb(std::array{0.2f, 0.9f, 1.2f}), Rgb(std::array{3.4f, 2.6f, 2.3f}));
  const int limit = fuzz.pick(100) == 0 ? 4096 : 1 + static_cast<int>(fuzz.pick(40));
  const RoughGrooveBsdf bsdf(distribution, metal, limit,
                             fuzz.pick(2) == 0 ? LongWays::lost : LongWays::without_loss);
  const Vec3<float> wo = fuzz.direction(), wi = fuzz.other(wo);
  CAPTURE(wo.x, wo.y, wo.z, wi.x, wi.y, wi.z, limit);
  constexpr float most = std::numeric_limits<float>::max();
  const auto [value, pdf] = bsdf.evaluate_with_pdf(wo, wi);
  REQUIRE(pdf >= 0);
  REQUIRE(pdf <= most);
  for (const float part : value) {
    REQUIRE(part >= 0);
    REQUIRE(part <= pdf * (1 + 1e-5f));
  }
  REQUIRE(bsdf.pdf(wo, wi) == Approx(pdf).epsilon(1e-5).margin(1e-30));
  const auto sample = bsdf.sample(wo, fuzz.unit(), {fuzz.unit(), fuzz.unit()});
  if (!sample) return;
  REQUIRE(largest(sample->weight) <= 1 + 1e-6f);
  REQUIRE(sample->probability > 0);
  REQUIRE(sample->direction.z >= 0);
  const Vec3<float>& d = sample->direction;
  REQUIRE(d.x * d.x + d.y * d.y + d.z * d.z == Approx(1).epsilon(1e-5));
}

}  // namespace

TEST_CASE(
    "whatever the directions, values are finite, no reflectance exceeds 1 and samples are unit vectors") {
  Fuzz fuzz;
  for (int trial = 0; trial < 5000; ++trial) {
    const float a = fuzz.log_uniform(1e-3f, 30), b = fuzz.pick(2) == 0 ? a : fuzz.log_uniform(1e-3f, 30);
    CAPTURE(a, b);
    check(fuzz, GgxSlopes<float>(a, b));
    check(fuzz, BeckmannSlopes<float>(a, b));
  }
  for (int trial = 0; trial < 50; ++trial)
    check(fuzz, BrushedSlopes(GgxSlopes<float>(fuzz.log_uniform(1e-3f, 30)), fuzz.log_uniform(1e-3f, 1e6f)));
}

TEST_CASE("directions that are no directions do no harm") {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  const RoughGrooveBsdf bsdf(GgxSlopes<float>(0.3f), Conductor<float>(0.2f, 3.0f));
  const std::array<float, 6> numbers{0, -1, 1, nan, infinite, -infinite};
  for (const float x : numbers)
    for (const float z : numbers) {
      const Vec3<float> wrong{x, 0.5f, z}, right{0.6f, 0, 0.8f};
      static_cast<void>(bsdf.evaluate(wrong, right));
      static_cast<void>(bsdf.evaluate(right, wrong));
      const auto sample = bsdf.sample(wrong, 0.5f, {0.5f, 0.5f});
      if (!(z >= 0)) CHECK_FALSE(sample);
      if (z < 0) CHECK(bsdf.pdf(right, wrong) == 0);
    }
}
