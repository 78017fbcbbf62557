// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A V-groove with a flat bottom: two panels that need not be equally steep, and a floor between their feet.
///
/// Method. A ray meets the floor once at most: light that climbs at an angle χ meets a wall of slope β > χ, and leaves
/// it at 2β − χ < 180°, still climbing. So the groove unfolds around the apex O of the full V, in which the panels
/// would meet: once on the way down, and once more on the way up. Rays of one direction are known by their signed
/// distance from O; the ends of all images cut the opening into the intervals of the lobes. With the full V of depth 1,
/// its opening W, L = 1/sin β the lengths of its panels, t the floor's part of the opening and r = (e_y² + e_z²)^½,
/// image j of the panels, met in turn, stands at the angle φ_j to the light, its rim at the distance h_j = r L sin φ_j
/// and its foot at t h_j. Light that meets the floor after j panels is mirrored there, which moves O by twice the
/// height of the floor, and climbs past images at the angles κ, κ − α, … until it leaves.
///
/// Distances are counted from the one where light enters first and in units of the width of the light, W e_z. So the
/// weights of a direction add up to 1 whatever the rounding, also for grazing light.
///
/// Validity: slopes in (0, 90°], not both 90° (`Trench`), and any floor. Within a few minutes of arc of vertical walls
/// O lies far below and weights lose digits: 2e-12 in double at 89.9°. Overhanging walls with a floor are not covered:
/// light then comes back to the floor.

#include <algorithm>
#include <cassert>
#include <limits>

#include "vcavity/conventions.hpp"
#include "vcavity/facet/bounce.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/profiles/profile.hpp"

namespace vcavity {

/// A groove with a flat bottom, infinitely long.
template <Number Real>
class TruncatedGroove {
 public:
  using value_type = Real;
  static constexpr bool is_profile = true;

  /// @param slope_one,slope_two angles of the panels to the mean plane, in (0, π/2], not both π/2
  /// @param floor width of the flat bottom over the depth of the groove, ≥ 0; 0 is the V-groove
  /// @throws std::invalid_argument when one is out of range or is not a number
  TruncatedGroove(const Real& slope_one, const Real& slope_two, const Real& floor)
      : slopes_{slope_one, slope_two}, floor_over_depth_(floor) {
    using std::cos;
    using std::sin;
    const Real half_pi = pi<Real>() / Real(2);
    const Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
    for (const Real& slope : slopes_)
      if (!(slope > Real(0) && slope <= half_pi * (Real(1) + rounding)))
        refuse("the slopes of a groove with a floor must lie in (0, π/2] radians, not ", slope);
    aperture_ = from_vertical(slope_one) + from_vertical(slope_two);
    if (!(aperture_ > rounding))
      refuse("the walls of a groove that narrows must not both be vertical, not ", slope_one);
    if (!(floor >= Real(0) && floor <= std::numeric_limits<Real>::max()))
      refuse("the floor of a groove must be at least 0 depths wide, not ", floor);
    lengths_[0] = Real(1) / sin(slope_one);
    lengths_[1] = Real(1) / sin(slope_two);
    opening_ = lengths_[0] * lengths_[1] * sin(aperture_);
    floor_over_opening_ = floor / (opening_ + floor);
  }

  /// The angle of a panel to the mean plane.
  const Real& slope(Panel panel) const { return slopes_[index(panel)]; }

  /// Width of the floor over the depth of the groove.
  Real floor_over_depth() const { return floor_over_depth_; }

  /// Width of the floor over that of the opening.
  Real floor_over_opening() const { return floor_over_opening_; }

  /// The area of all faces per area of the opening, under diffuse light the mean number of bounces.
  Real developed_area() const {
    return (lengths_[0] + lengths_[1]) * (Real(1) - floor_over_opening_) / opening_ + floor_over_opening_;
  }

  /// No ray bounces more often: on its way down it turns by less than π, and so it does on its way up.
  int max_bounces() const {
    constexpr int most_turns = (std::numeric_limits<int>::max() - 3) / 2;
    return 2 * (whole_at_most(Real(pi<Real>() / aperture_), most_turns) + 1) + 1;
  }

  /// Follows all light of a direction; see `Profile`.
  /// @param towards_light direction towards the light, z ≥ 0
  /// @param facets facet reflectances of the faces, or one for all
  /// @param visit called for each part of the light
  /// @param max_bounces light that needs more bounces is left out
  template <class Facets, class Visit>
  void follow(const Vec3<Real>& towards_light, const Facets& facets, Visit&& visit,
              int max_bounces = all_bounces) const {
    assert(towards_light.z >= Real(0));
    const Real least_up = smallest_divisor<Real>() / at_most(opening_, Real(1));
    const Vec3<Real> e{towards_light.x, towards_light.y, at_least(towards_light.z, least_up)};
    for (const Panel first : {Panel::one, Panel::two}) {
      Descent<Facets, Visit> descent(*this, e, first, facets, visit, max_bounces);
      descent.follow();
    }
  }

