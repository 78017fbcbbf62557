// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sines, cosines and exponentials of packs in vector registers: the inner loop of thin films.
///
/// Method. The argument is reduced by the nearest multiple of π/2 or ln 2, subtracted in parts that are exact products
/// (Cody & Waite 1980), and Taylor's series of what is left is cut where its next term is below a quarter of an ε. The
/// nearest whole number is found by adding and subtracting one so large that nothing but whole numbers fits beside it.
///
/// Errors are at most 2 ε of the result, or of 1 for sines and cosines. Arguments too large for the reduction (beyond
/// 10⁶, in float 10³) and exponents above 0 go through the standard library, one component after the other; so does
/// everything where the compiler may reorder sums (-ffast-math).
///
/// When not to use it: for numbers. The standard library is more exact by an ε.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/pack.hpp"

namespace vcavity::detail {

#if defined(__FAST_MATH__)
inline constexpr bool keeps_order_of_sums = false;
#else
inline constexpr bool keeps_order_of_sums = true;
#endif

/// Whether functions of packs of these numbers are computed here.
template <class Real>
inline constexpr bool has_pack_functions =
    keeps_order_of_sums && (std::is_same_v<Real, float> || std::is_same_v<Real, double>);

/// A sine and the cosine that belongs to it.
template <class Value>
struct SineAndCosine {
  Value sine, cosine;
};

/// Constants by number type.
template <class Real>
struct PackConstants;

template <>
struct PackConstants<double> {
  using Bits = std::uint64_t;
  static constexpr int mantissa = 52, bias = 1023;
  static constexpr double whole = 0x1.8p52;  ///< beside it only whole numbers fit
  static constexpr double half_pi[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
  static constexpr double ln_2[2] = {0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};
  static constexpr double largest_angle = 1e6;
  static constexpr double lowest_exponent = -40;          ///< below it e^x − 1 is −1
  static constexpr double lowest_normal_exponent = -708;  ///< above it e^x is a normal number
  static constexpr int sine_terms = 8, cosine_terms = 8, exponential_terms = 13;
};

template <>
struct PackConstants<float> {
  using Bits = std::uint32_t;
  static constexpr int mantissa = 23, bias = 127;
  static constexpr float whole = 0x1.8p23F;
  static constexpr float half_pi[3] = {0x1.92p+0F, 0x1.fb4p-12F, 0x1.4442dp-24F};
  static constexpr float ln_2[2] = {0x1.62e4p-1F, 0x1.7f7d1cp-20F};
  static constexpr float largest_angle = 1e3F;
  static constexpr float lowest_exponent = -18;
  static constexpr float lowest_normal_exponent = -87;
  static constexpr int sine_terms = 4, cosine_terms = 5, exponential_terms = 8;
};

/// 1 + x/(n (n+1)) (1 + x/((n+2)(n+3)) (1 + …)), the tail of Taylor's series of a sine or cosine.
/// @tparam first n
/// @tparam terms beyond the 1
template <int first, int terms, class Value>
VCAVITY_INLINE Value alternating_tail(const Value& x) {
  using Real = scalar_t<Value>;
  if constexpr (terms == 0) {
    return Value(1);
  } else {
    constexpr Real inverse = Real(1) / (Real(first) * Real(first + 1));
    return Value(1) + (inverse * x) * alternating_tail<first + 2, terms - 1>(x);
  }
}

/// 1 + x/n (1 + x/(n+1) (1 + …)), the same of an exponential.
template <int first, int terms, class Value>
VCAVITY_INLINE Value exponential_tail(const Value& x) {
  using Real = scalar_t<Value>;
  if constexpr (terms == 0) {
    return Value(1);
  } else {
    constexpr Real inverse = Real(1) / Real(first);
    return Value(1) + (inverse * x) * exponential_tail<first + 1, terms - 1>(x);
  }
}

/// The nearest whole number, of a modulus of less than a quarter of `whole`.
template <class Value>
VCAVITY_INLINE Value nearest_whole(const Value& x) {
  const Value whole(PackConstants<scalar_t<Value>>::whole);
  return (x + whole) - whole;
}

/// sin x and cos x.
template <class Real, std::size_t size, std::size_t most_bytes>
  requires has_pack_functions<Real>
VCAVITY_INLINE SineAndCosine<Pack<Real, size, most_bytes>> sine_and_cosine(
    const Pack<Real, size, most_bytes>& x) {
  using Value = Pack<Real, size, most_bytes>;
  using Constants = PackConstants<Real>;
  if (!all_of(magnitude(x) < Constants::largest_angle)) {
    SineAndCosine<Value> result;
    for (std::size_t i = 0; i < size; ++i) {
      result.sine[i] = std::sin(x[i]);
      result.cosine[i] = std::cos(x[i]);
    }
    return result;
  }
  constexpr Real per_quarter = Real(1) / Constants::half_pi[0];
  const Value quarters = nearest_whole(Value(per_quarter * x));
  const Value rest = ((x - Constants::half_pi[0] * quarters) - Constants::half_pi[1] * quarters) -
                     Constants::half_pi[2] * quarters;
  const Value minus_square = -(rest * rest);
  constexpr Real sixth = Real(1) / Real(6);
  const Value sine =
      rest + rest * (minus_square * (sixth * alternating_tail<4, Constants::sine_terms - 1>(minus_square)));
  const Value cosine =
      Value(1) + Real(0.5) * (minus_square * alternating_tail<3, Constants::cosine_terms - 1>(minus_square));
  // Quarter turns less whole turns, from −2 to 2.
  const Value quarter = quarters - Real(4) * nearest_whole(Value(Real(0.25) * quarters));
  const Value even_sign = Value(1) - magnitude(quarter);
  const Value odd = magnitude(even_sign);  // 0 if it is odd, else 1
  const auto is_even = odd > Real(0.5);
  return {select(is_even, Value(even_sign * sine), Value(quarter * cosine)),
          select(is_even, Value(even_sign * cosine), Value(-(quarter * sine)))};
}

/// 2^n, n being the whole number beside `whole` in a sum: the exponent is the end of the digits of that.
template <class Real, std::size_t size, std::size_t most_bytes>
VCAVITY_INLINE Pack<Real, size, most_bytes> power_of_two(const Pack<Real, size, most_bytes>& sum) {
  using Value = Pack<Real, size, most_bytes>;
  using Constants = PackConstants<Real>;
  using Bits = typename Constants::Bits;
  Value result;
#if defined(__GNUC__)
  constexpr std::size_t bytes = sizeof(Value) < most_bytes ? sizeof(Value) : most_bytes;
  if constexpr (sizeof(Value) % bytes == 0 && std::has_single_bit(bytes)) {
    typedef Bits Register VCAVITY_VECTOR(bytes);
    constexpr std::size_t width = bytes / sizeof(Real);
    for (std::size_t i = 0; i * width < size; ++i) {
      Register digits;
      std::memcpy(&digits, sum.begin() + i * width, bytes);
      digits = (digits + static_cast<Bits>(Constants::bias)) << Constants::mantissa;
      std::memcpy(result.begin() + i * width, &digits, bytes);
    }
    return result;
  }
#endif
  for (std::size_t i = 0; i < size; ++i) {
    const Bits digits = std::bit_cast<Bits>(sum[i]) + static_cast<Bits>(Constants::bias);
    result[i] = std::bit_cast<Real>(static_cast<Bits>(digits << Constants::mantissa));
  }
  return result;
}

/// An exponential in parts: e^x = scale (1 + less_one).
template <class Value>
struct ScaledExponential {
  Value less_one;  ///< of half a doubling at most
  Value scale;     ///< a power of two
};

/// e^x for x ≤ 0 of which the result is a normal number.
template <class Real, std::size_t size, std::size_t most_bytes>
VCAVITY_INLINE ScaledExponential<Pack<Real, size, most_bytes>> scaled_exponential(
    const Pack<Real, size, most_bytes>& x) {
  using Value = Pack<Real, size, most_bytes>;
  using Constants = PackConstants<Real>;
  constexpr Real per_ln_2 = Real(1) / Constants::ln_2[0];
  const Value whole(Constants::whole);
  const Value shifted = per_ln_2 * x + whole;
  const Value doublings = shifted - whole;
  const Value rest = (x - Constants::ln_2[0] * doublings) - Constants::ln_2[1] * doublings;
  return {rest * exponential_tail<2, Constants::exponential_terms - 1>(rest), power_of_two(shifted)};
}

/// e^x; 0 where that is no normal number.
template <class Real, std::size_t size, std::size_t most_bytes>
  requires has_pack_functions<Real>
VCAVITY_INLINE Pack<Real, size, most_bytes> exponential(const Pack<Real, size, most_bytes>& x) {
  using Value = Pack<Real, size, most_bytes>;
  if (!all_of(Value(-x) >= Real(0))) {
    Value result;
    for (std::size_t i = 0; i < size; ++i) result[i] = std::exp(x[i]);
    return result;
  }
  constexpr Real lowest = PackConstants<Real>::lowest_normal_exponent;
  const auto [less_one, scale] = scaled_exponential(at_least(x, lowest));
  return select(x >= lowest, scale + scale * less_one, Value(Real(0)));
}

/// e^x − 1, with its digits where x is small.
template <class Real, std::size_t size, std::size_t most_bytes>
  requires has_pack_functions<Real>
VCAVITY_INLINE Pack<Real, size, most_bytes> exponential_less_one(const Pack<Real, size, most_bytes>& x) {
  using Value = Pack<Real, size, most_bytes>;
  if (!all_of(Value(-x) >= Real(0))) {
    Value result;
    for (std::size_t i = 0; i < size; ++i) result[i] = std::expm1(x[i]);
    return result;
  }
  const auto [less_one, scale] = scaled_exponential(at_least(x, PackConstants<Real>::lowest_exponent));
  return scale * less_one + (scale - Value(1));
}

}  // namespace vcavity::detail
