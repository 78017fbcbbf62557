// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "bsdf/chi_square.hpp"
#include "support/catch.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

const Conductor<double> metal(1.17, 2.4);

/// Integral of f over the hemisphere by midpoints of equal steps in θ and φ.
template <class Function>
double integral_over_hemisphere(Function&& f, int rings) {
  double sum = 0;
  const double step = pi<double>() / 2 / rings;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < 4 * rings; ++j) {
      const double theta = (i + 0.5) * step;
      sum += std::sin(theta) * f(direction(theta, (j + 0.5) * step));
    }
  return sum * step * step;
}

}  // namespace

TEST_CASE("the density of directions integrates to one, and the BSDF to the albedo") {
  for (const double aperture_deg : {40.0, 90.0, 160.0})
    for (const double theta_deg : {20.0, 50.0, 85.0})
      for (const double width : {0.1, 0.3, 3.0}) {
        const GrooveBsdf grooves(Cavity<double>(radians(aperture_deg)), metal);
        const SpreadGrooveBsdf bsdf(grooves, width);
        const Vec3<double> wo = direction(radians(theta_deg), radians(33.0));
        CAPTURE(aperture_deg, theta_deg, width);
        const auto pdf = [&](const Vec3<double>& wi) { return bsdf.pdf(wo, wi); };
        const auto value = [&](const Vec3<double>& wi) { return bsdf.evaluate(wo, wi); };
        CHECK(integral_over_hemisphere(pdf, 200) == Approx(1).epsilon(1e-4));
        CHECK(integral_over_hemisphere(value, 200) == Approx(bsdf.albedo(wo)).epsilon(1e-4));
      }
}

TEST_CASE("directions are drawn with the density that pdf tells") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr int rings = 12, sectors = 24, draws = 100000, fine = 8;
  for (const double width : {0.1, 0.5}) {
    for (const LobeChoice choice : {LobeChoice::by_weight, LobeChoice::by_energy})
      for (const double theta_deg : {10.0, 80.0}) {
        const SpreadGrooveBsdf bsdf(GrooveBsdf(Cavity<double>(radians(70.0)), metal, choice), width);
        const Vec3<double> wo = direction(radians(theta_deg), radians(25.0));
        std::vector<double> counts(rings * sectors, 0), expected(rings * sectors, 0);
        const auto bin = [&](const Vec3<double>& d) {
          const double turn = std::atan2(d.x, d.y) / (2 * pi<double>());
          const int ring = std::min(rings - 1, static_cast<int>(d.z * rings));
          const int sector = std::min(sectors - 1, static_cast<int>((turn - std::floor(turn)) * sectors));
          return static_cast<std::size_t>(ring * sectors + sector);
        };
        for (int draw = 0; draw < draws; ++draw) {
          const double u = unit(random), v = unit(random), w = unit(random);
          const auto sample = bsdf.sample(wo, u, {v, w});
          REQUIRE(sample);
          ++counts[bin(sample->direction)];
        }
        constexpr int fine_rings = rings * fine, fine_sectors = sectors * fine;
        for (int i = 0; i < fine_rings; ++i)
          for (int j = 0; j < fine_sectors; ++j) {
            const Vec3<double> d =
                direction(std::acos((i + 0.5) / fine_rings), 2 * pi<double>() * (j + 0.5) / fine_sectors);
            expected[bin(d)] += draws * bsdf.pdf(wo, d) * 2 * pi<double>() / fine_rings / fine_sectors;
          }
        CAPTURE(width, theta_deg);
        CHECK(p_value(counts, expected) > false_alarm_rate / 8);  // of 8 tests together
      }
  }
}

TEST_CASE("a sample's weight is the BSDF over its density") {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> unit(0, 1);
  const Conductor<float> facet(1.17f, 2.4f);
  for (int trial = 0; trial < 2000; ++trial) {
    const GrooveBsdf grooves(Cavity<float>(radians(10 + 170 * unit(random))), facet, LobeChoice::by_weight);
    const SpreadGrooveBsdf bsdf(grooves, 0.01f + unit(random));
    const Vec3<float> wo = direction(std::acos(unit(random)), 6 * unit(random));
    const float u = unit(random), v = unit(random), w = unit(random);
    const auto sample = bsdf.sample(wo, u, {v, w});
    REQUIRE(sample);
    CHECK(sample->direction.z >= 0);
    CHECK(sample->probability == Approx(bsdf.pdf(wo, sample->direction)).epsilon(1e-3));
    CHECK(sample->weight * sample->probability == Approx(bsdf.evaluate(wo, sample->direction)).epsilon(1e-3));
  }
}

