// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Adaptive quadrature in one variable that is told what is known of the integrand.
///
/// Method. The range comes in pieces on which the integrand is smooth. Each is integrated by the Gauss–Legendre
/// rule whose order its singularities ask for; the fall of the Legendre series tells the error
/// (legendre_series.hpp). As long as the errors add up to more than the tolerance, the piece with the largest
/// one gets a rule of higher order, or is halved where the highest does not do. For the next, similar integral pieces
/// keep the orders they ended with, or lower ones where those did far better than they had to.
///
/// When not to use it: for an integrand whose singularities lie inside the pieces, unknown, it converges slowly.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcavity/numbers/legendre_series.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/substitution.hpp"

namespace vcavity {

/// A part of the range of an integral, and what is known of the integrand there.
template <class Real>
struct QuadraturePiece {
  Real low, high;                      ///< its ends
  Symmetry symmetry = Symmetry::none;  ///< even: the integrand is even about `low`
  Substitution variable{};             ///< the variable of integration
  SeriesDecay decay{};                 ///< of the Legendre series in that variable
  std::size_t order = 0;               ///< the first order to try; 0 for the one that the decay asks for
};

/// What a rule makes of a piece.
template <class Value>
struct PieceEstimate {
  Value value;
  std::array<double, 4> sizes;  ///< of the terms of the Legendre series
  double noise;                 ///< error of the values of the integrand, integrated over the piece
  double series_noise;          ///< what of that, and of rounding, is seen in a term of the series
};

/// An integral by adaptive quadrature.
template <class Value>
struct AdaptiveIntegral {
  Value value;
  double error;  ///< estimate, without the noise
  double noise;  ///< error of the values of the integrand, integrated
};

/// The orders of the rules for a variable.
struct QuadratureOrders {
  std::size_t step;      ///< orders are multiples of it, as where nodes come in packs
  std::size_t min, max;  ///< of the first to the last order tried
  double believed = 1;   ///< part of the rate of a piece from which the first order follows
  std::size_t start =
      max_series_order;  ///< highest first order: for where most pieces need less than they might
  double margin =
      1;  ///< part of the tolerance aimed at: an order that does not quite do costs more than a higher one

  /// The first order tried for an even integrand: fewer terms do not show how its series falls.
  std::size_t min_even() const {
    constexpr std::size_t enough = 6;
    return std::max((enough + step - 1) / step * step, min);
  }
  /// The number of nodes that bring an error down by a factor.
  /// @param rate per node; a guess stands in for 0
  std::size_t nodes(double factor, double rate) const {
    constexpr double guess = 1.5;
    const double order = std::log(1 / std::min(margin * factor, 0.5)) / (rate > 0 ? rate : guess);
    return step * static_cast<std::size_t>(std::ceil(std::min(order, 1e3) / static_cast<double>(step)));
  }
  /// The next order to try; a little higher where the rate is not known.
  std::size_t next(std::size_t order, double factor, double rate) const {
    const std::size_t unknown = (order / 2 + step) / step * step;
    return std::min(order + (rate > 0 ? std::max(nodes(factor, rate), step) : unknown), max);
  }
};

/// The sum of an integrand over the nodes of a rule, and of the terms of its Legendre series.
template <class Addend, class Weight>
struct SeriesSum {
  Addend integral = Addend(0);
  std::array<Addend, 4> terms{Addend(0), Addend(0), Addend(0), Addend(0)};

