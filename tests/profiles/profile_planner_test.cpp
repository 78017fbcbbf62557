// SPDX-License-Identifier: BSD-3-Clause
/// Plans for grooves of other shapes and of several materials keep what they promise.

#include <cmath>
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

using Facet = Coated<Conductor<double>>;

/// Random shapes and facets.
class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  double tolerance(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  AsymmetricGroove<double> sawtooth() {
    const double aperture = between(12, 150);
    const double most = (180 - aperture) / 2 - 3;
    return {radians(aperture), radians(between(-most, most))};
  }

  TruncatedGroove<double> floored() {
    return {radians(between(25, 84)), radians(between(25, 84)), std::exp(between(-4, 2))};
  }

  Trench<double> trench() { return Trench<double>(std::exp(between(-1, 2))); }

  double land() { return between(0.05, 0.9); }

  /// A metal or a dielectric, every other one under a film that may reflect p light better than s.
  Facet facet() {
    const double kind = between(0, 1);
    const Conductor<double> substrate = kind < 0.3   ? Conductor<double>(between(1.2, 3), 0)
                                        : kind < 0.4 ? Conductor<double>(between(0.5, 1), 0)
                                                     : Conductor<double>(between(0.05, 4), between(0, 6));
    std::vector<Film<double>> films;
    if (between(0, 1) < 0.5)
      films.emplace_back(between(1.2, 2.5), between(0, 1) < 0.5 ? 0 : between(0, 1), between(0, 0.6));
    return Facet(substrate, films);
  }

  /// Half of them close to grazing, where reflectances change fastest.
  Vec3<double> light() {
    const double cos_theta = between(0, 1) < 0.5 ? between(0, 1) : std::exp(-between(0, 14));
    return direction(std::acos(cos_theta), between(0, 2 * pi<double>()));
  }

 private:
  std::mt19937_64 random_;
};

/// How many plans there were, and what they left out.
struct Count {
  int plans = 0, unpolarized = 0, cut = 0, in_float = 0;

  void add(const EffectsPlan& plan) {
    ++plans;
    unpolarized += !plan.polarization;
    cut += plan.max_bounces != all_bounces;
    in_float += plan.single_precision;
  }
};

/// Whether the bounds add up to no more than the tolerance, as far as double precision reaches. Along a trench light may
/// bounce so often that it reaches nowhere.
template <class Shape>
void check_promise(const EffectsPlan& plan, const Shape& shape, double tolerance) {
  const double promised = plan.single_precision ? 0 : plan.bounds.rounding;
  CHECK((promised < 1e-3 || shape.max_bounces() > 1'000'000));
  CHECK(plan.bounds.total() - promised <= tolerance * (1 + 1e-12));
}

template <class Shape, class Facets>
double planned(const EffectsPlan& plan, const Shape& shape, const Facets& facets, const Vec3<double>& e) {
  return with_effects(plan, shape, facets, [&](const auto& groove, const auto& own) {
    using Real = scalar_t<std::remove_cvref_t<decltype(groove)>>;
    return static_cast<double>(
        unpolarized(directional_reflectance(groove, Vec3<Real>(e), own, plan.max_bounces)));
  });
}

template <class Shape, class Facets>
double planned(const EffectsPlan& plan, const Shape& shape, const Facets& facets) {
  return with_effects(plan, shape, facets, [&](const auto& groove, const auto& own) {
    using Real = scalar_t<std::remove_cvref_t<decltype(groove)>>;
    return static_cast<double>(
        bihemispherical_reflectance(groove, own, static_cast<Real>(plan.bounds.quadrature), plan.max_bounces)
            .value);
  });
}

template <class Shape, class Facets>
void check_directions(Scenes& scenes, const Shape& shape, const Facets& facets, Count& count) {
  const double tolerance = scenes.tolerance(1e-5, 0.3);
  const EffectsPlan plan = plan_effects(shape, facets, tolerance, Illumination::collimated);
  check_promise(plan, shape, tolerance);
  count.add(plan);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3<double> e = scenes.light();
    const double full = unpolarized(directional_reflectance(shape, e, polarized(facets)));
    worst = std::max(worst, std::abs(planned(plan, shape, facets, e) - full));
  }
  CAPTURE(tolerance, plan.polarization, plan.max_bounces, plan.single_precision, plan.bounds.polarization,
          plan.bounds.bounces, plan.bounds.rounding);
  CHECK(worst <= plan.bounds.total());
}

template <class Shape, class Facets>
void check_diffuse(Scenes& scenes, const Shape& shape, const Facets& facets, Count& count) {
  const double tolerance = scenes.tolerance(1e-4, 1e-1);
  const EffectsPlan plan = plan_effects(shape, facets, tolerance, Illumination::diffuse);
  check_promise(plan, shape, tolerance);
  count.add(plan);
  const double full = bihemispherical_reflectance(shape, polarized(facets), tolerance / 30).value;
  CAPTURE(tolerance, plan.polarization, plan.max_bounces, plan.single_precision);
  CHECK(std::abs(planned(plan, shape, facets) - full) <= plan.bounds.total() + tolerance / 30);
}

