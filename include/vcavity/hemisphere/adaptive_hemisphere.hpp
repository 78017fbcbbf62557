// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Quadrature over the hemisphere for surfaces whose kinks are not known, or not all.
///
/// Method. With e = (sin ψ, cos ψ sin θ', cos ψ cos θ') the bi-hemispherical reflectance of a surface that reflects light
/// from e_x as from −e_x is
///
///     R = (2/π) ∫∫ R(e) cos²ψ cos θ' dψ dθ'   over θ' in [−π/2, π/2], ψ in [0, π/2].
///
/// The weights of all lobes depend on θ' alone, and so do their kinks. Across the groove a cell is integrated by eight
/// Gauss–Legendre nodes, and once more by eight in either half; the difference is taken for the error of the second
/// result, from above. The cell with the largest is halved, until all together are small enough. Along the groove the
/// integrand is smooth but for critical angles, at which the range of ψ is cut: the order rises until two agree, and a
/// range on which they never do is halved.
///
/// When not to use it: for grooves whose kinks are known (bihemispherical.hpp): that converges much faster.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcavity/conventions.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"

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
  /// @param tolerance absolute error to aim at
  Integral<Value> operator()(const std::vector<Real>& ends, const Scalar& tolerance) {
    const Scalar norm = Scalar(2) / pi<Scalar>();
    along_tolerance_ = tolerance / Scalar(8);
    std::vector<Cell> cells;  // a heap, the largest error first
    Scalar error(0);
    const auto push = [&](const Cell& cell) {
      error += cell.error;
      cells.push_back(cell);
      std::push_heap(cells.begin(), cells.end(), smaller_error);
    };
    Value value(0);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (!(ends[i] < ends[i + 1])) continue;
      push(halved(ends[i], ends[i + 1], across(ends[i], ends[i + 1])));
    }
    for (const Cell& cell : cells) value = value + (cell.lower.value + cell.upper.value);
    constexpr std::size_t most_cells = 20000;
    const Scalar rounding = Scalar(4) * std::numeric_limits<Scalar>::epsilon();
    const Scalar enough = std::max(Scalar(0.75) * tolerance / norm, rounding * largest(value));
    while (error > enough && cells.size() < most_cells && !is_exhausted()) {
      std::pop_heap(cells.begin(), cells.end(), smaller_error);
      const Cell worst = cells.back();
      cells.pop_back();
      error -= worst.error;
      const Real middle = (worst.low + worst.high) / Real(2);
      push(halved(worst.low, middle, worst.lower));
      push(halved(middle, worst.high, worst.upper));
    }
    value = Value(0);
    error = Scalar(0);
    for (const Cell& cell : cells) {
      value = value + (cell.lower.value + cell.upper.value);
      error += cell.error + cell.lower.along_error + cell.upper.along_error;
    }
    return {norm * value, at_most_all_light(Scalar(norm * (error + Scalar(4) * rounding * largest(value)))),
            evaluations_};
  }

 private:
  static constexpr long long most_evaluations = 100'000'000;

  bool is_exhausted() const { return evaluations_ >= most_evaluations; }

  struct Part {
    Value value;
    Scalar along_error;
  };

  struct Cell {
    Real low, high;
    Part lower, upper;  // halves
    Scalar error;
  };

  static bool smaller_error(const Cell& a, const Cell& b) { return a.error < b.error; }

  /// A cell and its halves.
  /// @param whole its integral
  Cell halved(const Real& low, const Real& high, const Part& whole) {
    const Real middle = (low + high) / Real(2);
    Cell result{low, high, across(low, middle), across(middle, high), Scalar(0)};
    result.error = difference(whole.value, result.lower.value + result.upper.value);
    return result;
  }

  static Scalar difference(const Value& a, const Value& b) { return largest(Value(a + Scalar(-1) * b)); }

  static const std::vector<QuadratureNode<Real>>& rule(std::size_t order) {
    thread_local std::array<std::vector<QuadratureNode<Real>>, 65> rules;
    if (rules[order].empty()) rules[order] = gauss_legendre<Real>(order);
    return rules[order];
  }

  /// The integral over θ' from `low` to `high` by eight nodes.
  Part across(const Real& low, const Real& high) {
    using std::cos;
    using std::sin;
    const Real middle = (low + high) / Real(2), half = (high - low) / Real(2);
    Part sum{Value(0), Scalar(0)};
    for (const auto& node : rule(8)) {
      const Real theta = middle + half * node.x;
      const Real cosine = cos(theta);
      const Scalar weight = static_cast<Scalar>(half * node.weight * cosine);
      const Part inner = along(sin(theta), cosine);
      sum.value = sum.value + weight * inner.value;
      sum.along_error += weight * inner.along_error;
    }
    return sum;
  }

  /// The integral of R(e) cos²ψ over ψ in [0, π/2]; at the end of the evaluations nothing is known of it but that R ≤ 1.
  Part along(const Real& sine, const Real& cosine) {
    const Real quarter = pi<Real>() / Real(2);
    if (is_exhausted()) return {Value(0), static_cast<Scalar>(quarter / Real(2))};
    cut_angles_.assign({Real(0), quarter});
    cuts_(Vec3<Real>{Real(0), sine, cosine}, cut_angles_);
    std::sort(cut_angles_.begin(), cut_angles_.end());
    // Without cuts R is even, and nodes are drawn to grazing light only.
    if (cut_angles_.size() == 2)
      return along(sine, cosine, {Real(0), quarter, Real(0), Real(1)}, along_tolerance_, 0);
    Part sum{Value(0), Scalar(0)};
    const Scalar tolerance = along_tolerance_ / Scalar(static_cast<int>(cut_angles_.size() - 1));
    for (std::size_t i = 0; i + 1 < cut_angles_.size(); ++i) {
      const Real half = (cut_angles_[i + 1] - cut_angles_[i]) / Real(2);
      if (!(half > Real(0))) continue;
      if (is_exhausted()) {
        sum.along_error += static_cast<Scalar>(Real(2) * half);
        continue;
      }
      const Part piece = along(sine, cosine, {cut_angles_[i] + half, half, Real(-1), Real(1)}, tolerance, 0);
      sum.value = sum.value + piece.value;
      sum.along_error += piece.along_error;
    }
    return sum;
  }

  /// A range of ψ = middle + half · sin(πu/2), u from `low` to `high`. Nodes are drawn to where u = ±1.
  struct Range {
    Real middle, half;
    Real low, high;
  };

  /// The integral of R(e) cos²ψ over a range.
  Part along(const Real& sine, const Real& cosine, const Range& range, const Scalar& tolerance,
             int halvings) {
    constexpr std::array<std::size_t, 5> orders{8, 12, 18, 28, 42};
    constexpr int most_halvings = 12;
    std::size_t which = halvings == 0 && usual_ > 0 ? usual_ - 1 : 0;
    Value last = along(sine, cosine, range, orders[which]);
    Scalar error(0);
    for (++which; which < orders.size(); ++which) {
      const Value next = along(sine, cosine, range, orders[which]);
      error = difference(last, next);
      last = next;
      const Scalar rounding = Scalar(8) * std::numeric_limits<Scalar>::epsilon() * largest(next);
      if (error <= tolerance || error <= rounding) {
        if (halvings == 0) usual_ = which;
        return {last, error};
      }
    }
    if (halvings >= most_halvings || is_exhausted()) return {last, error};
    Range lower_range = range, upper_range = range;
    lower_range.high = upper_range.low = (range.low + range.high) / Real(2);
    const Part lower = along(sine, cosine, lower_range, tolerance / Scalar(2), halvings + 1);
    const Part upper = along(sine, cosine, upper_range, tolerance / Scalar(2), halvings + 1);
    return {lower.value + upper.value, lower.along_error + upper.along_error};
  }

  Value along(const Real& sine, const Real& cosine, const Range& range, std::size_t order) const {
    using std::cos;
    using std::sin;
    const Real quarter = pi<Real>() / Real(2);
    const Real middle = (range.low + range.high) / Real(2), half = (range.high - range.low) / Real(2);
    Value sum(0);
    for (const auto& node : rule(order)) {
      const Real u = quarter * (middle + half * node.x);
      const Real psi = range.middle + range.half * sin(u);
      const Real cos_psi = cos(psi);
      const Real weight = half * node.weight * range.half * quarter * cos(u) * cos_psi * cos_psi;
      sum = sum + static_cast<Scalar>(weight) *
                      reflectance_(Vec3<Real>{sin(psi), cos_psi * sine, cos_psi * cosine});
    }
    return sum;
  }

  const Reflectance& reflectance_;
  const Cuts& cuts_;
  const long long& evaluations_;
  std::vector<Real> cut_angles_;
  Scalar along_tolerance_{};
  std::size_t usual_ = 0;  // the order along ψ that sufficed last
};

}  // namespace vcavity::detail
