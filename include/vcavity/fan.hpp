// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A vector in the plane across the groove, turned by multiples of half the aperture.
///
/// Unfolding a groove turns everything by the same angle again and again. The first turns are looked up in
/// the table of the cavity and cost two products and a sum each; beyond its end, in narrow grooves, one turn
/// leads to the next (`TurningVector`).

#include <cmath>
#include <cstdint>

#include "cavity.hpp"
#include "turning_vector.hpp"

namespace vcavity {

/// @tparam Real number type of a component, or a `Pack` of them: one vector for each direction
/// @tparam step angle of a turn in units of α/2: 1 or 2
template <class Real, int step>
class FanVector {
  static_assert(step == 1 || step == 2);

 public:
  using Groove = Cavity<scalar_t<Real>>;

  /// @param cavity must outlive the vector
  /// @param x, y components before any turn
  /// @param multiple angle of the first turn in units of α/2, 0 or 1
  FanVector(const Groove& cavity, const Real& x, const Real& y, int multiple)
      : cavity_(&cavity),
        x_(x),
        y_(y),
        multiple_(multiple),
        turned_(x, y, step == 1 ? cavity.sin_half() : cavity.sin_aperture(),
                step == 1 ? cavity.versine_half() : cavity.versine_aperture()) {}

  Real x() const {
    if (!is_tabulated()) return turned_.x();
    return rotation().cosine * x_ - rotation().sine * y_;
  }

  Real y() const {
    if (!is_tabulated()) return turned_.y();
    return rotation().sine * x_ + rotation().cosine * y_;
  }

  /// Turns the vector once, from x towards y.
  void turn() {
    if (is_tabulated() && multiple_ + step > Groove::tabulated_multiples) turned_.place(x(), y());
    multiple_ += step;
    if (!is_tabulated()) turned_.turn();
  }

  /// Turns the vector `turns` times at once.
  void turn(int turns) {
    using std::cos;
    using std::sin;
    multiple_ += std::int64_t{step} * turns;
    if (is_tabulated()) return;
    using Scalar = scalar_t<Real>;
    const Scalar angle = Scalar(multiple_) * (cavity_->aperture() / Scalar(2));
    const Scalar cosine = cos(angle);
    const Scalar sine = sin(angle);
    turned_.place(cosine * x_ - sine * y_, sine * x_ + cosine * y_);
  }

 private:
  bool is_tabulated() const { return multiple_ <= Groove::tabulated_multiples; }
  const auto& rotation() const { return cavity_->multiple(multiple_); }

  const Groove* cavity_;
  Real x_, y_;
  std::int64_t multiple_;
  TurningVector<Real> turned_;  // beyond the table
};

}  // namespace vcavity
