// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Numbers: the types that the library computes with, and what they are made of.

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace vcavity {

/// A number type: built in, or any other with `std::numeric_limits`.
template <class T>
concept Number = std::numeric_limits<T>::is_specialized;

namespace detail {
template <class Value>
struct Scalar {};
template <Number Value>
struct Scalar<Value> {
  using type = Value;
};
template <class Value>
  requires(!Number<Value>) && requires { typename Value::value_type; }
struct Scalar<Value> {
  using type = typename Value::value_type;
};
}  // namespace detail

/// The number type that `Value` is made of: itself, or its `value_type`.
template <class Value>
using scalar_t = typename detail::Scalar<Value>::type;

/// A number without its fraction, as an int; 0 for negative numbers and for what is no number.
/// @param most the largest result, ≥ 0; no larger number is ever converted
/// @param x the number
template <Number Real>
int whole_at_most(const Real& x, int most) {
  if (!(x > Real(0))) return 0;
  // Rounded to `Real`, `most` may be one more than the largest int.
  return x < Real(most) ? static_cast<int>(x) : most;
}

/// π to the precision of `Real`, which may be any number type with an `acos` found by argument-dependent
/// look-up, or a type that brings its own, `Real::pi()`.
template <class Real>
Real pi() {
  if constexpr (std::is_floating_point_v<Real>) {
    return std::numbers::pi_v<Real>;
  } else if constexpr (requires { Real::pi(); }) {
    return Real::pi();
  } else {
    static const Real value = acos(Real(-1));
    return value;
  }
}

}  // namespace vcavity
