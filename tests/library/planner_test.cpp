// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vcavity/plan/planner.hpp>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

struct Scene {
  double aperture_deg, n, k;
  Cavity<double> cavity() const { return Cavity<double>(radians(aperture_deg)); }
  Conductor<double> facet() const { return {n, k}; }
};

/// Metals, dielectrics, indices close to 1 and below.
template <class Random>
Scene random_scene(Random& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double aperture_deg = unit(random) < 0.2 ? 180.0 / std::floor(1 + 9 * unit(random))
                                                 : std::exp(std::log(12.0) + std::log(15.0) * unit(random));
  const double kind = unit(random);
  if (kind < 0.25) return {aperture_deg, 1.2 + 2 * unit(random), 0};
  if (kind < 0.35) return {aperture_deg, 1 + std::exp(-8 * unit(random)), 0};
  if (kind < 0.45) return {aperture_deg, 0.4 + 0.6 * unit(random), 0};
  if (kind < 0.55) return {aperture_deg, 40 * unit(random), 100 * unit(random)};
  return {aperture_deg, 0.05 + 4 * unit(random), 6 * unit(random)};
}

template <class Random>
double random_tolerance(Random& random, double low, double high) {
  return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
}

/// Whether the bounds add up to no more than the tolerance, as far as double precision reaches.
bool keeps(const EffectsPlan& plan, double tolerance) {
  const double promised = plan.single_precision ? 0 : plan.bounds.rounding;
  return promised < 1e-4 && plan.bounds.total() - promised <= tolerance * (1 + 1e-12);
}

double planned_diffuse(const EffectsPlan& plan, const Scene& scene) {
  return with_effects(plan, scene.cavity(), scene.n, scene.k, [&](const auto& cavity, const auto& facet) {
    using Real = std::remove_cvref_t<decltype(cavity.aperture())>;
    return static_cast<double>(bihemispherical_reflectance(
                                   cavity, facet, static_cast<Real>(plan.bounds.quadrature), plan.max_bounces)
                                   .value);
  });
}

double planned_directional(const EffectsPlan& plan, const Scene& scene, const Vec3<double>& e) {
  return with_effects(plan, scene.cavity(), scene.n, scene.k, [&](const auto& cavity, const auto& facet) {
    using Real = std::remove_cvref_t<decltype(cavity.aperture())>;
    return static_cast<double>(
        unpolarized(directional_reflectance(cavity, Vec3<Real>(e), facet, plan.max_bounces)));
  });
}

}  // namespace

TEST_CASE("a plan for diffuse light keeps its tolerance in thousands of random scenes") {
  std::mt19937_64 random(211);
  int unpolarized_plans = 0, cut_plans = 0, float_plans = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Scene scene = random_scene(random);
    const double tolerance = random_tolerance(random, 1e-5, 1e-1);
    const EffectsPlan plan = plan_effects(scene.cavity(), scene.facet(), tolerance, Illumination::diffuse);
    CAPTURE(scene.aperture_deg, scene.n, scene.k, tolerance, plan.polarization, plan.max_bounces,
            plan.single_precision);
    CHECK(keeps(plan, tolerance));
    const double full =
        bihemispherical_reflectance(scene.cavity(), polarized(scene.facet()), tolerance / 30).value;
    CHECK(std::abs(planned_diffuse(plan, scene) - full) <= plan.bounds.total() + tolerance / 30);
    unpolarized_plans += !plan.polarization;
    cut_plans += plan.max_bounces != all_bounces;
    float_plans += plan.single_precision;
  }
  // Each effect is left out often enough for the check to mean something, but not always.
  for (const int plans : {unpolarized_plans, cut_plans, float_plans}) {
    CHECK(plans > 200);
    CHECK(plans < 1900);
  }
}

