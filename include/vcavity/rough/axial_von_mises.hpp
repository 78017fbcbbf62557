// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The axial von Mises distribution: of lines that know no front end, such as grooves, about a mean azimuth.
///
/// The density of the angle χ between a line and the mean, on (−π/2, π/2], is exp(κ cos 2χ)/(π I_0(κ)): the von
/// Mises distribution of the doubled angle (Mardia and Jupp, "Directional Statistics", 2000, §9.4). κ = 0 is no
/// preference; for large κ the lines are normally distributed with the standard deviation 1/(2√κ).
///
/// Method. The quantile has no closed form. The distribution function is tabulated once, and Newton's method
/// inverts it, with Gauss–Legendre quadrature of the density inside a cell of the table: to rounding, with 20
/// exponentials a draw. Angles so far out that less than ε of the lines lies beyond are not drawn.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>

#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

template <class Real>
class AxialVonMises {
 public:
  /// @param concentration κ in [0, 1e6]
  /// @throws std::invalid_argument when it is out of range or not a number
  explicit AxialVonMises(const Real& concentration) : concentration_(concentration) {
    using std::asin;
    using std::log;
    using std::sqrt;
    if (!(concentration >= Real(0) && concentration <= Real(1e6))) {
      std::ostringstream message;
      message << "the concentration of the grooves must lie in [0, 1e6], not be " << concentration;
      throw_invalid_argument(message.str());
    }
    const auto nodes = gauss_legendre<Real>(rule_size);
    for (std::size_t i = 0; i < rule_size; ++i) rule_[i] = nodes[i];
    // Where the density has fallen to ε² of its peak, if it falls so far.
    const Real least = Real(-2) * Real(log(std::numeric_limits<Real>::epsilon()));
    const Real sine2 = least / at_least(Real(Real(2) * concentration), Real(1e-3));
    end_ = sine2 < Real(1) ? Real(asin(sqrt(sine2))) : pi<Real>() / Real(2);
    below_[0] = Real(0);
    for (std::size_t i = 0; i < cells; ++i) below_[i + 1] = below_[i] + integral(node(i), node(i + 1));
    scale_ = Real(1) / below_[cells];
    for (Real& share : below_) share *= scale_;
  }

  /// κ
  Real concentration() const { return concentration_; }

  /// The density per radian divided by that of κ = 0, 1/π.
  /// @param sine2 the square of the sine of the angle from the mean, in [0, 1]
  Real relative_density(const Real& sine2) const {
    return unnormalised(sine2) * scale_ * (pi<Real>() / Real(2));
  }

  /// The angle from the mean that a share `u` of the lines stays below.
  /// @param u in [0, 1]
  /// @return in [−π/2, π/2]
  Real quantile(const Real& u) const {
    using std::sin;
    const bool is_left = u < Real(0.5);
    const Real share = is_left ? Real(1) - Real(2) * u : Real(2) * u - Real(1);
    std::size_t cell = 0;
    for (std::size_t step = cells / 2; step > 0; step /= 2)
      if (below_[cell + step] < share) cell += step;
    const Real low = node(cell), high = node(cell + 1);
    // The density falls from 0 to π/2, so the distribution function is concave, its secant below it.
    const Real cell_share = at_least(Real(below_[cell + 1] - below_[cell]), std::numeric_limits<Real>::min());
    Real angle = low + (high - low) * at_most(Real((share - below_[cell]) / cell_share), Real(1));
    for (int step = 0; step < newton_steps; ++step) {
      const Real sine = sin(angle);
      const Real miss = below_[cell] + scale_ * integral(low, angle) - share;
      const Real slope =
          at_least(Real(scale_ * unnormalised(Real(sine * sine))), std::numeric_limits<Real>::min());
      angle = at_most(at_least(Real(angle - miss / slope), low), high);
    }
    return is_left ? Real(-angle) : angle;
  }

 private:
  static constexpr std::size_t cells = 64;
  static constexpr std::size_t rule_size = 6;
  static constexpr int newton_steps = 3;

  Real node(std::size_t i) const {
    return end_ * (Real(static_cast<int>(i)) / Real(static_cast<int>(cells)));
  }

  /// exp(κ (cos 2χ − 1))
  Real unnormalised(const Real& sine2) const {
    using std::exp;
    return exp(Real(-2) * concentration_ * sine2);
  }

  Real integral(const Real& low, const Real& high) const {
    using std::sin;
    const Real half = (high - low) / Real(2);
    Real sum(0);
    for (const auto& [x, weight] : rule_) {
      const Real sine = sin(low + half * (Real(1) + x));
      sum += weight * unnormalised(Real(sine * sine));
    }
    return half * sum;
  }

  Real concentration_;
  Real end_;    // the largest angle drawn
  Real scale_;  // of the density on [0, end]
  std::array<QuadratureNode<Real>, rule_size> rule_;
  std::array<Real, cells + 1> below_;  // the distribution function of |χ| at the nodes
};

}  // namespace vcavity
