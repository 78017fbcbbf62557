// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Gauss–Legendre quadrature in any number type, and how well it does.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

#include "conventions.hpp"
#include "value.hpp"

namespace vcavity {

/// An integral, and how it was obtained.
template <class Value>
struct Integral {
  Value value;  ///< the integral
  scalar_t<Value>
      error;  ///< estimate of the absolute error, from the fall of the Legendre series of the integrand
  long long evaluations;  ///< number of evaluations of the facet reflectance
};

/// A node of a quadrature rule on [−1, 1].
template <class Real>
struct QuadratureNode {
  Real x;
  Real weight;
};

/// The Gauss–Legendre rule of `order` nodes on [−1, 1], exact for polynomials of degree 2·order − 1.
///
/// The nodes are the zeros of the Legendre polynomial, found by Newton's method from Tricomi's estimate; the
/// polynomials follow from their three-term recurrence (Abramowitz & Stegun, 22.7.10, 25.4.29). Good for the
/// orders of up to a few hundred that are used here; for thousands of nodes asymptotic formulas are better.
///
/// @param order number of nodes, at least 1
template <class Real>
std::vector<QuadratureNode<Real>> gauss_legendre(std::size_t order) {
  using std::abs;
  using std::cos;
  std::vector<QuadratureNode<Real>> nodes(order);
  const Real n = Real(static_cast<int>(order));
  for (std::size_t i = 0; i < (order + 1) / 2; ++i) {
    Real x = cos(pi<Real>() * (Real(static_cast<int>(i)) + Real(0.75)) / (n + Real(0.5)));
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
    nodes[i] = {-x, weight};
    nodes[order - 1 - i] = {x, weight};
  }
  return nodes;
}

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

/// The rate at which a Legendre series on [−1, 1] falls off at least, from one degree to the next, if the
/// function is singular at z: the sum of the half axes of the ellipse through z with foci ±1 (Trefethen,
/// "Approximation Theory and Approximation Practice", 2013, chapter 8) is the exponential of the rate.
inline double convergence_rate(const std::complex<double>& z) {
  return std::acosh(std::max(0.5 * (std::abs(z - 1.0) + std::abs(z + 1.0)), 1.0));
}

/// A variable of integration u with x = sin(κπu/2)/sin(κπ/2), both from −1 to 1: the larger κ, the more nodes
/// are drawn to the ends. κ = 0 leaves x as it is.
class DrawnVariable {
 public:
  /// @param draw κ in [0, 1]
  explicit DrawnVariable(double draw = 0)
      : draw_(draw), end_(draw > 0 ? std::sin(draw * quarter_turn()) : 1) {}

  /// The value x and its derivative dx/du.
  template <class Real>
  std::array<Real, 2> at(const Real& u) const {
    using std::cos;
    using std::sin;
    if (!(draw_ > 0)) return {u, Real(1)};
    const Real factor = Real(draw_) * (pi<Real>() / Real(2));
    const Real end = sin(factor);
    return {sin(factor * u) / end, factor * cos(factor * u) / end};
  }

  /// The point u of a singularity at x.
  std::complex<double> inverse(const std::complex<double>& x) const {
    return draw_ > 0 ? std::asin(x * end_) / (draw_ * quarter_turn()) : x;
  }

 private:
  static double quarter_turn() { return std::asin(1.0); }

  double draw_;
  double end_;
};

/// A variable of integration and the rate at which the series of the integrand falls off in it, 0 if unknown.
struct Convergence {
  DrawnVariable variable;
  double rate = 0;
};

/// The variable in which the series falls off fastest.
/// @param singularities in the plane of x; not empty
inline Convergence best_variable(const std::vector<std::complex<double>>& singularities) {
  Convergence best;
  for (const double draw : {0.0, 0.5, 0.75, 0.9, 1.0}) {
    const DrawnVariable variable(draw);
    double rate = std::numeric_limits<double>::infinity();
    for (const std::complex<double>& x : singularities)
      rate = std::min(rate, convergence_rate(variable.inverse(x)));
    if (rate > best.rate) best = {variable, rate};
    constexpr double fast = 0.9;
    if (rate > fast) break;
  }
  return best;
}

}  // namespace vcavity
