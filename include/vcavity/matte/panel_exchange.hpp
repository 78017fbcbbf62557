// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The exchange of light between the panels of a groove, discretised: for light that does not fill them evenly.
///
/// Method. A Nyström method in x = −ln s, s the distance from the apex. The panels of the quadrature grow from half the
/// aperture at the rim, the scale of the kernel, to 2.5, and end at s = ε; on each the radiosity is a polynomial. Where
/// a panel is long against its distance from the point that it lights, its integral is taken in pieces. On [0, ε] the
/// radiosity is the constant that it tends to at the apex (taking that for one more panel would ruin it there).
///
/// The aperture plays its part here alone; each pair of albedos then costs a factorisation, see
/// lambertian_cavity.hpp.
/// Good to some 1e-12 in double and long double, 1e-5 in float; what is achieved is measured against the closed form of
/// interreflection_kernel.hpp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/linear_system.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The exchange matrix of a groove with panels of unit width.
template <class Real>
class PanelExchange {
 public:
  explicit PanelExchange(const Cavity<Real>& cavity)
      : cavity_(cavity), rule_(gauss_legendre<Real>(order)), matrix_(0), squared_(0) {
    lay_panels();
    fill_matrix();
  }

  /// Nodes on each panel of the quadrature, and the polynomials' number of coefficients.
  static constexpr std::size_t order =
      static_cast<std::size_t>(std::clamp(std::numeric_limits<Real>::digits * 3 / 13, 6, 24));

  const Cavity<Real>& cavity() const { return cavity_; }

  /// Where the panels of the quadrature begin and end, in x = −ln s, from the rim on.
  const std::vector<Real>& breaks() const { return breaks_; }

  /// The distances from the apex of the nodes.
  const std::vector<Real>& positions() const { return positions_; }

  /// ∫ f ds is the sum of f times these over the nodes, but for what lies below `apex_width()`.
  const std::vector<Real>& weights() const { return weights_; }

  /// ε: nearer to the apex radiosity counts as constant.
  Real apex_width() const { return apex_width_; }

  /// What the apex region of the other panel, at radiosity 1, sends to the nodes.
  const std::vector<Real>& from_apex() const { return from_apex_; }

  /// The matrix of f ↦ ∫ K(s, t) f(t) dt between the nodes.
  const SquareMatrix<Real>& matrix() const { return matrix_; }

  /// Its square: the light that has crossed the groove twice.
  const SquareMatrix<Real>& squared() const { return squared_; }

  /// The mean of K(s, t) over t in [from, 1], with all its digits as `from` tends to 1.
  /// @param s,from in [0, 1], not both 0
  Real mean_kernel(const Real& s, const Real& from) const {
    const Real cosine = cos_aperture();
    const Real to_rim = distance(s, Real(1));
    const Real to_start = distance(s, from);
    return ((s - cosine) * (Real(1) + from - Real(2) * s * cosine) / (to_rim + to_start) + cosine * to_rim) /
           (Real(2) * to_rim * to_start);
  }

