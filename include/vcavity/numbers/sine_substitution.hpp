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

#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The larger half axis of the ellipse through z with foci ±1.
inline double half_axis(const std::complex<double>& z) {
  return 0.5 * (std::sqrt(std::norm(z - 1.0)) + std::sqrt(std::norm(z + 1.0)));
}

/// The rate at which a Legendre series on [−1, 1] falls off at least, from one degree to the next, if the
/// function is singular on the ellipse with foci ±1 and this larger half axis: its exponential is the sum of both half
/// axes (Trefethen, "Approximation Theory and Approximation Practice", 2013, chapter 8).
inline double convergence_rate(double half_axis) {
  return std::acosh(std::max(half_axis, 1.0));
}

/// A variable of integration u with x = sin(κπu/2)/sin(κπ/2), both from −1 to 1: the larger κ, the more nodes
/// are drawn to the ends. κ = 0 leaves x as it is.
class SineSubstitution {
 public:
  /// @param draw κ in [0, 1]
  explicit SineSubstitution(double draw = 0)
      : draw_(draw), end_(draw > 0 ? std::sin(draw * quarter_turn()) : 1) {}

  /// The value x and its derivative dx/du.
  /// @param u in [−1, 1], a number or a pack of them
  template <class Reals>
  std::array<Reals, 2> at(const Reals& u) const {
    using std::sin;
    using Real = scalar_t<Reals>;
    if (!(draw_ > 0)) return {u, Reals(Real(1))};
    const Real factor = Real(draw_) * (pi<Real>() / Real(2));
    const Real scale = draw_ < 1 ? Real(Real(1) / sin(factor)) : Real(1);
    const auto [sine, cosine] = detail::sine_and_cosine(Reals(factor * u));
    return {Reals(scale * sine), Reals((scale * factor) * cosine)};
  }

  /// The point u of a singularity at x.
  std::complex<double> inverse(const std::complex<double>& x) const {
    if (!(draw_ > 0)) return x;
    const std::complex<double> sine = x * end_;
    const double factor = draw_ * quarter_turn();
    if (sine.imag() != 0) return std::asin(sine) / factor;
    const double magnitude = std::abs(sine.real());
    const double beyond = magnitude > 1 ? std::acosh(magnitude) : 0;
    return {std::copysign(std::asin(std::min(magnitude, 1.0)), sine.real()) / factor, beyond / factor};
  }

  friend bool operator==(const SineSubstitution&, const SineSubstitution&) = default;

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
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& x : singularities)
    nearest = std::min(nearest, half_axis(variable.inverse(x)));
  return {variable, convergence_rate(nearest)};
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
