// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/bounce_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vcavity/hemisphere/kinks.hpp>

namespace vcavity::tools {
namespace {

struct BounceRange {
  int least = std::numeric_limits<int>::max();
  int most = 0;

  bool operator==(const BounceRange&) const = default;
};

/// Adds the numbers of bounces of the rays that meet first the panel towards which θ' is positive.
///
/// With the panels unfolded, a ray of m bounces meets them at the angles −D, α − D, …, (m − 1) α − D from their normals,
/// D = (π − α)/2 − θ', of which the last lies below π/2; and it deviates from the line through the middles of the
/// openings by less than α/2, |(m − 1) α/2 − D| < α/2.
void add_rays(BounceRange& range, const Cavity<double>& cavity, double theta_across) {
  const double aperture = cavity.aperture();
  const double first = (pi<double>() - aperture) / 2 - theta_across;
  const int lower = static_cast<int>(std::floor(2 * first / aperture)) + 1;
  for (const int bounces : {lower, lower + 1}) {
    if (bounces < 1 || !((bounces - 1) * aperture - first < pi<double>() / 2)) continue;
    range.least = std::min(range.least, bounces);
    range.most = std::max(range.most, bounces);
  }
}

BounceRange bounces_at(const Cavity<double>& cavity, double theta_across) {
  BounceRange range;
  add_rays(range, cavity, theta_across);
  if (theta_across < cavity.aperture() / 2) add_rays(range, cavity, -theta_across);
  return range;
}

}  // namespace

std::vector<BounceZone> bounce_zones(const Cavity<double>& cavity) {
  const std::vector<double> angles = kinks(cavity);
  std::vector<BounceZone> zones;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    const BounceRange here = bounces_at(cavity, (angles[i] + angles[i + 1]) / 2);
    if (!zones.empty() && zones.back().least == here.least && zones.back().most == here.most)
      zones.back().high = angles[i + 1];
    else
      zones.push_back({angles[i], angles[i + 1], here.least, here.most});
  }
  return zones;
}

}  // namespace vcavity::tools