  /// The mean of K over [a, 1] on one panel and [b, 1] on the other: Hottel's crossed strings, written without the
  /// difference of nearly equal lengths.
  /// @param a,b in [0, 1)
  Real mean_kernel_of_strips(const Real& a, const Real& b) const {
    const Real cosine = cos_aperture();
    const Real one(1);
    // d(s, b) − d(s, 1) = −(1 − b) h(s); needed is the slope of h from s = a to 1.
    const Real numerator_at_a = one + b - Real(2) * a * cosine;
    const Real sum_at_a = distance(a, b) + distance(a, one);
    const Real sum_at_rim = distance(one, b) + distance(one, one);
    const auto slope_of_distance = [&](const Real& end) {
      return (one + a - Real(2) * end * cosine) / (distance(one, end) + distance(a, end));
    };
    const Real slope_of_sum = slope_of_distance(b) + slope_of_distance(one);
    return (Real(2) * cosine * sum_at_a + numerator_at_a * slope_of_sum) / (Real(2) * sum_at_a * sum_at_rim);
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
  Real cos_aperture() const { return Real(1) - Real(2) * cavity_.sin_half() * cavity_.sin_half(); }

  /// The distance between points of the two panels.
  Real distance(const Real& s, const Real& t) const {
    using std::sqrt;
    const Real sine = cavity_.sin_half();
    return sqrt((s - t) * (s - t) + Real(4) * s * t * sine * sine);
  }

  void lay_panels() {
    using std::exp;
    using std::log;
    const Real last = -log(std::numeric_limits<Real>::epsilon()) * Real(0.65);
    Real width = std::min(cavity_.aperture(), Real(1)) / Real(2);
    breaks_.push_back(Real(0));
    while (breaks_.back() < last) {
      breaks_.push_back(breaks_.back() + width);
      width = std::min(Real(width * Real(1.5)), Real(2.5));
    }
    for (std::size_t panel = 0; panel + 1 < breaks_.size(); ++panel) {
      const Real half_width = (breaks_[panel + 1] - breaks_[panel]) / Real(2);
      for (const QuadratureNode<Real>& node : rule_) {
        x_.push_back(breaks_[panel] + half_width * (Real(1) + node.x));
        positions_.push_back(exp(-x_.back()));
        weights_.push_back(node.weight * half_width * positions_.back());
      }
    }
    apex_width_ = exp(-breaks_.back());
    for (const Real& s : positions_) from_apex_.push_back(kernel_below(s, apex_width_));
  }

  /// ∫_0^end K(s, t) dt, s > end.
  Real kernel_below(const Real& s, const Real& end) const {
    const Real sine = Real(2) * cavity_.sin_half() * cavity_.cos_half();
    const Real length = distance(s, end);
    return end * end * sine * sine / (Real(2) * length * (length + s - end * cos_aperture()));
  }

  void fill_matrix() {
    // Barycentric weights of the interpolation between the nodes of a panel (Berrut & Trefethen, SIAM Rev. 46, 2004).
    for (std::size_t j = 0; j < order; ++j) {
      Real weight(1);
      for (std::size_t k = 0; k < order; ++k)
        if (k != j) weight /= rule_[j].x - rule_[k].x;
      barycentric_.push_back(weight);
    }
    matrix_ = SquareMatrix<Real>(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i)
      for (std::size_t panel = 0; panel + 1 < breaks_.size(); ++panel)
        add_panel(&matrix_[i][panel * order], x_[i], panel, breaks_[panel], breaks_[panel + 1]);
    squared_ = matrix_ * matrix_;
  }

  /// Adds to a row what part of a panel sends to the point x, in pieces that are not long against the distance of x
  /// from the singularities of the kernel.
  void add_panel(Real* row, const Real& x, std::size_t panel, const Real& from, const Real& to) const {
    const Real gap = std::max(Real(0), std::max(Real(from - x), Real(x - to)));
    const Real length = to - from;
    const Real aperture = cavity_.aperture();
    if (length * length > Real(1.01) * (aperture * aperture + gap * gap)) {
      const Real middle = (from + to) / Real(2);
      add_panel(row, x, panel, from, middle);
      add_panel(row, x, panel, middle, to);
      return;
    }
    const Real left = breaks_[panel];
    const Real right = breaks_[panel + 1];
    const bool whole = from == left && to == right;
    for (std::size_t j = 0; j < order; ++j) {
      const Real y = from + length * (Real(1) + rule_[j].x) / Real(2);
      const Real share = rule_[j].weight * length / Real(2) * kernel(Real(x - y));
      if (whole) {
        row[j] += share;
      } else {
        add_interpolated(row, share, Real(((y - left) + (y - right)) / (right - left)));
      }
    }
  }

  /// Spreads a value at `place` in [−1, 1] of a panel over its nodes.
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

  /// K(s, t) t with s = e^{−x}, t = e^{−y}, u = x − y.
  Real kernel(const Real& u) const {
    using std::exp;
    using std::sinh;
    using std::sqrt;
    const Real sine = cavity_.sin_half();
    const Real half_sinh = sinh(u / Real(2));
    const Real square = half_sinh * half_sinh + sine * sine;
    return sine * sine * cavity_.cos_half() * cavity_.cos_half() * exp(u / Real(2)) /
           (Real(4) * square * sqrt(square));
  }

  Cavity<Real> cavity_;
  std::vector<QuadratureNode<Real>> rule_;
  std::vector<Real> barycentric_;
  std::vector<Real> breaks_;
  std::vector<Real> x_;
  std::vector<Real> positions_;
  std::vector<Real> weights_;
  Real apex_width_{0};
  std::vector<Real> from_apex_;
  SquareMatrix<Real> matrix_;
  SquareMatrix<Real> squared_;
};

}  // namespace vcavity
