// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sines, cosines and arctangents where the angle is known to lie between −π/2 and π/2: without the reduction of
/// any angle that the standard library has to begin with, and for packs without a call for each component.
///
/// Method. In float, polynomials with the least largest error over the quarter turn (Remez): 5e-9 of a sine, 2e-10
/// absolute of a cosine and 2e-8 of an angle, so that what remains is rounding, some ε. Every other type takes the
/// functions of its own library, component by component.
///
/// When not to use it: for angles beyond π/2 by more than rounding; there the polynomials mean nothing.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity::detail {

/// Whether the functions of a type are polynomials.
template <class Value>
inline constexpr bool has_short_series = std::is_same_v<scalar_t<Value>, float>;

/// c_first + c_(first+1) u + c_(first+2) u² + …, of `size` terms.
/// @param powers u, u², u⁴, …
template <std::size_t first, std::size_t size, class Value, std::size_t all, std::size_t doublings>
VCAVITY_INLINE Value polynomial_part(const std::array<float, all>& coefficients,
                                     const std::array<Value, doublings>& powers) {
  if constexpr (size == 1) {
    return Value(coefficients[first]);
  } else {
    constexpr auto doubling = static_cast<std::size_t>(std::bit_width(size - 1)) - 1;
    constexpr std::size_t low = std::size_t(1) << doubling;
    return polynomial_part<first + low, size - low>(coefficients, powers) * powers[doubling] +
           polynomial_part<first, low>(coefficients, powers);
  }
}

/// c_0 + c_1 u + c_2 u² + …, by halves (Estrin), which do not wait for each other as the steps of Horner do.
template <class Value, std::size_t size>
VCAVITY_INLINE Value polynomial(const std::array<float, size>& coefficients, const Value& u) {
  std::array<Value, static_cast<std::size_t>(std::bit_width(size - 1))> powers;
  powers[0] = u;
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * powers[i - 1];
  return polynomial_part<0, size>(coefficients, powers);
}

/// sin x
/// @param x in [−π/2, π/2], a number or a pack
template <class Value>
VCAVITY_INLINE Value acute_sine(const Value& x) {
  if constexpr (has_short_series<Value>) {
    constexpr std::array series{0.999999995f, -0.166666567f, 0.00833302514f, -0.000198074187f,
                                2.60190307e-06f};
    return x * polynomial(series, Value(x * x));
  } else {
    return sine(x);
  }
}

/// cos x
/// @param x in [−π/2, π/2], a number or a pack
template <class Value>
VCAVITY_INLINE Value acute_cosine(const Value& x) {
  if constexpr (has_short_series<Value>) {
    constexpr std::array series{
        1.0f, -0.499999994f, 0.0416666363f, -0.00138883614f, 2.47601613e-05f, -2.6051495e-07f};
    return polynomial(series, Value(x * x));
  } else {
    return cosine(x);
  }
}

/// arctan x, over x, as a function of x².
inline constexpr std::array arctangent_series{0.999999985f,  -0.333330733f,  0.199926194f,
                                              -0.142036444f, 0.106409337f,   -0.0750429375f,
                                              0.0426915099f, -0.0160686232f, 0.00284988817f};

/// The angle in a right-angled triangle, arctan(opposite/adjacent).
/// @param opposite, adjacent numbers ≥ 0, or arrays of them, not both 0
/// @return in [0, π/2]
template <class Real>
VCAVITY_INLINE Real acute_angle(const Real& opposite, const Real& adjacent) {
  if constexpr (has_short_series<Real>) {
    // Of the angle and its complement the smaller one; no branch, since half of all angles would take it.
    const Real slope = at_most(opposite, adjacent) / at_least(opposite, adjacent);
    const Real angle = slope * polynomial(arctangent_series, Real(slope * slope));
    const Real is_steep = select(adjacent < opposite, Real(1), Real(0));
    return angle + is_steep * (pi<Real>() / Real(2) - Real(2) * angle);
  } else {
    using std::atan2;
    return atan2(opposite, adjacent);
  }
}

/// The same for several triangles.
/// @param opposite, adjacent as above, in packs
template <class Value>
VCAVITY_INLINE Value acute_angles(const Value& opposite, const Value& adjacent) {
  if constexpr (has_short_series<Value>) {
    const Value longer_side = at_least(at_least(opposite, adjacent), std::numeric_limits<float>::min());
    const Value slope = at_most(opposite, adjacent) / longer_side;
    const Value angle = slope * polynomial(arctangent_series, Value(slope * slope));
    return select(opposite > adjacent, Value(pi<float>() / 2) - angle, angle);
  } else {
    return value_of_components<Value>(
        [&](std::size_t i) { return acute_angle(component(opposite, i), component(adjacent, i)); });
  }
}

/// An angle above the horizon on one side, and above that on the other: both with all their digits.
template <class Real>
struct Elevation {
  Real angle, complement;  // they add up to π

  Elevation turned() const { return {complement, angle}; }
};

/// The elevation of a vector in the plane above the side of positive `along`.
/// @param up ≥ 0, and not 0 if `along` is
template <class Real>
VCAVITY_INLINE Elevation<Real> elevation_of(const Real& along, const Real& up) {
  const Real low = acute_angle(up, magnitude(along));
  const Real high = pi<Real>() - low;
  // By products with 0 and 1: no branch, and no digit lost.
  const Real behind = select(along < Real(0), Real(1), Real(0)), before = Real(1) - behind;
  return {before * low + behind * high, before * high + behind * low};
}

/// A unit vector in the plane.
template <class Real>
struct PlaneDirection {
  Real cosine, sine;
};

/// cos 2πu and sin 2πu
/// @param u in [0, 1]
template <class Real>
VCAVITY_INLINE PlaneDirection<Real> direction_of_turns(const Real& u) {
  if constexpr (Number<Real> && has_short_series<Real>) {
    // From the nearer end of the quarter turns: the quadrant, and what is left of −½ … ½ quarters.
    const Real quarters = Real(4) * u;
    const int quadrant = static_cast<int>(quarters + Real(0.5));
    const Real angle = (quarters - Real(quadrant)) * (pi<Real>() / 2);
    const Real cosine = acute_cosine(angle), sine = acute_sine(angle);
    const bool is_odd = quadrant % 2 == 1;
    const Real along = is_odd ? -sine : cosine, across = is_odd ? cosine : sine;
    const bool is_behind = quadrant == 2 || quadrant == 3;
    return {is_behind ? -along : along, is_behind ? -across : across};
  } else {
    using std::cos;
    using std::sin;
    const Real angle = Real(2) * pi<Real>() * u;
    return {cos(angle), sin(angle)};
  }
}

}  // namespace vcavity::detail