/// Calls `check` with a random scene of every shape.
template <class Check>
void with_scenes(Scenes& scenes, const Check& check) {
  const FaceFacets facets{scenes.facet(), scenes.facet(), scenes.facet(), scenes.facet()};
  const auto sawtooth = scenes.sawtooth();
  INFO("sawtooth " << sawtooth.aperture() << " " << sawtooth.tilt());
  check(sawtooth, PanelFacets{facets.one, facets.two});
  check(sawtooth, facets.one);
  check(Land(sawtooth, scenes.land()), facets);
  check(Land(Cavity<double>(sawtooth.aperture()), scenes.land()), facets.one);
  const auto floored = scenes.floored();
  INFO("floored " << floored.slope(Panel::one) << " " << floored.slope(Panel::two) << " "
                  << floored.floor_over_depth());
  check(floored, facets);
  const auto trench = scenes.trench();
  INFO("trench " << trench.floor_over_depth());
  check(Land(trench, scenes.land()), facets);
}

}  // namespace

TEST_CASE("plans for other shapes and several materials keep their tolerance in every direction") {
  Scenes scenes(821);
  Count count;
  for (int trial = 0; trial < 60; ++trial)
    with_scenes(scenes, [&](const auto& shape, const auto& facets) {
      check_directions(scenes, shape, facets, count);
    });
  // Each effect is left out often enough for the check to mean something, but not always.
  for (const int plans : {count.unpolarized, count.in_float}) {
    CHECK(plans > count.plans / 20);
    CHECK(plans < count.plans * 19 / 20);
  }
}

TEST_CASE("plans for other shapes and several materials keep their tolerance in diffuse light") {
  Scenes scenes(823);
  Count count;
  for (int trial = 0; trial < 30; ++trial)
    with_scenes(scenes,
                [&](const auto& shape, const auto& facets) { check_diffuse(scenes, shape, facets, count); });
  for (const int plans : {count.unpolarized, count.cut, count.in_float}) {
    CHECK(plans > count.plans / 20);
    CHECK(plans < count.plans * 19 / 20);
  }
}

TEST_CASE("leaving polarisation out is bounded under films that reflect p light better than s") {
  Scenes scenes(827);
  for (int trial = 0; trial < 300; ++trial) {
    const Cavity<double> cavity(radians(scenes.between(15, 120)));
    const Facet facet = scenes.facet();
    const detail::TriedFacet<Facet> tried(facet);
    for (int i = 0; i < 30; ++i) {
      const Vec3<double> e = scenes.light();
      const double none = directional_reflectance(cavity, e, facet);
      const double full = unpolarized(directional_reflectance(cavity, e, polarized(facet)));
      CHECK(std::abs(full - none) <=
            directional_reflectance(cavity, e, tried)[detail::longest_cutoff] + 1e-13);
    }
  }
}

TEST_CASE("float keeps its bound on rounding in any direction of the other shapes") {
  Scenes scenes(829);
  double largest_share = 0;
  for (int trial = 0; trial < 40; ++trial)
    with_scenes(scenes, [&](const auto& shape, const auto& facets) {
      const double bound = rounding_bound<float>(shape, facets);
      const EffectsPlan plan{true, all_bounces, true, {}};
      double worst = 0;
      for (int i = 0; i < 60; ++i) {
        const Vec3<double> e = scenes.light();
        worst = std::max(worst, std::abs(planned(plan, shape, facets, e) -
                                         unpolarized(directional_reflectance(shape, e, polarized(facets)))));
      }
      CHECK(worst <= bound);
      if (bound < 0.1) largest_share = std::max(largest_share, worst / bound);
    });
  CHECK(largest_share > 0.02);  // the bound is no mere number that nothing could exceed
}

TEST_CASE("a tighter tolerance never asks for less of another shape") {
  Scenes scenes(839);
  for (int trial = 0; trial < 3; ++trial)
    with_scenes(scenes, [&](const auto& shape, const auto& facets) {
      for (const Illumination illumination : {Illumination::collimated, Illumination::diffuse}) {
        EffectsPlan tighter{true, all_bounces, false, {}};
        for (const double tolerance : {1e-5, 1e-3, 1e-1}) {
          const EffectsPlan plan = plan_effects(shape, facets, tolerance, illumination);
          CHECK(plan.polarization <= tighter.polarization);
          CHECK(plan.max_bounces <= tighter.max_bounces);
          CHECK(plan.single_precision >= tighter.single_precision);
          tighter = plan;
        }
      }
    });
}

TEST_CASE("a plan for another shape is refused without a positive tolerance") {
  const AsymmetricGroove<double> groove(1.0, 0.3);
  for (const double tolerance : {0.0, -1.0, std::nan("")})
    CHECK_THROWS_AS(plan_effects(groove, Conductor<double>(1.5, 0.0), tolerance, Illumination::diffuse),
                    std::invalid_argument);
}

TEST_CASE("grooves too steep for float are planned in double") {
  const AsymmetricGroove<double> groove(radians(60.0), radians(60.0 - 1e-5));
  CHECK(rounding_bound<float>(groove, Conductor<double>(1.5, 0.0)) == 1);
  CHECK_FALSE(plan_effects(groove, Conductor<double>(1.5, 0.0), 0.1, Illumination::diffuse).single_precision);
}
