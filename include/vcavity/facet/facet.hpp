// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Facets and values: the contract between the groove and what its panels are made of.
///
/// A facet is anything that can be called with the cosine of the angle of incidence, or with a `Bounce` if it
/// cannot do with less, and returns a value. The groove only multiplies, adds and scales values, so any type
/// with those three operations will do: a number, an RGB `glm::vec3`, a `Pack` of wavelengths, an
/// `EnergyBalance`. A value of your own needs
///
///  - `Value(1)`, the reflectance that changes nothing, and `Value(0)`, no light;
///  - `a * b`, the reflectance of a followed by b (it need not commute; the earlier bounce stands on the left);
///  - `a + b`, and `s * a` for a number s of type `scalar_t<Value>`;
///  - `largest(a)`, found by argument-dependent look-up: a number that is small only if all of `a` is small.
///
/// Lists of lobes also need `Value()`, absorptances `at_most(a, s)`, which limits all of `a` to a number s.
///
/// A value that multiplies but does not add up, such as the field amplitudes of a `Jones` matrix, says with an
/// overload of `power` what adds up in its place, and needs neither sums nor multiples itself.
///
/// All else that a facet may tell about itself is optional, and stands in the second half of this header: some
/// functions ask for it (`absorptance`, `absorptances`, `amplitudes`), others are faster or more exact if they
/// know it (`critical_cosine`, `singular_cosines`, `contrast`, `over_directions`).

#include <complex>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "vcavity/facet/bounce.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// What a facet is called with: the cosine of the angle of incidence, or the whole geometry of a bounce if it
/// cannot do with less.
template <class Facet, class Real>
using facet_argument_t = std::conditional_t<std::invocable<const Facet&, const Real&>, Real, Bounce<Real>>;

/// The value that a facet returns for a bounce in coordinates of type `Real`.
template <class Facet, class Real>
using value_t = std::remove_cvref_t<std::invoke_result_t<const Facet&, const facet_argument_t<Facet, Real>&>>;

/// What adds up from one lobe to the next, and can be taken a number of times.
template <class Power>
concept FacetPower = requires(const Power& a, const scalar_t<Power>& s) {
  Power(0);
  { a + a } -> std::convertible_to<Power>;
  { s* a } -> std::convertible_to<Power>;
};

// The three functions that follow return what they are given, by value: the reflectance of an expression is gone
// at the end of a line, and a reference to it would outlive it.

/// What adds up from one lobe to the next: a value itself, unless an overload for its type says otherwise.
/// @param throughput the product of the values of a way through the groove
template <FacetPower Value>
Value power(const Value& throughput) {
  return throughput;
}

/// What `power` makes of the values of a facet.
template <class Facet, class Real>
using power_t = std::remove_cvref_t<decltype(power(std::declval<const value_t<Facet, Real>&>()))>;

/// The reflectance of unpolarised light: the value itself, unless an overload for its type says otherwise.
/// @param reflectance of a groove
template <FacetPower Value>
Value unpolarized(const Value& reflectance) {
  return reflectance;
}

/// What becomes of light that travels the same way backwards: the same, unless an overload for its type says
/// otherwise.
/// @param reflectance of the way forwards
template <FacetPower Value>
Value reversed(const Value& reflectance) {
  return reflectance;
}

/// What `unpolarized` makes of the reflectance of a groove.
template <class Facet, class Real>
using unpolarized_t = std::remove_cvref_t<decltype(unpolarized(std::declval<const power_t<Facet, Real>&>()))>;

/// A value: all that the groove does with what a facet returns.
template <class Value>
concept FacetValue = requires(const Value& a) {
  Value(1);
  Value(0);
  { a* a } -> std::convertible_to<Value>;
  { largest(a) } -> std::convertible_to<scalar_t<Value>>;
};

/// A facet reflectance: callable with the cosine of the angle of incidence, in [0, 1], or with the `Bounce`.
/// @tparam Real number type of the cosine, or a `Pack` of them
template <class Facet, class Real>
concept FacetReflectance = std::invocable<const Facet&, const facet_argument_t<Facet, Real>&> &&
                           FacetValue<value_t<Facet, Real>> && FacetPower<power_t<Facet, Real>>;

