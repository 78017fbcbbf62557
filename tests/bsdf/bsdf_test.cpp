// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <type_traits>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "bsdf/chi_square.hpp"
#include "support/catch.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// Random grooves and directions, grazing ones included.
class Situations {
 public:
  explicit Situations(unsigned seed) : random_(seed) {}
  float uniform() { return std::uniform_real_distribution<float>(0, 1)(random_); }
  Cavity<float> cavity() { return Cavity<float>(radians(2 + 178 * uniform())); }
  Vec3<float> direction() { return vcavity::direction(std::acos(uniform()), 2 * pi<float>() * uniform()); }

 private:
  std::mt19937 random_;
};

const Conductor<glm::vec3> copper({0.21f, 1.12f, 1.21f}, {3.61f, 2.60f, 2.30f});

const auto white = [](float) { return 1.0f; };

}  // namespace

TEST_CASE("lobes are drawn as often as their probabilities say") {
  Situations situations(1);
  for (const LobeChoice choice : {LobeChoice::by_weight, LobeChoice::by_energy})
    for (int trial = 0; trial < 50; ++trial) {
      const GrooveBsdf bsdf(situations.cavity(), copper, choice);
      const Vec3<float> wo = situations.direction();
      const auto lobes = bsdf.lobes(wo);
      const auto odds = bsdf.probabilities(lobes);
      constexpr int draws = 20000;
      std::vector<double> counts(lobes.size(), 0), expected;
      for (std::size_t i = 0; i < lobes.size(); ++i) expected.push_back(draws * double(odds[i]));
      int strangers = 0;
      for (int draw = 0; draw < draws; ++draw) {
        const auto sample = bsdf.sample(wo, situations.uniform());
        REQUIRE(sample);
        bool found = false;
        for (std::size_t i = 0; i < lobes.size() && !found; ++i)
          if (sample->bounces == lobes[i].bounces && sample->first_panel == lobes[i].first_panel) {
            CHECK(sample->direction == lobes[i].direction);
            CHECK(sample->probability == Approx(odds[i]));
            ++counts[i];
            found = true;
          }
        strangers += !found;
      }
      CHECK(strangers == 0);
      CHECK(p_value(counts, expected) > false_alarm_rate / 100);  // of 100 tests together
    }
}

TEST_CASE("probabilities are the fractions of the opening, or of the reflected light") {
  const Cavity<float> cavity(radians(50.0f));
  const Vec3<float> wo = direction(radians(20.0f), radians(30.0f));
  const Conductor<float> metal(1.17f, 2.4f);
  const GrooveBsdf by_weight(cavity, metal, LobeChoice::by_weight);
  const GrooveBsdf by_energy(cavity, metal, LobeChoice::by_energy);
  const auto lobes = by_weight.lobes(wo);
  REQUIRE(lobes.size() >= 3);
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    CHECK(by_weight.probabilities(lobes)[i] == Approx(lobes[i].weight));
    CHECK(by_energy.probabilities(lobes)[i] ==
          Approx(lobes[i].weight * lobes[i].throughput / by_energy.albedo(wo)));
  }
}

TEST_CASE("the mean weight of samples is the albedo, in every colour") {
  // Exact expectation over the discrete distribution: no noise, only rounding.
  Situations situations(2);
  for (const LobeChoice choice : {LobeChoice::by_weight, LobeChoice::by_energy})
    for (int trial = 0; trial < 500; ++trial) {
      const GrooveBsdf bsdf(situations.cavity(), copper, choice);
      const Vec3<float> wo = situations.direction();
      const auto odds = bsdf.probabilities(bsdf.lobes(wo));
      glm::vec3 mean(0);
      float middle = 0;
      for (const float probability : odds) {
        if (!(probability > 0)) continue;
        const auto sample = bsdf.sample(wo, middle + probability / 2);
        REQUIRE(sample);
        mean += sample->probability * sample->weight;
        middle += probability;
      }
      for (int colour = 0; colour < 3; ++colour)
        CHECK(mean[colour] == Approx(bsdf.albedo(wo)[colour]).epsilon(1e-5));
    }
}

