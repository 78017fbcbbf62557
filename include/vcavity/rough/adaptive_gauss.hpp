// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Adaptive quadrature for integrands that are integrals themselves: without memory, so that one may stand inside
/// the other.
///
/// Method. A Gauss–Legendre rule of 12 nodes; the fall of the Legendre series of the integrand, from degrees 5 and 6
/// to 10 and 11, tells how much is beyond degree 23, what the rule does not integrate exactly. Pieces where that is
/// too much are halved, each half with half of the tolerance. Where a range has been cut at all kinks, its pieces are
/// short and most of them smooth: for these there is a rule of 6 nodes, with degrees 2 and 3 to 4 and 5.

#include <array>
#include <cstddef>
#include <limits>

#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity::detail {

/// An integral, the estimate of its error and the number of values of the integrand.
template <class Value>
struct Quadrature {
  Value value;
  scalar_t<Value> error;
  long long evaluations;

  friend Quadrature operator+(const Quadrature& a, const Quadrature& b) {
    return {a.value + b.value, a.error + b.error, a.evaluations + b.evaluations};
  }
};

/// A rule of 6 or 12 nodes with what a value at a node adds to the terms of the Legendre series.
template <class Real, std::size_t size = 12>
class GaussWithSeries {
 public:
  static_assert(size == 6 || size == 12);
  static constexpr std::size_t order = size;
  static constexpr std::size_t terms = 4;
  static constexpr std::array<std::size_t, terms> degrees{order / 2 - 1, order / 2, order - 2, order - 1};

  struct Node {
    Real x, weight;
    std::array<Real, terms> projection;
  };

  /// The one rule of the type and order.
  static const GaussWithSeries& get() {
    static const GaussWithSeries rule;
    return rule;
  }

  const std::array<Node, order>& nodes() const { return nodes_; }

 private:
  GaussWithSeries() {
    const auto nodes = gauss_legendre<Real>(order);
    for (std::size_t i = 0; i < order; ++i) {
      nodes_[i] = {nodes[i].x, nodes[i].weight, {}};
      Real before(1), polynomial = nodes[i].x;
      for (std::size_t degree = 1, term = 0; term < terms; ++degree) {
        const Real twice_and_one = static_cast<Real>(2 * degree + 1);
        if (degree == degrees[term])
          nodes_[i].projection[term++] = nodes[i].weight * polynomial * twice_and_one / Real(2);
        const Real next =
            (twice_and_one * nodes[i].x * polynomial - Real(static_cast<int>(degree)) * before) /
            Real(static_cast<int>(degree + 1));
        before = polynomial;
        polynomial = next;
      }
    }
  }

  std::array<Node, order> nodes_;
};

/// The integral of a function from `low` to `high`.
/// @param tolerance absolute error to aim at
/// @param function returns a `Quadrature` for a number: its value, with an error of its own
/// @param halvings how often a piece may be halved
/// @tparam order of the rule
template <class Value, std::size_t order = 12, class Real, class Function>
Quadrature<Value> integrate(const Function& function, const Real& low, const Real& high,
                            const scalar_t<Value>& tolerance, int halvings) {
  using Scalar = scalar_t<Value>;
  using Rule = GaussWithSeries<Real, order>;
  const Real half = (high - low) / Real(2);
  const Real middle = (high + low) / Real(2);
  Quadrature<Value> result{Value(0), Scalar(0), 0};
  std::array<Value, Rule::terms> series{Value(0), Value(0), Value(0), Value(0)};
  for (const auto& node : Rule::get().nodes()) {
    const Quadrature<Value> at = function(middle + half * node.x);
    result.value = result.value + scaled(half * node.weight, at.value);
    result.error += static_cast<Scalar>(half * node.weight) * at.error;
    result.evaluations += at.evaluations;
    for (std::size_t i = 0; i < series.size(); ++i)
      series[i] = series[i] + scaled(half * node.projection[i], at.value);
  }
  const Scalar middle_terms = largest(series[0]) + largest(series[1]);
  const Scalar last_terms = largest(series[2]) + largest(series[3]);
  const Scalar rounding = Scalar(4) * std::numeric_limits<Scalar>::epsilon() * largest(result.value);
  const Scalar fall = middle_terms > last_terms ? Scalar(last_terms / middle_terms) : Scalar(1);
  const Scalar error = Scalar(2) * last_terms * fall;
  if (halvings == 0 || error <= tolerance + rounding) {
    result.error += error + rounding;
    return result;
  }
  const Quadrature<Value> halves =
      integrate<Value, order>(function, low, middle, tolerance / Scalar(2), halvings - 1) +
      integrate<Value, order>(function, middle, high, tolerance / Scalar(2), halvings - 1);
  return {halves.value, halves.error, halves.evaluations + result.evaluations};
}

}  // namespace vcavity::detail
