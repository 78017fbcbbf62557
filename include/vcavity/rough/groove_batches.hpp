// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The grooves that lead light from one direction into another, several side by side in vector registers.
///
/// A batch has four consecutive numbers of bounces, and for each of them a pair of lanes: with panel one and with
/// panel two met first. Everything that the formulas of connecting_grooves.hpp ask for is computed for all lanes,
/// whether there is a groove or not: no branch depends on the directions but that on the number of batches. Where
/// branches decide, processors guess half of them wrong, and a wrong guess costs as much as a batch.
///
/// When not to use it: for single grooves; `ConnectingGrooves` has these.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/rough/connecting_grooves.hpp"
#include "vcavity/rough/way_series.hpp"

namespace vcavity {

/// Grooves of four consecutive numbers of bounces that lead light from one direction into another: in each pair of
/// lanes those of one number, with panel one and with panel two met first.
template <class Real>
struct GrooveBatch : GrooveWays<Pack<Real, 8>> {
  static constexpr std::size_t capacity = 8;
  static constexpr int bounce_counts = capacity / 2;
  using Lanes = Pack<Real, capacity>;

  int least_bounces;  ///< of the first pair of lanes; odd
  Lanes weight;       ///< BRDF × cosine per facet density D(m), for facets that reflect all light

  /// 0, 1, 2, …
  VCAVITY_INLINE static Lanes lane_numbers() {
    static constexpr std::array numbers{0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f};
    return Lanes::load(numbers.data());
  }

  /// 1 where panel one is met first, −1 where it is panel two.
  VCAVITY_INLINE static Lanes sides() {
    static constexpr std::array signs{1.0f, -1.0f, 1.0f, -1.0f, 1.0f, -1.0f, 1.0f, -1.0f};
    return Lanes::load(signs.data());
  }

  /// 1 where panel one is met last, −1 where it is panel two.
  VCAVITY_INLINE static Lanes leaving_sides() {
    static constexpr std::array signs{1.0f, -1.0f, -1.0f, 1.0f, 1.0f, -1.0f, -1.0f, 1.0f};
    return Lanes::load(signs.data());
  }

  /// The number of bounces of a lane.
  int bounces_of(std::size_t lane) const { return least_bounces + static_cast<int>(lane / 2); }

  /// The groove of a lane; there is one if its beam is above 0.
  ConnectingGroove<Real> operator[](std::size_t lane) const {
    return {lane % 2 == 0 ? Panel::one : Panel::two, bounces_of(lane), this->cos_half[lane],
            this->sin_half[lane], this->beam[lane]};
  }
};

/// Two ways with the same panel met first, of numbers of bounces two apart, or only the one of fewer.
template <class Real>
struct WayPair {
  Real elevation;  ///< of the light above the panel that is met first, in the plane across the groove
  Real sweep;      ///< jα, the same for both ways
  int bounces;     ///< of the first way
  bool has_both;   ///< whether there is one of two bounces more
};

/// All grooves that lead light from one direction into another, in batches: the first one, and then those of
/// `second`, `second` + 4, … bounces for as long as these `reach` so far.
template <class Real>
class GrooveBatches {
 public:
  using Batch = GrooveBatch<Real>;
  using Lanes = typename Batch::Lanes;

  /// The least number of bounces of the second batch.
  static constexpr int second = 1 + Batch::bounce_counts;
  static_assert(Batch::bounce_counts % 2 == 0, "a lane stays with one parity");

  /// @param grooves outlive this
  /// @param max_bounces light that needs more bounces is left out; at least 1
  VCAVITY_INLINE GrooveBatches(const ConnectingGrooves<Real>& grooves, int max_bounces)
      : GrooveBatches(
            grooves, max_bounces,
            // Of triangles that are |h| times as large: so no division by |h| comes first.
            detail::acute_angles(grooves.scale() * detail::pair_of(grooves.to_light().z, grooves.leaving().z),
                                 magnitude(detail::pair_of(grooves.along_h().x, grooves.along_h().y)))) {}

  /// Whether there may be grooves in a batch.
  /// @param least number of bounces of its first pair of lanes; odd and above 1
  VCAVITY_INLINE bool reach(int least) const {
    return least <= max_bounces_ && any_of(series_.have(bounces_from(least)));
  }

  /// The same, and in which lanes: bit i for lane i. Lane i + 4 has the same ways as lane i with two bounces more, and so
  /// one at most where lane i has one.
  VCAVITY_INLINE std::uint64_t lanes_reached(int least) const {
    return least <= max_bounces_ ? bits_of(series_.have(bounces_from(least))) : 0;
  }

  /// The two ways of a lane of the first half of a batch and of the lane half a batch on.
  /// @param reached the lanes that are reached
  VCAVITY_INLINE WayPair<Real> pair(int least, std::size_t lane, std::uint64_t reached) const {
    return {series_.elevation()[lane], series_.sweep()[lane], least + static_cast<int>(lane / 2),
            (reached >> (lane + Batch::bounce_counts) & 1) != 0};
  }

