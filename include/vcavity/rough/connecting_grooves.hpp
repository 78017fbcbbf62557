// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// All grooves that lead light from one given direction into another: one for each number of bounces and each panel
/// that may be met first.
///
/// Let e point towards the light and o the way it leaves, h be the horizontal part of e + o and y = h/|h|. Light
/// keeps its component along a groove, so only grooves that run at right angles to y can turn −e into o, whatever
/// the number of bounces. In the plane across such a groove e and o have the elevations k_e = atan2(e_z, ±e_y) and
/// k_o = atan2(o_z, ±o_y) above the panel that is met first, + for panel one, and for k_o the opposite sign after
/// an even number of bounces j. Unfolded, the ray is straight and leaves through the image of the opening that is
/// turned by jα:
///
///     jα = k_e + k_o.
///
/// So each j and first panel have exactly one aperture, and the rays that take this way are a fraction
/// √(e_y² + e_z²) B/(2 sin(α/2) e_z) of those that meet the groove, with
///
///     β = (π − jα)/2,   x = (α − |k_e − k_o|)/2,   B = sin(x + β) + min(0, sin(x − β))   if x > 0 and x + β > 0,
///
/// else none. A term of one bounce is the facet model of Torrance and Sparrow (1967), B cos η being their geometric
/// attenuation G times e · m. The pairs are symmetric in e and o.
///
/// All differences are taken between elevations, which are small where light grazes the surface: so they keep their
/// digits there. Where e + o is vertical, in the mirror direction, every azimuth leads there; any will do for the
/// one bounce of a flat facet, and the others, whose sum grows like 1/|h|, are left out: no light is lost, since
/// they have a finite integral.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/rough/way_series.hpp"

namespace vcavity {

namespace detail {

/// Numbers of e and of o, side by side; twice where registers are that wide.
template <class Real>
using PairOf = Pack<Real, has_short_series<Real> ? 4 : 2>;

/// @param of_e, of_o the two numbers
template <class Real>
VCAVITY_INLINE PairOf<Real> pair_of(const Real& of_e, const Real& of_o) {
  using Pair = PairOf<Real>;
  if constexpr (has_short_series<Real>)
    return Pair::template blended<std::array{true, false, true, false}>(Pair(of_e), Pair(of_o));
  else
    return Pair::template blended<std::array{true, false}>(Pair(of_e), Pair(of_o));
}

}  // namespace detail

/// A groove that leads light from e to o, and by which way.
template <class Real>
struct ConnectingGroove {
  Panel first_panel;  ///< the panel met first; the normal of panel one leans towards `across`
  int bounces;        ///< number of reflections
  Real cos_half;      ///< cosine of half the aperture, sin θ_m
  Real sin_half;      ///< sine of half the aperture, cos θ_m
  Real beam;          ///< B, in [0, 2]: the width of the rays that go this way where the panels have width 1
};

/// The grooves that lead light from one direction into another.
template <class Real>
class ConnectingGrooves {
 public:
  /// @param e unit vector towards the light, e.z ≥ 0
  /// @param o unit vector in which the light leaves, o.z ≥ 0
  VCAVITY_INLINE ConnectingGrooves(const Vec3<Real>& e, const Vec3<Real>& o) {
    using std::sqrt;
    const Real h_x = e.x + o.x;
    const Real h_y = e.y + o.y;
    const Real tilt2 = h_x * h_x + h_y * h_y;
    tilt_ = sqrt(tilt2);
    // Without a tilt of e + o any azimuth serves.
    const auto is_tilted = tilt_ > Real(0);
    scale_ = select(is_tilted, tilt_, Real(1));
    const Real inverse = Real(1) / scale_;
    across_ = {h_x * inverse, select(is_tilted, Real(h_y * inverse), Real(1))};
    e_ = in_groove(e);
    o_ = in_groove(o);
    // Of e_y and o_y the sum is |h|, and the difference follows from the heights, since e and o are of one length.
    // Next to the mirror direction, where h is short, products of h with e and o would lose their digits.
    const Real sum_z = e_.z + o_.z;
    const Real drop = (o_.z - e_.z) * sum_z;
    along_h_ = along(e, o, {h_x, h_y}, tilt2, drop);
    e_.y = select(is_tilted, Real(along_h_.x * inverse), e_.y);
    o_.y = select(is_tilted, Real(along_h_.y * inverse), o_.y);
    // Next to the mirror direction the lengths of e and o are too inexact for e_y, which may come out above 1.
    cos_eta_ = at_most(Real(sqrt(e_.y * e_.y + e_.z * e_.z)), Real(1));
    sum_length_ = sqrt(tilt2 + sum_z * sum_z);
    inverse_sum_ = Real(1) / sum_length_;
  }

  /// The unit vector across the grooves, from the side of panel one to that of panel two.
  const Vec2<Real>& across() const { return across_; }

