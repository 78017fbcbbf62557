// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A vector in a plane that is turned by the same angle again and again, without drift.
///
/// Method. A turn adds a small increment to each component. Thousands of plain additions would each round by
/// ε/2; here what an addition rounds off is kept and goes into the next one (Kahan, "Further remarks on
/// reducing truncation errors", Commun. ACM 8, 1965). The increments are written with 1 − cos instead of cos
/// and keep their relative precision. So the error after any number of turns through no more than π in total
/// stays below 8 ε times the length of the vector.
///
/// Compilers that treat addition as associative (-ffast-math) remove the compensation: the error then grows
/// by up to ε with each turn.

#include "value.hpp"

namespace vcavity {

/// @tparam Real number type of a component, or a `Pack` of them: one vector for each direction
template <class Real>
class TurningVector {
 public:
  using Scalar = scalar_t<Real>;

  /// @param x, y components at the start
  /// @param sine sin of the angle of one turn, from x towards y
  /// @param versine 1 − cos of that angle
  TurningVector(const Real& x, const Real& y, const Scalar& sine, const Scalar& versine)
      : x_{x, Real(0)}, y_{y, Real(0)}, sine_(sine), versine_(versine) {}

  const Real& x() const { return x_.value; }
  const Real& y() const { return y_.value; }

  /// Starts anew.
  void place(const Real& x, const Real& y) {
    x_ = {x, Real(0)};
    y_ = {y, Real(0)};
  }

  /// Turns the vector once.
  void turn() {
    const Real step_x = -(versine_ * x_.value + sine_ * y_.value);
    const Real step_y = sine_ * x_.value - versine_ * y_.value;
    x_.add(step_x);
    y_.add(step_y);
  }

 private:
  /// A sum, and what its last rounding added in excess.
  struct CompensatedSum {
    Real value;
    Real excess;

    void add(const Real& term) {
      const Real wanted = term - excess;
      const Real sum = value + wanted;
      excess = (sum - value) - wanted;
      value = sum;
    }
  };

  CompensatedSum x_;
  CompensatedSum y_;
  Scalar sine_;
  Scalar versine_;
};

}  // namespace vcavity
