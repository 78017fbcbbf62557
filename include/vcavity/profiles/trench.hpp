// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A rectangular trench: two vertical walls and a floor.
///
/// Method. Mirrored in its walls the trench is a flat floor. With the depth h and the width b, light that travels across
/// by X = 2h |tan θ'| / b widths from the opening to the floor and back meets the floor once, and as many walls as there
/// are multiples of b on its way: ⌊X⌋, or one more for the fraction X − ⌊X⌋ of the opening. Half of the way lies before
/// the floor; so there are at most three lobes, of the faces met before and after it. The cosines of incidence are |e_y|
/// on the walls and e_z on the floor.
///
/// When not to use it: without `Land` between the trenches. Walls of no thickness do not exist.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "vcavity/conventions.hpp"
#include "vcavity/facet/bounce.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/profiles/profile.hpp"

namespace vcavity {

/// A groove with vertical walls, infinitely long.
template <Number Real>
class Trench {
 public:
  using value_type = Real;
  static constexpr bool is_profile = true;

  /// @param floor width of the trench over its depth, > 0
  /// @throws std::invalid_argument when it is out of range or is not a number
  explicit Trench(const Real& floor) : floor_over_depth_(floor) {
    if (!(floor > Real(0) && floor <= std::numeric_limits<Real>::max())) {
      throw_invalid_argument("the floor of a trench must be more than 0 depths wide, not ", floor);
    }
  }

  /// Width of the floor over the depth.
  Real floor_over_depth() const { return floor_over_depth_; }

  /// The area of all faces per area of the opening, under diffuse light the mean number of bounces.
  Real developed_area() const { return Real(1) + Real(2) / floor_over_depth_; }

  /// No ray bounces more often.
  static constexpr int max_bounces() { return most_walls + 2; }

  /// Follows all light of a direction; see `Profile`.
  ///
  /// Grazing light counts as if it met no more than 2³⁰ walls. As all bounces on a wall are alike, many take no longer
  /// than their binary digits.
  /// @param e direction towards the light, e.z ≥ 0
  /// @param facets facet reflectances of the faces, or one for all
  /// @param visit called for each part of the light
  /// @param max_bounces light that needs more bounces is left out
  template <class Facets, class Visit>
  void follow(const Vec3<Real>& e, const Facets& facets, Visit&& visit, int max_bounces = all_bounces) const {
    using std::floor;
    using Value = face_value_t<Facets, Real>;
    assert(e.z >= Real(0));
    const Real sideways = magnitude(e.y);
    const Real most(most_walls);
    // X, without a division that might overflow, or be one by an underflow
    const Real way = Real(2) * sideways < most * floor_over_depth_ * e.z
                         ? Real(Real(2) * sideways / (most * floor_over_depth_ * e.z) * most)
                         : most;
    const Panel facing = e.y < Real(0) ? Panel::two : Panel::one;
    const Bounce<Real> down{sideways, e.z, e.x, Panel::one, 1}, up{sideways, -e.z, e.x, Panel::one, 1};

    // Rays within a fraction of the opening, counted along the way of the light, meet one more wall before the floor, or
    // in all. So the weights of few rays keep their digits.
    const Real half = way / Real(2);
    const Real before = floor(half), in_all = floor(way);
    const Real more_before = half - before, more_in_all = way - in_all;
    const std::array<Real, 4> ends{Real(1), std::max(more_before, more_in_all),
                                   std::min(more_before, more_in_all), Real(0)};
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const Real weight = ends[i] - ends[i + 1];
      if (!(weight > Real(0))) continue;
      const int walls = static_cast<int>(before) + (ends[i] <= more_before ? 1 : 0);
      const int all_walls = static_cast<int>(in_all) + (ends[i] <= more_in_all ? 1 : 0);
      FacePath path{facing, walls, true, walls % 2 == 0 ? facing : opposite(facing), all_walls - walls,
                    false};
      if (path.bounces() > max_bounces) continue;
      // Every wall turns the light round.
      const Bounce<Real> on_floor{e.z, walls % 2 == 0 ? Real(-e.y) : e.y, e.x, Panel::one, walls + 1};
      Value throughput = detail::reflect_at(facets, Face::floor, on_floor);
      if (walls > 0) throughput = alternating<Value>(facets, path.first_wall, walls, down) * throughput;
      if (path.walls_after_floor > 0)
        throughput =
            throughput * alternating<Value>(facets, path.first_wall_after_floor, path.walls_after_floor, up);
      const Real start = facing == Panel::two ? Real(Real(1) - ends[i]) : ends[i + 1];
      visit(FacePencil<Real>{path, start, weight, {-e.x, all_walls % 2 == 0 ? Real(-e.y) : e.y, e.z}},
            throughput);
    }
  }

 private:
  static constexpr int most_walls = 1 << 30;

  /// The product over walls met in turn.
  /// @param count their number, > 0
  template <class Value, class Facets>
  static Value alternating(const Facets& facets, Panel first, int count, const Bounce<Real>& bounce) {
    const auto at = [&](Panel panel) {
      Bounce<Real> there = bounce;
      there.panel = panel;
      return detail::reflect_at(facets, face_of(panel), there);
    };
    const Value single = at(first);
    if (count == 1) return single;
    Value power = single * at(opposite(first));
    Value product(1);
    for (int pairs = count / 2; pairs > 0; pairs /= 2) {
      if (pairs % 2 != 0) product = product * power;
      power = power * power;
      // Of many total reflections the rounding would grow beyond all numbers.
      if constexpr (requires { at_most(power, scalar_t<Value>(1)); })
        power = at_most(power, scalar_t<Value>(1));
    }
    return count % 2 == 0 ? product : product * single;
  }

  Real floor_over_depth_;
};

}  // namespace vcavity