  /// The direction towards the light in the frame of the grooves.
  const Vec3<Real>& to_light() const { return e_; }

  /// cos η, the length of either direction in the plane across the grooves.
  const Real& cos_eta() const { return cos_eta_; }

  /// |h|, the length of the horizontal part of e + o.
  const Real& tilt() const { return tilt_; }

  /// The direction in which the light leaves, in the frame of the grooves.
  const Vec3<Real>& leaving() const { return o_; }

  /// The normal of panel one of a groove, in the frame of the surface.
  Vec3<Real> normal(const ConnectingGroove<Real>& groove) const {
    return {groove.cos_half * across_.x, groove.cos_half * across_.y, groove.sin_half};
  }

  /// BRDF × cosine of the light that goes this way, for facets that reflect all light.
  /// @param groove the groove
  /// @param facet_density D(m) of the groove's facets, see slope_distribution.hpp
  VCAVITY_INLINE Real density(const ConnectingGroove<Real>& groove, const Real& facet_density) const {
    // cos(α/2)/|h| is 1/|e + o| for one bounce; so it has its value in the mirror direction too.
    const Real slope =
        groove.bounces == 1 ? inverse_sum_ : Real(groove.cos_half / (Real(groove.bounces) * tilt_));
    return cos_eta_ / (Real(2) * e_.z) * (facet_density * slope * groove.beam);
  }

  /// The groove of one bounce, a facet whose normal is half-way between the directions.
  VCAVITY_INLINE ConnectingGroove<Real> first() const {
    return {Panel::one, 1, tilt_ * inverse_sum_, (e_.z + o_.z) * inverse_sum_, lit_of_first() / cos_eta_};
  }

  /// BRDF × cosine of the light of one bounce per facet density D(m), for facets that reflect all light.
  VCAVITY_INLINE Real weight_of_first() const { return (Real(0.5) / e_.z) * (lit_of_first() * inverse_sum_); }

  /// The cosine of incidence of the groove of one bounce.
  VCAVITY_INLINE Real cosine_of_first() const { return Real(0.5) * sum_length_; }

  /// e · h and o · h, the components across the groove, times |h|.
  const Vec2<Real>& along_h() const { return along_h_; }

  /// |h|, or 1 where that is 0.
  const Real& scale() const { return scale_; }

  /// The ways of two and more bounces, for those who go through them one at a time.
  AllWays<Real> all_ways() const { return {elevation(e_), elevation(o_), across_, cos_eta_, e_.z, tilt_}; }

  /// BRDF × cosine of all light of more than `max_bounces` bounces, for facets that reflect all light: by the
  /// Euler–Maclaurin formula, with a relative error of the whole BRDF of 3e-4 at most for 32, and seldom a fifth of that.
  /// @param steepest_density D of the facets of vertical slope, whose normal is the horizontal vector `across`
  /// @param max_bounces light that needs more bounces is left out
  VCAVITY_INLINE Real density_beyond(int max_bounces, const Real& steepest_density) const {
    if (!(tilt_ > Real(0)) || !(steepest_density > Real(0))) return Real(0);
    // By value: what is handed over by address lies in memory from the beginning on.
    return cos_eta_ / (Real(2) * tilt_ * e_.z) *
           (steepest_density * beams_beyond(max_bounces, {e_.y, e_.z}, {o_.y, o_.z}, e_.z / cos_eta_));
  }

 private:
  using Elevation = detail::Elevation<Real>;

  /// e · m = |e + o|/2 of the facet of one bounce, and what the rims of the groove leave of it.
  VCAVITY_INLINE Real lit_of_first() const {
    return at_most(Real(Real(0.5) * sum_length_),
                   Real(Real(2) * ((e_.z + o_.z) * inverse_sum_) * at_most(e_.z, o_.z)));
  }

  /// The elevation of a direction above the side of panel one.
  VCAVITY_INLINE static Elevation elevation(const Vec3<Real>& v) { return detail::elevation_of(v.y, v.z); }

  /// The ways of one parity of the number of bounces and one first panel.
  class Series {
   public:
    Series(const Elevation& e, const Elevation& o) {
      const Elevation& lower = e.angle < o.angle ? e : o;
      const Elevation& upper = e.angle < o.angle ? o : e;
      sum_ = lower.angle + upper.angle;
      difference_ = lower.angle < lower.complement ? Real(upper.angle - lower.angle)
                                                   : Real(lower.complement - upper.complement);
      beta_ = Real(0.5) * (upper.complement - lower.angle);
      const Real slowest = at_least(Real(difference_ - Real(2) * beta_), difference_);
      most_bounces_ = sum_ / at_least(slowest, std::numeric_limits<Real>::min());
    }

