// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Where on the hemisphere the number of bounces changes.

#include <vcavity/groove/cavity.hpp>
#include <vector>

namespace vcavity::tools {

/// Directions whose light, depending on where it enters the groove, bounces between `least` and `most` times.
/// They lie between two great half-circles through the ends of the groove: the angle θ' of a direction,
/// projected on the plane across the groove (Eq. 7), decides alone.
struct BounceZone {
  double low;   ///< smallest θ' in radians
  double high;  ///< largest θ' in radians
  int least;
  int most;
};

/// The zones of a groove in ascending order of θ', from 0 to π/2; negative θ' mirror them. They end at the kinks of the
/// groove, and all of them are there.
std::vector<BounceZone> bounce_zones(const Cavity<double>& cavity);

}  // namespace vcavity::tools
