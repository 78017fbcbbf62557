// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What examples/mitsuba/lanes.hpp wants of Dr.Jit, as plain arrays: so a test without Dr.Jit can compile it, and follow
/// it with a debugger. As there, comparisons make masks that are no bool, and numbers and arrays of fewer dimensions
/// are spread over the entries of larger ones.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

namespace drjit {

/// @tparam Entry a number, a bool of a mask, or an array of these
template <class Entry, std::size_t count>
struct Array {
  std::array<Entry, count> entries{};

  Array() = default;
  /// The same everywhere.
  template <class Other>
    requires std::is_convertible_v<Other, Entry>
  Array(const Other& other) {
    entries.fill(Entry(other));
  }

  Entry& operator[](std::size_t i) { return entries[i]; }
  const Entry& operator[](std::size_t i) const { return entries[i]; }
};

template <class Value>
struct Traits {
  static constexpr std::size_t depth = 0, count = 0;
  using Entry = Value;
  template <class Other>
  using With = Other;
};
template <class Value, std::size_t n>
struct Traits<Array<Value, n>> {
  static constexpr std::size_t depth = Traits<Value>::depth + 1, count = n;
  using Entry = Value;
  template <class Other>
  using With = Array<typename Traits<Value>::template With<Other>, n>;
};

template <class Value>
using value_t = typename Traits<Value>::Entry;
template <class Value>
using mask_t = typename Traits<Value>::template With<bool>;

/// A function of numbers, entry by entry.
template <class Function, class... Values>
auto each(const Function& function, const Values&... values) {
  constexpr std::size_t depth = std::max({Traits<Values>::depth...});
  if constexpr (depth == 0) {
    return function(values...);
  } else {
    constexpr std::size_t count = std::max({Traits<Values>::depth == depth ? Traits<Values>::count : 0 ...});
    const auto entry = []<class Value>(const Value& value, std::size_t i) -> const auto& {
      if constexpr (Traits<Value>::depth == depth)
        return value[i];
      else
        return value;
    };
    Array<decltype(each(function, entry(values, 0)...)), count> result;
    for (std::size_t i = 0; i < count; ++i) result[i] = each(function, entry(values, i)...);
    return result;
  }
}

template <class A, class B>
concept Arrays = Traits<A>::depth + Traits<B>::depth > 0;

template <class Value>
  requires(Traits<Value>::depth > 0)
Value operator-(const Value& a) {
  return each([](float x) { return -x; }, a);
}
template <class A, class B>
  requires Arrays<A, B>
auto operator+(const A& a, const B& b) {
  return each([](float x, float y) { return x + y; }, a, b);
}
template <class A, class B>
  requires Arrays<A, B>
auto operator-(const A& a, const B& b) {
  return each([](float x, float y) { return x - y; }, a, b);
}
template <class A, class B>
  requires Arrays<A, B>
auto operator*(const A& a, const B& b) {
  return each([](float x, float y) { return x * y; }, a, b);
}
template <class A, class B>
  requires Arrays<A, B>
auto operator/(const A& a, const B& b) {
  return each([](float x, float y) { return x / y; }, a, b);
}
template <class A, class B>
  requires Arrays<A, B>
auto operator<(const A& a, const B& b) {
  return each([](float x, float y) { return x < y; }, a, b);
}
template <class A, class B>
  requires Arrays<A, B>
auto operator>(const A& a, const B& b) {
  return each([](float x, float y) { return x > y; }, a, b);
}
template <class A, class B>
  requires Arrays<A, B>
auto operator>=(const A& a, const B& b) {
  return each([](float x, float y) { return x >= y; }, a, b);
}

template <class Mask, class A, class B>
auto select(const Mask& mask, const A& a, const B& b) {
  return each([](bool is_set, float x, float y) { return is_set ? x : y; }, mask, a, b);
}
template <class A, class B>
auto minimum(const A& a, const B& b) {
  return each([](float x, float y) { return std::min(x, y); }, a, b);
}
template <class A, class B>
auto maximum(const A& a, const B& b) {
  return each([](float x, float y) { return std::max(x, y); }, a, b);
}
template <class Entry, std::size_t count>
Entry max(const Array<Entry, count>& a) {
  Entry result = a[0];
  for (const Entry& entry : a.entries) result = maximum(result, entry);
  return result;
}

template <class Value>
Value abs(const Value& a) {
  return each([](float x) { return std::abs(x); }, a);
}
template <class Value>
Value sqrt(const Value& a) {
  return each([](float x) { return std::sqrt(x); }, a);
}
template <class Value>
Value exp(const Value& a) {
  return each([](float x) { return std::exp(x); }, a);
}
template <class Value>
Value log(const Value& a) {
  return each([](float x) { return std::log(x); }, a);
}
template <class Value>
Value sin(const Value& a) {
  return each([](float x) { return std::sin(x); }, a);
}
template <class Value>
Value cos(const Value& a) {
  return each([](float x) { return std::cos(x); }, a);
}
template <class Value>
Value floor(const Value& a) {
  return each([](float x) { return std::floor(x); }, a);
}

template <class Value>
Value round(const Value& a) {
  return each([](float x) { return std::round(x); }, a);
}
/// Derivatives, of which there are none here, end at it.
template <class Value>
Value detach(const Value& a) {
  return a;
}

template <class Number>
inline constexpr Number Pi = std::numbers::pi_v<Number>;
template <class Number>
inline constexpr Number InvPi = std::numbers::inv_pi_v<Number>;

/// Whether arrays are those of a GPU, for which lanes.hpp does more itself.
template <class Value>
inline constexpr bool is_cuda_v = true;

}  // namespace drjit
