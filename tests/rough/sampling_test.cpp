// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/rough/elliptic_slopes.hpp>
#include <vcavity/rough/rough_bsdf.hpp>

#include "support/catch.hpp"

using namespace vcavity;

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

}  // namespace

TEST_CASE("no sample is lost and none weighs more than 1, in float, from smooth to rough and up to grazing") {
  Situations situations(1);
  const auto check = [&](const auto& distribution, int& lost, int& heavy) {
    const RoughGrooveBsdf bsdf(distribution, Conductor<float>(0.2f, 3.0f), 256, LongWays::without_loss);
    for (int draw = 0; draw < 50; ++draw) {
      const auto sample = bsdf.sample(situations.direction(), situations.uniform(), situations.point());
      lost += !sample;
      heavy += sample && !(sample->weight <= 1 + 1e-6f);
    }
  };
  int lost = 0, heavy = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    check(GgxSlopes<float>(situations.roughness(), situations.roughness()), lost, heavy);
    check(BeckmannSlopes<float>(situations.roughness(), situations.roughness()), lost, heavy);
  }
  CHECK(lost == 0);
  CHECK(heavy == 0);
}
