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
/// panels are numbered in order, and light arrives on their left side, seen along the polyline.
struct Relief {
  std::vector<glm::dvec2> profile;  ///< (y, z), in panel widths; y need not increase where walls overhang
  double length;                    ///< along x, centred on x = 0, in panel widths
  int panels_of_groove = 2;         ///< so many panels in a row belong to one groove, with its land

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

/// Equal grooves of any shape side by side.
/// @param period    the cross-section of one, from rim to rim and over the land behind it: the first and the last point
///                  are as high as any other; (y, z) in panel widths, the origin near its deepest point
/// @param grooves   their number, odd; the middle one lies where `period` says
/// @param length    of every groove, in panel widths
/// @throws std::invalid_argument if a parameter is out of range
Relief profile_array(const std::vector<glm::dvec2>& period, int grooves, double length);

}  // namespace tracer
