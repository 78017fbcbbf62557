// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which effects a material calls for, decided once, when the scene is loaded.

#include <algorithm>
#include <cmath>
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
  /// On the radiance, for light of radiance 1; of what a plan leaves out.
  vcavity::ErrorBounds bounds{0, 0, 0, 0};
};

/// Adds what one more index or shape calls for.
inline void include(Effects& effects, const vcavity::EffectsPlan& plan) {
  effects.polarization |= plan.polarization;
  effects.max_bounces = std::max(effects.max_bounces, plan.max_bounces);
  effects.double_precision |= !plan.single_precision;
  effects.bounds.polarization = std::max(effects.bounds.polarization, plan.bounds.polarization);
  effects.bounds.bounces = std::max(effects.bounds.bounces, plan.bounds.bounces);
  effects.bounds.rounding = std::max(effects.bounds.rounding, plan.bounds.rounding);
}

/// What is followed in the end costs no error.
inline Effects settled(Effects effects) {
  if (effects.polarization) effects.bounds.polarization = 0;
  if (effects.max_bounces == vcavity::all_bounces) effects.bounds.bounces = 0;
  return effects;
}

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
  for (const Shape& shape : shapes)
    for (const TintedIndex& material : materials)
      include(effects, plan_of(shape, material.facet(), tolerance));
  return settled(effects);
}

/// A bound as it is printed, with two digits and not below what it is.
inline double rounded_up(double bound) {
  if (!(bound > 0)) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - 1);
  return unit * std::ceil(bound / unit);
}

/// What is followed, and a bound on what each omission costs, in words.
inline std::string described(const Effects& effects) {
  std::ostringstream text;
  text.precision(2);
  if (effects.polarization)
    text << "polarisation followed";
  else
    text << "no polarisation";
  if (effects.bounds.polarization > 0)
    text << " (error below " << rounded_up(effects.bounds.polarization) << ")";
  if (effects.max_bounces == vcavity::all_bounces)
    text << ", all bounces";
  else
    text << ", at most " << effects.max_bounces << (effects.max_bounces == 1 ? " bounce" : " bounces")
         << " (error below " << rounded_up(effects.bounds.bounces) << ")";
  text << (effects.double_precision ? ", double" : ", single") << " precision";
  if (effects.bounds.rounding > 0) text << " (error below " << rounded_up(effects.bounds.rounding) << ")";
  return text.str();
}

}  // namespace vgroove
