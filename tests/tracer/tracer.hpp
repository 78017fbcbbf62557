// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Light followed from mirror to mirror across a real relief, one ray at a time.
///
/// Each reflection is the law of the mirror at the panel's geometric normal. There is no unfolding, no
/// formula for the number of bounces and no lobe in here: this is the program that the closed form of vcavity
/// has to agree with.

#include <glm/vec3.hpp>
#include <vector>

#include "embree_scene.hpp"
#include "relief.hpp"

namespace tracer {

/// One reflection.
struct Bounce {
  int panel;             ///< index in the relief
  double cos_incidence;  ///< of the angle between the ray and the panel's normal; negative from below
  int groove;            ///< that the panel belongs to
};

/// How a path ends.
enum class Ending {
  upwards,  ///< it leaves the relief through the plane of its top, where the grooves still have their walls
  missed,   ///< it has met no panel at all
  past_an_end,  ///< it leaves between two walls through an end of the finite grooves, or below the relief
  trapped,      ///< it does not come out: a failure of the arithmetic
};

/// A path from the light to where it leaves the relief.
struct Path {
  std::vector<Bounce> bounces;
  glm::dvec3 direction;  ///< of travel, after the last bounce
  glm::dvec3 top;        ///< where the last segment crosses the plane of the relief's top
  Ending ending;
  /// The smallest distance between the path and an edge of the relief that it passes or is stopped next to,
  /// measured across the ray, in panel widths. Beside an edge the neighbouring ray takes another way, so this
  /// is the distance to the nearest discontinuity of everything that depends on the path, found without a
  /// formula for where these lie.
  double clearance;
  bool refined = false;  ///< whether a panel was chosen in double precision
};

/// The number of panels met after the path had already left through the top of the groove that it met first.
int bounces_in_other_grooves(const Path& path);

/// Follows rays across one relief.
class Tracer {
 public:
  /// @throws std::runtime_error if Embree reports an error
  explicit Tracer(Relief relief);

  const Relief& relief() const { return relief_; }

  /// @param origin     where the ray starts, above the relief, in panel widths
  /// @param direction  of travel, of unit length
  Path trace(glm::dvec3 origin, glm::dvec3 direction) const;

 private:
  // A straight piece of a path, as far as the panel where it stops, if there is one.
  struct Segment {
    std::optional<int> panel;
    double distance;       // to the panel along the ray, or infinity
    double clearance;      // as in Path
    bool refined = false;  // as in Path
  };

  Segment segment_to(std::optional<int> panel, glm::dvec3 origin, glm::dvec3 direction) const;
  Segment next_segment(glm::dvec3 origin, glm::dvec3 direction) const;
  std::optional<int> search_all_panels(glm::dvec3 origin, glm::dvec3 direction) const;
  double distance_to(int panel, glm::dvec3 origin, glm::dvec3 direction) const;

  Relief relief_;
  std::vector<glm::dvec3> normals_;  // of each panel, on the side of the light
  EmbreeScene scene_;
};

}  // namespace tracer
