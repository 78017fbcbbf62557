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
#include <type_traits>
#include <utility>

#include "vcavity/numbers/number.hpp"

namespace vcavity {

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
concept FacetReflectance = std::invocable<const Facet&, const facet_argument_t<Facet, Real>&> &&
                           requires(value_t<Facet, Real> a, power_t<Facet, Real> p) {
                             { a* a } -> std::convertible_to<value_t<Facet, Real>>;
                             { p + p } -> std::convertible_to<power_t<Facet, Real>>;
                             {
                               scalar_t<value_t<Facet, Real>>(1) * p
                             } -> std::convertible_to<power_t<Facet, Real>>;
                           };

/// A facet of numbers that can be had for several directions at once: `facet.over_directions<4>()` takes a
/// `Pack` of 4 directions.
template <class Facet>
concept OverDirections = requires(const Facet& facet) { facet.template over_directions<4>(); };

}  // namespace vcavity
