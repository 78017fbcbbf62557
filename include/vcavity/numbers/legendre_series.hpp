// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Gauss–Legendre quadrature that also tells how well it does, from the Legendre series of the integrand.

#include <algorithm>
#include <array>
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

/// The Gauss–Legendre rule of `order` nodes with the terms of the series. For even integrands its nodes are
/// the positive ones of the rule of 2·order nodes: as exact as that one, at half the cost.
///
/// Rules are kept for the next call on the same thread.
///
/// @param order at least 4, at most `most_nodes`
template <class Real, Symmetry symmetry>
const SeriesRule<Real>& series_rule(std::size_t order) {
  constexpr std::size_t most_nodes = 64;
  constexpr bool even = symmetry == Symmetry::even;
  thread_local std::array<SeriesRule<Real>, most_nodes + 1> rules;
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

}  // namespace vcavity
