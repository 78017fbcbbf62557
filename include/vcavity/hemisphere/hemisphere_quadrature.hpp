// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Quadrature over the hemisphere: adaptive along the groove, within adaptive across it.
///
/// Method. The outer variable is an angle across the groove, the inner one ψ, the angle out of the plane across
/// it. At every node of the outer rules the inner integral is computed to its own tolerance
/// (adaptive_quadrature.hpp); its error adds to that of the whole and is noise to the outer series. The pieces
/// that one inner integral ended with are where the next begins.
///
/// An integrand tells the parts that it is the sum of (`parts_across`) with their pieces, and `at(part, angle, negligible)`
/// what a part is as a function of ψ there: `pieces()`, `piece(low, high)`, `weight()`, and the reflectance itself when
/// called with a facet, sin ψ, cos ψ and a limit of bounces. See cavity_integrand.hpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "vcavity/facet/facet.hpp"
#include "vcavity/hemisphere/counted_facet.hpp"
#include "vcavity/hemisphere/even_across.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/numbers/adaptive_quadrature.hpp"
#include "vcavity/numbers/pack.hpp"

namespace vcavity::detail {

/// The quadrature of one integrand.
template <class Real, class Facet, class Integrand>
class HemisphereQuadrature {
 public:
  using Value = unpolarized_t<Facet, Real>;
  using Scalar = scalar_t<Value>;

  /// @param integrand, facet must outlive the quadrature
  HemisphereQuadrature(Integrand& integrand, const Facet& facet)
      : integrand_(integrand), facet_(facet, evaluations_), wide_facet_(wide(facet_)) {}

  /// The integral with cos²ψ over all directions, times the norm of the integrand.
  /// @param tolerance absolute error to aim at; where the evaluations do not suffice, a looser one is
  Integral<Value> operator()(double tolerance) {
    Integral<Value> best = attempt(tolerance, max_evaluations / 5 * 2);
    if (!is_exhausted()) return best;
    constexpr std::size_t few_cuts = 16;
    integrand_.take_cuts(few_cuts);
    for (const double looser_tolerance : {1e-2, 1e-4}) {
      const Integral<Value> looser = attempt(std::max(looser_tolerance, tolerance), max_evaluations);
      if (looser.error < best.error) best = looser;
      if (is_exhausted()) break;
    }
    best.evaluations = evaluations_;
    return best;
  }

 private:
  /// @param limit of all evaluations
  Integral<Value> attempt(double tolerance, long long limit) {
    limit_ = limit;
    const double norm = static_cast<double>(integrand_.norm());
    // Half of it for the outer rule, the rest for the inner ones and for light that is not followed.
    const double all = tolerance / norm;
    double width = 0;
    const double across_tolerance = 0.5 * all;
    auto parts =
        integrand_.parts_across(static_cast<Real>(0.05 * all), may_do_with_few_nodes(across_tolerance));
    for (const Part& part : parts) width += static_cast<double>(part.width);
    along_tolerance_ = 0.4 * all / width;
    negligible_ = static_cast<Real>(std::min(0.05 * along_tolerance_, 0.1));
    Value sum(0);
    double off = static_cast<double>(integrand_.left_uncut());
    for (Part& part : parts) {
      const auto result = integral_across(part, across_tolerance / static_cast<double>(parts.size()));
      sum = sum + static_cast<Scalar>(part.sign) * result.value;
      off += result.error + result.noise;
    }
    const Value value = static_cast<Scalar>(integrand_.norm()) * sum;
    const double error = norm * off + rounding(value);
    return {value, static_cast<Scalar>(at_most_all_light(error)), evaluations_};
  }

  using Rule = SeriesRule<Real>;
  using Piece = QuadraturePiece<Real>;
  using Part = typename Integrand::Part;

  static constexpr long long max_evaluations = 20'000'000;
  static constexpr std::size_t most_even_nodes = 3;
  static constexpr double margin_across = 0.03;  // by trial: fewest evaluations

  /// Whether facets are asked for several directions of the same angle across at once.
  static constexpr bool in_packs() {
    if constexpr (std::is_floating_point_v<Real> && OverDirections<Facet>)
      return std::is_same_v<Value, Real>;
    else
      return false;
  }
  static constexpr std::size_t lanes = in_packs() ? 4 : 1;
  using Reals = std::conditional_t<in_packs(), Pack<Real, 4>, Real>;
  using Values = std::conditional_t<in_packs(), Pack<Real, 4>, Value>;

  static auto wide(const CountedFacet<Facet>& facet) {
    if constexpr (in_packs())
      return facet.template over_directions<lanes>();
    else
      return facet;
  }

  bool is_exhausted() const { return evaluations_ >= limit_; }

