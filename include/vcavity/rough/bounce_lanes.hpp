// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The light that goes through several grooves, with the reflectances of several bounces computed side by side.
///
/// Bounce i has the angle of incidence k − (i − ½)α in the plane across the groove, k being the elevation of the light
/// above the panel that is met first: its cosine, times cos η, is that of the facet. So no bounce needs the one before
/// it. Ways of up to eight bounces go side by side, one bounce of all ways of a batch after the other, whether there is
/// such a way or not; ways of more bounces one after the other, eight bounces of one side by side. In both cases the
/// facet is asked for eight directions at once, one component (colour) of its values after the other.
///
/// When not to use it: for facets that do not have `over_directions<n>(component)`, such as polarised ones, whose
/// values are no packs of numbers; `RoughGrooveBsdf` follows these bounce by bounce.

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/lane_reduction.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/render/bsdf.hpp"
#include "vcavity/rough/groove_batches.hpp"

namespace vcavity {

/// How many numbers a value consists of.
template <class Value>
inline constexpr std::size_t number_count = 0;
template <Number Value>
inline constexpr std::size_t number_count<Value> = 1;
template <class Real, std::size_t size, std::size_t most_bytes>
inline constexpr std::size_t number_count<Pack<Real, size, most_bytes>> = size;

/// A facet whose values are numbers or packs of them, of which every component can be had for several directions at
/// once. Cosines that rounding has moved beyond 0 or 1 must do no harm there.
template <class Facet, class Real>
concept ComponentsOverDirections =
    number_count<value_t<Facet, Real>> > 0 && requires(const Facet& facet, std::size_t i) {
      facet.template over_directions<GrooveBatch<Real>::capacity>(i);
    };

namespace detail {

/// A sum.
inline constexpr auto plus = [](const auto& a, const auto& b) { return a + b; };

/// A product.
inline constexpr auto times = [](const auto& a, const auto& b) { return a * b; };

/// A value of the first components of a pack.
template <class Value, class Components>
VCAVITY_INLINE Value value_of(const Components& components) {
  if constexpr (Number<Value>)
    return components[0];
  else if constexpr (std::is_same_v<Value, Components>)
    return components;
  else
    return Value(components);
}

}  // namespace detail

/// The directions at the bounces of a batch of ways, bounce by bounce, whether there is such a way or not.
/// @tparam least number of bounces of the first pair of lanes
template <class Real, int least>
class BounceRows {
 public:
  using Batch = GrooveBatch<Real>;
  using Lanes = typename Batch::Lanes;
  static constexpr std::size_t lanes = Batch::capacity;

  /// @param to_light the direction towards the light in the frame of the grooves
  /// @param batch the grooves
  VCAVITY_INLINE BounceRows(const Vec3<Real>& to_light, const Batch& batch) {
    const Lanes over_panel = to_light.y * Batch::sides();
    rows_[0] = {to_light.z * batch.sin_half + batch.cos_half * over_panel,
                to_light.z * batch.cos_half - batch.sin_half * over_panel};
    turn_from<1>(batch.sin_half, batch.cos_half);
    // The first bounces are those of every way; of the last three, each has two ways less. Where a way has none of
    // these, there is room for the very last.
    beyond_ = select(has(1), rows_[least].normal, rows_[least + 2].normal.template rearranged<from_end>());
  }

  /// The light that is left of each way.
  /// @param facet facet reflectance for the lanes
  /// @param white what goes each way for facets that reflect all light
  template <class Facet>
  VCAVITY_INLINE Lanes left_of(const Facet& facet, const Lanes& white) const {
    return left_of(facet, white, std::make_index_sequence<least>());
  }

 private:
  /// A direction in components along the normal of an image and along its panel.
  struct Direction {
    Lanes normal, tangent;
  };

  static constexpr std::size_t bounces = least + 3;
  static constexpr std::array<std::size_t, lanes> from_end{6, 7, 0, 1, 2, 3, 4, 5},
      to_end{2, 3, 4, 5, 6, 7, 0, 1};

  /// Turns the directions that are known by as many apertures, from image to image.
  template <std::size_t known>
  VCAVITY_INLINE void turn_from(const Lanes& half_sine, const Lanes& half_cosine) {
    if constexpr (known < bounces) {
      const Lanes sine = Real(2) * half_sine * half_cosine;
      const Lanes cosine = Lanes(Real(1)) - Real(2) * half_sine * half_sine;
      turn<known>(sine, cosine, std::make_index_sequence<std::min(known, bounces - known)>());
      turn_from<2 * known>(sine, cosine);
    }
  }
  // Without loops, compilers keep rows in registers.
  template <std::size_t known, std::size_t... i>
  VCAVITY_INLINE void turn(const Lanes& sine, const Lanes& cosine, std::index_sequence<i...>) {
    ((rows_[known + i] = {cosine * rows_[i].normal + sine * rows_[i].tangent,
                          cosine * rows_[i].tangent - sine * rows_[i].normal}),
     ...);
  }

  template <class Facet, std::size_t... i>
  VCAVITY_INLINE Lanes left_of(const Facet& facet, const Lanes& white, std::index_sequence<i...>) const {
    const Lanes one(Real(1)), beyond = facet(beyond_);
    const Lanes last = select(has(3), white * beyond.template rearranged<to_end>(), white) *
                       select(has(2), facet(rows_[least + 1].normal), one);
    return (last * ... * facet(rows_[i].normal)) * select(has(1), beyond, one);
  }

