// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A vector in the plane across the groove, turned by multiples of half the aperture.
///
/// Unfolding a groove turns everything by the same angle again and again. Turns are looked up in the table of
/// the cavity and cost two products and a sum for a component. Where the table ends, in narrow grooves, the
/// vector is turned from its beginning to there, and the table serves again: so no rounding adds up, however
/// many turns there are.

#include <cstdint>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/inline.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// @tparam Real number type of a component, or a `Pack` of them: one vector for each direction
template <class Real>
class FanVector {
 public:
  using Groove = Cavity<scalar_t<Real>>;

  /// @param cavity must outlive the vector
  /// @param x, y components before any turn
  FanVector(const Groove& cavity, const Real& x, const Real& y)
      : cavity_(&cavity), x_(x), y_(y), table_x_(x), table_y_(y), turned_y_(y) {}

  Real x() const {
    const auto& turn = cavity_->tabulated(in_table_);
    return turn.cosine * table_x_ - turn.sine * table_y_;
  }

  const Real& y() const { return turned_y_; }

  /// Turns the vector by a multiple of α/2, from x towards y.
  VCAVITY_INLINE void turn(std::int64_t multiple) {
    in_table_ += multiple;
    if (in_table_ > Groove::tabulated_multiples) start_table_again();
    const auto& turn = cavity_->tabulated(in_table_);
    turned_y_ = turn.sine * table_x_ + turn.cosine * table_y_;
  }

 private:
  void start_table_again() {
    constexpr std::int64_t length = Groove::tabulated_multiples + 1;
    before_table_ += in_table_ / length * length;
    in_table_ %= length;
    const auto turn = cavity_->multiple(before_table_);
    table_x_ = turn.cosine * x_ - turn.sine * y_;
    table_y_ = turn.sine * x_ + turn.cosine * y_;
  }

  const Groove* cavity_;
  Real x_, y_;                     // before any turn
  std::int64_t before_table_ = 0;  // multiples turned before the table started again
  Real table_x_, table_y_;         // components after these
  std::int64_t in_table_ = 0;
  Real turned_y_;  // after all turns
};

}  // namespace vcavity
