// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// From the words of the command line to the profile of the library.

#include <array>
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
  const double land = profile.land.value_or(0);
  if (profile.slopes_deg) {
    const std::array<double, 2>& slopes = *profile.slopes_deg;
    const double one = radians(slopes[0]), two = radians(slopes[1]), floor = profile.floor.value_or(0);
    if (!(floor > 0)) {
      // The digits of the aperture are those of the sum of the slopes in degrees.
      const double aperture = radians(180 - slopes[0] - slopes[1]);
      return use(Land(AsymmetricGroove<double>(aperture, radians((slopes[0] - slopes[1]) / 2)), land));
    }
    if (slopes[0] == 90 && slopes[1] == 90) return use(Land(Trench<double>(floor), land));
    return use(Land(TruncatedGroove<double>(one, two, floor), land));
  }
  const double aperture = radians(surface.aperture_deg), tilt_deg = profile.tilt_deg.value_or(0);
  if (tilt_deg == 0 && !profile.panel_two) return use(Land(Cavity<double>(aperture), land));
  return use(Land(AsymmetricGroove<double>(aperture, radians(tilt_deg)), land));
}

}  // namespace vcavity::tools
