// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Multiples of half the aperture: their cosines and sines in a table, and directions turned by them, so that no
/// trigonometric function is evaluated from bounce to bounce.
///
/// Method. The table holds no more multiples than the bounces of the groove need, and at most 15, which is enough
/// for apertures of 26° and more. Where it ends, in narrow grooves, a direction is turned from its beginning to
/// there, and the table serves again: so no rounding adds up, however many bounces there are.
///
/// When not to use it: from outside; `Cavity::multiple` gives any multiple, and `UnfoldedRay` turns rays.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// Cosine and sine of an angle.
template <class Real>
struct Rotation {
  Real cosine;
  Real sine;
};

/// Cosine and sine of half an aperture. The nearest float to π lies above π; the panels of a flat surface must not bend
/// the other way.
/// @param aperture in (0, π]
template <class Real>
Rotation<Real> half_rotation(const Real& aperture) {
  using std::cos;
  using std::sin;
  return {at_least(Real(cos(aperture / Real(2))), Real(0)), sin(aperture / Real(2))};
}

/// Cosines and sines of kα/2, k = 0, 1, 2, …, of a groove of aperture α.
template <class Real>
class HalfApertureMultiples {
 public:
  /// The largest number of multiples that are kept.
  static constexpr int max_tabulated = 15;

  /// @param aperture α, in (0, π]
  /// @param half cosine and sine of α/2
  /// @param max_bounces of any ray: the image behind its last bounce is the one of number `max_bounces + 1`
  HalfApertureMultiples(const Real& aperture, const Rotation<Real>& half, int max_bounces)
      : aperture_(aperture), tabulated_(needed(max_bounces)) {
    using std::cos;
    using std::sin;
    begin(half);
    for (int k = 2; k <= tabulated_; ++k) {
      const Real angle = Real(k) * (aperture / Real(2));
      table_[static_cast<std::size_t>(k)] = {cos(angle), sin(angle)};
    }
  }

  /// The same by the addition theorem, of a known angle.
  /// @param aperture α, in (0, π]
  /// @param half cosine and sine of α/2
  /// @param max_bounces of any ray
  /// @return as many multiples, each wrong by less than an ε more than the one before
  static HalfApertureMultiples by_addition(const Real& aperture, const Rotation<Real>& half,
                                           int max_bounces) {
    HalfApertureMultiples result(aperture, needed(max_bounces));
    result.begin(half);
    result.max_bounces_ = max_bounces;
    // Their number is odd: see `needed`.
    for (std::size_t k = 1; 2 * k < static_cast<std::size_t>(result.tabulated_); ++k) {
      result.add(k, k);
      result.add(k, k + 1);
    }
    return result;
  }

  /// The same by the addition theorem, without trigonometric functions; the angle is known only where it is asked
  /// for. Enough for all bounces if `max_bounces` is not 0.
  /// @param half cosine and sine of α/2
  explicit HalfApertureMultiples(const Rotation<Real>& half) : aperture_(0) {
    begin(half);
    constexpr int most = max_tabulated / 2;
    for (max_bounces_ = 1; max_bounces_ <= most; ++max_bounces_) {
      const auto m = static_cast<std::size_t>(max_bounces_);
      add(m, m);
      add(m, m + 1);
      // An aperture within rounding of π/m counts as π/m, here as in `Cavity::max_bounces`.
      const Real rounding = Real(4 * (3 + max_bounces_)) * std::numeric_limits<Real>::epsilon();
      const Rotation<Real>& turn = table_[2 * m];
      if (turn.sine < Real(0) || (turn.sine <= rounding && turn.cosine < Real(0))) break;
    }
    tabulated_ = 2 * max_bounces_ + 1;
    if (max_bounces_ > most) max_bounces_ = 0;
  }

  /// The angle α.
  Real aperture() const {
    if constexpr (Number<Real>) {
      using std::atan2;
      return aperture_ > Real(0) ? aperture_ : Real(Real(2) * atan2(table_[1].sine, table_[1].cosine));
    } else {
      return aperture_;  // where angles are packs, they are given
    }
  }

  /// The first m with mα ≥ π, found by the addition theorem; 0 if it was not, or the table is too short for it.
  int max_bounces() const { return max_bounces_; }

  /// The number of multiples that are kept.
  int tabulated() const { return tabulated_; }

  /// Cosine and sine of kα/2, for k in [0, tabulated()].
  const Rotation<Real>& operator[](std::int64_t k) const { return table_[static_cast<std::size_t>(k)]; }

  /// Cosine and sine of kα/2, for any k ≥ 0.
  VCAVITY_INLINE Rotation<Real> at(std::int64_t k) const {
    return k <= tabulated_ ? (*this)[k] : computed(k);
  }

  /// The same, best for those that are not kept.
  VCAVITY_INLINE Rotation<Real> computed(std::int64_t k) const {
    using std::cos;
    using std::sin;
    const Real angle = Real(k) * (aperture() / Real(2));
    return {cos(angle), sin(angle)};
  }

 private:
  /// The ray behind the last bounce is at image max_bounces + 1, at an odd multiple.
  static int needed(int max_bounces) {
    return max_bounces < max_tabulated / 2 ? 2 * max_bounces + 1 : max_tabulated;
  }

  HalfApertureMultiples(const Real& aperture, int tabulated) : aperture_(aperture), tabulated_(tabulated) {}

  void begin(const Rotation<Real>& half) {
    table_[0] = {Real(1), Real(0)};
    table_[1] = half;
  }

  void add(std::size_t i, std::size_t j) {
    const Rotation<Real>&a = table_[i], &b = table_[j];
    table_[i + j] = {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
  }

  Real aperture_;  // 0 where it has not been asked for
  int max_bounces_ = 0;
  int tabulated_;
  std::array<Rotation<Real>, max_tabulated + 1> table_{};  // 0 behind those that are kept
};

/// A direction in the plane across the groove, turned by multiples of α/2.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
class TurnedDirection {
 public:
  using Multiples = HalfApertureMultiples<scalar_t<Real>>;

  /// @param up,across components before any turn
  TurnedDirection(const Real& up, const Real& across)
      : up_(up), across_(across), table_up_(up), table_across_(across) {}

  /// Turns on, from up towards across.
  /// @param multiples those of the groove
  /// @param count so many multiples of α/2
  VCAVITY_INLINE void turn(const Multiples& multiples, std::int64_t count) {
    in_table_ += count;
    if (in_table_ > Multiples::max_tabulated) start_table_again(multiples);
  }

  /// The component across after all turns.
  VCAVITY_INLINE Real across(const Multiples& multiples) const {
    const auto& turn = multiples[in_table_];
    return turn.sine * table_up_ + turn.cosine * table_across_;
  }

  /// The component up after all turns.
  Real up(const Multiples& multiples) const {
    const auto& turn = multiples[in_table_];
    return turn.cosine * table_up_ - turn.sine * table_across_;
  }

 private:
  void start_table_again(const Multiples& multiples) {
    constexpr std::int64_t length = Multiples::max_tabulated + 1;
    before_table_ += in_table_ / length * length;
    in_table_ %= length;
    const auto turn = multiples.computed(before_table_);
    table_up_ = turn.cosine * up_ - turn.sine * across_;
    table_across_ = turn.sine * up_ + turn.cosine * across_;
  }

  Real up_, across_;               // before any turn
  std::int64_t before_table_ = 0;  // multiples turned before the table started again
  Real table_up_, table_across_;   // after these
  std::int64_t in_table_ = 0;      // multiples turned since
};

}  // namespace vcavity
