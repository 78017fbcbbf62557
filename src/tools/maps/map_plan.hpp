// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which effects a scene calls for: the tool's side of vcavity/planner.hpp, in words, and for colours.

#include <string>
#include <vcavity/plan/planner.hpp>
#include <vector>

#include "tools/maps/disc_map.hpp"

namespace vcavity::tools {

/// What a plan does, what it leaves out, and the bound on the error of each; one line.
std::string in_words(const EffectsPlan& plan);

/// The cheapest map that shows the full physics within a tolerance.
struct MapPlan {
  MapRequest request;
  std::string explanation;  ///< one line
  double bound;             ///< on the error, in the units of the tolerance
};

/// Plans a map of the reflectance.
///
/// At one wavelength the tolerance is an absolute error of the reflectance in every direction, see
/// plan_effects(). For a grid of wavelengths it is a colour difference CIEDE2000: the colours of cheaper maps
/// (coarser grid, no polarisation, float) are compared with those of the full physics on the given grid in
/// 1600 directions, and the bound is twice the largest difference. The planned map then holds the
/// colour only.
///
/// Throws UsageError where a grid of wavelengths has no colour.
MapPlan plan_map(MapRequest request, double tolerance);

/// The same map in float if rounding keeps within a tolerance then, else in double; nothing else is left out.
/// @param tolerance absolute error of the reflectance or absorptance at every wavelength
/// @param stored how its numbers are stored, which rounds them too
/// Throws UsageError for a tolerance that not even double and this storage can promise, and for a map of
/// another quantity.
MapPlan plan_precision(MapRequest request, double tolerance, ExrNumber stored);

}  // namespace vcavity::tools