  /// @param value of the integrand at a node
  /// @param weight of the node
  /// @param projection of the node on the terms
  void add(const Addend& value, const Weight& weight, const std::array<Weight, 4>& projection) {
    integral = integral + scaled(weight, value);
    for (std::size_t i = 0; i < terms.size(); ++i) terms[i] = terms[i] + scaled(projection[i], value);
  }
};

/// The integral over all pieces.
/// @param pieces of the range; in the end as they were then but for ample orders, a good start for a similar integrand
/// @param tolerance absolute error to aim at; what cannot be reached is told in the result
/// @param orders to try
/// @param estimate called with a piece and a rule, returns a `PieceEstimate`
/// @param halves called with a piece that the highest order does not do for, returns two or more in its place,
/// or none if it cannot be halved
/// @param exhausted called between rules; true ends the quadrature with what it has
template <class Real, class Value, class Estimate, class Halves, class Exhausted>
AdaptiveIntegral<Value> integrate_adaptively(std::vector<QuadraturePiece<Real>>& pieces, double tolerance,
                                             const QuadratureOrders& orders, Estimate&& estimate,
                                             Halves&& halves, Exhausted&& exhausted) {
  struct Work {
    QuadraturePiece<Real> piece;
    PieceEstimate<Value> estimate;
    double error;
    double fall;  // of the error with a node, at least as far as is seen
  };
  const auto is_better = [](const Work& a, const Work& b) { return a.error < b.error; };
  // Degrees that one more node resolves; it makes twice as many exact.
  const auto degrees_per_node = [](const QuadraturePiece<Real>& piece) {
    return piece.symmetry == Symmetry::even ? 2 : 1;
  };
  const auto rate_per_node = [&](const QuadraturePiece<Real>& piece) {
    return 2 * degrees_per_node(piece) * piece.decay.rate;
  };
  // The nodes that a piece needs by what is known of it.
  const auto nodes_for = [&](const QuadraturePiece<Real>& piece, double share) {
    return std::max(orders.nodes(share * std::exp2(4 - std::min(piece.decay.multiplicity, 6)),
                                 orders.believed * rate_per_node(piece)),
                    piece.symmetry == Symmetry::even ? orders.min_even() : orders.min);
  };
  const auto done = [&](QuadraturePiece<Real> piece, double share) {
    if (piece.order == 0) piece.order = std::min(nodes_for(piece, share), orders.start);
    piece.order = std::clamp(piece.order, orders.min, orders.max);
    const SeriesRule<Real>& rule = piece.symmetry == Symmetry::even
                                       ? series_rule<Real, Symmetry::even>(piece.order)
                                       : series_rule<Real, Symmetry::none>(piece.order);
    const PieceEstimate<Value> result = estimate(piece, rule);
    const SeriesEstimate series = series_estimate(rule, result.sizes, piece.decay, result.series_noise);
    constexpr double lasting = 0.8;  // of the fall that is seen
    const double seen = lasting * degrees_per_node(piece) * series.fall;
    return Work{piece, result, series.error,
                piece.decay.trust < 1 ? seen : std::max(rate_per_node(piece), seen)};
  };

  std::vector<Work> heap;  // the largest error first
  heap.reserve(pieces.size());
  const double share = tolerance / static_cast<double>(std::max<std::size_t>(pieces.size(), 1));
  double error = 0;
  while (!pieces.empty()) {
    const QuadraturePiece<Real> piece = pieces.back();
    pieces.pop_back();
    // So near to a singularity that no rule will do: halves may need fewer nodes than the whole.
    if (piece.order == 0 && piece.decay.rate > 0 && nodes_for(piece, share) > 2 * orders.max) {
      const std::vector<QuadraturePiece<Real>> parts = halves(piece);
      std::size_t nodes = 0;
      for (const QuadraturePiece<Real>& part : parts) nodes += nodes_for(part, share);
      if (!parts.empty() && nodes < nodes_for(piece, share)) {
        pieces.insert(pieces.end(), parts.begin(), parts.end());
        continue;
      }
    }
    heap.push_back(done(piece, share));
    error += heap.back().error;
  }
  std::make_heap(heap.begin(), heap.end(), is_better);
  while (error > tolerance && !heap.empty() && !exhausted()) {
    std::pop_heap(heap.begin(), heap.end(), is_better);
    const Work worst = heap.back();
    heap.pop_back();
    const double aim =
        std::max(tolerance - (error - worst.error), 0.5 * tolerance / static_cast<double>(heap.size() + 1));
    std::vector<QuadraturePiece<Real>> next;
    if (worst.piece.order < orders.max) {
      next.push_back(worst.piece);
      next.back().order = orders.next(worst.piece.order, aim / worst.error, worst.fall);
    } else {
      next = halves(worst.piece);
      if (next.empty()) {
        heap.push_back(worst);
        break;
      }
    }
    error -= worst.error;
    for (const QuadraturePiece<Real>& piece : next) {
      heap.push_back(done(piece, aim / static_cast<double>(next.size())));
      std::push_heap(heap.begin(), heap.end(), is_better);
    }
    error = 0;
    for (const Work& work : heap) error += work.error;
  }

  std::sort(heap.begin(), heap.end(), [](const Work& a, const Work& b) { return a.piece.low < b.piece.low; });
  AdaptiveIntegral<Value> result{Value(0), 0, 0};
  for (const Work& work : heap) {
    result.value = result.value + work.estimate.value;
    result.error += work.error;
    result.noise += work.estimate.noise;
    pieces.push_back(work.piece);
    // A piece that came out far better than it has to begins with fewer nodes next time.
    const double ample = 0.1 * tolerance / static_cast<double>(heap.size());
    if (work.error < ample && work.fall > 0) {
      constexpr double least_error = 1e-8;
      const double spare = std::log(ample / std::max(work.error, least_error * ample)) / work.fall;
      const auto fewer = orders.step * static_cast<std::size_t>(spare / static_cast<double>(orders.step));
      const std::size_t least = work.piece.symmetry == Symmetry::even ? orders.min_even() : orders.min;
      pieces.back().order = std::max(work.piece.order - std::min(fewer, work.piece.order), least);
    }
  }
  return result;
}

}  // namespace vcavity
