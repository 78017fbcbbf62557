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
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity::detail {

/// Whether the functions of a type are polynomials.
template <class Value>
inline constexpr bool has_short_series = std::is_same_v<scalar_t<Value>, float>;

/// c_0 + c_1 u + c_2 u² + …
template <class Value, std::size_t size>
VCAVITY_INLINE Value polynomial(const std::array<float, size>& coefficients, const Value& u) {
  Value sum(coefficients[size - 1]);
  for (std::size_t i = size - 1; i-- > 0;) sum = sum * u + Value(coefficients[i]);
  return sum;
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

/// The angle in a right-angled triangle, arctan(opposite/adjacent).
/// @param opposite, adjacent numbers ≥ 0, not both 0
/// @return in [0, π/2]
template <Number Real>
VCAVITY_INLINE Real acute_angle(const Real& opposite, const Real& adjacent) {
  if constexpr (has_short_series<Real>) {
    constexpr std::array series{0.999999985f,   -0.333330733f, 0.199926194f,   -0.142036444f, 0.106409337f,
                                -0.0750429375f, 0.0426915099f, -0.0160686232f, 0.00284988817f};
    const bool is_steep = adjacent < opposite;
    const Real slope = is_steep ? adjacent / opposite : opposite / adjacent;
    const Real angle = slope * polynomial(series, Real(slope * slope));
    return is_steep ? pi<Real>() / 2 - angle : angle;
  } else {
    using std::atan2;
    return atan2(opposite, adjacent);
  }
}

}  // namespace vcavity::detail
