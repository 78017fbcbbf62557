// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Variables of integration that draw nodes to the ends of a range, and how fast the Legendre series of a function
/// with known singularities falls off in them.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The rate at which a Legendre series on [−1, 1] falls off at least, from one degree to the next, if the
/// function is singular at z: the sum of the half axes of the ellipse through z with foci ±1 (Trefethen,
/// "Approximation Theory and Approximation Practice", 2013, chapter 8) is the exponential of the rate.
inline double convergence_rate(const std::complex<double>& z) {
  return std::acosh(std::max(0.5 * (std::abs(z - 1.0) + std::abs(z + 1.0)), 1.0));
}

/// A variable of integration u with x = sin(κπu/2)/sin(κπ/2), both from −1 to 1: the larger κ, the more nodes
/// are drawn to the ends. κ = 0 leaves x as it is.
class SineSubstitution {
 public:
  /// @param draw κ in [0, 1]
  explicit SineSubstitution(double draw = 0)
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
  SineSubstitution variable;
  double rate = 0;
};

/// The rate at which the series falls off in a variable.
/// @param variable of integration
/// @param singularities in the plane of x; not empty
inline Convergence convergence_in(const SineSubstitution& variable,
                                  const std::vector<std::complex<double>>& singularities) {
  double rate = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& x : singularities)
    rate = std::min(rate, convergence_rate(variable.inverse(x)));
  return {variable, rate};
}

/// The variable in which the series falls off fastest.
/// @param singularities in the plane of x; not empty
inline Convergence best_variable(const std::vector<std::complex<double>>& singularities) {
  Convergence best;
  for (const double draw : {0.0, 0.5, 0.75, 0.9, 1.0}) {
    const Convergence here = convergence_in(SineSubstitution(draw), singularities);
    if (here.rate > best.rate) best = here;
    constexpr double fast = 0.9;
    if (here.rate > fast) break;
  }
  return best;
}

}  // namespace vcavity
