// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Many terms of a bounce series at once, for reflectances that are numbers: what makes narrow grooves fast.
///
/// Method. From m to m + 2 bounces the logarithm of the product grows by g(m + 1), with
/// g(k) = ln ρ(cos ψ cos(u − kα/2)) + ln ρ(cos ψ cos(u + kα/2)), which is smooth on the scale of many bounces. On a
/// block of m it is replaced by the polynomial through a dozen Gauss–Legendre nodes; sums of that over every other k
/// follow from its integral and derivatives (Euler and Maclaurin's formula for midpoints, Abramowitz & Stegun, 25.4.2),
/// and the sum of T_m times the product over m from a rule for arithmetic progressions (progression_sum.hpp). The last
/// coefficients of the polynomial tell its error.
///
/// When not to use it: for values whose product does not commute, such as Jones matrices.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcavity/hemisphere/plain_numbers.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/legendre_series.hpp"
#include "vcavity/numbers/progression_sum.hpp"

namespace vcavity::detail {

/// Nodes of the polynomial; of the rules for sums.
inline constexpr std::size_t block_nodes = 12;
inline constexpr std::size_t block_sum_order = 1;  // index of 12 in progression_orders
inline constexpr int min_block_log2 = 5, max_block_log2 = 28;

/// A block of 2n terms after m bounces, n a power of two, whatever m.
template <class Real>
struct SeriesBlock {
  std::array<Real, block_nodes> nodes;  ///< where g is wanted: k − m
  std::array<std::array<Real, block_nodes>, 2>
      last_coefficients;  ///< the last two of the series of g, from its nodes
  struct Sum {
    Real bounces;  ///< a number of bounces beyond m, rarely an integer
    Real weight;   ///< in the sum over all of that parity
    std::array<Real, block_nodes>
        logarithm;                       ///< of the product, less that before the block, from g at the nodes
    std::array<Real, block_nodes> here;  ///< a function of k there, from its values at the nodes
  };
  std::vector<Sum> even, odd;                         ///< beyond m
  std::array<Real, block_nodes> last_even, last_odd;  ///< logarithms at the end of the block
};

/// The Legendre polynomials below `block_nodes` with their first five derivatives and their integral from −1, at s.
template <class Real>
struct LegendreJet {
  std::array<std::array<Real, block_nodes + 1>, 6> derivative{};  ///< [d][degree]
  explicit LegendreJet(const Real& s) {
    auto& p = derivative;
    p[0][0] = Real(1);
    p[0][1] = s;
    p[1][1] = Real(1);
    for (std::size_t n = 2; n <= block_nodes; ++n) {
      const Real degree = Real(static_cast<int>(n));
      for (std::size_t d = 0; d < p.size(); ++d) {
        // n P_n = (2n − 1) s P_(n−1) − (n − 1) P_(n−2), derived d times
        Real rise = s * p[d][n - 1];
        if (d > 0) rise += Real(static_cast<int>(d)) * p[d - 1][n - 1];
        p[d][n] = ((Real(2) * degree - Real(1)) * rise - (degree - Real(1)) * p[d][n - 2]) / degree;
      }
    }
  }
  /// ∫ P_n from −1
  Real integral(std::size_t n) const {
    if (n == 0) return derivative[0][1] + Real(1);
    return (derivative[0][n + 1] - derivative[0][n - 1]) / Real(static_cast<int>(2 * n + 1));
  }
};

/// @param log2 of n
template <class Real>
const SeriesBlock<Real>& series_block(int log2) {
  thread_local std::array<SeriesBlock<Real>, max_block_log2 + 1> blocks;
  SeriesBlock<Real>& block = blocks[static_cast<std::size_t>(log2)];
  if (!block.even.empty()) return block;
  const Real length = Real(2) * Real(1 << log2);
  // g is wanted from k = m − 1 to m + length.
  const Real half = (length + Real(1)) / Real(2);
  const Real middle = half - Real(1);
  const auto rule = gauss_legendre<Real>(block_nodes);
  std::array<std::array<Real, block_nodes>, block_nodes> coefficient;  // [degree][node]
  for (std::size_t i = 0; i < block_nodes; ++i) {
    block.nodes[i] = middle + half * rule[i].x;
    for (std::size_t n = 0; n < block_nodes; ++n)
      coefficient[n][i] =
          (Real(static_cast<int>(n)) + Real(0.5)) * rule[i].weight * legendre_polynomial(n, rule[i].x);
  }
  block.last_coefficients = {coefficient[block_nodes - 2], coefficient[block_nodes - 1]};
  // Σ g over every other k up to k0 + 2J − 1 is Q(k0 + 2J) − Q(k0), for steps of 2
  // Q = ½ ∫ g − g'/12 + 7 g'''/720 − 31 g⁽⁵⁾/30240.
  const auto q = [&](const Real& k) {
    const LegendreJet<Real> jet((k - middle) / half);
    std::array<Real, block_nodes> result{};
    for (std::size_t n = 0; n < block_nodes; ++n) {
      const Real h2 = half * half;
      const Real value = half * jet.integral(n) / Real(2) - jet.derivative[1][n] / (Real(12) * half) +
                         Real(7) * jet.derivative[3][n] / (Real(720) * half * h2) -
                         Real(31) * jet.derivative[5][n] / (Real(30240) * half * h2 * h2);
      for (std::size_t i = 0; i < block_nodes; ++i) result[i] += value * coefficient[n][i];
    }
    return result;
  };
  const auto between = [&](const Real& from, const Real& to) {
    std::array<Real, block_nodes> result = q(to);
    const std::array<Real, block_nodes> start = q(from);
    for (std::size_t i = 0; i < block_nodes; ++i) result[i] -= start[i];
    return result;
  };
  const auto here = [&](const Real& k) {
    const LegendreJet<Real> jet((k - middle) / half);
    std::array<Real, block_nodes> result{};
    for (std::size_t n = 0; n < block_nodes; ++n)
      for (std::size_t i = 0; i < block_nodes; ++i) result[i] += jet.derivative[0][n] * coefficient[n][i];
    return result;
  };
  for (const auto& node : kept_progression_rule<Real, block_sum_order>(log2)) {
    const Real even = Real(2) * node.index, odd = even - Real(1);
    block.even.push_back({even, node.weight, between(Real(0), even), here(even)});
    block.odd.push_back({odd, node.weight, between(Real(-1), odd), here(odd)});
  }
  block.last_even = between(Real(0), length);
  block.last_odd = between(Real(-1), length - Real(1));
  return block;
}

/// The products of the last odd and the last even number of bounces.
template <class Value>
struct SeriesProducts {
  Value of_odd, of_even;
};

/// A block of terms, added up.
template <class Value, class Real>
struct BlockSum {
  Value value;
  SeriesProducts<Value> products;  ///< at the end of the block
  Real uncertain;                  ///< absolute error of the products
};

/// The sum of the 2n terms after m bounces.
/// @param log2 of n
/// @param step called with k, a real number: the bounces at u ∓ kα/2. `growth(step)` is the product of their
/// reflectances, and `observed(product, step)` what is seen of a product that ends there.
/// @param weight called with a number of bounces, not an integer: T
/// @param before the products at m − 1 and at m
template <class Bounces, class Real, class Value, class Step, class Weight>
BlockSum<Value, Real> sum_of_block(int m, int log2, Step&& step, Weight&& weight,
                                   const SeriesProducts<Value>& before) {
  using std::exp;
  using std::log;
  using Numbers = PlainNumbers<Value>;
  const SeriesBlock<Real>& block = series_block<Real>(log2);
  std::array<Value, block_nodes> logarithms, observed;
  for (std::size_t i = 0; i < block_nodes; ++i) {
    const auto bounces = step(Real(m) + block.nodes[i]);
    logarithms[i] = Bounces::growth(bounces);
    for (std::size_t lane = 0; lane < Numbers::count; ++lane)
      Numbers::at(logarithms[i], lane) =
          log(at_least(Numbers::at(logarithms[i], lane), std::numeric_limits<Real>::min()));
    if constexpr (Bounces::is_observed_in_part) observed[i] = Bounces::observed(Value(1), bounces);
  }
  const auto combined = [](const std::array<Real, block_nodes>& factors,
                           const std::array<Value, block_nodes>& values) {
    Value sum(0);
    for (std::size_t i = 0; i < block_nodes; ++i) sum = sum + factors[i] * values[i];
    return sum;
  };
  const auto grown = [&](const Value& product, const std::array<Real, block_nodes>& factors) {
    Value growth = combined(factors, logarithms);
    for (std::size_t lane = 0; lane < Numbers::count; ++lane)
      Numbers::at(growth, lane) = exp(Numbers::at(growth, lane));
    return Value(product * growth);
  };
  BlockSum<Value, Real> result{Value(0), before, Real(0)};
  for (const auto& [parts, product] :
       {std::pair(&block.even, &before.of_even), std::pair(&block.odd, &before.of_odd)})
    for (const auto& part : *parts) {
      Value term = grown(*product, part.logarithm);
      if constexpr (Bounces::is_observed_in_part) term = term * combined(part.here, observed);
      result.value = result.value + (part.weight * weight(Real(m) + part.bounces)) * term;
    }
  result.products = {grown(before.of_odd, block.last_odd), grown(before.of_even, block.last_even)};
  // What has little light may be known little of.
  for (const auto& coefficient : block.last_coefficients) {
    const Value last = combined(coefficient, logarithms);
    result.uncertain +=
        Real(1 << log2) * (largest(Value(last * before.of_odd)) + largest(Value(last * before.of_even)));
  }
  return result;
}

}  // namespace vcavity::detail
