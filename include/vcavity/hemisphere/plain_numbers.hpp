// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Reflectances that are made of numbers which multiply one by one, so that logarithms turn long products into sums.
///
/// When not to use it: for Jones matrices and whatever else does not commute; their count is 0.

#include <cstddef>
#include <type_traits>

#include "vcavity/numbers/pack.hpp"
#include "vcavity/polarization/polarization.hpp"

namespace vcavity::detail {

/// How many numbers there are in a value, and how to reach each of them.
template <class Value>
struct PlainNumbers {
  static constexpr std::size_t count = std::is_floating_point_v<Value> ? 1 : 0;  ///< 0: it is something else
  static Value& at(Value& value, std::size_t) { return value; }
};
template <class Real, std::size_t size, std::size_t bytes>
struct PlainNumbers<Pack<Real, size, bytes>> {
  static constexpr std::size_t count = std::is_floating_point_v<Real> ? size : 0;
  static Real& at(Pack<Real, size, bytes>& value, std::size_t i) { return value[i]; }
};
template <class Value>
struct PlainNumbers<SeparatePolarizations<Value>> {
  static constexpr std::size_t of_each = PlainNumbers<Value>::count;
  static constexpr std::size_t count = 2 * of_each;
  static auto& at(SeparatePolarizations<Value>& value, std::size_t i) {
    return PlainNumbers<Value>::at(i < of_each ? value.s : value.p, i % of_each);
  }
};

}  // namespace vcavity::detail
