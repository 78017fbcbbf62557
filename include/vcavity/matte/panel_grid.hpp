// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Places along a panel at which radiosity is computed, and the quadrature and the polynomials between them.
///
/// Method. In x = −ln s, s the distance from the apex over the length of the panel. Panels of the quadrature grow from
/// half the aperture, the scale of the kernel, where a rim is near, to 2.5, and end at s = ε; on each the radiosity is a
/// polynomial. On [0, ε] it is the constant that it tends to at the apex (taking that for one more panel would ruin it
/// there).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The places along one panel, its rim at s = 1.
template <class Real>
class PanelGrid {
 public:
  /// @param aperture the angle between the panels, in (0, π]
  /// @param other_rim −ln of the distance of the other panel's rim from the apex over that of this one's; where it is
  /// not positive, no place of this panel faces it
  explicit PanelGrid(const Real& aperture, const Real& other_rim = Real(0))
      : rule_(gauss_legendre<Real>(order)) {
    using std::exp;
    using std::log;
    const Real last = -log(std::numeric_limits<Real>::epsilon()) * Real(0.65);
    const Real finest = std::min(aperture, Real(1)) / Real(2);
    breaks_.push_back(Real(0));
    while (breaks_.back() < last) breaks_.push_back(next_break(breaks_.back(), finest, other_rim));
    for (std::size_t panel = 0; panel + 1 < breaks_.size(); ++panel) {
      const Real half_width = (breaks_[panel + 1] - breaks_[panel]) / Real(2);
      for (const QuadratureNode<Real>& node : rule_) {
        x_.push_back(breaks_[panel] + half_width * (Real(1) + node.x));
        positions_.push_back(exp(-x_.back()));
        weights_.push_back(node.weight * half_width * positions_.back());
      }
    }
    apex_width_ = exp(-breaks_.back());
    // Barycentric weights of the interpolation between the nodes of a panel (Berrut & Trefethen, SIAM Rev. 46, 2004).
    for (std::size_t j = 0; j < order; ++j) {
      Real weight(1);
      for (std::size_t k = 0; k < order; ++k)
        if (k != j) weight /= rule_[j].x - rule_[k].x;
      barycentric_.push_back(weight);
    }
  }

  /// Nodes on each panel of the quadrature, and the polynomials' number of coefficients.
  static constexpr std::size_t order =
      static_cast<std::size_t>(std::clamp(std::numeric_limits<Real>::digits * 3 / 13, 6, 24));

  /// The Gauss–Legendre rule of each panel.
  const std::vector<QuadratureNode<Real>>& rule() const { return rule_; }

  /// Where the panels of the quadrature begin and end, in x = −ln s, from the rim on.
  const std::vector<Real>& breaks() const { return breaks_; }

  /// −ln s of the nodes.
  const std::vector<Real>& x() const { return x_; }

  /// The distances from the apex of the nodes.
  const std::vector<Real>& positions() const { return positions_; }

  /// ∫ f ds is the sum of f times these over the nodes, but for what lies below `apex_width()`.
  const std::vector<Real>& weights() const { return weights_; }

  /// ε: nearer to the apex radiosity counts as constant.
  const Real& apex_width() const { return apex_width_; }

  /// Spreads a value at `place` in [−1, 1] of a panel of the quadrature over its nodes.
  void add_interpolated(Real* row, const Real& value, const Real& place) const {
    Real product(1);
    for (std::size_t k = 0; k < order; ++k) product *= place - rule_[k].x;
    if (product == Real(0)) {
      for (std::size_t k = 0; k < order; ++k)
        if (place == rule_[k].x) row[k] += value;
      return;
    }
    for (std::size_t k = 0; k < order; ++k)
      row[k] += value * product * barycentric_[k] / (place - rule_[k].x);
  }

  /// The coefficients of the polynomials in y = (x − x_left)/(x_right − x_left) through values at the nodes, `order` of
  /// them for each panel of the quadrature.
  std::vector<Real> polynomials(const std::vector<Real>& values) const {
    std::vector<Real> result(values.size(), Real(0));
    for (std::size_t first = 0; first < values.size(); first += order)
      for (std::size_t degree = 0; degree < order; ++degree) {
        // The Legendre coefficient, and the powers of y that its polynomial consists of.
        Real coefficient(0);
        for (std::size_t i = 0; i < order; ++i) {
          Real p0(0), p1(1);
          for (std::size_t k = 1; k <= degree; ++k) {
            const Real n = Real(static_cast<int>(k));
            const Real p2 = ((Real(2) * n - Real(1)) * rule_[i].x * p1 - (n - Real(1)) * p0) / n;
            p0 = p1;
            p1 = p2;
          }
          coefficient += rule_[i].weight * p1 * values[first + i];
        }
        coefficient *= (Real(2 * static_cast<int>(degree)) + Real(1)) / Real(2);
        Real power = degree % 2 == 0 ? coefficient : Real(-coefficient);
        for (std::size_t k = 0; k <= degree; ++k) {
          result[first + k] += power;
          power *= -Real(static_cast<int>((degree - k) * (degree + k + 1))) /
                   Real(static_cast<int>((k + 1) * (k + 1)));
        }
      }
    return result;
  }

 private:
  /// Panels grow by half from a rim on, and shrink likewise towards one that is ahead.
  static Real next_break(const Real& from, const Real& finest, const Real& other_rim) {
    const Real widest(2.5);
    const bool behind = !(other_rim > from);
    const Real beyond_rim = behind && other_rim > Real(0) ? Real(from - other_rim) : from;
    const Real width = std::min(Real(finest + beyond_rim / Real(2)), widest);
    if (behind) return from + width;
    const Real ahead = other_rim - from;
    const Real shrunk = std::min(width, Real((finest + ahead / Real(2)) / Real(1.5)));
    if (shrunk * Real(1.5) < ahead) return from + shrunk;
    return shrunk < ahead ? Real(from + ahead / Real(2)) : other_rim;
  }

  std::vector<QuadratureNode<Real>> rule_;
  std::vector<Real> barycentric_;
  std::vector<Real> breaks_;
  std::vector<Real> x_;
  std::vector<Real> positions_;
  std::vector<Real> weights_;
  Real apex_width_{0};
};

}  // namespace vcavity
