// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The light that goes through several grooves, with the reflectances of several bounces computed side by side.
///
/// Bounce i has the angle of incidence k − (i − ½)α in the plane across the groove, k being the elevation of the light
/// above the panel that is met first: its cosine, times cos η, is that of the facet. So no bounce needs the one before
/// it. Ways of few bounces go side by side, one bounce of all of them after the other, whether there is such a way or
/// not; ways of many bounces one after the other, eight bounces of one side by side. In both cases the facet is asked
/// for eight directions at once, one component (colour) of its values after the other.
///
/// When not to use it: for facets that do not have `over_directions<n>(component)`, such as polarised ones, whose
/// values are no packs of numbers; `RoughGrooveBsdf` follows these bounce by bounce.

#include <array>
#include <cstddef>
#include <type_traits>

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

/// Adds the light of the first batch, of one to four bounces.
/// @param sum what it is added to
/// @param facet facet reflectance
/// @param to_light the direction towards the light in the frame of the grooves
/// @param batch the grooves
/// @param white what goes through each for facets that reflect all light
template <class Real, ComponentsOverDirections<Real> Facet>
VCAVITY_INLINE void add_short_ways(BsdfEvaluation<Real, value_t<Facet, Real>>& sum, const Facet& facet,
                                   const Vec3<Real>& to_light, const GrooveBatch<Real>& batch,
                                   const typename GrooveBatch<Real>::Lanes& white) {
  using Lanes = typename GrooveBatch<Real>::Lanes;
  constexpr std::size_t lanes = GrooveBatch<Real>::capacity;
  constexpr std::size_t most_bounces = GrooveBatch<Real>::bounce_counts;
  constexpr std::size_t components = number_count<value_t<Facet, Real>>;
  using AllBounces = Pack<Real, most_bounces * lanes>;

  // The direction in components along the normal of the image and along the panel, turned from image to image.
  const Lanes over_panel = to_light.y * GrooveBatch<Real>::sides();
  const Lanes normal = to_light.z * batch.sin_half + batch.cos_half * over_panel;
  const Lanes tangent = to_light.z * batch.cos_half - batch.sin_half * over_panel;
  const Lanes sine = Real(2) * batch.sin_half * batch.cos_half;
  const Lanes cosine = Lanes(Real(1)) - Real(2) * batch.sin_half * batch.sin_half;
  const Lanes twice_sine = Real(2) * sine * cosine;
  const Lanes twice_cosine = Lanes(Real(1)) - Real(2) * sine * sine;
  const Lanes second_normal = cosine * normal + sine * tangent;
  const Lanes second_tangent = cosine * tangent - sine * normal;
  const AllBounces incidence(std::array{normal, second_normal, twice_cosine * normal + twice_sine * tangent,
                                        twice_cosine * second_normal + twice_sine * second_tangent});
  std::array<Lanes, components + 1> light;
  for (std::size_t c = 0; c < components; ++c) {
    const AllBounces reflectance = facet.template over_directions<most_bounces * lanes>(c)(incidence);
    light[c] = reflectance.template slice<lanes>(0);
    for (std::size_t i = 1; i < most_bounces; ++i) {
      const auto exists = GrooveBatch<Real>::lane_numbers() >= Real(static_cast<int>(2 * i));
      light[c] = select(exists, light[c] * reflectance.template slice<lanes>(i), light[c]);
    }
    light[c] = light[c] * white;
  }
  light[components] = white;
  const auto sums = detail::combined_lanes(detail::plus, light);
  sum.value = sum.value + detail::value_of<value_t<Facet, Real>>(sums);
  sum.pdf += sums[components];
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
