// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

const Polarized<Conductor<double>> metal(Conductor<double>(1.17, 2.4));

template <class Check>
void for_each_element(const Mueller<double>& a, const Mueller<double>& b, Check&& check) {
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) check(a(row, column), b(row, column));
}

}  // namespace

TEST_CASE("light that travels a lobe backwards has the reversed Mueller matrix of the lobe") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  int compared = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const GrooveBsdf bsdf(Cavity<double>(radians(20 + 160 * unit(random))), metal);
    const Vec3<double> e = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
    for (const auto& there : bsdf.lobes(e))
      for (const auto& back : bsdf.lobes(there.direction)) {
        const Vec3<double> miss = back.direction - e;
        if (back.bounces != there.bounces || std::abs(miss.y) + std::abs(miss.z) > 1e-9) continue;
        for_each_element(power(back.throughput), reversed(power(there.throughput)),
                         [](double a, double b) { CHECK(a == Approx(b).margin(1e-9)); });
        ++compared;
      }
  }
  CHECK(compared > 800);
}

TEST_CASE("samples of polarised light add up to the Mueller matrix of the groove, both ways") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const LobeChoice choice : {LobeChoice::by_weight, LobeChoice::by_energy})
    for (int trial = 0; trial < 200; ++trial) {
      const GrooveBsdf bsdf(Cavity<double>(radians(20 + 160 * unit(random))), metal, choice);
      const Vec3<double> wo = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
      Mueller<double> to_wo(0), from_wo(0);
      double middle = 0;
      for (const double probability : bsdf.probabilities(bsdf.lobes(wo))) {
        if (!(probability > 0)) continue;
        const auto radiance = bsdf.sample(wo, middle + probability / 2);
        const auto importance = bsdf.sample(wo, middle + probability / 2, Transport::importance);
        REQUIRE(radiance);
        REQUIRE(importance);
        to_wo = to_wo + radiance->probability * radiance->weight;
        from_wo = from_wo + importance->probability * importance->weight;
        middle += probability;
      }
      const auto check = [](double a, double b) { CHECK(a == Approx(b).margin(1e-12)); };
      for_each_element(from_wo, bsdf.albedo(wo), check);
      for_each_element(to_wo, reversed(bsdf.albedo(wo)), check);
    }
}

TEST_CASE("narrow spread lobes carry the Mueller matrices of infinitely narrow ones") {
  const GrooveBsdf grooves(Cavity<double>(radians(50.0)), metal);
  const SpreadGrooveBsdf bsdf(grooves, 1e-4);
  const Vec3<double> wo = direction(radians(20.0), radians(30.0));
  for (const Transport transport : {Transport::radiance, Transport::importance})
    for (const double u : {0.1, 0.5, 0.9}) {
      const auto wide = bsdf.sample(wo, u, {0.5, 0.25}, transport);
      const auto narrow = grooves.sample(wo, u, transport);
      REQUIRE(wide);
      REQUIRE(narrow);
      for_each_element(wide->weight, narrow->weight,
                       [](double a, double b) { CHECK(a == Approx(b).margin(1e-9)); });
    }
}

TEST_CASE("spread lobes of polarised light: what goes one way is the reverse of what goes the other") {
  const SpreadGrooveBsdf bsdf(GrooveBsdf(Cavity<double>(radians(50.0)), metal), 0.1);
  const Vec3<double> wo = direction(radians(20.0), radians(30.0));
  double sense = 0;
  for (const double u : {0.1, 0.5, 0.9}) {
    const auto sample = bsdf.sample(wo, u, {0.3, 0.6});
    REQUIRE(sample);
    const Vec3<double>& wi = sample->direction;
    const Mueller<double> radiance = bsdf.evaluate(wo, wi, Transport::radiance);
    const Mueller<double> importance = bsdf.evaluate(wo, wi, Transport::importance);
    for_each_element(radiance, reversed(importance),
                     [](double a, double b) { CHECK(a == Approx(b).margin(1e-14)); });
    // What is drawn is what is evaluated, the other way as well.
    for_each_element(sample->probability * sample->weight, radiance,
                     [](double a, double b) { CHECK(a == Approx(b).margin(1e-12)); });
    const auto forwards = bsdf.sample(wo, u, {0.3, 0.6}, Transport::importance);
    REQUIRE(forwards);
    for_each_element(forwards->probability * forwards->weight, importance,
                     [](double a, double b) { CHECK(a == Approx(b).margin(1e-12)); });
    sense += std::abs(radiance(0, 2) - importance(0, 2));
  }
  CHECK(sense > 1e-3);  // the two differ, or nothing has been tested
}
