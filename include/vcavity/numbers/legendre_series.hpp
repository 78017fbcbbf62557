// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Gauss–Legendre quadrature that also tells how well it does, from the Legendre series of the integrand.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcavity/numbers/gauss_legendre.hpp"

namespace vcavity {

/// A quadrature rule that also yields terms of the Legendre series of the integrand. The quadrature error is
/// made of the terms beyond `exact_degree`; how fast the known ones fall off tells how large those are.
template <class Real>
struct SeriesRule {
  static constexpr std::size_t terms = 4;

  struct Node {
    Real x;
    Real weight;
    std::array<Real, terms> projection;  ///< what the integrand here adds to the coefficients of the terms
  };

  std::vector<Node> nodes;
  std::array<double, terms> degrees;  ///< of the terms: two halfway through the series, and the last two that
                                      ///< the nodes resolve
  double exact_degree;                ///< degree up to which polynomials are integrated exactly
};

/// The Legendre polynomial of a degree.
/// @param degree at least 0
/// @param x in [−1, 1]
template <class Real>
Real legendre_polynomial(std::size_t degree, const Real& x) {
  Real p0(1);
  Real p1 = x;
  if (degree == 0) return p0;
  for (std::size_t k = 2; k <= degree; ++k) {
    const Real p2 = (Real(static_cast<int>(2 * k - 1)) * x * p1 - Real(static_cast<int>(k - 1)) * p0) /
                    Real(static_cast<int>(k));
    p0 = p1;
    p1 = p2;
  }
  return p1;
}

/// Whether a rule integrates from −1 to 1, or from 0 to 1 an integrand that is even.
enum class Symmetry { none, even };

/// The orders of the rules that `series_rule` makes.
inline constexpr std::size_t min_series_order = 4, max_series_order = 64;

/// The Gauss–Legendre rule of `order` nodes with the terms of the series. For even integrands its nodes are
/// the positive ones of the rule of 2·order nodes: as exact as that one, at half the cost.
///
/// Rules are kept for the next call on the same thread.
///
/// @param order from `min_series_order` to `max_series_order`
template <class Real, Symmetry symmetry>
const SeriesRule<Real>& series_rule(std::size_t order) {
  assert(order >= min_series_order && order <= max_series_order);
  constexpr bool even = symmetry == Symmetry::even;
  thread_local std::array<SeriesRule<Real>, max_series_order + 1> rules;
  SeriesRule<Real>& rule = rules[order];
  if (!rule.nodes.empty()) return rule;

  const std::size_t half = (order - 1) / 2;
  const std::array<std::size_t, SeriesRule<Real>::terms> degrees =
      even ? std::array{2 * half - 2, 2 * half, 2 * order - 4, 2 * order - 2}
           : std::array{half - 1, half, order - 2, order - 1};
  std::copy(degrees.begin(), degrees.end(), rule.degrees.begin());
  rule.exact_degree = static_cast<double>(even ? 4 * order - 1 : 2 * order - 1);
  for (const QuadratureNode<Real>& node : gauss_legendre<Real>(even ? 2 * order : order)) {
    if (even && node.x < Real(0)) continue;
    typename SeriesRule<Real>::Node with_terms{node.x, node.weight, {}};
    for (std::size_t term = 0; term < degrees.size(); ++term) {
      const Real norm = Real(static_cast<int>(2 * degrees[term] + 1)) / Real(even ? 1 : 2);
      with_terms.projection[term] = norm * node.weight * legendre_polynomial(degrees[term], node.x);
    }
    rule.nodes.push_back(with_terms);
  }
  return rule;
}

/// How the Legendre series of an integrand falls off in the end, as far as its singularities are known.
struct SeriesDecay {
  double rate = 0;       ///< from one degree to the next the terms shrink by exp(−rate) or less; 0 if unknown
  int multiplicity = 2;  ///< with a pole of order p they fall off like k^(p − 1) exp(−rate k)
  double trust =
      0.4;  ///< part of the observed rate that is believed to last; 1 if all singularities are known
};

/// What the Legendre series says about a rule.
struct SeriesEstimate {
  double error;     ///< absolute; 0 where the series has come down to the noise
  double fall = 0;  ///< from one more degree resolved to the next the error shrinks by exp(−fall)
};

/// Estimate of the error of a rule.
///
/// The terms beyond those that the rule resolves continue the fall of the last known ones. Its rate is the
/// smaller of that of the singularities and of the trusted part of that observed.
///
/// @param rule the rule
/// @param sizes of the terms of the rule, as `SeriesRule::projection` adds them up
/// @param decay what is known of the series
/// @param noise error of the coefficients, below which they say nothing
template <class Real>
SeriesEstimate series_estimate(const SeriesRule<Real>& rule,
                               const std::array<double, SeriesRule<Real>::terms>& sizes,
                               const SeriesDecay& decay, double noise) {
  constexpr double safety = 25;  // by trial, over random grooves and facets
  // Either of two neighbours may be small by chance, but hardly both.
  const std::size_t middle = sizes[0] > sizes[1] ? 0 : 1;
  const std::size_t last = sizes[2] > sizes[3] ? 2 : 3;
  if (sizes[last] <= noise * rule.degrees[last]) return {0};
  const double observed =
      std::max(std::log(sizes[middle] / sizes[last]) / (rule.degrees[last] - rule.degrees[middle]), 0.0);
  const double lasting = decay.trust * observed;
  const double rate = decay.rate > 0 ? std::min(decay.rate, lasting) : lasting;
  const double missed_degree = rule.exact_degree + 1;
  const auto missed = [&](std::size_t known) {
    const double further = missed_degree - rule.degrees[known];
    double size = sizes[known] * std::exp(-rate * further);
    for (int i = 1; i < decay.multiplicity; ++i) size *= missed_degree / rule.degrees[known];
    return size;
  };
  // Of what is no number the first stays. With a degree the last term falls, and another degree is exact.
  return {safety * std::max(missed(3), missed(2)), observed + rate};
}

}  // namespace vcavity
