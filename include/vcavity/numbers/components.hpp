// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The same few operations for a number and, component by component, for a `glm::vec` of colours; `Pack` brings
/// its own.

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <type_traits>
#include <utility>

#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// Component by component, the absolute value.
template <Number Real>
Real magnitude(const Real& a) {
  return a < Real(0) ? Real(-a) : a;
}

/// The largest magnitude in a value.
template <Number Real>
Real largest(const Real& a) {
  return magnitude(a);
}

template <glm::length_t length, class Real>
Real largest(const glm::vec<length, Real>& a) {
  Real result = largest(a[0]);
  for (glm::length_t i = 1; i < length; ++i) result = glm::max(result, largest(a[i]));
  return result;
}

// Comparisons make masks: a bool of numbers, and of a `glm::vec`, which has no such operators itself, one bool for
// each component.

template <glm::length_t length, class Real>
glm::vec<length, bool> operator>=(const glm::vec<length, Real>& a, const glm::vec<length, Real>& b) {
  return glm::greaterThanEqual(a, b);
}
template <glm::length_t length, class Real>
glm::vec<length, bool> operator>=(const glm::vec<length, Real>& a, const Real& b) {
  return glm::greaterThanEqual(a, glm::vec<length, Real>(b));
}
template <glm::length_t length, class Real>
glm::vec<length, bool> operator>(const glm::vec<length, Real>& a, const glm::vec<length, Real>& b) {
  return glm::greaterThan(a, b);
}
template <glm::length_t length, class Real>
glm::vec<length, bool> operator>(const glm::vec<length, Real>& a, const Real& b) {
  return glm::greaterThan(a, glm::vec<length, Real>(b));
}

/// Component by component, `a` where a mask is set and `b` elsewhere.
/// @param mask of a comparison
/// @param a what is taken where the mask is true
/// @param b what is taken elsewhere
template <class Value>
Value select(bool mask, const Value& a, const Value& b) {
  return mask ? a : b;
}

template <glm::length_t length, class Real>
glm::vec<length, Real> select(const glm::vec<length, bool>& mask, const glm::vec<length, Real>& a,
                              const glm::vec<length, Real>& b) {
  return glm::mix(b, a, mask);
}

/// Whether a component of a mask is set.
constexpr bool any_of(bool mask) {
  return mask;
}

/// Whether all components of a mask are set.
constexpr bool all_of(bool mask) {
  return mask;
}

/// The mask that comparisons of values make.
template <class Value>
using mask_t = decltype(std::declval<const Value&>() > std::declval<const Value&>());

/// A value times a number, or times one number for each of its components.
template <class Value, class Factor>
auto scaled(const Factor& factor, const Value& value) {
  if constexpr (Number<Factor>) {
    return static_cast<scalar_t<Value>>(factor) * value;
  } else {
    return factor * value;
  }
}

/// The smallest number to divide by: its inverse is finite.
template <class Real>
Real smallest_divisor() {
  return Real(4) * std::numeric_limits<Real>::min();
}

/// Component by component, the larger of `a` and the number `floor`.
template <Number Real>
Real at_least(const Real& a, const Real& floor) {
  return a < floor ? floor : a;
}

template <glm::length_t length, class Real>
glm::vec<length, Real> at_least(const glm::vec<length, Real>& a, const Real& floor) {
  return glm::max(a, floor);
}

/// Component by component, the smaller of `a` and the number `ceiling`.
template <Number Real>
Real at_most(const Real& a, const Real& ceiling) {
  return ceiling < a ? ceiling : a;
}

template <glm::length_t length, class Real>
glm::vec<length, Real> at_most(const glm::vec<length, Real>& a, const Real& ceiling) {
  return glm::min(a, ceiling);
}

}  // namespace vcavity