 private:
  static constexpr std::size_t index(Panel panel) { return panel == Panel::one ? 0 : 1; }

  static void refuse(const char* message, const Real& value) { throw_invalid_argument(message, value); }

  /// π/2 − slope, with the digits by which π/2 differs from its rounded value, which is the cosine of that.
  static Real from_vertical(const Real& slope) {
    using std::cos;
    const Real half_pi = pi<Real>() / Real(2);
    return (half_pi - slope) + cos(half_pi);
  }

  /// A range of distances from O.
  struct Interval {
    Real low, high;
    bool empty() const { return !(low < high); }
    Interval mirrored() const { return {-high, -low}; }
  };

  /// The light that meets one panel first, p; the other one is q. In a frame in which p lies at y < 0.
  template <class Facets, class Visit>
  class Descent {
   public:
    using Value = face_value_t<Facets, Real>;

    Descent(const TruncatedGroove& groove, const Vec3<Real>& e, Panel first, const Facets& facets,
            Visit& visit, int max_bounces)
        : groove_(groove),
          along_(e.x),
          first_(first),
          facets_(facets),
          visit_(visit),
          max_bounces_(max_bounces) {
      using std::atan2;
      using std::sqrt;
      const Real size = at_least(magnitude(e.y), e.z);
      const Real y = e.y / size, z = e.z / size;
      across_ = size * sqrt(y * y + z * z);
      width_ = groove.opening_ * e.z;
      const Real facing = first == Panel::one ? e.y : Real(-e.y);
      theta_ = atan2(facing, e.z);
      phi_0_ = theta_ - from_vertical(groove.slope(opposite(first)));
      phi_1_ = from_vertical(groove.slope(first)) + theta_;
      base_ = at_least(rim(0), Real(0));
    }

    void follow() {
      const Real inside = (rim(0) - base_) / width_;
      if (first_ == Panel::one)
        from_floor(
            0, Value(1),
            {std::max(inside, foot_beyond_base(0)), std::min(rim_beyond_base(1), foot_beyond_base(1))});
      if (!(phi_1_ > Real(0))) return;
      Interval rest{std::max(inside, foot_beyond_base(1)), rim_beyond_base(1)};
      Value throughput(1);
      for (int j = 1; !rest.empty() && j <= max_bounces_; ++j) {
        const Bounce<Real> bounce = on_wall(wall(j), phi(j), j);
        throughput = j == 1 ? at(face_of(wall(1)), bounce) : throughput * at(face_of(wall(j)), bounce);
        Real next_rim = rest.low, next_foot = rest.low;
        if (phi(j + 1) < pi<Real>()) {
          next_rim = rim_beyond_base(j + 1);
          next_foot = foot_beyond_base(j + 1);
        }
        const Interval leaves{std::max(rest.low, next_rim), rest.high};
        if (!leaves.empty())
          visit_(pencil({first_, j, false, Panel::one, 0, false}, leaves, leaving(bounce)), throughput);
        from_floor(j, throughput, {rest.low, std::min(rest.high, next_foot)});
        rest = {std::max(rest.low, next_foot), std::min(rest.high, next_rim)};
      }
    }

   private:
    /// The panel met as number j; number 0 is the one that casts the shadow.
    Panel wall(int j) const { return j % 2 != 0 ? first_ : opposite(first_); }

    Real phi(int j) const { return j == 0 ? phi_0_ : Real(phi_1_ + Real(j - 1) * groove_.aperture_); }

    /// h_j
    Real rim(int j) const {
      using std::sin;
      return across_ * groove_.lengths_[index(wall(j))] * sin(phi(j));
    }

    /// (h_j − base)/(W e_z), as a product that keeps its digits as e_z → 0.
    Real rim_beyond_base(int j) const {
      using std::cos;
      using std::sin;
      if (!(base_ > Real(0))) return rim(j) / width_;
      const int from = j % 2;  // the image that ends on the same circle
      const Real turn = Real(j - from) * groove_.aperture_ / Real(2);
      const Real beyond = Real(2) * groove_.lengths_[index(wall(j))] * sin(turn) *
                          (across_ * cos((from == 0 ? phi_0_ : phi_1_) + turn)) / width_;
      return from == 0 ? beyond : Real(1) + beyond;
    }

    /// (t h_j − base)/(W e_z)
    Real foot_beyond_base(int j) const {
      const Real t = groove_.floor_over_opening_;
      if (!(base_ > Real(0))) return t * rim(j) / width_;
      return t * rim_beyond_base(j) - (Real(1) - t) * (base_ / width_);
    }

