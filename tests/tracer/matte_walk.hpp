// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Light followed across a real relief of matte panels, one random walk at a time: each panel sends it on into the
/// hemisphere above itself with the cosine of the angle to its normal. No view factor and no integral equation in here.

#include <glm/vec3.hpp>

#include "embree_scene.hpp"
#include "relief.hpp"
#include "statistics.hpp"

namespace tracer {

/// A walk from the light to where it leaves the relief.
struct MatteWalk {
  int on_left = 0;       ///< times that a left panel of a groove was met (even index), and
  int on_right = 0;      ///< a right one
  glm::dvec3 direction;  ///< of travel, after the last panel
  bool escaped = false;  ///< upwards; else the arithmetic has lost it, or the grooves have ended
};

/// Follows random walks across one relief.
class MatteWalker {
 public:
  /// @throws std::runtime_error if Embree reports an error
  explicit MatteWalker(Relief relief);

  /// @param origin     where the light starts, above the relief, in panel widths
  /// @param direction  of travel, of unit length
  MatteWalk walk(glm::dvec3 origin, glm::dvec3 direction, agreement::Uniform& uniform) const;

 private:
  Relief relief_;
  EmbreeScene scene_;
};

}  // namespace tracer
