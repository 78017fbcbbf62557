// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

namespace {

using vcavity::Conductor;
using vcavity::GgxSlopes;
using vcavity::plan_rough_effects;

// Reflects all but 4e-7 of the light at each bounce.
const Conductor<double> almost_white(1e-3, 1e4);
const Conductor<double> silver(0.125, 3.34);
const Conductor<double> glass(1.5, 0.0);

}  // namespace

TEST_CASE("The plan of a rough surface bounds the light beyond its last bounce, and by little more") {
  struct Known {
    double roughness;
    int bounces;
    double lost;  // at normal incidence, by quadrature of the white BRDF
  };
  for (const auto& [roughness, bounces, lost] :
       {Known{0.3, 3, 1.8e-2}, {0.3, 8, 3.0e-3}, {1.0, 3, 0.166}, {1.0, 8, 3.2e-2}, {1.0, 16, 8.8e-3}}) {
    CAPTURE(roughness, bounces);
    // A tolerance in which the light beyond `bounces` has just room: polarisation hardly matters.
    const auto plan = plan_rough_effects(GgxSlopes<double>(roughness), almost_white, 1.8 * lost);
    CHECK(plan.max_bounces <= bounces);
    CHECK(plan.bounds.bounces <= 1.8 * lost);
    const auto stricter = plan_rough_effects(GgxSlopes<double>(roughness), almost_white, lost);
    CHECK(stricter.max_bounces > bounces);
  }
}

TEST_CASE("The plan of a rough surface bounds what is left out in directions that it has not looked at") {
  std::mt19937 random(20261126);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto check = [&](const auto& slopes, const auto& facet, double tolerance) {
    const auto plan = plan_rough_effects(slopes, facet, tolerance);
    for (int trial = 0; trial < 2; ++trial) {
      // As many directions at each elevation, up to 89.9°.
      const vcavity::Vec3<double> e =
          vcavity::direction(unit(random) * vcavity::radians(89.9), 2 * vcavity::pi<double>() * unit(random));
      constexpr double to = 3e-5;
      const auto albedo = [&](const auto& model, int bounces) {
        return directional_albedo(slopes, e, model, to, bounces).value;
      };
      CAPTURE(e.x, e.y, e.z, plan.max_bounces);
      const double all = albedo(facet, vcavity::all_bounces);
      CHECK(all - albedo(facet, plan.max_bounces) <= plan.bounds.bounces + 2 * to);
      if (!plan.polarization)
        CHECK(std::abs(albedo(polarized(facet), vcavity::all_bounces) - all) <=
              plan.bounds.polarization + 2 * to);
    }
  };
  for (const double roughness : {0.1, 1.0}) {
    CAPTURE(roughness);
    check(GgxSlopes<double>(roughness), silver, 1e-2);
    check(GgxSlopes<double>(roughness), glass, 5e-2);
    check(vcavity::BeckmannSlopes<double>(roughness, 0.3), silver, 2e-3);
  }
}

TEST_CASE("No more light is left out than there are grooves so narrow, which is known of GGX") {
  const double a = 0.3;
  const auto plan = plan_rough_effects(GgxSlopes<double>(a), almost_white, 2e-2);
  const double steepest = 1 / std::tan(vcavity::pi<double>() / (2 * plan.max_bounces));
  const double share = a * a / (a * a + steepest * steepest);
  CHECK(plan.bounds.bounces <= share * (1 + 1e-9));
  const double shorter = 1 / std::tan(vcavity::pi<double>() / (2 * (plan.max_bounces - 1)));
  CHECK(a * a / (a * a + shorter * shorter) > 2e-2 - plan.bounds.polarization);
}

TEST_CASE(
    "The errors of a plan for a rough surface add up to no more than the tolerance, and a looser one asks "
    "for no more") {
  for (const auto& facet : {silver, glass, almost_white}) {
    vcavity::EffectsPlan stricter{true, vcavity::all_bounces, true, {0, 0, 0, 0}};
    for (const double tolerance : {1e-4, 3e-4, 1e-3, 2e-3, 3e-3, 5e-3, 1e-2, 3e-2, 0.1, 0.3}) {
      CAPTURE(tolerance);
      const auto plan = plan_rough_effects(GgxSlopes<double>(0.6), facet, tolerance);
      CHECK(plan.bounds.polarization + plan.bounds.bounces <= tolerance);
      CHECK(plan.max_bounces <= stricter.max_bounces);
      CHECK((stricter.polarization || !plan.polarization));
      stricter = plan;
    }
  }
}

TEST_CASE("A rough surface that absorbs more calls for fewer bounces") {
  const GgxSlopes<double> slopes(0.6);
  const auto of_white = plan_rough_effects(slopes, almost_white, 1e-2);
  const auto of_silver = plan_rough_effects(slopes, silver, 1e-2);
  const auto of_glass = plan_rough_effects(slopes, glass, 1e-2);
  CHECK(of_white.max_bounces > of_silver.max_bounces);
  CHECK(of_silver.max_bounces > of_glass.max_bounces);
}

TEST_CASE("Rough glass calls for polarisation at a tolerance at which silver does not") {
  const GgxSlopes<double> slopes(0.5);
  CHECK(plan_rough_effects(slopes, glass, 1e-3).polarization);
  CHECK_FALSE(plan_rough_effects(slopes, silver, 1e-3).polarization);
}

TEST_CASE("The tolerance of a plan for a rough surface must be positive") {
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(plan_rough_effects(GgxSlopes<double>(0.5), silver, tolerance), std::invalid_argument);
}
