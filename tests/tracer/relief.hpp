// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Real geometry for the tracer: a relief of flat panels that run along x, of finite length.
///
/// Nothing here, nor in the rest of the tracer, includes a header of vcavity: the two programs share the
/// names of their results and no formula.

#include <glm/vec2.hpp>
#include <vector>

namespace tracer {

/// A polyline in the y-z plane drawn out along x. Every pair of neighbouring points bounds one flat panel;
/// panels are numbered from left to right, and light arrives from above.
struct Relief {
  std::vector<glm::dvec2> profile;  ///< (y, z), y increasing, in panel widths
  double length;                    ///< along x, centred on x = 0, in panel widths

  /// Number of panels.
  int panels() const { return static_cast<int>(profile.size()) - 1; }
  /// Height of the highest edge.
  double top() const;
};

/// Equal V-grooves side by side, made of panels of unit width, with the apex of the middle one on the x axis:
/// close to the origin single-precision coordinates resolve the narrow end of a groove best.
/// @param aperture  angle between the panels of a groove, radians, in (0, pi]
/// @param grooves   their number, odd
/// @param length    of every groove, in panel widths
/// @return the relief; panels 2 g and 2 g + 1 are the left and right one of groove g
/// @throws std::invalid_argument if a parameter is out of range
Relief groove_array(double aperture, int grooves, double length);

/// The groove that a panel of groove_array() belongs to.
inline int groove_of(int panel) {
  return panel / 2;
}

}  // namespace tracer
