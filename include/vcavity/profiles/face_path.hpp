// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The way of light over a surface whose grooves have more than two panels: which faces it meets, in which order.
///
/// Between two meetings with the floor light alternates between the panels, and no more than one floor is met; so a few
/// numbers say all, however many bounces there are.

#include <string>

#include "vcavity/conventions.hpp"

namespace vcavity {

/// A plane face of a surface with grooves.
enum class Face {
  one,    ///< panel one
  two,    ///< panel two
  floor,  ///< the flat bottom of a groove
  land    ///< the flat between two grooves, at the height of their rims
};

/// A panel as a face.
constexpr Face face_of(Panel panel) {
  return panel == Panel::one ? Face::one : Face::two;
}

/// The faces that light meets, in order: `walls` panels in turn, the floor, `walls_after_floor` panels in turn; or the
/// land alone.
struct FacePath {
  Panel first_wall = Panel::one;              ///< the panel met first, if `walls` > 0
  int walls = 0;                              ///< panels met before the floor, or at all
  bool meets_floor = false;                   ///< whether the floor is met
  Panel first_wall_after_floor = Panel::one;  ///< the panel met after the floor, if `walls_after_floor` > 0
  int walls_after_floor = 0;                  ///< panels met after the floor
  bool meets_land = false;                    ///< whether the land is met, and nothing else

  friend bool operator==(const FacePath&, const FacePath&) = default;

  /// Number of reflections.
  int bounces() const { return meets_land ? 1 : walls + (meets_floor ? 1 : 0) + walls_after_floor; }

  /// The face met first.
  Face first_face() const {
    if (meets_land) return Face::land;
    return walls > 0 ? face_of(first_wall) : Face::floor;
  }

  /// One character for every face: 1 and 2 for the panels, F for the floor, L for land; such as "1F2".
  std::string text() const {
    if (meets_land) return "L";
    std::string faces = alternating(first_wall, walls);
    if (meets_floor) faces += 'F';
    return faces + alternating(first_wall_after_floor, walls_after_floor);
  }

 private:
  static std::string alternating(Panel first, int count) {
    std::string faces;
    for (Panel panel = first; count > 0; --count, panel = opposite(panel))
      faces += panel == Panel::one ? '1' : '2';
    return faces;
  }
};

/// Rays of one direction that enter a groove side by side and go the same way.
template <class Real>
struct FacePencil {
  FacePath path;         ///< the faces met
  Real start;            ///< where they enter: a fraction of the period, from the rim of panel one towards +y
  Real weight;           ///< how much of it they fill
  Vec3<Real> direction;  ///< in which they travel after the last bounce
};

}  // namespace vcavity
