// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// From the words of the command line to the profile of the library.

#include <vcavity/conventions.hpp>
#include <vcavity/groove/asymmetric_groove.hpp>
#include <vcavity/groove/cavity.hpp>
#include <vcavity/profiles/land.hpp>
#include <vcavity/profiles/trench.hpp>
#include <vcavity/profiles/truncated_groove.hpp>

#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// Calls `use` with the grooves of a surface and the land between them, be it 0.
/// @pre the description has been checked
/// @return what `use` returns, of one type for all profiles
template <class Use>
auto with_profile(const SurfaceDescription& surface, Use&& use) {
  const ProfileDescription& profile = surface.profile;
  const double land = profile.land.value_or(0), floor = profile.floor.value_or(0);
  double aperture_deg = surface.aperture_deg, tilt_deg = profile.tilt_deg.value_or(0);
  if (profile.slopes_deg) {
    const auto& [one, two] = *profile.slopes_deg;
    if (floor > 0 && one == 90 && two == 90) return use(Land(Trench<double>(floor), land));
    if (floor > 0) return use(Land(TruncatedGroove<double>(radians(one), radians(two), floor), land));
    // The digits of the aperture are those of the sum of the slopes in degrees.
    aperture_deg = 180 - one - two;
    tilt_deg = (one - two) / 2;
  }
  if (tilt_deg == 0 && !profile.panel_two) return use(Land(Cavity<double>(radians(aperture_deg)), land));
  return use(Land(AsymmetricGroove<double>(radians(aperture_deg), radians(tilt_deg)), land));
}

}  // namespace vcavity::tools
