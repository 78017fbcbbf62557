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
#include <mutex>
#include <optional>

#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"

namespace vcavity {

namespace detail {

/// A node of a rule for sums.
template <class Real>
struct ProgressionNode {
  Real index;  ///< in [1, m], rarely an integer
  Real weight;
};

/// A node of the rule of `order` nodes for j = 1, …, m.
/// @param count m, larger than the order
/// @param order number of nodes
/// @param i which of them, below `order`
template <class Real>
ProgressionNode<Real> progression_node(int count, std::size_t order, std::size_t i) {
  const Real m = Real(count);
  const auto beta = [m](std::size_t k) {
    const Real k2 = Real(static_cast<int>(k * k));
    return k2 * (Real(1) - k2 / (m * m)) / (Real(4) * k2 - Real(1));
  };
  Real norm = m;
  for (std::size_t k = 1; k < order; ++k) norm *= beta(k);
  Real x = gauss_legendre_node<Real>(order, i).x;
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
  return {(m + Real(1) + x * m) / Real(2), norm / (derivative * lower)};
}

/// Orders that are tried one after the other.
inline constexpr std::array<std::size_t, 6> progression_orders{8, 12, 18, 26, 38, 56};

/// Sums of so many terms or fewer, as a power of two, have rules that are kept.
inline constexpr int largest_log2_count = 30;

/// A rule for a power of two of terms, made at its first use and kept for the whole program: in static memory,
/// about 80 kB for double, so that nothing is allocated.
template <class Real, std::size_t which_order>
const auto& kept_progression_rule(int log2_count) {
  constexpr std::size_t order = progression_orders[which_order];
  struct Kept {
    std::once_flag made;
    std::array<ProgressionNode<Real>, order> nodes;
  };
  static std::array<Kept, largest_log2_count + 1> rules;
  Kept& rule = rules[static_cast<std::size_t>(log2_count)];
  std::call_once(rule.made, [&rule, log2_count] {
    for (std::size_t i = 0; i < order; ++i) rule.nodes[i] = progression_node<Real>(1 << log2_count, order, i);
  });
  return rule.nodes;
}

/// The sum by the rule of one order, or by the next ones until they agree; see `progression_sum`.
/// @param previous the sum of the order before
/// @param evaluations of the orders before
template <class Real, std::size_t which_order, class Function>
std::optional<Real> progression_sum_from(const Function& f, int first, int log2_count, const Real& tolerance,
                                         const Real& previous, std::size_t evaluations) {
  if constexpr (which_order == progression_orders.size()) {
    return {};
  } else {
    evaluations += progression_orders[which_order];
    if (2 * evaluations > (std::size_t{1} << log2_count)) return {};
    Real sum(0);
    for (const auto& [index, weight] : kept_progression_rule<Real, which_order>(log2_count))
      sum += weight * f(Real(first - 1) + index);
    if (which_order > 0 && magnitude(Real(sum - previous)) <= tolerance) return sum;
    return progression_sum_from<Real, which_order + 1>(f, first, log2_count, tolerance, sum, evaluations);
  }
}

}  // namespace detail

/// Σ f(j) over j = first, …, first + 2^k − 1 to an absolute tolerance, or nothing if that takes half as many
/// evaluations as there are terms, or more.
/// @param f a smooth function of the index, which need not be an integer
/// @param first the first index
/// @param log2_count k, at most 30
/// @param tolerance of the sum, > 0
template <class Real, class Function>
std::optional<Real> progression_sum(const Function& f, int first, int log2_count, const Real& tolerance) {
  return detail::progression_sum_from<Real, 0>(f, first, log2_count, tolerance, Real(0), 0);
}

}  // namespace vcavity
