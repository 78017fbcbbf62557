// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What is left of a logarithm and an exponential after their first terms, without the loss of digits of the plain
/// difference; in any number type.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// ln(1 + y), and by how much y exceeds it.
template <class Real>
struct LogarithmAndRest {
  Real logarithm;  ///< ln(1 + y)
  Real rest;       ///< y − ln(1 + y) ≥ 0, y²/2 for small y
};

/// ln(1 + y) and y − ln(1 + y), both with all their digits, for the price of one logarithm.
///
/// With s = y/(2 + y), ln(1 + y) = 2 artanh s = 2(s + s³/3 + s⁵/5 + …) (Abramowitz & Stegun, 4.1.27), and y − 2s = sy.
/// @param y above −1
template <class Real>
LogarithmAndRest<Real> logarithm_and_rest(const Real& y) {
  using std::abs;
  using std::log;
  if (abs(y) < Real(0.125)) {
    // s² < 1/225 gives 7.8 bits for each term.
    constexpr int terms = std::numeric_limits<Real>::digits * 10 / 78 + 1;
    static const auto odd_inverses = [] {
      std::array<Real, std::size_t(terms)> result{};
      for (int k = 0; k < terms; ++k) result[static_cast<std::size_t>(k)] = Real(2) / Real(2 * k + 3);
      return result;
    }();
    const Real s = y / (Real(2) + y);
    const Real square = s * s;
    Real sum = odd_inverses[std::size_t(terms) - 1];
    for (std::size_t k = std::size_t(terms) - 1; k-- > 0;) sum = sum * square + odd_inverses[k];
    const Real rest = s * (y - square * sum);
    return {y - rest, rest};
  }
  const Real u = Real(1) + y;
  const Real logarithm = log(u) + (y - (u - Real(1))) / u;  // with what the sum has rounded away
  return {logarithm, y - logarithm};
}

/// e^x − 1 and e^x − 1 − x, both with nearly all their digits.
template <class Real>
struct ExponentialAndRest {
  Real less_one;  ///< e^x − 1
  Real rest;      ///< e^x − 1 − x ≥ 0, x²/2 for small x
};

/// e^x − 1 and e^x − 1 − x for the price of one exponential.
template <class Real>
ExponentialAndRest<Real> exponential_and_rest(const Real& x) {
  using std::abs;
  using std::expm1;
  if (abs(x) > Real(0.5)) {
    const Real less_one = expm1(x);
    return {less_one, less_one - x};
  }
  // 1/k! from k = 2 on, until the terms no longer count at x = ½.
  static const std::vector<Real> inverse_factorials = [] {
    std::vector<Real> result;
    Real term(0.5);
    for (int k = 3; term > std::numeric_limits<Real>::epsilon() / Real(8); ++k) {
      result.push_back(result.empty() ? Real(0.5) : Real(result.back() / Real(k - 1)));
      term /= Real(2 * k);
    }
    return result;
  }();
  Real sum(0);
  for (std::size_t k = inverse_factorials.size(); k-- > 0;) sum = sum * x + inverse_factorials[k];
  const Real rest = sum * x * x;
  return {x + rest, rest};
}

}  // namespace vcavity
