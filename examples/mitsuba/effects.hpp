// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which effects a material calls for, decided once, when the scene is loaded.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "spectra.hpp"

namespace vgroove {

/// What is followed through a groove, and what is left out.
struct Effects {
  bool polarization;
  int max_bounces = vcavity::all_bounces;
  bool double_precision = false;
  /// Of all that a plan leaves out, on the radiance, for light of radiance 1; nothing where none is known.
  std::optional<double> error_bound = std::nullopt;
};

/// The plan of one shape and facet.
template <class Shape, class Facet>
vcavity::EffectsPlan plan_of(const Shape& shape, const Facet& facet, double tolerance) {
  if constexpr (vcavity::SlopeDistribution<Shape>)
    return vcavity::plan_rough_effects(shape, facet, tolerance);
  else
    return vcavity::plan_effects(shape, facet, tolerance, vcavity::Illumination::collimated);
}

/// The cheapest effects whose reflectance, in any direction and for every given material and shape, lies within a
/// tolerance of the full physics. A darker tint makes no omission cost more.
/// @tparam Shape a `Cavity`, an `AsymmetricGroove`, or a distribution of slopes, in double
/// @param shapes at least one
/// @param materials at least one
/// @param polarized_light whether the renderer follows Stokes parameters, which need the fields whatever the tolerance
template <class Shape>
Effects planned_effects(const std::vector<Shape>& shapes, std::span<const TintedIndex> materials,
                        double tolerance, bool polarized_light) {
  Effects effects{polarized_light, 1};
  std::vector<vcavity::ErrorBounds> bounds;
  for (const Shape& shape : shapes)
    for (const TintedIndex& material : materials) {
      const vcavity::EffectsPlan plan = plan_of(shape, material.facet(), tolerance);
      effects.polarization |= plan.polarization;
      effects.max_bounces = std::max(effects.max_bounces, plan.max_bounces);
      effects.double_precision |= !plan.single_precision;
      bounds.push_back(plan.bounds);
    }
  // What one calls for is followed for all, and costs none of them an error.
  double largest_error = 0;
  for (const vcavity::ErrorBounds& each : bounds) {
    const double of_polarization = effects.polarization ? 0 : each.polarization;
    const double of_bounces = effects.max_bounces == vcavity::all_bounces ? 0 : each.bounces;
    largest_error = std::max(largest_error, of_polarization + of_bounces + each.rounding);
  }
  effects.error_bound = largest_error;
  return effects;
}

/// A bound as it is printed, with two digits and not below what it is.
inline double rounded_up(double bound) {
  if (!(bound > 0)) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - 1);
  return unit * std::ceil(bound / unit);
}

/// What is followed, and a bound on what all omissions together cost, in words.
inline std::string described(const Effects& effects) {
  std::ostringstream text;
  text.precision(2);
  text << (effects.polarization ? "polarisation followed" : "no polarisation");
  if (effects.max_bounces == vcavity::all_bounces)
    text << ", all bounces";
  else
    text << ", at most " << effects.max_bounces << (effects.max_bounces == 1 ? " bounce" : " bounces");
  text << (effects.double_precision ? ", double" : ", single") << " precision";
  if (effects.error_bound) text << " (error below " << rounded_up(*effects.error_bound) << ")";
  return text.str();
}

}  // namespace vgroove
