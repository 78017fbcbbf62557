// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Gauss–Legendre quadrature in any number type.

#include <cmath>
#include <cstddef>
#include <vector>

#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A node of a quadrature rule on [−1, 1].
template <class Real>
struct QuadratureNode {
  Real x;
  Real weight;
};

/// One node of the Gauss–Legendre rule of `order` nodes on [−1, 1], exact for polynomials of degree
/// 2·order − 1.
///
/// The nodes are the zeros of the Legendre polynomial, found by Newton's method from Tricomi's estimate; the
/// polynomials follow from their three-term recurrence (Abramowitz & Stegun, 22.7.10, 25.4.29). Good for the
/// orders of up to a few hundred that are used here; for thousands of nodes asymptotic formulas are better.
///
/// @param order number of nodes, at least 1
/// @param i which of them, in [0, order), in ascending order
template <class Real>
QuadratureNode<Real> gauss_legendre_node(std::size_t order, std::size_t i) {
  using std::abs;
  using std::cos;
  const bool below = i < (order + 1) / 2;
  const int from_end = static_cast<int>(below ? i : order - 1 - i);
  const Real n = Real(static_cast<int>(order));
  Real x = cos(pi<Real>() * (Real(from_end) + Real(0.75)) / (n + Real(0.5)));
  Real derivative(0);
  Real step(1);
  Real last_step(2);
  while (abs(step) < abs(last_step) &&
         !(step == Real(0))) {  // quadratic convergence, until rounding takes over
    last_step = step;
    Real p0(1);
    Real p1 = x;
    for (std::size_t k = 2; k <= order; ++k) {
      const Real degree = Real(static_cast<int>(k));
      const Real p2 = ((Real(2) * degree - Real(1)) * x * p1 - (degree - Real(1)) * p0) / degree;
      p0 = p1;
      p1 = p2;
    }
    derivative = n * (p0 - x * p1) / ((Real(1) - x) * (Real(1) + x));
    step = p1 / derivative;
    x -= step;
  }
  const Real weight = Real(2) / ((Real(1) - x) * (Real(1) + x) * derivative * derivative);
  return {below && 2 * i + 1 != order ? Real(-x) : x, weight};
}

/// The whole rule, in ascending order.
/// @param order number of nodes, at least 1
template <class Real>
std::vector<QuadratureNode<Real>> gauss_legendre(std::size_t order) {
  std::vector<QuadratureNode<Real>> nodes(order);
  for (std::size_t i = 0; i < (order + 1) / 2; ++i) {
    const QuadratureNode<Real> node = gauss_legendre_node<Real>(order, i);
    nodes[i] = node;
    nodes[order - 1 - i] = {2 * i + 1 == order ? node.x : Real(-node.x), node.weight};
  }
  return nodes;
}

}  // namespace vcavity
