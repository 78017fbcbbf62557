// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Small dense systems of linear equations in any number type.

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A square matrix, row by row.
template <class Real>
class SquareMatrix {
 public:
  explicit SquareMatrix(std::size_t size) : size_(size), entries_(size * size, Real(0)) {}

  std::size_t size() const { return size_; }
  Real* operator[](std::size_t row) { return &entries_[row * size_]; }
  const Real* operator[](std::size_t row) const { return &entries_[row * size_]; }

  /// The product with a column of `size()` numbers.
  std::vector<Real> operator*(const std::vector<Real>& column) const {
    std::vector<Real> result(size_, Real(0));
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j) result[i] += (*this)[i][j] * column[j];
    return result;
  }

  SquareMatrix operator*(const SquareMatrix& other) const {
    SquareMatrix result(size_);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t k = 0; k < size_; ++k) {
        const Real factor = (*this)[i][k];
        for (std::size_t j = 0; j < size_; ++j) result[i][j] += factor * other[k][j];
      }
    return result;
  }

 private:
  std::size_t size_;
  std::vector<Real> entries_;
};

/// A matrix factorised by Gaussian elimination with partial pivoting (Golub & Van Loan, "Matrix Computations", 3.4), so
/// that each further right side costs no more than a product.
template <class Real>
class LuFactors {
 public:
  /// @param matrix not singular
  explicit LuFactors(SquareMatrix<Real> matrix)
      : factors_(std::move(matrix)), swapped_with_(factors_.size()) {
    using std::abs;
    const std::size_t n = factors_.size();
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n; ++i)
        if (abs(factors_[i][k]) > abs(factors_[pivot][k])) pivot = i;
      swapped_with_[k] = pivot;
      if (pivot != k)
        for (std::size_t j = 0; j < n; ++j) std::swap(factors_[k][j], factors_[pivot][j]);
      for (std::size_t i = k + 1; i < n; ++i) {
        const Real factor = factors_[i][k] / factors_[k][k];
        factors_[i][k] = factor;
        for (std::size_t j = k + 1; j < n; ++j) factors_[i][j] -= factor * factors_[k][j];
      }
    }
  }

  /// The solution for a right side of as many numbers as the matrix has rows.
  std::vector<Real> solve(std::vector<Real> right) const {
    const std::size_t n = factors_.size();
    for (std::size_t k = 0; k < n; ++k) std::swap(right[k], right[swapped_with_[k]]);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) right[i] -= factors_[i][j] * right[j];
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t j = i + 1; j < n; ++j) right[i] -= factors_[i][j] * right[j];
      right[i] /= factors_[i][i];
    }
    return right;
  }

 private:
  SquareMatrix<Real> factors_;
  std::vector<std::size_t> swapped_with_;
};

}  // namespace vcavity