    /// The integral of the terms cos(α/2) B/j over j from n on, in steps of 2, for D(m) = 1, with
    /// the leading terms of sines and cosines of the small angle α/2.
    /// @param steepness e_z/cos η: no more rays go a way than meet the groove, B ≤ 2 sin(α/2) e_z/cos η. Towards the
    ///        horizon more would be left by rounding.
    Real beyond(const Real& n, const Real& steepness) const {
      using std::log;
      using std::sin;
      if (!(n < most_bounces_)) return Real(0);
      const Real half_sum = Real(0.5) * sum_;
      const Real half_difference = Real(0.5) * difference_;
      const Real cos_beta = sin(half_sum);
      const Real both_lit_until = beta_ > Real(0)
                                      ? at_most(Real(sum_ / (difference_ + Real(2) * beta_)), most_bounces_)
                                      : most_bounces_;
      const Real b = at_least(both_lit_until, n);
      const Real both = (sin(beta_) - cos_beta * half_difference) * log(b / n) +
                        cos_beta * half_sum * (Real(1) / n - Real(1) / b);
      const Real one = half_sum * (Real(1) / b - Real(1) / most_bounces_) -
                       (half_difference > Real(0) ? Real(half_difference * log(most_bounces_ / b)) : Real(0));
      return at_most(at_least(Real(Real(0.5) * both + cos_beta * one), Real(0)),
                     Real(half_sum / n * steepness));
    }

   private:
    Real sum_;         // jα
    Real difference_;  // |k_e − k_o|
    Real beta_;
    Real most_bounces_;
  };

  /// The integral of the terms cos(α/2) B/j over the numbers j beyond a limit, of all series, for D(m) = 1.
  /// @param e, o the directions in the plane across the groove
  /// @param steepness e_z/cos η
  VCAVITY_NOINLINE static Real beams_beyond(int max_bounces, Vec2<Real> e, Vec2<Real> o, Real steepness) {
    const Elevation from = detail::elevation_of(e.x, e.y), to = detail::elevation_of(o.x, o.y);
    const std::array odd{Series(from, to), Series(from.turned(), to.turned())};
    const std::array even{Series(from, to.turned()), Series(from.turned(), to)};
    const bool odd_is_next = max_bounces % 2 == 0;
    Real sum(0);
    for (const Series& series : odd)
      sum += series.beyond(Real(odd_is_next ? max_bounces : max_bounces + 1), steepness);
    for (const Series& series : even)
      sum += series.beyond(Real(odd_is_next ? max_bounces + 1 : max_bounces), steepness);
    return sum;
  }

  /// v · h of one of the two directions, or of both side by side.
  /// @param v_x, v_y its horizontal components
  /// @param drop the square of the other direction's height, less that of its own
  /// @param h the horizontal part of their sum
  /// @param tilt2 |h|²
  template <class Value>
  VCAVITY_INLINE static Value along(const Value& v_x, const Value& v_y, const Value& drop,
                                    const Vec2<Real>& h, const Real& tilt2) {
    const Value product = h.x * v_x + h.y * v_y;
    return select(v_x * v_x + v_y * v_y > tilt2, Value(Real(0.5) * (Value(tilt2) + drop)), product);
  }

  /// e · h and o · h. In lanes, where compilers make no branch of the choice: processors would guess it wrong half the time.
  VCAVITY_INLINE static Vec2<Real> along(const Vec3<Real>& e, const Vec3<Real>& o, const Vec2<Real>& h,
                                         const Real& tilt2, const Real& drop) {
    if constexpr (Number<Real>) {
      const detail::PairOf<Real> both = along(detail::pair_of(e.x, o.x), detail::pair_of(e.y, o.y),
                                              detail::pair_of(drop, Real(-drop)), h, tilt2);
      return {both[0], both[1]};
    } else {
      return {along(e.x, e.y, drop, h, tilt2), along(o.x, o.y, Real(-drop), h, tilt2)};
    }
  }

  /// A direction in the frame of the grooves; its inverse height, and products of two of these, are finite.
  VCAVITY_INLINE Vec3<Real> in_groove(const Vec3<Real>& v) const {
    return {v.x * across_.y - v.y * across_.x, v.x * across_.x + v.y * across_.y,
            at_least(v.z, least_height())};
  }

  static Real least_height() {
    using std::sqrt;
    if constexpr (std::is_floating_point_v<Real> || !Number<Real>) {
      return sqrt(smallest_divisor<Real>());
    } else {
      static const Real value = sqrt(smallest_divisor<Real>());
      return value;
    }
  }

  Vec2<Real> across_;
  Vec3<Real> e_, o_;  // in the frame of the grooves
  Real tilt_;         // |h|
  Real scale_;        // the same, or 1 where that is 0
  Vec2<Real> along_h_;
  Real cos_eta_;
  Real sum_length_;   // |e + o|
  Real inverse_sum_;  // 1/|e + o|
};

}  // namespace vcavity
