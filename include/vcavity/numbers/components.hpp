// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The same few operations for a number and, component by component, for a `glm::vec` of colours; `Pack` brings
/// its own.

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <type_traits>

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

/// Component by component, `a` where x ≥ 0 and `b` elsewhere.
template <Number Real>
Real select_nonnegative(const Real& x, const Real& a, const Real& b) {
  return x >= Real(0) ? a : b;
}

template <glm::length_t length, class Real>
glm::vec<length, Real> select_nonnegative(const glm::vec<length, Real>& x, const glm::vec<length, Real>& a,
                                          const glm::vec<length, Real>& b) {
  return glm::mix(b, a, glm::greaterThanEqual(x, glm::vec<length, Real>(0)));
}

/// Component by component, `a` where x > 0 and `b` elsewhere.
template <Number Real>
Real select_positive(const Real& x, const Real& a, const Real& b) {
  return x > Real(0) ? a : b;
}

/// Whether a component is positive.
template <Number Real>
bool any_positive(const Real& a) {
  return a > Real(0);
}

/// Whether all components are positive.
template <Number Real>
bool all_positive(const Real& a) {
  return a > Real(0);
}

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
template <Number Real>
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

/// Calls `visit` with every component of `a`.
template <Number Real, class Visit>
void for_each_component(const Real& a, Visit&& visit) {
  visit(a);
}

template <glm::length_t length, class Real, class Visit>
void for_each_component(const glm::vec<length, Real>& a, Visit&& visit) {
  for (glm::length_t i = 0; i < length; ++i) visit(a[i]);
}

}  // namespace vcavity