TEST_CASE("a plan for every direction keeps its tolerance in thousands of random scenes") {
  std::mt19937_64 random(223);
  std::uniform_real_distribution<double> unit(0, 1);
  int unpolarized_plans = 0, float_plans = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Scene scene = random_scene(random);
    const double tolerance = random_tolerance(random, 1e-6, 0.3);
    const EffectsPlan plan = plan_effects(scene.cavity(), scene.facet(), tolerance, Illumination::collimated);
    CHECK(keeps(plan, tolerance));
    double worst = 0;
    for (int i = 0; i < 80; ++i) {
      // Half of the directions close to grazing, where reflectances change fastest.
      const double cos_theta = i % 2 == 0 ? unit(random) : std::exp(-14 * unit(random));
      const Vec3<double> e = direction(std::acos(cos_theta), 2 * pi<double>() * unit(random));
      const double full = unpolarized(directional_reflectance(scene.cavity(), e, polarized(scene.facet())));
      worst = std::max(worst, std::abs(planned_directional(plan, scene, e) - full));
    }
    CAPTURE(scene.aperture_deg, scene.n, scene.k, tolerance, plan.polarization, plan.max_bounces,
            plan.single_precision, plan.bounds.rounding);
    CHECK(worst <= plan.bounds.total());
    unpolarized_plans += !plan.polarization;
    float_plans += plan.single_precision;
  }
  for (const int plans : {unpolarized_plans, float_plans}) {
    CHECK(plans > 100);
    CHECK(plans < 950);
  }
}

TEST_CASE("a looser tolerance never asks for more") {
  std::mt19937_64 random(227);
  for (int trial = 0; trial < 40; ++trial) {
    const Scene scene = random_scene(random);
    for (const Illumination illumination : {Illumination::collimated, Illumination::diffuse}) {
      EffectsPlan tighter{true, all_bounces, false, {}};
      for (const double tolerance : {1e-6, 1e-4, 1e-3, 1e-2, 1e-1}) {
        const EffectsPlan plan = plan_effects(scene.cavity(), scene.facet(), tolerance, illumination);
        CAPTURE(scene.aperture_deg, scene.n, scene.k, tolerance);
        CHECK(plan.polarization <= tighter.polarization);
        CHECK(plan.max_bounces <= tighter.max_bounces);
        CHECK(plan.single_precision >= tighter.single_precision);
        tighter = plan;
      }
    }
  }
}

TEST_CASE("silver in diffuse light to one percent needs neither polarisation nor double precision") {
  const EffectsPlan plan = plan_effects(Cavity<double>(radians(60.0)), Conductor<double>(0.1249, 3.3391),
                                        1e-2, Illumination::diffuse);
  CHECK_FALSE(plan.polarization);
  CHECK(plan.single_precision);
}

TEST_CASE("glass to a millionth needs all there is") {
  const EffectsPlan plan =
      plan_effects(Cavity<double>(radians(60.0)), Dielectric<double>(1.5), 1e-6, Illumination::diffuse);
  CHECK(plan.polarization);
  CHECK(plan.max_bounces == all_bounces);
  CHECK_FALSE(plan.single_precision);
}

TEST_CASE("a plan without a positive tolerance is refused") {
  for (const double tolerance : {0.0, -1.0, std::nan("")})
    CHECK_THROWS_AS(
        plan_effects(Cavity<double>(1.0), Dielectric<double>(1.5), tolerance, Illumination::diffuse),
        std::invalid_argument);
}

TEST_CASE("separate polarisations bound the error of leaving polarisation out, direction by direction") {
  std::mt19937_64 random(229);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    const Scene scene = random_scene(random);
    const Vec3<double> e = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
    const auto by = [&](const auto& facet) {
      return unpolarized(directional_reflectance(scene.cavity(), e, facet));
    };
    const double none = by(scene.facet());
    CHECK(std::abs(by(polarized(scene.facet())) - none) <=
          by(separately_polarized(scene.facet())) - none + 1e-14);
  }
}

TEST_CASE("float keeps its bound on rounding in any direction, quantity and model of polarisation") {
  std::mt19937_64 random(233);
  std::uniform_real_distribution<double> unit(0, 1);
  double largest_share = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Scene scene = random_scene(random);
    const double bound = rounding_bound<float>(scene.cavity(), scene.facet());
    const Cavity<float> narrow(at_most(static_cast<float>(scene.cavity().aperture()), pi<float>()));
    const Conductor<float> facet(static_cast<float>(scene.n), static_cast<float>(scene.k));
    CAPTURE(scene.aperture_deg, scene.n, scene.k, bound);
    for (int i = 0; i < 40; ++i) {
      const double cos_theta = i % 2 == 0 ? unit(random) : std::exp(-14 * unit(random));
      const Vec3<double> e = direction(std::acos(cos_theta), 2 * pi<double>() * unit(random));
      const auto check = [&](const auto& single, const auto& exact) {
        const Vec3<float> e_single(e);
        const double reflected =
            static_cast<double>(unpolarized(directional_reflectance(narrow, e_single, single))) -
            unpolarized(directional_reflectance(scene.cavity(), e, exact));
        const double absorbed =
            static_cast<double>(unpolarized(directional_absorptance(narrow, e_single, single))) -
            unpolarized(directional_absorptance(scene.cavity(), e, exact));
        const double error = std::max(std::abs(reflected), std::abs(absorbed));
        CHECK(error <= bound);
        if (bound < 0.1) largest_share = std::max(largest_share, error / bound);
      };
      check(facet, scene.facet());
      check(separately_polarized(facet), separately_polarized(scene.facet()));
      check(polarized(facet), polarized(scene.facet()));
    }
  }
  CHECK(largest_share > 0.05);  // the bound is no mere number that nothing could exceed
}