  /// Whether few nodes across do, as far as is known beforehand. Light that bounces most often is little in narrow grooves,
  /// but its kinks would be seen where all the rest is as good as even: then it is worth while to integrate it apart.
  bool may_do_with_few_nodes(double tolerance) const {
    if (!integrand_.even_across()) return false;
    const EvenAcross<Real, most_even_nodes> rule(integrand_.width());
    return rule.error(0, 1 / static_cast<double>(integrand_.width()), integrand_.singularity_across()) <=
           tolerance;
  }

  /// The outer integral of a part.
  AdaptiveIntegral<Value> integral_across(Part& part, double tolerance) {
    along_pieces_.clear();
    kept_orders_.clear();
    if (part.pieces.size() == 1 && integrand_.even_across()) {
      const auto by_two = by_few_nodes<2>(part, tolerance);
      if (by_two.error <= tolerance) return by_two;
      const auto by_three = by_few_nodes<most_even_nodes>(part, tolerance);
      if (by_three.error <= tolerance) return by_three;
    }
    return integrate_adaptively<Real, Value>(
        part.pieces, tolerance,
        {1, min_series_order, 40, integrand_.believed_across(), integrand_.start_across(), margin_across},
        [&](const auto& piece, const auto& rule) { return across(part, piece, rule); },
        [&](const Piece& piece) { return integrand_.halves_across(piece); }, [&] { return is_exhausted(); });
  }

  /// The outer integral of a part that is almost even (even_across.hpp).
  template <std::size_t count>
  AdaptiveIntegral<Value> by_few_nodes(const Part& part, double tolerance) {
    const EvenAcross<Real, count> rule(part.width);
    const double distance = integrand_.singularity_across();
    AdaptiveIntegral<Value> result{Value(0), 0, 0};
    Value first(0);
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& node = rule.nodes()[i];
      const auto along = integrand_.at(part, node.u, negligible_);
      const auto inner = integral_along(along);
      const Real weight = node.weight * along.weight();
      result.value = result.value + static_cast<Scalar>(weight) * inner.value;
      result.noise += static_cast<double>(weight) * error_along(along, inner);
      const Value even = static_cast<Scalar>(along.weight() / node.hat) * inner.value;
      if (i == 0) first = even;
      if (i == 1) difference = static_cast<double>(largest(Value(even + Scalar(-1) * first)));
      size = std::max(size, static_cast<double>(largest(even)));
      result.error = rule.error(difference, size, distance);
      if (!(result.error <= tolerance)) break;
    }
    return result;
  }

  /// Bound on the error of an inner integral.
  template <class Along>
  static double error_along(const Along& along, const AdaptiveIntegral<Value>& inner) {
    const double error = inner.error + inner.noise + static_cast<double>(along.beyond());
    return error <= Integrand::largest_along ? error : Integrand::largest_along;
  }

  /// Of the range of the nodes of a piece.
  static std::array<Real, 2> middle_and_half(const Piece& piece) {
    if (piece.symmetry == Symmetry::even) return {Real(0), piece.high};
    return {(piece.low + piece.high) / Real(2), (piece.high - piece.low) / Real(2)};
  }

  /// The inner integrals at the nodes of an outer rule.
  PieceEstimate<Value> across(const Part& part, const Piece& piece, const Rule& rule) {
    const auto [middle, half] = middle_and_half(piece);
    SeriesSum<Value, Real> sum;
    double noise = 0;
    for (const auto& node : rule.nodes) {
      const auto [x, slope] = piece.variable.at(node.x);
      const auto along = integrand_.at(part, middle + half * x, negligible_);
      const Real scale = half * slope * along.weight();
      const auto inner = integral_along(along);
      std::array<Real, Rule::terms> projection;
      for (std::size_t i = 0; i < Rule::terms; ++i) projection[i] = node.projection[i] * scale;
      sum.add(inner.value, Real(node.weight * scale), projection);
      noise += static_cast<double>(node.weight * scale) * error_along(along, inner);
    }
    return estimate_of(sum, noise, rule);
  }

  /// The integral over ψ.
  template <class Along>
  AdaptiveIntegral<Value> integral_along(const Along& along) {
    std::vector<Piece>& pieces = along_pieces_;
    if (integrand_.is_cut() || pieces.empty()) {
      pieces = along.pieces();
      for (std::size_t i = 0; i < pieces.size() && i < kept_orders_.size(); ++i)
        pieces[pieces.size() - 1 - i].order = kept_orders_[i];
    }
    const std::size_t count = pieces.size();
    const double tolerance = along_tolerance_ / static_cast<double>(along.weight());
    const auto result = integrate_adaptively<Real, Value>(
        pieces, tolerance, {4, min_series_order, 56, 1, integrand_.start_along()},
        [&](const auto& piece, const auto& rule) { return estimate_along(along, piece, rule); },
        [&](const Piece& piece) { return along.halves(piece); }, [&] { return is_exhausted(); });
    if (integrand_.is_cut() && pieces.size() == count) {
      kept_orders_.clear();
      for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
        kept_orders_.push_back(piece->order);
    }
    return result;
  }

