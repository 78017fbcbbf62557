// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Quadrature over the hemisphere for surfaces whose kinks are not known, or not all.
///
/// Method. With e = (sin ψ, cos ψ sin θ', cos ψ cos θ') the bi-hemispherical reflectance of a surface that reflects light
/// from e_x as from −e_x is
///
///     R = (2/π) ∫∫ R(e) cos²ψ cos θ' dψ dθ'   over θ' in [−π/2, π/2], ψ in [0, π/2].
///
/// The weights of all lobes depend on θ' alone, and so do their kinks: between those that are known the integrand is
/// smooth across the groove. Along it, it is even in ψ and smooth but for critical angles, at which the range is cut. Both
/// integrals are adaptive and tell their errors from the fall of Legendre series (adaptive_quadrature.hpp), of which no
/// more is known than what is seen; a cell with a kink is halved until it is small enough.
///
/// When not to use it: for symmetric grooves of one material (bihemispherical.hpp), which need fewer evaluations.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcavity/conventions.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/numbers/adaptive_quadrature.hpp"
#include "vcavity/numbers/components.hpp"

namespace vcavity::detail {

/// @tparam Reflectance called with a direction, returns a `Value`
/// @tparam Cuts called with a direction at ψ = 0 and a vector, to which it appends angles ψ
template <class Real, class Value, class Reflectance, class Cuts>
class AdaptiveHemisphere {
 public:
  using Scalar = scalar_t<Value>;

  /// @param reflectance R(e)
  /// @param cuts finds where R is not smooth along ψ
  /// @param evaluations of the facet, counted by `reflectance`
  AdaptiveHemisphere(const Reflectance& reflectance, const Cuts& cuts, const long long& evaluations)
      : reflectance_(reflectance), cuts_(cuts), evaluations_(evaluations) {}

  /// R and the estimate of its error.
  /// @param ends of the first cells: angles θ' in ascending order, from −π/2 to π/2
  /// @param tolerance absolute error to aim at; where the evaluations do not suffice, a looser one is
  Integral<Value> operator()(const std::vector<Real>& ends, const Scalar& tolerance) {
    const double aim = static_cast<double>(tolerance);
    Integral<Value> best = attempt(ends, {aim, max_evaluations / 5 * 2, all_cells, many_cuts});
    if (!is_exhausted()) return best;
    for (const Effort& next : {Effort{1e-2, max_evaluations / 5 * 3, few_cells, few_cuts},
                               Effort{1e-4, max_evaluations, few_cells, few_cuts}}) {
      Effort looser = next;
      looser.tolerance = std::max(looser.tolerance, aim);
      const Integral<Value> result = attempt(ends, looser);
      if (result.error < best.error) best = result;
    }
    best.evaluations = evaluations_;
    return best;
  }

 private:
  using Piece = QuadraturePiece<Real>;
  using Rule = SeriesRule<Real>;

  static constexpr long long max_evaluations = 50'000'000;

  /// What is spent on an attempt. Where there are more kinks than cells, or than cuts, pieces that need it are halved.
  struct Effort {
    double tolerance;
    long long limit;  ///< of all evaluations
    std::size_t cells, cuts;
  };
  static constexpr std::size_t whole_range_order = 12;  // that sees how mirrors lose light near grazing
  static constexpr std::size_t all_cells = 1'000'000, few_cells = 64, many_cuts = 64, few_cuts = 8;

  bool is_exhausted() const { return evaluations_ >= limit_; }

  Integral<Value> attempt(const std::vector<Real>& ends, const Effort& effort) {
    const double tolerance = effort.tolerance;
    limit_ = effort.limit;
    most_cuts_ = effort.cuts;
    usual_order_ = whole_range_order;
    const double norm = 2 / static_cast<double>(pi<Real>());
    constexpr double width = 2;  // ∫ cos θ' dθ'
    along_tolerance_ = 0.4 * tolerance / norm / width;
    std::vector<Piece> pieces;
    each_range(ends, effort.cells,
               [&](const Real& low, const Real& high) { pieces.push_back(across_piece(low, high)); });
    constexpr std::size_t first_order = 8, last_order = 24;  // beyond it a half of the piece does better
    const auto result = integrate_adaptively<Real, Value>(
        pieces, 0.5 * tolerance / norm, {1, min_series_order, last_order, 1, first_order},
        [&](const Piece& piece, const Rule& rule) { return across(piece, rule); },
        [](const Piece& piece) { return halves(piece, across_piece); }, [&] { return is_exhausted(); });
    const Value value = static_cast<Scalar>(norm) * result.value;
    const double error = norm * (result.error + result.noise) + rounding(value);
    return {value, static_cast<Scalar>(at_most_all_light(error)), evaluations_};
  }

  /// The ranges between angles in ascending order, several of them together where there are more than `most`.
  template <class Use>
  static void each_range(const std::vector<Real>& angles, std::size_t most, const Use& use) {
    const std::size_t stride = angles.size() / most + 1;
    for (std::size_t i = 0, next = 0; i + 1 < angles.size(); i = next) {
      next = std::min(i + stride, angles.size() - 1);
      if (angles[i] < angles[next]) use(angles[i], angles[next]);
    }
  }

  /// Nothing is known of the series but what is seen.
  static constexpr SeriesDecay unknown{0, 2, 0.3};