TEST_CASE("between the directions of a plan's grid, and towards grazing, nothing exceeds the bound") {
  double largest_share = 0;
  for (const Scene& scene :
       {Scene{60, 1.5, 0}, {40, 1.33, 0}, {60, 100, 100}, {120, 1000, 1000}, {60, 2.5, 4}})
    for (const double theta : {0.05, 0.3}) {
      const Cavity<double> cavity = scene.cavity();
      const Conductor<double> facet = scene.facet();
      const detail::TriedFacet<Conductor<double>> tried(facet);
      const detail::Omissions bound = detail::worst_omissions(cavity, tried, {theta});
      constexpr int steps = 4000;
      for (int i = 0; i < 2 * steps; ++i) {
        // Evenly in the angle along the groove, and evenly in the logarithm of its cosine.
        const double share = static_cast<double>(i % steps) / steps;
        const double cos_psi = i < steps ? std::cos(share * pi<double>() / 2) : std::exp(-14 * share);
        const double sin_psi = std::sqrt((1 - cos_psi) * (1 + cos_psi));
        const Vec3<double> e{sin_psi, cos_psi * std::sin(theta), cos_psi * std::cos(theta)};
        const detail::Omissions here = directional_reflectance(cavity, e, tried);
        for (std::size_t k = 0; k <= detail::longest_cutoff; ++k) {
          if (here[k] > bound[k]) FAIL_CHECK(scene.n << ' ' << theta << ' ' << cos_psi << ' ' << k);
          if (bound[k] > 0) largest_share = std::max(largest_share, here[k] / bound[k]);
        }
      }
    }
  // The grid alone, without the margin of a fifth, would fall short.
  CHECK(largest_share > 1 / 1.2);
}

TEST_CASE("bounds for diffuse light contain the error of their own quadrature") {
  int below = 0;
  for (const double aperture_deg : {22.0, 47.0, 75.0, 110.0})
    for (const auto& [n, k] : {std::pair{1.5, 0.0}, {0.2, 3.4}, {0.7, 0.0}})
      for (const double tolerance : {0.3, 0.03}) {
        const Cavity<double> cavity(radians(aperture_deg));
        const Conductor<double> facet(n, k);
        const detail::TriedFacet<Conductor<double>> tried(facet);
        const auto exact = bihemispherical_reflectance(cavity, tried, 1e-9);
        const auto rough = bihemispherical_reflectance(cavity, tried, tolerance);
        const detail::Omissions bounds = detail::mean_omissions(cavity, facet, tolerance);
        for (const std::size_t omission : {std::size_t(0), std::size_t(1), detail::longest_cutoff}) {
          CAPTURE(aperture_deg, n, k, tolerance, omission);
          CHECK(bounds[omission] >= exact.value[omission] - 1e-8);
          if (rough.value[omission] < exact.value[omission] - 1e-6) ++below;
        }
      }
  CHECK(below > 10);  // without the error the bounds would be too small
}

TEST_CASE("the bound on rounding of strong metals holds where a cosine is off by ε towards grazing") {
  const double epsilon = static_cast<double>(std::numeric_limits<float>::epsilon());
  for (const double n : {10.0, 100.0, 1000.0}) {
    const Conductor<double> facet(n, n);
    const double bound = detail::rounding_per_bounce(detail::as_complex(facet.contrast()), epsilon);
    double worst = 0;
    for (int i = 1; i < 2000; ++i) {
      const double cosine = std::exp(-14.0 * i / 2000);
      const auto here = facet.amplitudes(cosine), there = facet.amplitudes(cosine + epsilon);
      worst = std::max(
          {worst, std::abs(norm(here.r_p) - norm(there.r_p)), std::abs(norm(here.r_s) - norm(there.r_s))});
    }
    CAPTURE(n, worst, bound);
    CHECK(worst <= bound);
    CHECK(worst > 0.2 * bound);
  }
}
