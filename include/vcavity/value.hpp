// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Values: what a facet reflectance may return.
///
/// The groove only multiplies, adds and scales facet reflectances, so any type with those three operations
/// will do: a number, an RGB `glm::vec3`, a `Pack` of wavelengths, an `EnergyBalance`. A type of your own
/// needs
///
///  - `Value(1)`, the reflectance that changes nothing, and `Value(0)`, no light;
///  - `a * b`, the reflectance of a followed by b (it need not commute; the earlier bounce stands on the
///  left);
///  - `a + b`, and `s * a` for a number s of type `scalar_t<Value>`;
///  - `largest(a)`, found by argument-dependent look-up: a number that is small only if all of `a` is small.
///
/// A value that multiplies but does not add up, such as the field amplitudes of a `Jones` matrix, says with
/// an overload of `power` what adds up in its place, and needs neither sums nor multiples itself.

#include <concepts>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <type_traits>
#include <utility>

namespace vcavity {

/// A number type: built in, or any other with `std::numeric_limits`.
template <class T>
concept Number = std::numeric_limits<T>::is_specialized;

namespace detail {
template <class Value>
struct Scalar {
  using type = Value;
};
template <class Value>
requires(!Number<Value>) struct Scalar<Value> {
  using type = typename Value::value_type;
};
}  // namespace detail

/// The number type that `Value` is made of: itself, or its `value_type`.
template <class Value>
using scalar_t = typename detail::Scalar<Value>::type;

template <class Real>
class PanelImages;  // bounces.hpp

/// What a facet is called with: the cosine of the angle of incidence, or the whole geometry of a bounce if it
/// cannot do with less.
template <class Facet, class Real>
using facet_argument_t =
    std::conditional_t<std::invocable<const Facet&, const Real&>, Real, PanelImages<Real>>;

/// The value that a facet returns for a bounce in coordinates of type `Real`.
template <class Facet, class Real>
using value_t = std::remove_cvref_t<std::invoke_result_t<const Facet&, const facet_argument_t<Facet, Real>&>>;

/// What adds up from one lobe to the next: a value itself, unless an overload for its type says otherwise.
template <class Value>
const Value& power(const Value& throughput) {
  return throughput;
}

/// What `power` makes of the values of a facet.
template <class Facet, class Real>
using power_t = std::remove_cvref_t<decltype(power(std::declval<const value_t<Facet, Real>&>()))>;

/// The reflectance of unpolarised light: the value itself, unless an overload for its type says otherwise.
template <class Value>
const Value& unpolarized(const Value& reflectance) {
  return reflectance;
}

/// What becomes of light that travels the same way backwards: the same, unless an overload for its type says
/// otherwise.
template <class Value>
const Value& reversed(const Value& reflectance) {
  return reflectance;
}

/// What `unpolarized` makes of the reflectance of a groove.
template <class Facet, class Real>
using unpolarized_t = std::remove_cvref_t<decltype(unpolarized(std::declval<const power_t<Facet, Real>&>()))>;

/// A facet reflectance: anything callable with the cosine of the angle of incidence, in [0, 1], or with the
/// `PanelImages` of a bounce, that returns a value.
template <class Facet, class Real>
concept FacetReflectance = std::invocable < const Facet&,
        const facet_argument_t<Facet, Real>
& > &&requires(value_t<Facet, Real> a, power_t<Facet, Real> p) {
  { a* a } -> std::convertible_to<value_t<Facet, Real>>;
  { p + p } -> std::convertible_to<power_t<Facet, Real>>;
  { scalar_t<value_t<Facet, Real>>(1) * p } -> std::convertible_to<power_t<Facet, Real>>;
};

/// A facet of numbers that can be had for several directions at once: `facet.over_directions<4>()` takes a
/// `Pack` of 4 directions.
template <class Facet>
concept OverDirections = requires(const Facet& facet) {
  facet.template over_directions<4>();
};

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
