// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Numbers of Dr.Jit as values of vcavity: as many directions at once as an array has entries, with derivatives where the
/// array has them.
///
/// The headers of vcavity compute with packs of numbers, whose comparisons make masks that `select` takes. An array of
/// Dr.Jit is such a pack, of which nobody knows the entries before a kernel runs. So whether any entry meets a condition
/// is answered with "maybe": `any_of` is true and `all_of` false, all work is done, and masks decide what counts.
///
/// When not to use it: where a function of vcavity branches on a number. Such code does not compile, for a mask is no bool.

#include <drjit/jit.h>
#include <drjit/math.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vcavity/vcavity.hpp>

namespace vgroove {

/// A condition on each entry of an array.
template <class Mask>
struct LaneMask {
  Mask mask;

  friend bool any_of(const LaneMask&) { return true; }
  friend bool all_of(const LaneMask&) { return false; }
};

/// @tparam Array `Float` of a vectorised variant, or a colour or spectrum of them
template <class Array>
struct Lanes {
  using Entry = drjit::value_t<Array>;
  static constexpr bool is_number = std::is_arithmetic_v<Entry>;
  using value_type = Lanes<std::conditional_t<is_number, Array, Entry>>;
  using Mask = LaneMask<drjit::mask_t<Array>>;

  Array array;

  Lanes() = default;
  Lanes(const Array& values) : array(values) {}
  /// The same number everywhere.
  template <class Number>
    requires std::is_arithmetic_v<Number>
  explicit Lanes(Number number) : array(static_cast<float>(number)) {}
  /// A number of each direction as the value of all colours.
  template <class Other>
    requires(!is_number && std::is_same_v<Other, Entry>)
  Lanes(const Lanes<Other>& number) : array(number.array) {}

  friend Lanes operator-(const Lanes& a) { return -a.array; }
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.array + b.array; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.array - b.array; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.array * b.array; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.array / b.array; }
  Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
  Lanes& operator/=(const Lanes& b) { return *this = *this / b; }

  friend Mask operator<(const Lanes& a, const Lanes& b) { return {a.array < b.array}; }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return {a.array > b.array}; }
  friend Mask operator>=(const Lanes& a, const Lanes& b) { return {a.array >= b.array}; }
  template <class Condition>
  friend Lanes select(const LaneMask<Condition>& mask, const Lanes& a, const Lanes& b) {
    return Array(drjit::select(mask.mask, a.array, b.array));
  }

  /// An array of numbers is the only component of its value.
  Lanes& operator[](std::size_t)
    requires is_number
  {
    return *this;
  }
  const Lanes& operator[](std::size_t) const
    requires is_number
  {
    return *this;
  }
  friend constexpr std::size_t component_count(const Lanes&)
    requires is_number
  {
    return 1;
  }

  static Lanes pi() { return Lanes(drjit::Pi<float>); }

  friend Lanes sqrt(const Lanes& a) { return drjit::sqrt(a.array); }
  friend Lanes magnitude(const Lanes& a) { return drjit::abs(a.array); }
  friend Lanes at_least(const Lanes& a, const Lanes& floor) { return drjit::maximum(a.array, floor.array); }
  friend Lanes at_most(const Lanes& a, const Lanes& ceiling) {
    return drjit::minimum(a.array, ceiling.array);
  }
  friend Lanes exp(const Lanes& a) { return drjit::exp(a.array); }
  friend Lanes sin(const Lanes& a) {
    if constexpr (has_coarse_sine)
      return a.turned([](const Lanes& rest) { return vcavity::detail::acute_sine(rest); });
    else
      return drjit::sin(a.array);
  }
  friend Lanes cos(const Lanes& a) {
    if constexpr (has_coarse_sine)
      return a.turned([](const Lanes& rest) { return vcavity::detail::acute_cosine(rest); });
    else
      return drjit::cos(a.array);
  }
  friend Lanes log(const Lanes& a) { return drjit::log(a.array); }
  friend Lanes floor(const Lanes& a) { return drjit::floor(a.array); }
  friend Lanes abs(const Lanes& a) { return drjit::abs(a.array); }
  friend Lanes log1p(const Lanes& a) { return drjit::log(1.f + a.array); }
  friend value_type largest(const Lanes& a) {
    if constexpr (is_number)
      return drjit::abs(a.array);
    else
      return drjit::max(drjit::abs(a.array));
  }

 private:
  /// The sines of GPUs, which Dr.Jit takes, are wrong by 6e-7. Of a nearly vertical wall that is much, and through many
  /// bounces it adds up.
  static constexpr bool has_coarse_sine = drjit::is_cuda_v<Array>;

  /// A function that changes its sign with each half turn.
  /// @param of_acute the function between −π/2 and π/2
  template <class OfAcute>
  Lanes turned(const OfAcute& of_acute) const {
    const Array half_turns = drjit::round(drjit::detach(array) * drjit::InvPi<float>);
    // π in parts of few digits, of which multiples are exact (Cody and Waite 1980).
    const Array rest =
        ((array - half_turns * 3.140625f) - half_turns * 9.67502594e-4f) - half_turns * 1.50995799e-7f;
    const Array parity = half_turns - 2.f * drjit::floor(0.5f * half_turns);
    return of_acute(Lanes(rest)).array * (1.f - 2.f * parity);
  }
};

}  // namespace vgroove

/// The properties of the entries, where functions ask for them by the type of a value.
template <class Array>
struct std::numeric_limits<vgroove::Lanes<Array>> {
  using Value = vgroove::Lanes<Array>;
  static constexpr bool is_specialized = false;  // a pack is no number
  static Value epsilon() { return Value(std::numeric_limits<float>::epsilon()); }
  static Value min() { return Value(std::numeric_limits<float>::min()); }
  static Value max() { return Value(std::numeric_limits<float>::max()); }
};

namespace vcavity {

/// Single precision: short polynomials will do for acute angles.
template <class Array>
inline constexpr bool detail::has_short_series<vgroove::Lanes<Array>> = true;

/// Grooves of as many apertures as an array has entries, through which derivatives pass. It stands in for `Cavity` where
/// the headers want one, with the same members.
template <class Array>
class Cavity<vgroove::Lanes<Array>> {
 public:
  using Real = vgroove::Lanes<Array>;
  using value_type = Real;
  using Rotation = vcavity::Rotation<Real>;
  static constexpr std::size_t max_lobes = 4;

  /// @param aperture in radians, in (0, π]
  /// @param max_bounces of the narrowest groove: so many are followed in all
  Cavity(const Real& aperture, int max_bounces)
      : max_bounces_(max_bounces), multiples_(aperture, half_of(aperture), max_bounces) {}

  Real aperture() const { return multiples_.aperture(); }
  Real sin_half() const { return multiples_[1].sine; }
  Real cos_half() const { return multiples_[1].cosine; }
  Real inverse_sin_half() const { return Real(1) / sin_half(); }
  Real least_up() const { return smallest_divisor<Real>() * inverse_sin_half(); }
  Rotation multiple(std::int64_t k) const { return multiples_.at(k); }
  const HalfApertureMultiples<Real>& multiples() const { return multiples_; }
  int max_bounces() const { return max_bounces_; }

 private:
  static Rotation half_of(const Real& aperture) {
    const Real half = Real(0.5f) * aperture;
    return {at_least(cos(half), Real(0)), sin(half)};
  }

  int max_bounces_;
  HalfApertureMultiples<Real> multiples_;
};

/// Multiplying by 1 is all there is.
template <class Array>
inline constexpr bool cheaper_than_branch<vgroove::Lanes<Array>> = true;

}  // namespace vcavity
