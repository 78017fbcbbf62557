// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which effects grooves of other shapes call for: the answer of planner.hpp for unequal panels, floors, land and facets
/// of different materials.
///
/// Method. What leaving out polarisation or long ways costs is bounded lobe by lobe as in planner.hpp, whose argument
/// asks neither for equal panels nor for one material. Rounding has two parts. A product of reflectances of at most 1 is
/// wrong by no more than its factors together: in one direction by the largest number of bounces times the error of
/// one, under diffuse light by the mean number, which is the area of the faces per area of the opening. The weights of
/// lobes have no such formula; their error is measured, against long double, on the grid of the search.
///
/// When not to use it: for symmetric grooves of one material, which `plan_effects` of a `Cavity` serves. And not where
/// walls of a floored groove are within minutes of arc of vertical: hundreds of lobes make a plan a matter of seconds.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcavity/facet/panel_facets.hpp"
#include "vcavity/groove/asymmetric_groove.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/hemisphere/asymmetric_bihemispherical.hpp"
#include "vcavity/hemisphere/kinks.hpp"
#include "vcavity/plan/planner.hpp"
#include "vcavity/profiles/bihemispherical.hpp"
#include "vcavity/profiles/face_facets.hpp"
#include "vcavity/profiles/land.hpp"
#include "vcavity/profiles/profile.hpp"
#include "vcavity/profiles/smooth_ranges.hpp"
#include "vcavity/profiles/trench.hpp"
#include "vcavity/profiles/truncated_groove.hpp"

