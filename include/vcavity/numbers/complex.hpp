// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Complex numbers over any value type: `std::complex` is defined for float, double and long double only,
/// while field amplitudes are also needed for packs, colours and 50-digit numbers.

#include "vcavity/numbers/compiler.hpp"

namespace vcavity {

/// re + i·im
template <class Value>
struct Complex {
  Value re;
  Value im;

  VCAVITY_INLINE friend Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  VCAVITY_INLINE friend Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  VCAVITY_INLINE friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  VCAVITY_INLINE friend Complex operator*(const Value& s, const Complex& a) { return {s * a.re, s * a.im}; }
  VCAVITY_INLINE friend Complex operator/(const Complex& a, const Complex& b) {
    const Value inverse = Value(1) / norm(b);
    return {(a.re * b.re + a.im * b.im) * inverse, (a.im * b.re - a.re * b.im) * inverse};
  }

  /// The complex conjugate.
  VCAVITY_INLINE friend Complex conj(const Complex& a) { return {a.re, -a.im}; }

  /// The squared modulus.
  VCAVITY_INLINE friend Value norm(const Complex& a) { return a.re * a.re + a.im * a.im; }
};

}  // namespace vcavity
