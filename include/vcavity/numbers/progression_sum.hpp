// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sums over an arithmetic progression: Σ f(j) for j = 1, …, m, of a smooth f, with far fewer than m
/// evaluations.
///
/// Method. Gaussian quadrature for the sum: the nodes are the zeros of the polynomial of degree n that is
/// orthogonal to all lower ones under summation over 1, …, m (Gram 1883; recurrence in Abramowitz &
/// Stegun, 22.17, and Gautschi, "Orthogonal Polynomials", 2004, table 1.1), so the sum is exact for
/// polynomials up to degree 2n − 1. For m ≫ n² the nodes are those of Gauss and Legendre, from which Newton's
/// method starts. With every order the error shrinks by a constant factor, so the difference of two orders
/// bounds it from above once they agree.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "vcavity/numbers/gauss_legendre.hpp"

namespace vcavity {

namespace detail {

/// A node of a rule for sums.
template <class Real>
struct ProgressionNode {
  Real index;  ///< in [1, m], rarely an integer
  Real weight;
};

/// The rule of `order` nodes for j = 1, …, m.
/// @param count m, larger than the order
template <class Real>
std::vector<ProgressionNode<Real>> progression_rule(int count, std::size_t order) {
  const Real m = Real(count);
  const auto beta = [m](std::size_t k) {
    const Real k2 = Real(static_cast<int>(k * k));
    return k2 * (Real(1) - k2 / (m * m)) / (Real(4) * k2 - Real(1));
  };
  Real norm = m;
  for (std::size_t k = 1; k < order; ++k) norm *= beta(k);
  std::vector<ProgressionNode<Real>> rule;
  for (const auto& node : gauss_legendre<Real>(order)) {
    Real x = node.x;
    Real lower(0);  // the polynomial of one degree less
    Real derivative(0);
    Real step(1);
    for (int newton_step = 0; newton_step < 12 && magnitude(step) > std::numeric_limits<Real>::epsilon();
         ++newton_step) {
      Real p0(0), p1(1), d0(0), d1(0);
      for (std::size_t k = 0; k < order; ++k) {
        const Real b = k == 0 ? Real(0) : beta(k);
        const Real p2 = x * p1 - b * p0;
        const Real d2 = p1 + x * d1 - b * d0;
        p0 = p1;
        p1 = p2;
        d0 = d1;
        d1 = d2;
      }
      lower = p0;
      derivative = d1;
      step = p1 / d1;
      x -= step;
    }
    rule.push_back({(m + Real(1) + x * m) / Real(2), norm / (derivative * lower)});
  }
  return rule;
}

/// Orders that are tried one after the other.
inline constexpr std::array<std::size_t, 6> progression_orders{8, 12, 18, 26, 38, 56};

/// The same for a power of two of terms; kept for the next call on the same thread.
template <class Real>
const std::vector<ProgressionNode<Real>>& kept_progression_rule(int log2_count, std::size_t which_order) {
  thread_local std::array<std::array<std::vector<ProgressionNode<Real>>, progression_orders.size()>, 31>
      rules;
  auto& rule = rules[static_cast<std::size_t>(log2_count)][which_order];
  if (rule.empty()) rule = progression_rule<Real>(1 << log2_count, progression_orders[which_order]);
  return rule;
}

}  // namespace detail

/// Σ f(j) over j = first, …, first + 2^k − 1 to an absolute tolerance, or nothing if that takes half as many
/// evaluations as there are terms, or more.
/// @param f a smooth function of the index, which need not be an integer
/// @param log2_count k, at most 30
template <class Real, class Function>
std::optional<Real> progression_sum(Function&& f, int first, int log2_count, const Real& tolerance) {
  Real previous(0);
  std::size_t evaluations = 0;
  for (std::size_t which = 0; which < detail::progression_orders.size(); ++which) {
    evaluations += detail::progression_orders[which];
    if (2 * evaluations > (std::size_t{1} << log2_count)) return {};
    Real sum(0);
    for (const auto& [index, weight] : detail::kept_progression_rule<Real>(log2_count, which))
      sum += weight * f(Real(first - 1) + index);
    if (which > 0 && magnitude(Real(sum - previous)) <= tolerance) return sum;
    previous = sum;
  }
  return {};
}

}  // namespace vcavity
