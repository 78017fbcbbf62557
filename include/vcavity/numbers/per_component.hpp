// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Functions of numbers applied to values of many components: what has no vector instruction, such as a logarithm,
/// one component after the other.

#include <cstddef>
#include <glm/detail/qualifier.hpp>
#include <type_traits>

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

/// Component `i` of a value, counted from 0; of a number the number itself. It lives as long as the value does.
template <class Value>
constexpr decltype(auto) component(Value&& value, [[maybe_unused]] std::size_t i) {
  if constexpr (Number<std::remove_cvref_t<Value>>)
    return (value);
  else if constexpr (requires { value.length(); })
    return (value[static_cast<glm::length_t>(i)]);
  else
    return (value[i]);
}

/// Calls `visit` with every component of `a`.
template <class Value, class Visit>
void for_each_component(const Value& a, Visit&& visit) {
  for (std::size_t i = 0; i < component_count(a); ++i) visit(component(a, i));
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