    /// @param rays distances from O on the way down
    FacePencil<Real> pencil(const FacePath& path, const Interval& rays, const Vec3<Real>& direction) const {
      // The rim of the panel met first is the end of the opening.
      const Real from_rim = rim_beyond_base(1) - rays.high, weight = rays.high - rays.low;
      return {path, first_ == Panel::one ? from_rim : Real(Real(1) - from_rim - weight), weight, direction};
    }

    Value at(Face face, const Bounce<Real>& bounce) const {
      return detail::reflect_at(facets_, face, bounce);
    }

    /// @param angle from the panel to the light
    Bounce<Real> on_wall(Panel panel, const Real& angle, int number) const {
      using std::cos;
      using std::sin;
      return {at_least(Real(across_ * sin(angle)), Real(0)), across_ * cos(angle), along_, panel, number};
    }

    /// Where light goes after a bounce.
    Vec3<Real> leaving(const Bounce<Real>& bounce) const {
      using std::cos;
      using std::sin;
      const Real cosine = cos(groove_.slope(bounce.panel)), sine = sin(groove_.slope(bounce.panel));
      const Real outwards = bounce.tangent * cosine + bounce.cosine * sine;
      return {-along_, bounce.panel == Panel::one ? outwards : Real(-outwards),
              bounce.cosine * cosine - bounce.tangent * sine};
    }

    /// Light that meets the floor after j panels.
    /// @param throughput of these
    /// @param rays distances from O on the way down
    void from_floor(int j, const Value& throughput, Interval rays) {
      using std::cos;
      using std::sin;
      if (rays.empty() || j >= max_bounces_) return;
      // The direction of the light as the floor finds it, from +y.
      const bool turned = j % 2 != 0;
      const Real omega = turned ? Real(pi<Real>() - groove_.slope(first_) + phi(j))
                                : Real(groove_.slope(opposite(first_)) - phi(j));
      // A ray at the distance x on the way down has the distance sign · x + shift on the way up, x in units of the
      // width and counted from `base`.
      bool mirrored = turned;
      Real shift = -Real(2) * groove_.floor_over_opening_ * across_ * cos(omega);
      if (turned) rays = rays.mirrored();

      const Real y = across_ * cos(omega), z = at_least(Real(across_ * sin(omega)), Real(0));
      const Real floor_y = first_ == Panel::one ? y : Real(-y);
      const Bounce<Real> floor{z, -floor_y, along_, Panel::one, j + 1};
      Value light = j == 0 ? at(Face::floor, floor) : throughput * at(Face::floor, floor);

      FacePath path{first_, j, true, first_, 0, false};
      Vec3<Real> direction{-along_, -floor_y, z};
      Real climb = groove_.slope(first_) - omega;
      if (climb > Real(0)) {
        mirrored = !mirrored;
        shift = -shift;
        rays = rays.mirrored();
      } else {
        climb = groove_.slope(opposite(first_)) + omega - pi<Real>();
        path.first_wall_after_floor = opposite(first_);
      }
      for (int k = 1; !rays.empty(); ++k) {
        const Panel panel = k % 2 != 0 ? path.first_wall_after_floor : opposite(path.first_wall_after_floor);
        const Real angle = climb - Real(k - 1) * groove_.aperture_;
        Real end = rays.low;
        if (angle > Real(0))
          end = (across_ * groove_.lengths_[index(panel)] * sin(angle) - shift +
                 (mirrored ? base_ : Real(-base_))) /
                width_;
        const Interval leaves{std::max(rays.low, end), rays.high};
        if (!leaves.empty()) visit_(pencil(path, mirrored ? leaves.mirrored() : leaves, direction), light);
        rays.high = std::min(rays.high, end);
        if (rays.empty() || j + k >= max_bounces_) return;
        Bounce<Real> bounce = on_wall(panel, angle, j + 1 + k);
        bounce.tangent = -bounce.tangent;  // the light climbs
        light = light * at(face_of(panel), bounce);
        path.walls_after_floor = k;
        direction = leaving(bounce);
      }
    }

    const TruncatedGroove& groove_;
    Real along_;
    Panel first_;
    const Facets& facets_;
    Visit& visit_;
    int max_bounces_;
    Real across_;  // r
    Real width_;   // of the light that enters the full V
    Real theta_;   // θ', or −θ' where panel two is met first
    Real phi_0_, phi_1_;
    Real base_;  // the distance of the ray that enters first, 0 if that is O's own
  };

  std::array<Real, 2> slopes_;
  Real floor_over_depth_;
  Real aperture_;
  std::array<Real, 2> lengths_;  // of the panels of the full V of depth 1
  Real opening_;                 // of it
  Real floor_over_opening_;
};

}  // namespace vcavity
