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

  /// The number of bounces of a lane.
  int bounces_of(std::size_t lane) const { return least_bounces + static_cast<int>(lane / 2); }

  /// The groove of a lane; there is one if its beam is above 0.
  ConnectingGroove<Real> operator[](std::size_t lane) const {
    return {lane % 2 == 0 ? Panel::one : Panel::two, bounces_of(lane), this->cos_half[lane],
            this->sin_half[lane], this->beam[lane]};
  }
};

/// All grooves that lead light from one direction into another, in batches: the first one, and then those of
/// `second`, `second` + 4, … to `last` bounces.
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
      : GrooveBatches(grooves, max_bounces,
                      detail::acute_angles(pair(grooves.to_light().z, grooves.leaving().z),
                                           magnitude(pair(grooves.to_light().y, grooves.leaving().y)))) {}

  /// No light goes a way of more bounces than this.
  int last() const { return last_; }

  /// The batch of one to four bounces.
  VCAVITY_INLINE Batch first() const {
    Batch batch = from(1);
    // One bounce has but one way, and that has all its digits; also in the mirror direction.
    static constexpr std::array is_of_one{1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    static constexpr std::array exists{1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const auto mask = Lanes::load(is_of_one.data()) > Real(0);
    const Lanes existing = Lanes::load(exists.data());
    const ConnectingGroove<Real> one = grooves_.first();
    batch.cos_half = select(mask, Lanes(one.cos_half), batch.cos_half);
    batch.sin_half = select(mask, Lanes(one.sin_half), batch.sin_half);
    batch.beam = select(mask, one.beam * existing, batch.beam);
    batch.weight = select(mask, grooves_.density(one, Real(1)) * existing, batch.weight);
    return batch;
  }

  /// A further batch.
  /// @param least number of bounces of the first pair of lanes; odd
  VCAVITY_INLINE Batch from(int least) const {
    static constexpr std::array in_pairs{0.0f, 0.0f, 1.0f, 1.0f, 2.0f, 2.0f, 3.0f, 3.0f};
    Batch batch{series_.ways(Lanes(Real(least)) + Lanes::load(in_pairs.data())), least, {}};
    batch.beam = select(batch.bounces > Real(last_), Lanes(Real(0)), batch.beam);
    batch.weight = scale_ * (batch.beam * ((inverse_tilt_ * batch.cos_half) / batch.bounces));
    return batch;
  }

 private:
  /// Numbers of e and of o, side by side; twice where registers are that wide.
  using Pair = Pack<Real, detail::has_short_series<Real> ? 4 : 2>;

  /// @param low the elevations of e and o above the nearer horizon
  VCAVITY_INLINE GrooveBatches(const ConnectingGrooves<Real>& grooves, int max_bounces, const Pair& low)
      // Of an odd number of bounces, panel one and panel two first; then of an even one.
      : grooves_(grooves),
        series_(elevation(low[0], grooves.to_light().y * Batch::sides()),
                elevation(low[1], grooves.leaving().y * leaving_sides())),
        scale_(grooves.cos_eta() / (Real(2) * grooves.to_light().z)) {
    const bool is_tilted = grooves.tilt() > Real(0);
    inverse_tilt_ = is_tilted ? Real(Real(1) / grooves.tilt()) : Real(0);
    const Real most = is_tilted ? largest_of(series_.most_bounces()) : Real(1);
    last_ = most < Real(max_bounces) ? static_cast<int>(most) : max_bounces;
  }

  VCAVITY_INLINE static Pair pair(const Real& of_e, const Real& of_o) {
    static constexpr std::array is_of_o{0.0f, 1.0f, 0.0f, 1.0f};
    return select(Pair::load(is_of_o.data()) > Real(0), Pair(of_o), Pair(of_e));
  }

  /// 1 where light leaves over panel one, −1 where over panel two.
  VCAVITY_INLINE static Lanes leaving_sides() {
    static constexpr std::array signs{1.0f, -1.0f, -1.0f, 1.0f, 1.0f, -1.0f, -1.0f, 1.0f};
    return Lanes::load(signs.data());
  }

  /// Elevations above panels.
  /// @param low elevation above the nearer horizon
  /// @param along component of the direction across the groove, towards the panel
  VCAVITY_INLINE static detail::Elevation<Lanes> elevation(const Real& low, const Lanes& along) {
    const auto is_behind = along < Real(0);
    const Lanes near(low), far(pi<Real>() - low);
    return {select(is_behind, far, near), select(is_behind, near, far)};
  }

  /// The largest of the first four lanes, which are all that differ.
  VCAVITY_INLINE static Real largest_of(const Lanes& a) {
    const Real of_odd = a[0] < a[1] ? a[1] : a[0], of_even = a[2] < a[3] ? a[3] : a[2];
    return of_odd < of_even ? of_even : of_odd;
  }

  const ConnectingGrooves<Real>& grooves_;
  WaySeries<Lanes> series_;
  Real scale_;  // cos η/(2 e_z)
  Real inverse_tilt_;
  int last_;
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
  for (int least = batches.second; least <= batches.last(); least += Batch::bounce_counts)
    visit_batch(batches.from(least));
}

}  // namespace vcavity
