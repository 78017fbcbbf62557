// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A fixed number of values computed together, such as the wavelengths of a spectrum or neighbouring
/// directions.
///
/// Every operation works component by component, in vector registers where the compiler has them (GCC and
/// Clang, as wide as the instruction set that the translation unit is compiled for). `Conductor<Pack<double,
/// 31>>` is a facet reflectance for 31 wavelengths at once. Translation units compiled for different
/// instruction sets must not exchange packs.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

namespace detail {

/// Bytes in a vector register.
#if defined(__AVX512F__)
inline constexpr std::size_t register_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

/// As many numbers as an instruction takes: a vector register, or a single number where there is none.
template <class Real, std::size_t size, std::size_t most_bytes>
struct Register {
  using type = Real;
  static constexpr std::size_t width = 1;
};

#if defined(__GNUC__)
template <class Real, std::size_t size, std::size_t most_bytes>
  requires((std::is_same_v<Real, float> || std::is_same_v<Real, double>) && size > 1)
struct Register<Real, size, most_bytes> {
  // No wider than the pack, rounded up to a power of two.
  static constexpr std::size_t bytes() {
    std::size_t result = 2 * sizeof(Real);
    while (result < size * sizeof(Real) && result < most_bytes) result *= 2;
    return result;
  }
  typedef Real type VCAVITY_VECTOR(bytes());
  static constexpr std::size_t width = bytes() / sizeof(Real);
};
#endif

}  // namespace detail

/// How many numbers fit into a vector register: the size of pack that is fastest.
template <class Real>
inline constexpr std::size_t native_lanes = std::max<std::size_t>(detail::register_bytes / sizeof(Real), 1);

/// @tparam Real number type of a component
/// @tparam size number of components, at least 1
/// @tparam most_bytes size of the vector registers; part of the type, so that code for different instruction
///          sets can be linked into one program
template <class Real, std::size_t size, std::size_t most_bytes = detail::register_bytes>
class Pack {
  template <class, std::size_t, std::size_t>
  friend class Pack;
  using Register = typename detail::Register<Real, size, most_bytes>::type;
  static constexpr std::size_t width = detail::Register<Real, size, most_bytes>::width;
  static constexpr std::size_t registers = (size + width - 1) / width;

 public:
  using value_type = Real;

  /// What comparisons of packs make: for each component whether it holds.
  class Mask {
   public:
    /// Component by component, `a` where the mask is set and `b` elsewhere.
    VCAVITY_INLINE Pack choose(const Pack& a, const Pack& b) const {
      Pack result;
      for (std::size_t i = 0; i < registers; ++i)
        result.registers_[i] = registers_[i] ? a.registers_[i] : b.registers_[i];
      return result;
    }
    VCAVITY_INLINE friend bool any_of(const Mask& mask) {
      return mask.holds_for_any([](const auto& x) { return x; });
    }
    VCAVITY_INLINE friend bool all_of(const Mask& mask) {
      return !mask.holds_for_any([](const auto& x) { return !x; });
    }

    /// A number of which bit i is set where component i holds; of packs of as many components as a component has bits,
    /// or fewer.
    VCAVITY_INLINE friend std::uint64_t bits_of(const Mask& mask) {
      static_assert(size <= 8 * sizeof(Real), "a bit for each component");
      return mask.bits(std::make_index_sequence<width>());
    }

   private:
    friend class Pack;

    template <std::size_t... lane>
    VCAVITY_INLINE std::uint64_t bits(std::index_sequence<lane...>) const {
      if constexpr (width == 1) {
        std::uint64_t result = 0;
        for (std::size_t i = 0; i < size; ++i) result |= std::uint64_t(registers_[i] ? 1 : 0) << i;
        return result;
      } else {
        using Bits = std::remove_cvref_t<decltype(registers_[0])>;
        using Word = std::remove_cvref_t<decltype(registers_[0][0])>;
        const auto bit = [](std::size_t i) { return i < size ? static_cast<Word>(Word(1) << i) : Word(0); };
        Bits found = registers_[0] & Bits{bit(lane)...};
        for (std::size_t i = 1; i < registers; ++i) found |= registers_[i] & Bits{bit(i * width + lane)...};
        const std::uint64_t word = combined_words(found);
        return sizeof(Word) == 4 ? (word | word >> 32) & 0xffffffffu : word;
      }
    }