namespace vcavity {

/// A shape with plans of its own, in double precision.
template <class Shape>
concept PlannableShape = std::same_as<Shape, AsymmetricGroove<double>> ||
                         (Profile<Shape> && std::same_as<scalar_t<Shape>, double>);

namespace detail {

/// Whether a shape can be had in another number type: what its limits leave must be more than rounding.
template <class Real>
bool is_more_than_rounding(double rest) {
  return rest > 64 * static_cast<double>(std::numeric_limits<Real>::epsilon());
}
template <class Real>
bool representable(const Cavity<double>&) {
  return true;
}
template <class Real>
bool representable(const AsymmetricGroove<double>& groove) {
  return is_more_than_rounding<Real>(std::min(groove.slope(Panel::one), groove.slope(Panel::two))) &&
         is_more_than_rounding<Real>(groove.aperture());
}
template <class Real>
bool representable(const TruncatedGroove<double>& groove) {
  return is_more_than_rounding<Real>(pi<double>() - groove.slope(Panel::one) - groove.slope(Panel::two)) &&
         groove.floor_over_depth() < static_cast<double>(std::numeric_limits<Real>::max());
}
template <class Real>
bool representable(const Trench<double>& trench) {
  return trench.floor_over_depth() > static_cast<double>(std::numeric_limits<Real>::min()) &&
         trench.floor_over_depth() < static_cast<double>(std::numeric_limits<Real>::max());
}
template <class Real, class Groove>
bool representable(const Land<Groove>& profile) {
  return is_more_than_rounding<Real>(1 - profile.fraction()) && representable<Real>(profile.groove());
}

/// A shape in another number type.
template <class Real>
Cavity<Real> in_numbers(const Cavity<double>& cavity) {
  return Cavity<Real>(at_most(static_cast<Real>(cavity.aperture()), pi<Real>()));
}
template <class Real>
AsymmetricGroove<Real> in_numbers(const AsymmetricGroove<double>& groove) {
  return {static_cast<Real>(groove.aperture()), static_cast<Real>(groove.tilt())};
}
template <class Real>
TruncatedGroove<Real> in_numbers(const TruncatedGroove<double>& groove) {
  return {static_cast<Real>(groove.slope(Panel::one)), static_cast<Real>(groove.slope(Panel::two)),
          static_cast<Real>(groove.floor_over_depth())};
}
template <class Real>
Trench<Real> in_numbers(const Trench<double>& trench) {
  return Trench<Real>(static_cast<Real>(trench.floor_over_depth()));
}
template <class Real, class Groove>
auto in_numbers(const Land<Groove>& profile) {
  return Land(in_numbers<Real>(profile.groove()), static_cast<Real>(profile.fraction()));
}

/// Where the weights of a shape have kinks, as far as a search wants to know.
inline std::vector<double> kinks_for_search(const Cavity<double>& cavity) {
  std::vector<double> ends = kinks(cavity);
  const std::vector<double> positive = ends;
  for (const double angle : positive) ends.push_back(-angle);
  sort_angles(ends);
  return ends;
}
inline std::vector<double> kinks_for_search(const AsymmetricGroove<double>& groove) {
  return kinks(groove, [](const double&) { return 1.0; });
}
template <Profile Shape>
std::vector<double> kinks_for_search(const Shape& profile) {
  constexpr double coarse = 1e-2;
  return smooth_ranges(profile, coarse).ends;
}
template <class Groove>
std::vector<double> kinks_for_search(const Land<Groove>& profile) {
  return kinks_for_search(profile.groove());
}

/// Angles θ' for a search, with some that are closer and closer to grazing.
template <class Shape>
std::vector<double> angles_for_search(const Shape& shape) {
  constexpr int closest = 25;
  std::vector<double> angles = angles_across(kinks_for_search(shape));
  for (int i = 5; i <= closest; ++i)
    for (const double side : {-1.0, 1.0}) angles.push_back(side * (pi<double>() / 2 - std::exp(-i)));
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// A shape as a profile, whose lobes name the faces they meet.
inline Land<AsymmetricGroove<double>> as_profile(const AsymmetricGroove<double>& groove) {
  return Land(groove, 0.0);
}
template <Profile Shape>
const Shape& as_profile(const Shape& profile) {
  return profile;
}

/// Rounding errors of all weights of a direction together.
struct WeightRounding {
  double worst;  ///< in any direction
  double mean;   ///< over the hemisphere
};

/// Measures them: lobes in a number type against those in long double.
/// @param angles θ' of a grid, ascending
template <class Real, class Shape>
WeightRounding weight_rounding(const Shape& profile, const std::vector<double>& angles) {
  constexpr double few = 4;  // what the grid may have missed
  const auto rounded = in_numbers<Real>(profile);
  const auto exact = in_numbers<long double>(profile);
  std::vector<std::pair<FacePath, double>> weights;
  const auto difference = [&](double theta) {
    weights.clear();
    const Vec3<double> e{0, std::sin(theta), at_least(std::cos(theta), 0.0)};
    const auto add = [&](const auto& shape, double sign) {
      using Number = scalar_t<std::remove_cvref_t<decltype(shape)>>;
      shape.follow(
          Vec3<Number>(e), [](const Number&) { return Number(1); },
          [&](const FacePencil<Number>& light, const Number&) {
            const auto same = std::find_if(weights.begin(), weights.end(),
                                           [&](const auto& lobe) { return lobe.first == light.path; });
            const double weight = sign * static_cast<double>(light.weight);
            if (same == weights.end())
              weights.emplace_back(light.path, weight);
            else
              same->second += weight;
          });
    };
    add(exact, 1);
    add(rounded, -1);
    double sum = 0;
    for (const auto& [path, weight] : weights) sum += magnitude(weight);
    return sum;
  };
  const double least = 4 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  WeightRounding result{least, least};
  double last = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double here = difference(angles[i]);
    result.worst = std::max(result.worst, few * here);
    if (i > 0)
      result.mean += few * std::max(here, last) * (std::sin(angles[i]) - std::sin(angles[i - 1])) / 2;
    last = here;
  }
  return result;
}

/// The facets of a shape, each tried with and without polarisation.
template <class Facets>
auto tried_facets(const Facets& facets) {
  return each_facet(
      facets, [](const auto& facet) { return TriedFacet<std::remove_cvref_t<decltype(facet)>>(facet); });
}

/// The largest rounding error of any facet at one bounce.
template <class Real, class Facets>
double rounding_per_bounce_of(const Facets& facets) {
  double largest = 0;
  each_facet(facets, [&](const auto& facet) {
    largest = std::max(largest, rounding_per_bounce<Real>(facet));
    return 0;
  });
  return largest;
}

/// Bound on the rounding error of a reflectance.
/// @param angles θ' of a grid, ascending
template <class Real, class Shape, class Facets>
double shape_rounding(const Shape& profile, const Facets& facets, const std::vector<double>& angles,
                      Illumination illumination) {
  if (!representable<Real>(profile)) return 1;
  // The tilt, or the angle of an image formed from two slopes, carries some ε more than in a symmetric groove.
  const double per_bounce = 2 * rounding_per_bounce_of<Real>(facets);
  const WeightRounding weights = weight_rounding<Real>(profile, angles);
  if (illumination == Illumination::diffuse)
    return at_most(profile.developed_area() * per_bounce + weights.mean, 1.0);
  return at_most(profile.max_bounces() * per_bounce + weights.worst, 1.0);
}

/// The errors of diffuse reflectance, as exactly as it takes to tell them from `share`.
/// @param reachable the largest number of bounces of any light
template <class Shape, class Facets>
Omissions mean_shape_omissions(const Shape& shape, const Facets& tried, double share, int reachable) {
  constexpr double coarse = 1e-3, finer = 1.0 / 32;
  const double finest = share / 8;
  double tolerance = std::max(coarse, finest);
  for (;;) {
    const auto errors = bihemispherical_reflectance(shape, tried, tolerance);
    const auto is_open = [&](std::size_t i) {
      return errors.value[i] - errors.error <= share && errors.value[i] + errors.error > share;
    };
    bool open = is_open(longest_cutoff);
    for (std::size_t i = 0; i < longest_cutoff && i + 1 < static_cast<std::size_t>(reachable); ++i)
      open = open || is_open(i);
    if (!open || tolerance <= finest) return errors.value + Omissions(errors.error);
    tolerance = std::max(finer * tolerance, finest);
  }
}

}  // namespace detail

/// Bound on the absolute rounding error of a reflectance in any model of polarisation, in any direction or under diffuse
/// light; an estimate as far as the weights of the lobes go, which are tried on a grid.
/// @tparam Real the number type that it is computed with
/// @param shape an `AsymmetricGroove` or a profile
/// @param facets one facet as for the `rounding_bound` of a `Cavity`, or `PanelFacets` or `FaceFacets` of such
/// @param illumination of the scene
/// @return at most 1, which is also the answer where the shape cannot be had in this number type. Light along the walls
/// of a trench meets so many of them that nothing better can be promised in float
template <class Real, PlannableShape Shape, class Facets>
double rounding_bound(const Shape& shape, const Facets& facets,
                      Illumination illumination = Illumination::collimated) {
  return detail::shape_rounding<Real>(detail::as_profile(shape), facets, detail::angles_for_search(shape),
                                      illumination);
}

/// The cheapest plan for grooves of another shape, or of several materials; see `plan_effects` of a `Cavity`.
///
/// @param shape an `AsymmetricGroove` or a profile
/// @param facets one facet as there, or `PanelFacets` or `FaceFacets` of such
/// @param tolerance largest absolute error of the reflectance, > 0
/// @param illumination of the scene
/// @throws std::invalid_argument when the tolerance is not a positive number
template <PlannableShape Shape, class Facets>
EffectsPlan plan_effects(const Shape& shape, const Facets& facets, double tolerance,
                         Illumination illumination) {
  const double share = detail::share_of(tolerance, illumination);
  const std::vector<double> angles = detail::angles_for_search(shape);
  const auto tried = detail::tried_facets(facets);
  const detail::Omissions errors =
      illumination == Illumination::diffuse
          ? detail::mean_shape_omissions(shape, tried, share, shape.max_bounces())
          : detail::worst_omissions(shape, tried, angles);
  return detail::plan_within(share, illumination, errors, shape.max_bounces(), [&]<class Real>(Real) {
    return detail::shape_rounding<Real>(detail::as_profile(shape), facets, angles, illumination);
  });
}

/// Calls `use` with the shape and the facets of a plan, in its number type and with or without polarisation.
/// @param plan as from `plan_effects`
/// @param shape an `AsymmetricGroove` or a profile
/// @param facets one facet that can be had in any number type, or `PanelFacets` or `FaceFacets` of such
/// @param use what is called
/// @return what `use` returns, of one type for all plans
template <PlannableShape Shape, class Facets, class Use>
auto with_effects(const EffectsPlan& plan, const Shape& shape, const Facets& facets, Use&& use) {
  const auto in_precision = [&]<class Real>(Real) {
    const auto own = detail::each_facet(facets, [](const auto& facet) { return facet.template in<Real>(); });
    const auto groove = detail::in_numbers<Real>(shape);
    return plan.polarization ? use(groove, polarized(own)) : use(groove, own);
  };
  return plan.single_precision ? in_precision(float()) : in_precision(double());
}

}  // namespace vcavity
