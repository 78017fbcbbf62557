// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <random>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/facet/rational_facet.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/lockstep_rough_bsdf.hpp>
#include <vcavity/rough/rough_bsdf.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

Vec3<double> direction(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double azimuth = 2 * pi<double>() * uniform(random), z = uniform(random);
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(azimuth), across * std::sin(azimuth), z};
}

const Conductor<double> metal(0.2, 2.0);

template <class Distribution, class Facet = Conductor<double>>
struct Surface {
  Distribution distribution;
  Facet reflectance = metal;

  const Distribution& slopes() const { return distribution; }
  const Facet& facet() const { return reflectance; }
};

template <class Distribution, class Facet = Conductor<double>>
void check(const Distribution& distribution, int max_bounces, const Facet& facet = metal) {
  const Surface<Distribution, Facet> surface{distribution, facet};
  const RoughGrooveBsdf one_by_one(distribution, surface.facet(), max_bounces);
  const LockstepRoughBsdf lockstep(surface, max_bounces);
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3<double> wo = direction(random), wi = direction(random);
    const auto expected = one_by_one.evaluate_with_pdf(wo, wi);
    const auto found = lockstep.evaluate_with_pdf(wo, wi);
    // An exponential has the absolute error of its exponent as a relative one.
    const double exponent = expected.pdf > 0 ? std::fabs(std::log(expected.pdf)) : 0;
    const double rounding = 1e-13 + std::numeric_limits<double>::epsilon() * exponent;
    REQUIRE(found.pdf == Approx(expected.pdf).epsilon(rounding));
    REQUIRE(found.value == Approx(expected.value).epsilon(1e-12));
    REQUIRE(lockstep.pdf(wo, wi) == Approx(expected.pdf).epsilon(rounding));
  }
}

}  // namespace

TEST_CASE("A rough surface in lockstep has the values of one direction after the other") {
  for (const int max_bounces : {1, 2, 3, 12, 32}) {
    check(GgxSlopes(0.7), max_bounces);
    check(GgxSlopes(0.7), max_bounces, RationalFacet<double>(metal));
    check(GgxSlopes(0.1, 1.5), max_bounces);
    check(BeckmannSlopes(0.9), max_bounces);
    check(BrushedSlopes(GgxSlopes(1.2), 10.0), max_bounces);
  }
}

TEST_CASE("A rough surface in lockstep is black below the horizon, and knows the mirror direction") {
  const Surface<GgxSlopes<double>> surface{GgxSlopes(0.4)};
  const LockstepRoughBsdf bsdf(surface, 8);
  const RoughGrooveBsdf same(surface.slopes(), surface.facet(), 8);
  const Vec3<double> wo{0.6, 0, 0.8};
  for (const auto& below : {Vec3<double>{0.6, 0, -0.8}, Vec3<double>{0, 1, -1e-9}}) {
    CHECK(bsdf.evaluate_with_pdf(wo, below).value == 0);
    CHECK(bsdf.evaluate_with_pdf(below, wo).pdf == 0);
    CHECK(bsdf.pdf(wo, below) == 0);
  }
  const Vec3<double> mirrored{-0.6, 0, 0.8}, up{0, 0, 1};
  CHECK(bsdf.evaluate_with_pdf(wo, mirrored).value == Approx(same.evaluate(wo, mirrored)).epsilon(1e-14));
  CHECK(bsdf.evaluate_with_pdf(up, up).value == Approx(same.evaluate(up, up)).epsilon(1e-14));
}

TEST_CASE("A way drawn in lockstep is one of those that make up the density") {
  const Surface<BeckmannSlopes<double>> surface{BeckmannSlopes(0.9)};
  const LockstepRoughBsdf bsdf(surface, 32), one_bounce(surface, 1);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3<double> wo = direction(random);
    const auto drawn = bsdf.draw(wo, uniform(random), {uniform(random), uniform(random)});
    const Vec3<double> wi = drawn.ray.leaving();
    const auto alone = bsdf.evaluate_drawn(wo, wi, drawn, true);
    REQUIRE(alone.pdf > 0);
    REQUIRE(alone.pdf < bsdf.pdf(wo, wi) * (1 + 1e-6));
    REQUIRE(alone.value < alone.pdf);
    REQUIRE(bsdf.evaluate_drawn(wo, wi, drawn, false).pdf == 0);
    if (drawn.ray.way().bounces < 2)
      REQUIRE(alone.value == Approx(one_bounce.evaluate_with_pdf(wo, wi).value).epsilon(1e-6));
  }
}
