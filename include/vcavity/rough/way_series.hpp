// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The ways of light through the grooves that lead it from one direction into another, as a function of the number of
/// bounces: for one panel that is met first, and for even numbers or for odd ones.
///
/// The geometry is that of connecting_grooves.hpp. All elevations are in the plane across the groove; with k_e and k_o
/// above the horizons from which they make the aperture α = (k_e + k_o)/j, the width B of the rays of a way follows
/// without a branch, for as many series side by side as a value has components, and for the arrays of renderers that
/// follow many paths in lockstep.
///
/// When not to use it: from outside; `ConnectingGrooves` knows which elevations belong together.

#include <cmath>
#include <limits>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// Ways through grooves side by side, one in each component of a value.
template <class Value>
struct GrooveWays {
  Value bounces;          ///< the numbers of bounces
  Value inverse_bounces;  ///< 1/bounces
  Value elevation;        ///< of the light above the panel that is met first, in the plane across the groove
  Value half_aperture;    ///< α/2
  Value cos_half, sin_half;
  Value beam;  ///< B, as in `ConnectingGroove`; 0 where there is no groove

  /// The normals of panel one, or of panel two turned by half a turn, in the frame of the surface.
  /// @param across the unit vector across the grooves
  template <class Number>
  Vec3<Value> normals(const Vec2<Number>& across) const {
    return {across.x * cos_half, across.y * cos_half, sin_half};
  }

  /// BRDF × cosine of the light that goes each way, of two and more bounces, for facets that reflect all light.
  /// @param cos_eta cos η
  /// @param height e_z
  /// @param tilt |h|
  /// @param facet_densities D(m) of the groove of each
  template <class Number>
  Value densities(const Number& cos_eta, const Number& height, const Number& tilt,
                  const Value& facet_densities) const {
    return cos_eta / (Number(2) * height) * (facet_densities * beam * cos_half / (tilt * bounces));
  }
};

/// @tparam Value a number, or a pack with a series in each component
template <class Value>
class WaySeries {
 public:
  using Real = scalar_t<Value>;

  /// @param from elevation of the light above the panel that is met first
  /// @param to elevation of the way it leaves, above the same panel after an odd number of bounces, above the other
  ///        one after an even number
  VCAVITY_INLINE WaySeries(const detail::Elevation<Value>& from, const detail::Elevation<Value>& to)
      : WaySeries(from, to, Real(2) * detail::acute_sine(Value(Real(0.5) * (from.angle + to.angle)))) {}

  /// The same if more is known.
  /// @param beam_of_one 2 cos β
  VCAVITY_INLINE WaySeries(const detail::Elevation<Value>& from, const detail::Elevation<Value>& to,
                           const Value& beam_of_one)
      : from_(from.angle), beam_of_one_(beam_of_one) {
    lower_ = at_most(from.angle, to.angle);
    upper_ = at_least(from.angle, to.angle);
    lower_complement_ = at_least(from.complement, to.complement);
    upper_complement_ = at_most(from.complement, to.complement);
    sum_ = lower_ + upper_;
    // Where elevations are measured from the near horizon, they have more digits than from the far one.
    const auto is_low = lower_complement_ > lower_;
    const Value difference =
        select(is_low, Value(upper_ - lower_), Value(lower_complement_ - upper_complement_));
    twice_beta_ = upper_complement_ - lower_;
    slowest_ = at_least(Value(difference - twice_beta_), difference);
    nearer_ = select(is_low, lower_, Value(-lower_complement_));
    half_turns_before_ = select(is_low, Value(Real(1)), Value(Real(2)));
  }

  /// Elevation of the light above the panel that is met first.
  VCAVITY_INLINE const Value& elevation() const { return from_; }

  /// jα, how far the light turns in the unfolded groove.
  VCAVITY_INLINE const Value& sweep() const { return sum_; }

  /// Ways of fewer bounces than this exist.
  Value most_bounces() const { return sum_ / at_least(slowest_, std::numeric_limits<Real>::min()); }

  /// Where there are ways of given numbers of bounces.
  /// @param bounces whole numbers above 1
  VCAVITY_INLINE mask_t<Value> have(const Value& bounces) const { return sum_ > Value(bounces * slowest_); }

  /// The ways of given numbers of bounces.
  /// @param bounces whole numbers above 1, of the parity of the series
  VCAVITY_INLINE GrooveWays<Value> ways(const Value& bounces) const {
    GrooveWays<Value> ways;
    ways.bounces = bounces;
    ways.inverse_bounces = Value(Real(1)) / bounces;
    ways.elevation = from_;
    const Value inverse = Real(0.5) * ways.inverse_bounces;
    const Value fewer = bounces - Value(Real(1));
    ways.half_aperture = sum_ * inverse;
    // 2jβ, 2jx and 2j(x + β)
    const Value beta = bounces * twice_beta_;
    const Value x = (bounces + Value(Real(1))) * lower_ - fewer * upper_;
    const Value x_plus_beta =
        (bounces + fewer) * upper_complement_ + nearer_ - pi<Real>() * (bounces - half_turns_before_);
    const auto is_one_lit = beta > x;
    const Value angle = select(is_one_lit, x, x_plus_beta) * inverse;
    ways.cos_half = detail::acute_cosine(ways.half_aperture);
    ways.sin_half = detail::acute_sine(ways.half_aperture);
    const Value beam = select(is_one_lit, beam_of_one_, Value(Real(1))) * detail::acute_sine(angle);
    ways.beam = select(have(bounces), at_least(beam, Real(0)), Value(Real(0)));
    return ways;
  }

