// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Elementary functions of values, component by component: `Pack` and `glm::vec` bring the roots that
/// Fresnel's formula needs, thin films also want sines and exponentials.
///
/// When not to use it: in the innermost loops of bare facets; a call for each component takes as long as all
/// of Fresnel's formula.

#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>

#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"

namespace vcavity::detail {

/// The value of f(component) for each component.
template <Number Real, class Function>
Real transformed(const Real& a, Function&& f) {
  return f(a);
}

template <glm::length_t length, class Real, class Function>
glm::vec<length, Real> transformed(glm::vec<length, Real> a, Function&& f) {
  for (glm::length_t i = 0; i < length; ++i) a[i] = f(a[i]);
  return a;
}

template <class Real, std::size_t size, std::size_t bytes, class Function>
Pack<Real, size, bytes> transformed(const Pack<Real, size, bytes>& a, Function&& f) {
  Pack<Real, size, bytes> result(Real(0));
  for (std::size_t i = 0; i < size; ++i) result[i] = f(a[i]);
  return result;
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