    /// Whether a component of what `bits` makes of the mask is set.
    template <class Bits>
    VCAVITY_INLINE bool holds_for_any(Bits bits) const {
      if constexpr (width == 1) {
        for (const bool x : registers_)
          if (bits(x)) return true;
        return false;
      } else if constexpr (size % width != 0) {
        for (std::size_t i = 0; i < size; ++i)
          if (bits(registers_[i / width][i % width] != 0)) return true;
        return false;
      } else {
        auto found = bits(registers_[0]);
        for (std::size_t i = 1; i < registers; ++i) found |= bits(registers_[i]);
        return combined_words(found) != 0;
      }
    }

    /// All words of 64 bits or'ed, halves at a time.
    template <class Bits>
    VCAVITY_INLINE static std::uint64_t combined_words(const Bits& bits) {
      if constexpr (sizeof bits <= sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, &bits, sizeof bits);
        return word;
      } else {
        typedef std::uint64_t Half VCAVITY_VECTOR(sizeof bits / 2);
        Half halves[2];
        std::memcpy(halves, &bits, sizeof bits);
        return combined_words(halves[0] | halves[1]);
      }
    }

    decltype(std::declval<Register>() > std::declval<Register>()) registers_[registers];
  };

  Pack() = default;

  /// All components equal to `value`.
  VCAVITY_INLINE explicit Pack(const Real& value) {
    for (Register& x : registers_) x = broadcast(value);
  }

  VCAVITY_INLINE explicit Pack(const std::array<Real, size>& components) : Pack(components.back()) {
    std::copy(components.begin(), components.end(), begin());
  }

  /// The first components of a longer pack.
  template <std::size_t longer>
    requires(longer > size)
  VCAVITY_INLINE explicit Pack(const Pack<Real, longer, most_bytes>& a) {
    if constexpr (Pack<Real, longer, most_bytes>::width == width)
      for (std::size_t i = 0; i < registers; ++i) registers_[i] = a.registers_[i];
    else
      *this = load(a.begin());
  }

  /// Packs of whole registers, one after the other.
  template <std::size_t part, std::size_t count>
    requires(part* count == size && count > 1 && part % Pack<Real, part, most_bytes>::width == 0)
  VCAVITY_INLINE explicit Pack(const std::array<Pack<Real, part, most_bytes>, count>& parts) {
    if constexpr (part % width == 0) {
      constexpr std::size_t each = part / width;
      for (std::size_t i = 0; i < registers; ++i) registers_[i] = parts[i / each].registers_[i % each];
    } else {
      // Several of them fill a register.
      static_assert(sizeof parts == sizeof registers_);
      std::memcpy(registers_, parts.data(), sizeof registers_);
    }
  }

  /// The i-th of the packs of whole registers that a pack is made of.
  template <std::size_t part>
    requires(size % part == 0 && part % Pack<Real, part, most_bytes>::width == 0)
  VCAVITY_INLINE Pack<Real, part, most_bytes> slice(std::size_t i) const {
    Pack<Real, part, most_bytes> result;
    if constexpr (part % width == 0) {
      constexpr std::size_t each = part / width;
      for (std::size_t k = 0; k < each; ++k) result.registers_[k] = registers_[i * each + k];
    } else {
      std::memcpy(result.registers_, begin() + i * part, sizeof result.registers_);
    }
    return result;
  }

  /// Component by component, `a` where the pattern holds and `b` elsewhere: what `select` does with a mask, for less,
  /// where the choice depends on no number.
  template <std::array<bool, size> pattern>
    requires(size % width == 0)
  VCAVITY_INLINE static Pack blended(const Pack& a, const Pack& b) {
    return blended<pattern>(a, b, std::make_index_sequence<registers>());
  }

  /// The same components in another order: component i of the result is component `order[i]`.
  template <std::array<std::size_t, size> order>
    requires(size % width == 0)
  VCAVITY_INLINE Pack rearranged() const {
    return rearranged<order>(std::make_index_sequence<registers>());
  }

  /// The `size` components that start at an address.
  VCAVITY_INLINE static Pack load(const Real* components) {
    Pack result(components[size - 1]);
    std::memcpy(result.registers_, components, size * sizeof(Real));
    return result;
  }

  /// The same from numbers of another type.
  template <class Other>
  VCAVITY_INLINE static Pack load(const Other* components) {
    Pack result;
    for (std::size_t i = 0; i < registers; ++i)
      result.registers_[i] = converted(components, i * width, std::make_index_sequence<width>());
    return result;
  }

  VCAVITY_INLINE Real& operator[](std::size_t i) { return begin()[i]; }
  VCAVITY_INLINE const Real& operator[](std::size_t i) const { return begin()[i]; }
  VCAVITY_INLINE Real* begin() { return reinterpret_cast<Real*>(registers_); }
  VCAVITY_INLINE Real* end() { return begin() + size; }
  VCAVITY_INLINE const Real* begin() const { return reinterpret_cast<const Real*>(registers_); }
  VCAVITY_INLINE const Real* end() const { return begin() + size; }

  VCAVITY_INLINE friend Pack operator-(const Pack& a) {
    return map([](const auto& x) { return -x; }, a);
  }
  VCAVITY_INLINE friend Pack operator+(const Pack& a, const Pack& b) {
    return map([](const auto& x, const auto& y) { return x + y; }, a, b);
  }
  VCAVITY_INLINE friend Pack operator-(const Pack& a, const Pack& b) {
    return map([](const auto& x, const auto& y) { return x - y; }, a, b);
  }
  VCAVITY_INLINE friend Pack operator*(const Pack& a, const Pack& b) {
    return map([](const auto& x, const auto& y) { return x * y; }, a, b);
  }
  VCAVITY_INLINE friend Pack operator/(const Pack& a, const Pack& b) {
    return map([](const auto& x, const auto& y) { return x / y; }, a, b);
  }
  VCAVITY_INLINE friend Pack operator*(const Real& s, const Pack& a) {
    return map([y = broadcast(s)](const auto& x) { return y * x; }, a);
  }
  friend bool operator==(const Pack& a, const Pack& b) { return std::equal(a.begin(), a.end(), b.begin()); }

  VCAVITY_INLINE friend Pack sqrt(const Pack& a) {
    Pack result = a;
    for (Register& x : result.registers_) x = root(x, std::make_index_sequence<width>());
    return result;
  }
  VCAVITY_INLINE friend Pack magnitude(const Pack& a) {
    return map([](const auto& x) { return x < zero() ? -x : x; }, a);
  }
  VCAVITY_INLINE friend Mask operator>=(const Pack& a, const Pack& b) {
    return compare([](const auto& x, const auto& y) { return x >= y; }, a, b);
  }
  VCAVITY_INLINE friend Mask operator>=(const Pack& a, const Real& b) {
    return compare([y = broadcast(b)](const auto& x) { return x >= y; }, a);
  }
  VCAVITY_INLINE friend Mask operator>(const Pack& a, const Pack& b) {
    return compare([](const auto& x, const auto& y) { return x > y; }, a, b);
  }
  VCAVITY_INLINE friend Mask operator>(const Pack& a, const Real& b) {
    return compare([y = broadcast(b)](const auto& x) { return x > y; }, a);
  }
  VCAVITY_INLINE friend Mask operator<(const Pack& a, const Real& b) {
    return compare([y = broadcast(b)](const auto& x) { return x < y; }, a);
  }
  VCAVITY_INLINE friend Pack select(const Mask& mask, const Pack& a, const Pack& b) {
    return mask.choose(a, b);
  }
  VCAVITY_INLINE friend Pack at_least(const Pack& a, const Real& floor) {
    return map([low = broadcast(floor)](const auto& x) { return greater(low, x); }, a);
  }
  VCAVITY_INLINE friend Pack at_most(const Pack& a, const Real& ceiling) {
    return map([high = broadcast(ceiling)](const auto& x) { return lesser(high, x); }, a);
  }
  VCAVITY_INLINE friend Pack at_most(const Pack& a, const Pack& b) {
    return map([](const auto& x, const auto& y) { return lesser(y, x); }, a, b);
  }
  VCAVITY_INLINE friend Pack at_least(const Pack& a, const Pack& b) {
    return map([](const auto& x, const auto& y) { return greater(y, x); }, a, b);
  }
  friend Real largest(const Pack& a) {
    Real result = vcavity::largest(a[0]);
    for (const Real& x : a) result = at_least(result, vcavity::largest(x));
    return result;
  }

 private:
  template <std::array<std::size_t, size> order, std::size_t... i>
  VCAVITY_INLINE Pack rearranged(std::index_sequence<i...>) const {
    Pack result;
    ((result.registers_[i] = rearranged_register<order, i>(std::make_index_sequence<width>())), ...);
    return result;
  }
  template <std::array<std::size_t, size> order, std::size_t i, std::size_t... lane>
  VCAVITY_INLINE Register rearranged_register(std::index_sequence<lane...>) const {
    if constexpr (width == 1) {
      return registers_[order[i]];
    } else {
      return Register{registers_[order[i * width + lane] / width][order[i * width + lane] % width]...};
    }
  }
  template <std::array<bool, size> pattern, std::size_t... i>
  VCAVITY_INLINE static Pack blended(const Pack& a, const Pack& b, std::index_sequence<i...>) {
    Pack result;
    ((result.registers_[i] =
          blended_register<pattern, i>(a.registers_[i], b.registers_[i], std::make_index_sequence<width>())),
     ...);
    return result;
  }
  template <std::array<bool, size> pattern, std::size_t i, std::size_t... lane>
  VCAVITY_INLINE static Register blended_register(const Register& a, const Register& b,
                                                  std::index_sequence<lane...>) {
    if constexpr (width == 1) {
      return pattern[i] ? a : b;
    } else {
      return Register{(pattern[i * width + lane] ? a[lane] : b[lane])...};
    }
  }
  // Without a loop, compilers see the one instruction that this is.
  template <std::size_t... lane>
  VCAVITY_INLINE static Register root(const Register& x, std::index_sequence<lane...>) {
    using std::sqrt;
    if constexpr (width == 1) {
      return sqrt(x);
    } else {
      return Register{sqrt(x[lane])...};
    }
  }
  template <class Other, std::size_t... lane>
  VCAVITY_INLINE static Register converted(const Other* components, std::size_t start,
                                           std::index_sequence<lane...>) {
    const auto component = [&](std::size_t i) {
      return static_cast<Real>(components[i < size ? i : size - 1]);
    };
    if constexpr (width == 1) {
      return component(start);
    } else {
      return Register{component(start + lane)...};
    }
  }
  VCAVITY_INLINE static Register broadcast(const Real& value) {
    if constexpr (width == 1) {
      return value;
    } else {
      return value - Register{};
    }
  }
  VCAVITY_INLINE static Register zero() { return Register(broadcast(Real(0))); }

  /// What is not less, or x if neither is.
  VCAVITY_INLINE static Register greater(Register limit, const Register& x) {
    if constexpr (width > 1) VCAVITY_FORGET(limit);
    return x < limit ? limit : x;
  }
  VCAVITY_INLINE static Register lesser(Register limit, const Register& x) {
    if constexpr (width > 1) VCAVITY_FORGET(limit);
    return limit < x ? limit : x;
  }

  /// The pack of operation(a, b, …), a register at a time.
  template <class Operation, class... Packs>
  VCAVITY_INLINE static Pack map(Operation operation, const Packs&... packs) {
    Pack result;
    for (std::size_t i = 0; i < registers; ++i) result.registers_[i] = operation(packs.registers_[i]...);
    return result;
  }

  /// The mask of condition(a, b, …), a register at a time.
  template <class Condition, class... Packs>
  VCAVITY_INLINE static Mask compare(Condition condition, const Packs&... packs) {
    Mask result;
    for (std::size_t i = 0; i < registers; ++i) result.registers_[i] = condition(packs.registers_[i]...);
    return result;
  }

  Register registers_[registers];
};

}  // namespace vcavity
