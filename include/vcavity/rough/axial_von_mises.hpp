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
      throw_invalid_argument("the concentration of the grooves must lie in [0, 1e6], not be ", concentration);
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
  /// @param sine2 the square of the sine of the angle from the mean, in [0, 1]; a number, or an array of them
  template <class Value>
  Value relative_density(const Value& sine2) const {
    return unnormalised(sine2) * Value(scale_) * Value(pi<Real>() / Real(2));
  }

  /// The angle from the mean that a share `u` of the lines stays below.
  /// @param u in [0, 1]; a number, or an array of them
  /// @return in [−π/2, π/2]
  template <class Value>
  Value quantile(const Value& u) const {
    using std::sin;
    const Value least(std::numeric_limits<Real>::min());
    const auto is_left = u < Value(Real(0.5));
    const Value twice = Value(Real(2)) * u;
    const Value share = select(is_left, Value(Value(Real(1)) - twice), Value(twice - Value(Real(1))));
    const Cell<Value> cell = cell_of(share);
    // The density falls from 0 to π/2, so the distribution function is concave, its secant below it.
    const Value cell_share = at_least(Value(cell.below_high - cell.below_low), least);
    Value angle = cell.low + (cell.high - cell.low) *
                                 at_most(Value((share - cell.below_low) / cell_share), Value(Real(1)));
    for (int step = 0; step < newton_steps; ++step) {
      const Value sine = sin(angle);
      const Value miss = cell.below_low + Value(scale_) * integral(cell.low, angle) - share;
      const Value slope = at_least(Value(Value(scale_) * unnormalised(Value(sine * sine))), least);
      angle = at_most(at_least(Value(angle - miss / slope), cell.low), cell.high);
    }
    return select(is_left, Value(-angle), angle);
  }

 private:
  static constexpr std::size_t cells = 64;
  static constexpr std::size_t rule_size = 6;
  static constexpr int newton_steps = 3;

  Real node(std::size_t i) const {
    return end_ * (Real(static_cast<int>(i)) / Real(static_cast<int>(cells)));
  }

  /// A cell of the table: between which angles it lies, and the shares of the lines below these.
  template <class Value>
  struct Cell {
    Value low, high;
    Value below_low, below_high;
  };

  /// The cell in which a share of the lines is reached.
  template <class Value>
  Cell<Value> cell_of(const Value& share) const {
    if constexpr (Number<Value>) {
      std::size_t cell = 0;
      for (std::size_t step = cells / 2; step > 0; step /= 2)
        if (below_[cell + step] < share) cell += step;
      return {node(cell), node(cell + 1), below_[cell], below_[cell + 1]};
    } else {
      // Each share has a cell of its own, and all are looked for in the same steps.
      Cell<Value> cell{Value(node(0)), Value(node(1)), Value(below_[0]), Value(below_[1])};
      for (std::size_t i = 1; i < cells; ++i) {
        const auto is_beyond = share > Value(below_[i]);
        cell = {select(is_beyond, Value(node(i)), cell.low), select(is_beyond, Value(node(i + 1)), cell.high),
                select(is_beyond, Value(below_[i]), cell.below_low),
                select(is_beyond, Value(below_[i + 1]), cell.below_high)};
      }
      return cell;
    }
  }

  /// exp(κ (cos 2χ − 1))
  template <class Value>
  Value unnormalised(const Value& sine2) const {
    using std::exp;
    return exp(Value(Real(-2) * concentration_) * sine2);
  }

  template <class Value>
  Value integral(const Value& low, const Value& high) const {
    using std::sin;
    const Value half = (high - low) / Value(Real(2));
    Value sum(Real(0));
    for (const auto& [x, weight] : rule_) {
      const Value sine = sin(low + half * Value(Real(1) + x));
      sum += Value(weight) * unnormalised(Value(sine * sine));
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