TEST_CASE("narrow lobes draw the directions of infinitely narrow ones") {
  const GrooveBsdf grooves(Cavity<float>(radians(50.0f)), Conductor<float>(1.17f, 2.4f));
  const SpreadGrooveBsdf bsdf(grooves, 1e-3f);
  const Vec3<float> wo = direction(radians(20.0f), radians(30.0f));
  for (const float u : {0.0f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    const auto wide = bsdf.sample(wo, u, {0.5f, 0.25f});
    const auto narrow = grooves.sample(wo, u);
    REQUIRE(wide);
    REQUIRE(narrow);
    CHECK(wide->bounces == narrow->bounces);
    CHECK(wide->weight == Approx(narrow->weight).epsilon(1e-3));
    const Vec3<float> shift = wide->direction - narrow->direction;
    // The median of a von Mises–Fisher distribution lies √(2 ln 2) widths off its mean.
    CHECK(std::sqrt(glm::dot(shift, shift)) == Approx(1e-3 * std::sqrt(2 * std::log(2.0))).epsilon(1e-2));
  }
}

TEST_CASE("random numbers at either end of their range give unit vectors and finite weights") {
  const float below_one = std::nextafter(1.0f, 0.0f);
  for (const float width : {1e-4f, 0.1f, 1.0f, 10.0f}) {
    const GrooveBsdf grooves(Cavity<float>(radians(50.0f)), Conductor<float>(1.17f, 2.4f));
    const SpreadGrooveBsdf bsdf(grooves, width);
    const Vec3<float> wo = direction(radians(20.0f), radians(30.0f));
    for (const float u : {0.0f, below_one, 1.0f})
      for (const float v : {0.0f, below_one, 1.0f}) {
        CAPTURE(width, u, v);
        const auto sample = bsdf.sample(wo, u, {v, 1 - v});
        if (!sample) {
          CHECK(v == 1.0f);  // the far tail, of density 0
          continue;
        }
        CHECK(glm::dot(sample->direction, sample->direction) == Approx(1).epsilon(1e-5));
        CHECK(sample->direction.z >= 0);
        CHECK(sample->weight > 0);
        CHECK(sample->weight <= 4);
      }
  }
}

TEST_CASE("lobes of a width reflect nothing below the horizon") {
  const SpreadGrooveBsdf bsdf(GrooveBsdf(Cavity<double>(radians(60.0)), metal), 0.2);
  const Vec3<double> above = direction(radians(20.0), radians(30.0));
  const Vec3<double> below{0.6, 0, -0.8};
  CHECK(bsdf.evaluate(above, below) == 0);
  CHECK(bsdf.evaluate(below, above) == 0);
  CHECK(bsdf.pdf(above, below) == 0);
  CHECK(bsdf.pdf(below, above) == 0);
  CHECK_FALSE(bsdf.sample(below, 0.5, {0.5, 0.5}));
}

TEST_CASE("widths that are no widths are refused with their value") {
  const GrooveBsdf grooves(Cavity<float>(radians(60.0f)), Conductor<float>(1.17f, 2.4f));
  for (const float width : {0.0f, -1.0f, 11.0f, 1e-30f, std::numeric_limits<float>::quiet_NaN()})
    CHECK_THROWS_WITH(SpreadGrooveBsdf(grooves, width),
                      Catch::Matchers::ContainsSubstring("width of a lobe"));
}

TEMPLATE_TEST_CASE("both ends of the random numbers draw a direction, whatever the width", "", float,
                   double) {
  using Real = TestType;
  const GrooveBsdf grooves(Cavity<Real>(radians(Real(60))), Conductor<Real>(Real(0.1249), Real(3.3391)));
  for (const Real& width :
       {VonMisesFisher<Real>::smallest_width(), Real(1e-4), Real(0.02), Real(1), Real(10)}) {
    const SpreadGrooveBsdf bsdf(grooves, width);
    for (const Real& u_lobe : {Real(0), Real(0.5), Real(1)})
      for (const Real& u_x : {Real(0), Real(0.5), Real(1)})
        for (const Real& u_y : {Real(0), Real(0.5), Real(1)})
          for (const Real& theta : {Real(0), Real(0.8), Real(1.55)}) {
            const auto sample = bsdf.sample(direction(theta, Real(0.7)), u_lobe, {u_x, u_y});
            CAPTURE(width, u_lobe, u_x, u_y, theta);
            REQUIRE(sample);
            CHECK(sample->probability > 0);
            CHECK(std::isfinite(sample->probability));
            CHECK(sample->weight > 0);
            CHECK(sample->weight <= Real(1.0001));
          }
  }
}
