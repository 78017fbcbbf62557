// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What is left of a logarithm and an exponential after their first terms, without the loss of digits of the plain
/// difference; in any number type.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

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
  if (abs(y) < Real(0.25)) {
    // s² < 1/49 gives 5.6 bits for each term.
    constexpr int terms = std::numeric_limits<Real>::digits * 10 / 56 + 1;
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

/// e^x − 1 − x with all its digits, x²/2 for small x.
template <class Real>
Real exponential_rest(const Real& x) {
  using std::abs;
  using std::exp;
  if (abs(x) > Real(1)) return exp(x) - Real(1) - x;
  Real term = x * x / Real(2);
  Real sum(0);
  for (int k = 3; abs(term) > std::numeric_limits<Real>::epsilon() * abs(sum) / Real(8); ++k) {
    sum += term;
    term *= x / Real(k);
  }
  return sum;
}

}  // namespace vcavity