/// The value of a facet for one bounce: called with the cosine of the angle of incidence if it can be, else
/// with the bounce itself.
/// @param facet facet reflectance
/// @param bounce where it is asked for
template <class Real, FacetReflectance<Real> Facet>
VCAVITY_INLINE value_t<Facet, Real> reflect(const Facet& facet, const Bounce<Real>& bounce) {
  if constexpr (std::invocable<const Facet&, const Real&>) {
    return facet(bounce.cosine);
  } else {
    return facet(bounce);
  }
}

// What a facet may tell about itself.

/// A facet that knows its absorptance, as `Conductor` and `Dielectric` do:
/// `absorptance(cosine or bounce)` is 1 − reflectance to full relative precision.
template <class Facet, class Real>
concept AbsorbingFacet = FacetReflectance<Facet, Real> &&
                         requires(const Facet& facet, const facet_argument_t<Facet, Real>& bounce) {
                           { facet.absorptance(bounce) } -> std::convertible_to<value_t<Facet, Real>>;
                         };

/// A facet that knows the absorptances of s and of p light: `absorptances(cosine)` has members `s` and `p`.
template <class Facet, class Real>
concept FieldAbsorber = requires(const Facet& facet, const Real& cosine) {
  facet.absorptances(cosine).s;
  facet.absorptances(cosine).p;
};

/// A facet that knows its amplitudes: `amplitudes(cosine)` has the complex members `r_s` and `r_p`.
template <class Facet, class Real>
concept FieldReflector = requires(const Facet& facet, const Real& cosine) {
  facet.amplitudes(cosine).r_s;
  facet.amplitudes(cosine).r_p;
};

/// A facet that knows the cosine at which its reflectance has a kink or bends most sharply, as at the critical
/// angle of total reflection: `critical_cosine()`, 0 if there is none in (0, 1].
template <class Facet, class Real>
concept CriticalFacet = requires(const Facet& facet) {
  { facet.critical_cosine() } -> std::convertible_to<Real>;
};

/// A facet that knows where its reflectance is singular as a function of a complex cosine:
/// `singular_cosines()` is a range of `std::complex<double>`, one of each conjugate pair.
template <class Facet>
concept SingularFacet = requires(const Facet& facet) {
  { *facet.singular_cosines().begin() } -> std::convertible_to<std::complex<double>>;
  facet.singular_cosines().end();
};

/// An interface between two media that knows its contrast (n + ik)² − 1: `contrast()`, a number or a
/// `Complex` of the facet's values.
template <class Facet>
concept ContrastingFacet = requires(const Facet& facet) { facet.contrast(); };

/// A facet of numbers that can be had for several directions at once: `facet.over_directions<4>()` takes a
/// `Pack` of 4 directions.
template <class Facet>
concept OverDirections = requires(const Facet& facet) { facet.template over_directions<4>(); };

/// A number as a fraction, of which several are multiplied with a single division.
template <class Value>
struct Fraction {
  Value numerator;
  Value denominator;  ///< above 0
};

/// The reflectance of a facet as a fraction: `facet.fraction(cosine)` if it knows one. The products of four numerators
/// and of four denominators are finite, and those of the denominators not 0.
/// @param cosine of incidence, in [0, 1]
template <class Facet, class Value>
VCAVITY_INLINE Fraction<Value> fraction_of(const Facet& facet, const Value& cosine) {
  if constexpr (requires { facet.fraction(cosine); })
    return facet.fraction(cosine);
  else
    return {facet(cosine), Value(scalar_t<Value>(1))};
}

/// The critical cosine of a facet; 0 if it has none or does not tell.
template <class Real, class Facet>
Real critical_cosine_of([[maybe_unused]] const Facet& facet) {
  if constexpr (CriticalFacet<Facet, Real>) {
    return facet.critical_cosine();
  } else {
    return Real(0);
  }
}

/// The singularities of a facet reflectance in the plane of complex cosines; none if it does not tell.
template <class Facet>
std::vector<std::complex<double>> singular_cosines_of([[maybe_unused]] const Facet& facet) {
  if constexpr (SingularFacet<Facet>) {
    const auto points = facet.singular_cosines();
    return {points.begin(), points.end()};
  } else {
    return {};
  }
}

}  // namespace vcavity
