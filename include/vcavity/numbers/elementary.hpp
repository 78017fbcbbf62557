// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Elementary functions of values, component by component: `Pack` and `glm::vec` bring the roots that
/// Fresnel's formula needs, thin films also want sines and exponentials.
///
/// Method. Packs have some of them in vector registers (pack_functions.hpp); the rest, and all other values, goes through
/// the standard library, one component after the other.
///
/// When not to use it: in the innermost loops of bare facets; a call for each component takes as long as all
/// of Fresnel's formula.

#include <cmath>
#include <cstddef>

#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack_functions.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity::detail {

/// The value of f(component) for each component.
template <class Value, class Function>
Value transformed(const Value& a, const Function& f) {
  return value_of_components<Value>([&a, &f](std::size_t i) { return f(component(a, i)); });
}

/// sin a
template <class Value>
Value sine(const Value& a) {
  return transformed(a, [](const scalar_t<Value>& x) {
    using std::sin;
    return scalar_t<Value>(sin(x));
  });
}

/// cos a
template <class Value>
Value cosine(const Value& a) {
  return transformed(a, [](const scalar_t<Value>& x) {
    using std::cos;
    return scalar_t<Value>(cos(x));
  });
}

/// Both.
template <class Value>
SineAndCosine<Value> sine_and_cosine(const Value& a) {
  return {sine(a), cosine(a)};
}

/// e^a
template <class Value>
Value exponential(const Value& a) {
  return transformed(a, [](const scalar_t<Value>& x) {
    using std::exp;
    return scalar_t<Value>(exp(x));
  });
}

/// e^a − 1, to full relative precision.
template <class Value>
Value exponential_less_one(const Value& a) {
  return transformed(a, [](const scalar_t<Value>& x) {
    using std::expm1;
    return scalar_t<Value>(expm1(x));
  });
}

}  // namespace vcavity::detail