  /// Where ways have so many bounces beyond the first ones.
  VCAVITY_INLINE static auto has(int further) { return Batch::lane_numbers() >= Real(2 * further); }

  std::array<Direction, bounces> rows_;
  Lanes beyond_;
};

/// Light that goes through several grooves, lane by lane.
/// @tparam components of the light
template <class Real, std::size_t components>
struct LightInLanes {
  using Lanes = typename GrooveBatch<Real>::Lanes;

  std::array<Lanes, components> light;  ///< each component
  Lanes white;                          ///< the same for facets that reflect all light

  VCAVITY_INLINE friend LightInLanes operator+(const LightInLanes& a, const LightInLanes& b) {
    LightInLanes sum;
    for (std::size_t c = 0; c < components; ++c) sum.light[c] = a.light[c] + b.light[c];
    sum.white = a.white + b.white;
    return sum;
  }

  /// All of it.
  template <class Value>
  VCAVITY_INLINE BsdfEvaluation<Real, Value> sum() const {
    std::array<Lanes, components + 1> all;
    for (std::size_t c = 0; c < components; ++c) all[c] = light[c];
    all[components] = white;
    const auto sums = detail::combined_lanes(detail::plus, all);
    return {detail::value_of<Value>(sums), sums[components]};
  }
};

/// The light of a batch of ways of few bounces.
/// @tparam least number of bounces of the first pair of lanes
/// @param facet facet reflectance
/// @param to_light the direction towards the light in the frame of the grooves
/// @param batch the grooves
/// @param white what goes through each for facets that reflect all light
template <int least, class Real, ComponentsOverDirections<Real> Facet>
VCAVITY_INLINE auto light_of_short_ways(const Facet& facet, const Vec3<Real>& to_light,
                                        const GrooveBatch<Real>& batch,
                                        const typename GrooveBatch<Real>::Lanes& white) {
  using Rows = BounceRows<Real, least>;
  constexpr std::size_t components = number_count<value_t<Facet, Real>>;
  const Rows rows(to_light, batch);
  LightInLanes<Real, components> result;
  for (std::size_t c = 0; c < components; ++c)
    result.light[c] = rows.left_of(facet.template over_directions<Rows::lanes>(c), white);
  result.white = white;
  return result;
}

/// Adds the light of a batch, two ways at a time.
/// @param sum what it is added to
/// @param facet facet reflectance
/// @param cos_eta cos η, the length of the direction of the light in the plane across the groove
/// @param batch the grooves
/// @param white what goes through each for facets that reflect all light
template <class Real, ComponentsOverDirections<Real> Facet>
VCAVITY_NOINLINE void add_long_ways(value_t<Facet, Real>& sum, const Facet& facet, Real cos_eta,
                                    const GrooveBatch<Real>& batch,
                                    const typename GrooveBatch<Real>::Lanes& white) {
  using Batch = GrooveBatch<Real>;
  using Lanes = typename Batch::Lanes;
  constexpr std::size_t lanes = Batch::capacity;
  constexpr std::size_t components = number_count<value_t<Facet, Real>>;
  using Two = Pack<Real, 2 * lanes>;
  std::array<std::size_t, lanes + 1> ways;
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    ways[count] = lane;
    count += white[lane] > Real(0) ? 1 : 0;
  }
  ways[count] = 0;
  // Added up by themselves, as their densities are: so that the light does not exceed these by rounding.
  value_t<Facet, Real> of_batch(0);
  const auto both = [](const Real& first, const Real& second) {
    return Two(std::array{Lanes(first), Lanes(second)});
  };
  for (std::size_t way = 0; way < count; way += 2) {
    // Where there is no second way, any will do, without light.
    const std::size_t a = ways[way], b = ways[way + 1];
    const Real bounces_b = way + 1 < count ? batch.bounces[b] : Real(0);
    const Two bounces = both(batch.bounces[a], bounces_b);
    const Two elevation = both(batch.elevation[a], batch.elevation[b]);
    const Two aperture = both(Real(2) * batch.half_aperture[a], Real(2) * batch.half_aperture[b]);
    Two number(std::array{Batch::lane_numbers(), Batch::lane_numbers()});
    number = number + Two(Real(0.5));  // of the bounce, less ½
    std::array<Two, components> products;
    products.fill(Two(Real(1)));
    const Real most = at_least(Real(batch.bounces[a]), bounces_b);
    for (Real done(0); done < most; done += Real(static_cast<int>(lanes))) {
      const auto exists = bounces > number;
      const Two angle = select(exists, elevation - aperture * number, Two(Real(0)));
      const Two incidence = cos_eta * detail::acute_cosine(angle);
      for (std::size_t c = 0; c < components; ++c) {
        const Two reflectance = facet.template over_directions<2 * lanes>(c)(incidence);
        products[c] = select(exists, products[c] * reflectance, products[c]);
      }
      number = number + Two(Real(static_cast<int>(lanes)));
    }
    for (std::size_t i = 0; i < 2; ++i) {
      std::array<Lanes, components> half;
      for (std::size_t c = 0; c < components; ++c) half[c] = products[c].template slice<lanes>(i);
      const Real light = i == 0 ? white[a] : way + 1 < count ? white[b] : Real(0);
      const auto throughput = detail::combined_lanes(detail::times, half);
      of_batch = of_batch + scaled(light, detail::value_of<value_t<Facet, Real>>(throughput));
    }
  }
  sum = sum + of_batch;
}

}  // namespace vcavity
