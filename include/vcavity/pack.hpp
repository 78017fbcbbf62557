// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A fixed number of values computed together, such as the wavelengths of a spectrum or neighbouring
/// directions.
///
/// Every operation works component by component, in loops of known length that compilers turn into vector
/// instructions. `Conductor<Pack<double, 31>>` is a facet reflectance for 31 wavelengths at once.

#include <array>
#include <cmath>
#include <cstddef>

#include "value.hpp"

namespace vcavity {

/// @tparam Real number type of a component
/// @tparam size number of components, at least 1
template <class Real, std::size_t size>
class Pack {
 public:
  using value_type = Real;

  Pack() = default;

  /// All components equal to `value`.
  constexpr explicit Pack(const Real& value) { components_.fill(value); }

  constexpr explicit Pack(const std::array<Real, size>& components) : components_(components) {}

  constexpr Real& operator[](std::size_t i) { return components_[i]; }
  constexpr const Real& operator[](std::size_t i) const { return components_[i]; }
  constexpr auto begin() const { return components_.begin(); }
  constexpr auto end() const { return components_.end(); }

  /// The pack of operation(a[i], b[i], …).
  template <class Operation, class... Packs>
  static constexpr Pack map(Operation operation, const Packs&... packs) {
    Pack result;
    for (std::size_t i = 0; i < size; ++i) result[i] = operation(packs[i]...);
    return result;
  }

  friend constexpr Pack operator-(const Pack& a) {
    return map([](const Real& x) { return -x; }, a);
  }
  friend constexpr Pack operator+(const Pack& a, const Pack& b) {
    return map([](const Real& x, const Real& y) { return x + y; }, a, b);
  }
  friend constexpr Pack operator-(const Pack& a, const Pack& b) {
    return map([](const Real& x, const Real& y) { return x - y; }, a, b);
  }
  friend constexpr Pack operator*(const Pack& a, const Pack& b) {
    return map([](const Real& x, const Real& y) { return x * y; }, a, b);
  }
  friend constexpr Pack operator/(const Pack& a, const Pack& b) {
    return map([](const Real& x, const Real& y) { return x / y; }, a, b);
  }
  friend constexpr Pack operator*(const Real& s, const Pack& a) { return Pack(s) * a; }
  friend constexpr bool operator==(const Pack&, const Pack&) = default;

  friend Pack sqrt(const Pack& a) {
    return map(
        [](const Real& x) {
          using std::sqrt;
          return sqrt(x);
        },
        a);
  }
  friend Pack abs(const Pack& a) {
    return map([](const Real& x) { return x < Real(0) ? Real(-x) : x; }, a);
  }
  friend Pack select_nonnegative(const Pack& x, const Pack& a, const Pack& b) {
    return map([](const Real& t, const Real& y, const Real& z) { return t >= Real(0) ? y : z; }, x, a, b);
  }
  friend Pack at_least(const Pack& a, const Real& floor) {
    return map([&floor](const Real& x) { return x < floor ? floor : x; }, a);
  }
  friend Pack at_most(const Pack& a, const Real& ceiling) {
    return map([&ceiling](const Real& x) { return ceiling < x ? ceiling : x; }, a);
  }
  template <class Visit>
  friend void for_each_component(const Pack& a, Visit&& visit) {
    for (const Real& x : a) visit(x);
  }
  friend Real largest(const Pack& a) {
    Real result = vcavity::largest(a[0]);
    for (const Real& x : a) result = at_least(result, vcavity::largest(x));
    return result;
  }

 private:
  std::array<Real, size> components_;
};

}  // namespace vcavity
