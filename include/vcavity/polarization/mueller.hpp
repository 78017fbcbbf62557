// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Mueller matrices: what becomes of partially polarised light, and what adds up where waves do not
/// interfere.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/linear.hpp"
#include "vcavity/polarization/jones.hpp"

namespace vcavity {

/// Intensity and polarisation of light, I, Q, U, V; axes and signs are in conventions.hpp.
template <class Value>
using Stokes = std::array<Value, 4>;

/// A turn of the axes a and b of polarised light by an angle χ, from a towards b.
template <class Real>
struct AxesTurn {
  Real cos_twice;  ///< cos 2χ
  Real sin_twice;  ///< sin 2χ
};

/// A linear map of Stokes parameters.
template <class Value>
class Mueller : public Linear<Mueller<Value>, Value> {
 public:
  using value_type = scalar_t<Value>;

  Mueller() = default;

  /// 1: the light stays as it is. 0: no light at all.
  explicit Mueller(int light) {
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        rows_[row][column] = Value(static_cast<value_type>(row == column ? light : 0));
  }

  /// What a Jones matrix does to intensities: M_ij = ½ tr(σ_i J σ_j J†), with the Pauli matrices in the order
  /// of the Stokes parameters.
  VCAVITY_INLINE explicit Mueller(const Jones<Value>& j) {
    const value_type half(0.5);
    const Value aa = norm(j.aa), ab = norm(j.ab), ba = norm(j.ba), bb = norm(j.bb);
    const Complex<Value> to_a = j.aa * conj(j.ab), to_b = j.ba * conj(j.bb);
    const Complex<Value> from_a = j.aa * conj(j.ba), from_b = j.ab * conj(j.bb);
    const Complex<Value> straight = j.aa * conj(j.bb), crossed = j.ab * conj(j.ba);
    rows_ = {
        {{half * (aa + ab + ba + bb), half * (aa - ab + ba - bb), to_a.re + to_b.re, -to_a.im - to_b.im},
         {half * (aa + ab - ba - bb), half * (aa - ab - ba + bb), to_a.re - to_b.re, to_b.im - to_a.im},
         {from_a.re + from_b.re, from_a.re - from_b.re, straight.re + crossed.re, crossed.im - straight.im},
         {from_a.im + from_b.im, from_a.im - from_b.im, straight.im + crossed.im, straight.re - crossed.re}}};
  }

  /// An element, by value: the matrix is often that of an expression, and gone at its end.
  /// @param row, column 0, 1, 2, 3 stand for I, Q, U, V
  Value operator()(std::size_t row, std::size_t column) const { return rows_[row][column]; }

  /// All elements of an operation on matrices; see `Linear`.
  template <class Operation, class... Muellers>
  VCAVITY_INLINE static Mueller combine(const Operation& operation, const Muellers&... matrices) {
    Mueller result;
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        result.rows_[row][column] = operation(matrices.rows_[row][column]...);
    return result;
  }

  /// The largest element.
  friend value_type largest(const Mueller& a) {
    value_type result(0);
    for (const auto& row : a.rows_)
      for (const Value& element : row) result = at_least(result, largest(element));
    return result;
  }

  /// What becomes of light that travels the same way backwards. By Helmholtz reciprocity the Jones matrix is
  /// transposed; and of the axes of light that travels along −k, a is the same and b the opposite, so that U
  /// changes sign.
  friend Mueller reversed(const Mueller& a) {
    Mueller result;
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        result.rows_[row][column] = (row == 2) == (column == 2) ? a(column, row) : -a(column, row);
    return result;
  }

  /// The same matrix for other axes of the light before and after.
  /// @param a the matrix
  /// @param before,after from the axes of this matrix to those of the result
  template <class Real>
  friend Mueller in_turned_axes(const Mueller& a, const AxesTurn<Real>& before, const AxesTurn<Real>& after) {
    Mueller turned = a;
    for (std::size_t row = 0; row < 4; ++row) {
      turned.rows_[row][1] = scaled(before.cos_twice, a(row, 1)) + scaled(before.sin_twice, a(row, 2));
      turned.rows_[row][2] = scaled(before.cos_twice, a(row, 2)) - scaled(before.sin_twice, a(row, 1));
    }
    Mueller result = turned;
    for (std::size_t column = 0; column < 4; ++column) {
      result.rows_[1][column] =
          scaled(after.cos_twice, turned(1, column)) + scaled(after.sin_twice, turned(2, column));
      result.rows_[2][column] =
          scaled(after.cos_twice, turned(2, column)) - scaled(after.sin_twice, turned(1, column));
    }
    return result;
  }

  /// The light that `light` becomes.
  friend Stokes<Value> operator*(const Mueller& a, const Stokes<Value>& light) {
    Stokes<Value> result;
    for (std::size_t row = 0; row < 4; ++row)
      result[row] = a(row, 0) * light[0] + a(row, 1) * light[1] + a(row, 2) * light[2] + a(row, 3) * light[3];
    return result;
  }

 private:
  std::array<std::array<Value, 4>, 4> rows_;
};

/// Waves of different lobes do not interfere: their Mueller matrices add up, not their Jones matrices.
template <class Value>
VCAVITY_INLINE Mueller<Value> power(const Jones<Value>& throughput) {
  return Mueller<Value>(throughput);
}

/// The reflectance of unpolarised light, ½‖J‖² in terms of the Jones matrix.
template <class Value>
Value unpolarized(const Mueller<Value>& reflectance) {
  return reflectance(0, 0);
}

/// The degree of polarisation of light, in [0, 1]; 0 in the dark.
template <class Value>
Value degree_of_polarization(const Stokes<Value>& light) {
  using std::sqrt;
  using Real = scalar_t<Value>;
  const Value intensity = at_least(light[0], std::numeric_limits<Real>::min());
  const Value q = light[1] / intensity, u = light[2] / intensity, v = light[3] / intensity;
  return at_most(Value(sqrt(q * q + u * u + v * v)), Real(1));
}

/// The degree of polarisation, in [0, 1], that unpolarised light leaves with; 0 where none leaves.
template <class Value>
Value polarizance(const Mueller<Value>& m) {
  return degree_of_polarization(Stokes<Value>{m(0, 0), m(1, 0), m(2, 0), m(3, 0)});
}

/// How much the reflectance depends on the polarisation of the incident light, (max − min)/(max + min) in
/// [0, 1]; 0 where no light leaves.
///
/// By reciprocity, for the matrix of all lobes of a direction, also the degree of polarisation of the groove
/// as seen from that direction in unpolarised diffuse light.
template <class Value>
Value diattenuation(const Mueller<Value>& m) {
  return degree_of_polarization(Stokes<Value>{m(0, 0), m(0, 1), m(0, 2), m(0, 3)});
}

}  // namespace vcavity