  /// Nodes are drawn to the ends: there panels begin to be lit, by grazing light, of which mirrors lose most.
  static Piece across_piece(const Real& low, const Real& high) {
    return {low, high, Symmetry::none, SineSubstitution(1), unknown, 0};
  }
  /// Nodes are drawn to critical angles and to grazing light.
  static Piece along_piece(const Real& low, const Real& high) {
    return {low, high, low == Real(0) ? Symmetry::even : Symmetry::none, SineSubstitution(1), unknown, 0};
  }

  template <class MakePiece>
  static std::vector<Piece> halves(const Piece& piece, const MakePiece& make) {
    const Real middle = (piece.low + piece.high) / Real(2);
    const Real least = Real(64) * std::numeric_limits<Real>::epsilon();
    if (!(piece.high - piece.low > least)) return {};
    return {make(piece.low, middle), make(middle, piece.high)};
  }

  /// The inner integrals at the nodes of an outer rule.
  PieceEstimate<Value> across(const Piece& piece, const Rule& rule) {
    using std::cos;
    using std::sin;
    const Real middle = (piece.low + piece.high) / Real(2), half = (piece.high - piece.low) / Real(2);
    SeriesSum<Value, Real> sum;
    double noise = 0;
    for (const auto& node : rule.nodes) {
      const auto [x, slope] = piece.variable.at(node.x);
      const Real theta = middle + half * x, cosine = cos(theta);
      const auto inner = along(sin(theta), cosine);
      const Real factor = half * slope * cosine;
      sum.add(inner.value, Real(factor * node.weight), scaled_projection(node, factor));
      noise += static_cast<double>(factor * node.weight) * (inner.error + inner.noise);
    }
    return estimate_of(sum, noise, rule);
  }

  /// The integral of R(e) cos²ψ over ψ in [0, π/2]; at the end of the evaluations nothing is known of it but that R ≤ 1.
  AdaptiveIntegral<Value> along(const Real& sine, const Real& cosine) {
    const Real quarter = pi<Real>() / Real(2);
    if (is_exhausted()) return {Value(0), static_cast<double>(quarter) / 2, 0};
    cut_angles_.assign({Real(0), quarter});
    cuts_(Vec3<Real>{Real(0), sine, cosine}, cut_angles_);
    std::sort(cut_angles_.begin(), cut_angles_.end());
    along_pieces_.clear();
    each_range(cut_angles_, most_cuts_,
               [&](const Real& low, const Real& high) { along_pieces_.push_back(along_piece(low, high)); });
    if (along_pieces_.size() == 1) along_pieces_.front().order = usual_order_;
    constexpr std::size_t first_order = 8, last_order = 42;
    const auto result = integrate_adaptively<Real, Value>(
        along_pieces_, along_tolerance_, {1, min_series_order, last_order, 1, first_order},
        [&](const Piece& piece, const Rule& rule) { return along(sine, cosine, piece, rule); },
        [](const Piece& piece) { return halves(piece, along_piece); }, [&] { return is_exhausted(); });
    if (along_pieces_.size() == 1) usual_order_ = along_pieces_.front().order;
    return result;
  }

  /// The integrand at the nodes of an inner rule.
  PieceEstimate<Value> along(const Real& sine, const Real& cosine, const Piece& piece,
                             const Rule& rule) const {
    using std::cos;
    using std::sin;
    const bool is_even = piece.symmetry == Symmetry::even;
    const Real low = is_even ? Real(-piece.high) : piece.low;
    const Real middle = (low + piece.high) / Real(2), half = (piece.high - low) / Real(2);
    SeriesSum<Value, Real> sum;
    for (const auto& node : rule.nodes) {
      const auto [x, slope] = piece.variable.at(node.x);
      const Real psi = middle + half * x, cos_psi = cos(psi);
      const Real factor = half * slope * cos_psi * cos_psi;
      sum.add(reflectance_(Vec3<Real>{sin(psi), cos_psi * sine, cos_psi * cosine}),
              Real(factor * node.weight), scaled_projection(node, factor));
    }
    return estimate_of(sum, 0, rule);
  }

  static std::array<Real, Rule::terms> scaled_projection(const typename Rule::Node& node,
                                                         const Real& factor) {
    std::array<Real, Rule::terms> result;
    for (std::size_t i = 0; i < Rule::terms; ++i) result[i] = node.projection[i] * factor;
    return result;
  }

  /// What the sum over a rule says about a piece.
  static PieceEstimate<Value> estimate_of(const SeriesSum<Value, Real>& sum, double noise, const Rule& rule) {
    PieceEstimate<Value> result{sum.integral, {}, noise, 0};
    for (std::size_t i = 0; i < Rule::terms; ++i)
      result.sizes[i] = static_cast<double>(largest(Value(sum.terms[i])));
    result.series_noise = rounding(result.value) + noise / rule.degrees.back();
    return result;
  }

  /// The rounding error of a sum of this size, below which differences say nothing.
  static double rounding(const Value& value) {
    return static_cast<double>(Scalar(4) * std::numeric_limits<Scalar>::epsilon() * largest(value));
  }

  const Reflectance& reflectance_;
  const Cuts& cuts_;
  const long long& evaluations_;
  long long limit_ = max_evaluations;
  std::size_t most_cuts_ = many_cuts;
  double along_tolerance_ = 0;
  std::vector<Real> cut_angles_;
  std::vector<Piece> along_pieces_;
  std::size_t usual_order_ = whole_range_order;  // that sufficed last along a range without cuts
};

}  // namespace vcavity::detail