 private:
  Value from_;
  Value lower_, upper_;  // elevations above the near horizon
  Value lower_complement_, upper_complement_;
  Value nearer_;             // the lower elevation, from the near horizon or negative from the far one,
  Value half_turns_before_;  // and the number of bounces at which that is x + β
  Value sum_;                // jα
  Value twice_beta_;         // 2β
  Value beam_of_one_;        // 2 cos β, which is 2 sin(jα/2); only asked for where β > 0
  Value slowest_;            // jα is above j times this for all numbers j of bounces that there are
};

/// How many ways of two and more bounces there are, counted through one series after the other.
template <class Value>
struct WayCounts {
  Value even_from_one;  ///< with panel one met first and an even number of bounces
  Value odd_from_one;   ///< these, and those with an odd number
  Value even_from_two;  ///< these, and those with panel two met first and an even number
  Value all;            ///< these, and those with an odd number
};

/// The ways of all numbers of bounces above 1 and of both first panels that lead light from one direction into another,
/// one at a time.
/// @tparam Value a number, or an array with a pair of directions in each entry
template <class Value>
struct AllWays {
  using Real = scalar_t<Value>;
  using Elevation = detail::Elevation<Value>;

  Elevation from;      ///< elevation of the light above panel one
  Elevation to;        ///< elevation of the direction in which it leaves, above the same panel
  Vec2<Value> across;  ///< the unit vector across the grooves
  Value cos_eta;       ///< length of either direction in the plane across the grooves
  Value height;        ///< vertical component of the direction towards the light
  Value tilt;          ///< |h|; where it is 0, there are none of these ways

  /// How many ways there may be; where there is none in the end, their beam is 0.
  /// @param max_bounces the most that count
  WayCounts<Value> counts(const Value& max_bounces) const {
    using std::floor;
    // Even numbers from 2 on, or odd ones from 3 on.
    const auto of_series = [&max_bounces](const Elevation& e, const Elevation& o, int least) {
      const Value most = at_most(WaySeries<Value>(e, o).most_bounces(), max_bounces);
      return at_least(Value(floor(Value(Real(0.5) * (most - Value(Real(least)))))) + Value(Real(1)), Real(0));
    };
    WayCounts<Value> result;
    result.even_from_one = of_series(from, to.turned(), 2);
    result.odd_from_one = result.even_from_one + of_series(from, to, 3);
    result.even_from_two = result.odd_from_one + of_series(from.turned(), to, 2);
    const Value all = result.even_from_two + of_series(from.turned(), to.turned(), 3);
    result.all = select(tilt > Value(Real(0)), all, Value(Real(0)));
    return result;
  }

  /// One of the ways.
  /// @param counts how many there are
  /// @param n which one, from 0 on
  GrooveWays<Value> way(const WayCounts<Value>& counts, const Value& n) const {
    const auto meets_two = n >= counts.odd_from_one;
    const Value of_panel = n - select(meets_two, counts.odd_from_one, Value(Real(0)));
    const Value even =
        select(meets_two, Value(counts.even_from_two - counts.odd_from_one), counts.even_from_one);
    const auto is_odd = of_panel >= even;
    const Value bounces = Real(2) * (of_panel - select(is_odd, even, Value(Real(0)))) +
                          select(is_odd, Value(Real(3)), Value(Real(2)));
    const Elevation e = chosen(meets_two, from.turned(), from), o = chosen(meets_two, to.turned(), to);
    return WaySeries<Value>(e, chosen(is_odd, o, o.turned())).ways(bounces);
  }

  /// The normals of panel one of some ways, in the frame of the surface; see `GrooveWays`.
  Vec3<Value> normals(const GrooveWays<Value>& ways) const { return ways.normals(across); }

  /// BRDF × cosine of the light that goes each way, for facets that reflect all light.
  /// @param ways the ways
  /// @param facet_densities D(m) of the groove of each
  Value densities(const GrooveWays<Value>& ways, const Value& facet_densities) const {
    return ways.densities(cos_eta, height, tilt, facet_densities);
  }

 private:
  template <class Mask>
  static Elevation chosen(const Mask& mask, const Elevation& a, const Elevation& b) {
    return {select(mask, a.angle, b.angle), select(mask, a.complement, b.complement)};
  }
};

}  // namespace vcavity
