// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sums and multiples of values that are made of several parts, written once.

#include <cstddef>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"

namespace vcavity {

/// Base of a value with `a + b` and `s * a`, part by part. The factor is a number, a number for each component of
/// the parts, or a pack of them.
/// @tparam Derived the value. It has a static member `combine(operation, a, …)`, the value of operation(part of a,
///          …) for every part
/// @tparam Part of what its parts are made
template <class Derived, class Part>
struct Linear {
  VCAVITY_INLINE friend Derived operator+(const Derived& a, const Derived& b) {
    return Derived::combine([](const auto& x, const auto& y) { return x + y; }, a, b);
  }
  VCAVITY_INLINE friend Derived operator*(const scalar_t<Part>& s, const Derived& a) {
    return Derived::combine([&s](const auto& x) { return s * x; }, a);
  }
  VCAVITY_INLINE friend Derived operator*(const Part& s, const Derived& a)
    requires(!Number<Part>)
  {
    return Derived::combine([&s](const auto& x) { return s * x; }, a);
  }
  template <class Real, std::size_t size, std::size_t bytes>
  VCAVITY_INLINE friend Derived operator*(const Pack<Real, size, bytes>& s, const Derived& a) {
    return Derived::combine([&s](const auto& x) { return s * x; }, a);
  }
};

}  // namespace vcavity