  /// A pack of nodes of an inner rule.
  struct AlongNode {
    Reals sine, cosine;  // of ψ
    Reals weight;        // with cos²ψ
    std::array<Reals, Rule::terms> projection;
  };

  /// The nodes of an inner rule on a piece. Where ψ is not cut they serve at all angles across.
  struct AlongNodes {
    Piece piece;
    std::vector<AlongNode> nodes;

    bool are_of(const Piece& other) const {
      return piece.order == other.order && piece.low == other.low && piece.high == other.high &&
             piece.symmetry == other.symmetry && piece.variable == other.variable;
    }
  };

  template <class Along>
  const std::vector<AlongNode>& nodes_along(const Along& along, const Piece& piece, const Rule& rule) {
    if (integrand_.is_cut()) {
      fill(scratch_, along, piece, rule);
      return scratch_;
    }
    for (const AlongNodes& kept : kept_nodes_)
      if (kept.are_of(piece)) return kept.nodes;
    kept_nodes_.push_back({piece, {}});
    fill(kept_nodes_.back().nodes, along, piece, rule);
    return kept_nodes_.back().nodes;
  }

  template <class Along>
  void fill(std::vector<AlongNode>& nodes, const Along& along, const Piece& piece, const Rule& rule) const {
    const auto [middle, half] = middle_and_half(piece);
    nodes.clear();
    for (std::size_t start = 0; start < rule.nodes.size(); start += lanes) {
      AlongNode node;
      Reals u;
      for (std::size_t lane = 0; lane < lanes; ++lane) component(u, lane) = rule.nodes[start + lane].x;
      const auto [x, slope] = piece.variable.at(u);
      const auto direction = along.direction(Reals(Reals(middle) + half * x));
      const Reals factor = half * (slope * direction.slope * direction.cosine * direction.cosine);
      node.sine = direction.sine;
      node.cosine = direction.cosine;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const auto& at = rule.nodes[start + lane];
        component(node.weight, lane) = at.weight;
        for (std::size_t i = 0; i < Rule::terms; ++i) component(node.projection[i], lane) = at.projection[i];
      }
      node.weight = factor * node.weight;
      for (Reals& projection : node.projection) projection = factor * projection;
      nodes.push_back(node);
    }
  }

  /// The integrand at the nodes of an inner rule.
  template <class Along>
  PieceEstimate<Value> estimate_along(const Along& along, const Piece& piece, const Rule& rule) {
    SeriesSum<Values, Reals> sum;
    double left_out = 0;
    for (const AlongNode& node : nodes_along(along, piece, rule)) {
      const long long left = std::max(limit_ - evaluations_, 0LL) / static_cast<long long>(2 * lanes);
      const auto here = along(wide_facet_, node.sine, node.cosine, static_cast<int>(left));
      sum.add(here.value, node.weight, node.projection);
      for (std::size_t lane = 0; lane < lanes; ++lane)
        left_out += static_cast<double>(component(node.weight, lane) * here.left_out);
    }
    return estimate_of(sum, left_out, rule);
  }

  /// What the sum over a rule says about a piece.
  template <class Sum>
  PieceEstimate<Value> estimate_of(const Sum& sum, double noise, const Rule& rule) {
    PieceEstimate<Value> result{total(sum.integral), {}, noise, 0};
    for (std::size_t i = 0; i < Rule::terms; ++i)
      result.sizes[i] = static_cast<double>(largest(total(sum.terms[i])));
    result.series_noise = rounding(result.value) + noise / rule.degrees.back();
    return result;
  }

  template <class SomeReals>
  static auto& component(SomeReals& values, std::size_t lane) {
    if constexpr (in_packs())
      return values[lane];
    else
      return values;
  }

  /// The sum over the directions of a pack.
  template <class Addend>
  static Value total(const Addend& values) {
    if constexpr (in_packs() && !std::is_same_v<Addend, Value>)
      return std::accumulate(values.begin(), values.end(), Value(0));
    else
      return values;
  }

  /// The rounding error of a sum of this size, below which differences say nothing.
  static double rounding(const Value& value) {
    return static_cast<double>(Scalar(4) * std::numeric_limits<Scalar>::epsilon() * largest(value));
  }

  Integrand& integrand_;
  long long evaluations_ = 0, limit_ = max_evaluations;
  CountedFacet<Facet> facet_;
  std::remove_cvref_t<decltype(wide(std::declval<const CountedFacet<Facet>&>()))> wide_facet_;
  double along_tolerance_ = 0;
  Real negligible_{0};
  std::vector<Piece>
      along_pieces_;  // of the last inner integral; where ψ is not cut the next begins with them
  std::vector<std::size_t> kept_orders_;  // of the last one, from grazing, where it is
  std::vector<AlongNodes> kept_nodes_;    // of all rules so far, where ψ is not cut
  std::vector<AlongNode> scratch_;        // of one rule, where it is
};

}  // namespace vcavity::detail
