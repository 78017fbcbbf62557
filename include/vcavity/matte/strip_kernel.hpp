// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What strips of two panels that meet at an apex send each other, for panels of any lengths.
///
/// Method. K(s, t) = ½ st sin²α / (s² + t² − 2st cos α)^{3/2}, s and t the distances from the apex, and Hottel's crossed
/// strings for its integrals (in W. H. McAdams, "Heat Transmission", 3rd ed., 1954), written without the difference of
/// nearly equal lengths.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/matte/panel_grid.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/linear_system.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The exchange between the planes of two panels.
template <class Real>
class StripKernel {
 public:
  explicit StripKernel(const Cavity<Real>& cavity)
      : aperture_(cavity.aperture()), sin_half_(cavity.sin_half()), cos_half_(cavity.cos_half()) {}

  /// cos α
  Real cosine() const { return Real(1) - Real(2) * sin_half_ * sin_half_; }

  /// The distance between points of the two panels.
  Real distance(const Real& s, const Real& t) const {
    using std::sqrt;
    return sqrt((s - t) * (s - t) + Real(4) * s * t * sin_half_ * sin_half_);
  }

  /// K(s, t) t, which depends on u = ln(t/s) alone.
  Real per_logarithm(const Real& u) const {
    using std::exp;
    using std::sinh;
    using std::sqrt;
    const Real half_sinh = sinh(u / Real(2));
    const Real square = half_sinh * half_sinh + sin_half_ * sin_half_;
    return sin_half_ * sin_half_ * cos_half_ * cos_half_ * exp(u / Real(2)) /
           (Real(4) * square * sqrt(square));
  }

  /// ∫_0^end K(s, t) dt, s > end.
  Real below(const Real& s, const Real& end) const {
    const Real sine = Real(2) * sin_half_ * cos_half_;
    const Real length = distance(s, end);
    return end * end * sine * sine / (Real(2) * length * (length + s - end * cosine()));
  }

  /// The share of the light that leaves s (Lambert) and passes the rim of the other panel at `rim`:
  /// 1 − ∫_0^rim K(s, t) dt.
  Real passing(const Real& s, const Real& rim) const {
    const Real sine = Real(2) * sin_half_ * cos_half_;
    const Real length = distance(s, rim);
    const Real along = s - rim * cosine();
    if (along > Real(0)) return (length + along) / (Real(2) * length);
    const Real across = rim * sine;
    return across * across / (Real(2) * length * (length - along));
  }

  /// The mean of K(s, t) over t in [from, rim], with all its digits as `from` tends to the rim.
  /// @param s,from not both 0
  /// @param rim end of the range
  Real mean(const Real& s, const Real& from, const Real& rim) const {
    const Real to_rim = distance(s, rim);
    const Real to_start = distance(s, from);
    return ((s - rim * cosine()) * (rim + from - Real(2) * s * cosine()) / (to_rim + to_start) +
            cosine() * to_rim) /
           (Real(2) * to_rim * to_start);
  }

  /// The mean of K over [a, a_rim] on one panel and [b, b_rim] on the other.
  Real mean_of_strips(const Real& a, const Real& a_rim, const Real& b, const Real& b_rim) const {
    // d(s, b) − d(s, b_rim) = −(b_rim − b) h(s); needed is the slope of h from s = a to a_rim.
    const Real numerator_at_a = b_rim + b - Real(2) * a * cosine();
    const Real sum_at_a = distance(a, b) + distance(a, b_rim);
    const Real sum_at_rim = distance(a_rim, b) + distance(a_rim, b_rim);
    const auto slope_of_distance = [&](const Real& end) {
      return (a_rim + a - Real(2) * end * cosine()) / (distance(a_rim, end) + distance(a, end));
    };
    const Real slope_of_sum = slope_of_distance(b) + slope_of_distance(b_rim);
    return (Real(2) * cosine() * sum_at_a + numerator_at_a * slope_of_sum) /
           (Real(2) * sum_at_a * sum_at_rim);
  }

  /// Sets a block of a matrix to f ↦ ∫ K(s, t) f(t) dt from the nodes of one panel to those of the other, but for what
  /// comes from below its `apex_width()`.
  /// @param matrix what the block is a part of
  /// @param row,column where the block begins
  /// @param receiver,sender nodes of either panel
  /// @param ratio the logarithm of the length of the panel that sends over that of the one that receives
  void fill_block(SquareMatrix<Real>& matrix, std::size_t row, const PanelGrid<Real>& receiver,
                  std::size_t column, const PanelGrid<Real>& sender, const Real& ratio) const {
    const std::vector<Real>& breaks = sender.breaks();
    for (std::size_t i = 0; i < receiver.x().size(); ++i)
      for (std::size_t panel = 0; panel + 1 < breaks.size(); ++panel)
        add_panel(&matrix[row + i][column + panel * PanelGrid<Real>::order], Real(receiver.x()[i] + ratio),
                  sender, panel, breaks[panel], breaks[panel + 1]);
  }

 private:
  /// Adds to a row what part of a panel sends to the point x, in pieces that are not long against the distance of x
  /// from the singularities of the kernel.
  void add_panel(Real* row, const Real& x, const PanelGrid<Real>& sender, std::size_t panel, const Real& from,
                 const Real& to) const {
    const Real gap = std::max(Real(0), std::max(Real(from - x), Real(x - to)));
    const Real length = to - from;
    if (length * length > Real(1.01) * (aperture_ * aperture_ + gap * gap)) {
      const Real middle = (from + to) / Real(2);
      add_panel(row, x, sender, panel, from, middle);
      add_panel(row, x, sender, panel, middle, to);
      return;
    }
    const Real left = sender.breaks()[panel];
    const Real right = sender.breaks()[panel + 1];
    const bool whole = from == left && to == right;
    for (std::size_t j = 0; j < PanelGrid<Real>::order; ++j) {
      const QuadratureNode<Real>& node = sender.rule()[j];
      const Real y = from + length * (Real(1) + node.x) / Real(2);
      const Real share = node.weight * length / Real(2) * per_logarithm(Real(x - y));
      if (whole) {
        row[j] += share;
      } else {
        sender.add_interpolated(row, share, Real(((y - left) + (y - right)) / (right - left)));
      }
    }
  }

  Real aperture_, sin_half_, cos_half_;
};

}  // namespace vcavity