  /// The batch of one to four bounces.
  VCAVITY_INLINE Batch first() const {
    Batch batch = from(1);
    // One bounce has but one way, and that has all its digits; also in the mirror direction.
    const ConnectingGroove<Real> one = grooves_.first();
    batch.cos_half = with_first(one.cos_half, one.cos_half, batch.cos_half);
    batch.sin_half = with_first(one.sin_half, one.sin_half, batch.sin_half);
    batch.beam = with_first(one.beam, Real(0), batch.beam);
    batch.weight = with_first(grooves_.weight_of_first(), Real(0), batch.weight);
    return batch;
  }

  /// A further batch.
  /// @param least number of bounces of the first pair of lanes; odd
  VCAVITY_INLINE Batch from(int least) const {
    Batch batch{series_.ways(bounces_from(least)), least, {}};
    batch.beam = select(batch.bounces > Real(max_bounces_), Lanes(Real(0)), batch.beam);
    batch.weight = (batch.beam * batch.cos_half) * (scale_ * batch.inverse_bounces);
    return batch;
  }

 private:
  using Pair = detail::PairOf<Real>;

  /// Numbers of a batch of which those of one bounce, with panel one and with panel two met first, are given.
  VCAVITY_INLINE static Lanes with_first(const Real& panel_one, const Real& panel_two, const Lanes& others) {
    static constexpr std::array is_first{true, false, false, false, false, false, false, false},
        is_one_bounce{true, true, false, false, false, false, false, false};
    const Lanes of_one = Lanes::template blended<is_first>(Lanes(panel_one), Lanes(panel_two));
    return Lanes::template blended<is_one_bounce>(of_one, others);
  }

  /// @param low the elevations of e and o above the nearer horizon
  VCAVITY_INLINE GrooveBatches(const ConnectingGrooves<Real>& grooves, int max_bounces, const Pair& low)
      // Of an odd number of bounces, panel one and panel two first; then of an even one.
      : grooves_(grooves),
        series_(elevation(low[0], grooves.to_light().y * Batch::sides()),
                elevation(low[1], grooves.leaving().y * Batch::leaving_sides()), beams_of_one(grooves)),
        scale_(grooves.cos_eta() * (Real(0.5) / grooves.to_light().z)) {
    const bool is_tilted = grooves.tilt() > Real(0);
    // Finite, so that no light goes where there is no beam.
    scale_ = is_tilted ? at_most(Real(scale_ / grooves.tilt()), std::numeric_limits<Real>::max()) : Real(0);
    max_bounces_ = is_tilted ? max_bounces : 1;
  }

  /// 2 cos β of the series: β is half the sum of the angles that the directions make with the vertical in the plane
  /// across the groove, or half their difference if the number of bounces is even.
  VCAVITY_INLINE static Lanes beams_of_one(const ConnectingGrooves<Real>& grooves) {
    static constexpr std::array is_odd{true, true, false, false, true, true, false, false};
    const Real half_sum = grooves.first().sin_half;
    const Real half_difference = at_most(Real(grooves.cosine_of_first() / grooves.cos_eta()), Real(1));
    return Lanes::template blended<is_odd>(Lanes(Real(2) * half_sum), Lanes(Real(2) * half_difference));
  }

  /// Elevations above panels.
  /// @param low elevation above the nearer horizon
  /// @param along component of the direction across the groove, towards the panel
  VCAVITY_INLINE static detail::Elevation<Lanes> elevation(const Real& low, const Lanes& along) {
    const auto is_behind = along < Real(0);
    const Lanes near(low), far(pi<Real>() - low);
    return {select(is_behind, far, near), select(is_behind, near, far)};
  }

  /// The numbers of bounces of a batch.
  VCAVITY_INLINE static Lanes bounces_from(int least) {
    static constexpr std::array in_pairs{0.0f, 0.0f, 1.0f, 1.0f, 2.0f, 2.0f, 3.0f, 3.0f};
    return Lanes(Real(least)) + Lanes::load(in_pairs.data());
  }

  const ConnectingGrooves<Real>& grooves_;
  WaySeries<Lanes> series_;
  Real scale_;       // cos η/(2|h| e_z)
  int max_bounces_;  // 1 where only the groove of one bounce counts
};

/// Calls `visit` with every groove of at most `max_bounces` bounces, in ascending order of these.
template <class Real, class Visit>
void for_each_groove(const ConnectingGrooves<Real>& grooves, int max_bounces, Visit&& visit) {
  using Batch = GrooveBatch<Real>;
  const auto visit_batch = [&visit](const Batch& batch) {
    for (std::size_t lane = 0; lane < Batch::capacity; ++lane)
      if (batch.beam[lane] > Real(0)) visit(batch[lane]);
  };
  const GrooveBatches<Real> batches(grooves, max_bounces);
  visit_batch(batches.first());
  for (int least = batches.second; batches.reach(least); least += Batch::bounce_counts)
    visit_batch(batches.from(least));
}

}  // namespace vcavity
