// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Functions of numbers applied to values of many components: what has no vector instruction, such as a logarithm,
/// one component after the other.

#include <cstddef>
#include <glm/detail/qualifier.hpp>

#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"

namespace vcavity {

/// The number of components of a value: 1 for a number.
template <Number Real>
constexpr std::size_t component_count(const Real&) {
  return 1;
}

template <glm::length_t length, class Real>
constexpr std::size_t component_count(const glm::vec<length, Real>&) {
  return static_cast<std::size_t>(length);
}

template <class Real, std::size_t size, std::size_t most_bytes>
constexpr std::size_t component_count(const Pack<Real, size, most_bytes>&) {
  return size;
}

/// Component `i` of a value, counted from 0; of a number the number itself.
template <Number Real>
Real& component(Real& value, std::size_t) {
  return value;
}

template <Number Real>
const Real& component(const Real& value, std::size_t) {
  return value;
}

template <glm::length_t length, class Real>
Real& component(glm::vec<length, Real>& value, std::size_t i) {
  return value[static_cast<glm::length_t>(i)];
}

template <glm::length_t length, class Real>
const Real& component(const glm::vec<length, Real>& value, std::size_t i) {
  return value[static_cast<glm::length_t>(i)];
}

template <class Real, std::size_t size, std::size_t most_bytes>
Real& component(Pack<Real, size, most_bytes>& value, std::size_t i) {
  return value[i];
}

template <class Real, std::size_t size, std::size_t most_bytes>
const Real& component(const Pack<Real, size, most_bytes>& value, std::size_t i) {
  return value[i];
}

/// The value whose component i is `function(i)`, converted to the number type of the value.
template <class Value, class Function>
Value value_of_components(const Function& function) {
  Value result(0);
  for (std::size_t i = 0; i < component_count(result); ++i)
    component(result, i) = static_cast<scalar_t<Value>>(function(i));
  return result;
}

}  // namespace vcavity
