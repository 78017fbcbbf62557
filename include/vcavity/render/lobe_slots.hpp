// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The lobes of many directions at once, for renderers that follow a packet of paths in lockstep.
///
/// Rays of one direction that meet a given panel first of a symmetric groove bounce j or j + 1 times, never more
/// differently: their distances from the apex span an angle of at most the aperture. So a direction has one lobe of an
/// odd and one of an even number of bounces for each first panel, and each of these four has its own slot. Of panels
/// of unequal length some rays may pass the shorter one after their first bounce; the others bounce j, j + 1 or j + 2
/// times, for images fall off within two apertures of a right angle. So there are four slots for each first panel, that
/// of one bounce, and of more those of each remainder by three. All directions of a packet fill their slots in the same
/// few steps, as many as the groove has bounces at most; masks decide what counts, and nothing branches on a direction.
///
/// When not to use it: for directions that come one by one; `GrooveBsdf` stops at their last bounce.

#include <array>
#include <cstddef>

#include "vcavity/conventions.hpp"
#include "vcavity/groove/asymmetric_groove.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/lobes.hpp"
#include "vcavity/groove/unfoldable_groove.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A lobe that some directions of a packet have.
/// @tparam Real a `Pack` of numbers, one for each direction
/// @tparam Power what `power` makes of the values of a facet
template <class Real, class Power>
struct LobeSlot {
  Real weight =
      Real(scalar_t<Real>(0));  ///< fraction of the opening; 0 for directions that have no such lobe
  Power light = Power(0);       ///< weight × throughput
  /// In which the light travels after its last bounce; has a meaning only where the weight is not 0.
  Vec3<Real> direction = {Real(scalar_t<Real>(0)), Real(scalar_t<Real>(0)), Real(scalar_t<Real>(1))};
};

/// The slots of a packet of directions.
/// @tparam count how many, `max_lobes` of the groove
template <class Real, class Power, std::size_t count = 4>
using LobeSlots = std::array<LobeSlot<Real, Power>, count>;

/// The slot of a lobe of a symmetric groove: even and odd numbers of bounces that meet panel one first, then the same
/// of panel two.
/// @param first_panel the panel met first
/// @param bounces number of reflections, at least 1
template <class Real>
constexpr std::size_t slot_of(const Cavity<Real>&, Panel first_panel, int bounces) {
  return (first_panel == Panel::one ? 0u : 2u) + static_cast<std::size_t>(bounces % 2);
}

/// The same of an asymmetric groove: one bounce on panel one, then more by their remainder; and the same of panel two.
template <class Real>
constexpr std::size_t slot_of(const AsymmetricGroove<Real>&, Panel first_panel, int bounces) {
  return (first_panel == Panel::one ? 0u : 4u) +
         (bounces == 1 ? 0u : 1u + static_cast<std::size_t>(bounces % 3));
}

namespace detail {

/// Component by component, `a` where a mask is set and `b` elsewhere.
template <class Mask, class Real>
Vec3<Real> select_direction(const Mask& mask, const Vec3<Real>& a, const Vec3<Real>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

}  // namespace detail

/// The lobes of many directions at once. Panel one of a symmetric groove is the one that faces the light: directions
/// with e.y < 0 are to be mirrored before, and their lobes after.
/// @param groove a `Cavity` or an `AsymmetricGroove`: one for all directions or, if it is made of packs itself, one for
///        each
/// @param e directions towards the light, all with e.z ≥ 0, and with e.y ≥ 0 if the groove is symmetric
/// @param facet facet reflectance of packs, see `over_directions`
/// @param max_bounces lobes of more bounces are left out
/// @return the lobes in the order of `slot_of`
template <class Groove, class Real, FacetReflectance<Real> Facet>
  requires UnfoldableGroove<Groove, Real>
LobeSlots<Real, power_t<Facet, Real>, Groove::max_lobes> lobe_slots(const Groove& groove, const Vec3<Real>& e,
                                                                    const Facet& facet,
                                                                    int max_bounces = all_bounces) {
  using Power = power_t<Facet, Real>;
  LobeSlots<Real, Power, Groove::max_lobes> slots;
  for_each_lobe(groove, e, facet,
                [&](const UnfoldedRay<Real>& last, const Real& weight, const auto& throughput) {
                  LobeSlot<Real, Power>& slot = slots[slot_of(groove, last.first_panel(), last.number())];
                  slot.weight = slot.weight + weight;
                  slot.light = slot.light + scaled(weight, power(throughput));
                  slot.direction = detail::select_direction(weight > scalar_t<Real>(0),
                                                            exit_direction(groove, last), slot.direction);
                },
                {.max_bounces = max_bounces});
  return slots;
}

/// A direction drawn for each direction of a packet.
template <class Real, class Power>
struct SlotSample {
  Vec3<Real> direction;  ///< in which the light of the drawn lobe travels
  Power light;  ///< weight × throughput of the lobe; by its probability it is BSDF × cosine / probability
  Real probability;  ///< of the lobe; 0 where no light is left and nothing is drawn
};

/// The probabilities of drawing each slot, in proportion to its light.
/// @param slots of the directions
/// @param energy called with weight × throughput, gives a number ≥ 0 for each direction
/// @return numbers that add up to 1; all 0 where no light is left
template <class Real, class Power, std::size_t count, class Energy>
std::array<Real, count> slot_probabilities(const std::array<LobeSlot<Real, Power>, count>& slots,
                                           Energy&& energy) {
  using Scalar = scalar_t<Real>;
  std::array<Real, count> result;
  Real sum(Scalar(0));
  for (std::size_t i = 0; i < slots.size(); ++i) {
    result[i] = energy(slots[i].light);
    sum = sum + result[i];
  }
  const Real inverse = Real(Scalar(1)) / at_least(sum, smallest_divisor<Scalar>());
  for (Real& probability : result) probability = probability * inverse;
  return result;
}

/// Draws a slot for each direction, never one of probability 0.
/// @param slots of the directions
/// @param odds their probabilities
/// @param u random numbers, uniform in [0, 1]
template <class Real, class Power, std::size_t count>
SlotSample<Real, Power> drawn_slot(const std::array<LobeSlot<Real, Power>, count>& slots,
                                   const std::array<Real, count>& odds, const Real& u) {
  using Scalar = scalar_t<Real>;
  const Real none(Scalar(0)), one(Scalar(1));
  SlotSample<Real, Power> result{slots[0].direction, Power(0), none};
  Real left = u, is_open = one;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const auto is_candidate = Real(is_open * odds[i]) > Scalar(0);
    const Real taken = select(is_candidate, one, none);
    result.direction = detail::select_direction(is_candidate, slots[i].direction, result.direction);
    result.light = scaled(Real(one - taken), result.light) + scaled(taken, slots[i].light);
    result.probability = select(is_candidate, odds[i], result.probability);
    is_open = select(is_candidate, select(odds[i] > left, none, one), is_open);
    left = select(is_candidate, Real(left - odds[i]), left);
  }
  return result;
}

}  // namespace vcavity