TEST_CASE("a white furnace stays white with one sample") {
  Situations situations(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const GrooveBsdf bsdf(situations.cavity(), white);
    const auto sample = bsdf.sample(situations.direction(), situations.uniform());
    REQUIRE(sample);
    CHECK(sample->weight == Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("samples by energy of one wavelength carry no noise but the direction") {
  Situations situations(4);
  const Conductor<float> metal(1.17f, 2.4f);
  for (int trial = 0; trial < 2000; ++trial) {
    const GrooveBsdf bsdf(situations.cavity(), metal);
    const Vec3<float> wo = situations.direction();
    const auto sample = bsdf.sample(wo, situations.uniform());
    REQUIRE(sample);
    CHECK(sample->weight == Approx(bsdf.albedo(wo)).epsilon(1e-5));
  }
}

TEST_CASE("both transport directions: power between two directions is the same there and back") {
  Situations situations(5);
  const Conductor<double> metal(1.17, 2.4);
  int compared = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Cavity<double> cavity(situations.cavity().aperture());
    const GrooveBsdf bsdf(cavity, metal);
    const Vec3<double> wo(situations.direction());
    for (const auto& there : bsdf.lobes(wo))
      for (const auto& back : bsdf.lobes(there.direction)) {
        const Vec3<double> miss = back.direction - wo;
        if (back.bounces != there.bounces || std::abs(miss.y) + std::abs(miss.z) > 1e-6) continue;
        CHECK(wo.z * there.weight * there.throughput ==
              Approx(there.direction.z * back.weight * back.throughput).epsilon(1e-5).margin(1e-7));
        ++compared;
      }
  }
  CHECK(compared > 1500);
}

TEST_CASE("random numbers at either end of their range draw lobes of the groove") {
  Situations situations(6);
  const float below_one = std::nextafter(1.0f, 0.0f);
  for (int trial = 0; trial < 2000; ++trial) {
    const GrooveBsdf bsdf(situations.cavity(), copper,
                          trial % 2 == 0 ? LobeChoice::by_weight : LobeChoice::by_energy);
    const Vec3<float> wo = situations.direction();
    for (const float u : {0.0f, std::numeric_limits<float>::denorm_min(), below_one, 1.0f}) {
      const auto sample = bsdf.sample(wo, u);
      REQUIRE(sample);
      CHECK(sample->probability > 0);
      CHECK(sample->probability <= 1);
      CHECK(largest(sample->weight) <= 4);
      CHECK(largest(sample->weight) > 0);
    }
  }
}

TEST_CASE("a lobe that reflects nothing is never drawn, even where rounding leaves a gap") {
  using detail::choose;
  const std::array<float, 4> odds{0.0f, 0.25f, 0.0f, 0.0f};
  for (const float u : {0.0f, 0.2f, 0.25f, 0.9f, 1.0f}) CHECK(choose(odds, 4, u) == 1);
  const std::array<float, 4> nothing{};
  CHECK(choose(nothing, 4, 0.5f) == 4);
  CHECK(choose(nothing, 0, 0.5f) == 0);
}

TEST_CASE("no light is drawn below the horizon, from there, or from nowhere") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const GrooveBsdf bsdf(Cavity<float>(radians(60.0f)), copper);
  for (const Vec3<float>& wo :
       {Vec3<float>{0, 0, -1}, Vec3<float>{0.6f, 0, -0.8f}, Vec3<float>{1, 0, -1e-30f},
        Vec3<float>{nan, nan, nan}, Vec3<float>{0, nan, 1}}) {
    CHECK_FALSE(bsdf.sample(wo, 0.5f));
    CHECK(bsdf.lobes(wo).size() == 0);
    CHECK(bsdf.albedo(wo) == glm::vec3(0));
  }
  Situations situations(7);
  for (int trial = 0; trial < 20000; ++trial) {
    // Rounding puts light below the horizon where the groove is almost flat.
    const Cavity<float> flat(std::nextafter(pi<float>(), 0.0f));
    const GrooveBsdf grooves(trial % 2 == 0 ? flat : situations.cavity(), white);
    const float tilt = std::pow(10.0f, -8 * situations.uniform());
    const float azimuth = 2 * pi<float>() * situations.uniform();
    const Vec3<float> grazing = direction(std::acos(tilt), azimuth);
    const auto sample = grooves.sample({grazing.x, grazing.y, tilt}, situations.uniform());
    REQUIRE(sample);
    CHECK(sample->direction.z >= 0);
    CHECK(glm::dot(sample->direction, sample->direction) == Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("a black groove and a bounce limit lose light, not samples") {
  const auto black = [](float) { return 0.0f; };
  const Vec3<float> wo = direction(radians(45.0f), radians(10.0f));
  CHECK_FALSE(GrooveBsdf(Cavity<float>(radians(60.0f)), black).sample(wo, 0.5f));
  const GrooveBsdf single(Cavity<float>(radians(60.0f)), white, LobeChoice::by_weight, 1);
  const auto sample = single.sample(wo, 0.5f);
  REQUIRE(sample);
  CHECK(sample->bounces == 1);
  CHECK(sample->weight == Approx(single.albedo(wo)));
  CHECK(single.albedo(wo) < 0.9f);
}

TEST_CASE("nothing but its discrete directions: evaluate and pdf are zero") {
  const GrooveBsdf bsdf(Cavity<float>(radians(60.0f)), copper);
  const Vec3<float> wo = direction(radians(20.0f), radians(30.0f));
  const auto sample = bsdf.sample(wo, 0.5f);
  REQUIRE(sample);
  CHECK(bsdf.evaluate(wo, sample->direction) == glm::vec3(0));
  CHECK(bsdf.pdf(wo, sample->direction) == 0.0f);
}

TEST_CASE("packs of wavelengths are drawn like single ones") {
  using Spectrum = Pack<float, 4>;
  const Conductor<Spectrum> facet(Spectrum({0.2f, 1.1f, 1.2f, 1.3f}), Spectrum({3.6f, 2.6f, 2.3f, 2.2f}));
  const GrooveBsdf bsdf(Cavity<float>(radians(45.0f)), facet);
  const Vec3<float> wo = direction(radians(35.0f), radians(70.0f));
  const auto sample = bsdf.sample(wo, 0.3f);
  REQUIRE(sample);
  for (std::size_t i = 0; i < 4; ++i) {
    const Conductor<float> one(std::array{0.2f, 1.1f, 1.2f, 1.3f}[i], std::array{3.6f, 2.6f, 2.3f, 2.2f}[i]);
    const auto lobes = GrooveBsdf(Cavity<float>(radians(45.0f)), one).lobes(wo);
    for (const auto& lobe : lobes)
      if (lobe.direction == sample->direction)
        CHECK(sample->weight[i] * sample->probability == Approx(lobe.weight * lobe.throughput).epsilon(1e-5));
  }
}

TEST_CASE("a groove that is made where it stays, by adding angles, is drawn from like any other") {
  Situations situations(21);
  int made = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const float aperture = radians(2 + 178 * situations.uniform()), u = situations.uniform();
    const Vec3<float> wo = situations.direction();
    const GrooveBsdf expected(Cavity<float>(aperture), copper, LobeChoice::by_weight, 20);
    const GrooveBsdf bsdf(
        [&] {
          ++made;
          return Cavity<float>::by_addition(aperture);
        },
        copper, LobeChoice::by_weight, 20);
    STATIC_REQUIRE(std::is_same_v<decltype(bsdf), decltype(expected)>);
    CAPTURE(degrees(aperture), wo.x, wo.y, wo.z, u);
    CHECK(glm::distance(bsdf.albedo(wo), expected.albedo(wo)) < 2e-5f);
    const auto sample = bsdf.sample(wo, u), same = expected.sample(wo, u);
    REQUIRE(sample.has_value() == same.has_value());
    // Next to the border between two lobes either may be drawn.
    if (!sample || sample->bounces != same->bounces || sample->first_panel != same->first_panel) continue;
    CHECK(glm::distance(sample->direction, same->direction) < 1e-5f);
    CHECK(std::abs(sample->probability - same->probability) < 2e-5f);
  }
  CHECK(made == 1000);
}
