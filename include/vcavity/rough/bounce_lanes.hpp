// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The reflectances of all bounces of a way through a groove, computed side by side.
///
/// Bounce i has the angle of incidence k − (i − ½)α in the plane across the groove, k being the elevation of the light
/// above the panel that is met first: its cosine, times cos η, is that of the facet. So no bounce needs the one before
/// it, and the facet is asked for several at once, one component (colour) of its values after the other.
///
/// When not to use it: for facets that do not have `over_directions<n>(component)`, such as polarised ones, whose
/// values are no packs of numbers; `RoughGrooveBsdf` follows these bounce by bounce.

#include <array>
#include <cstddef>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/rough/connecting_grooves.hpp"

namespace vcavity {

/// How many numbers a value consists of.
template <class Value>
inline constexpr std::size_t number_count = 0;
template <Number Value>
inline constexpr std::size_t number_count<Value> = 1;
template <class Real, std::size_t size, std::size_t most_bytes>
inline constexpr std::size_t number_count<Pack<Real, size, most_bytes>> = size;

/// A facet whose values are numbers or packs of them, of which every component can be had for several directions at
/// once.
template <class Facet, class Real>
concept ComponentsOverDirections =
    number_count<value_t<Facet, Real>> > 0 && requires(const Facet& facet, std::size_t i) {
      facet.template over_directions<GrooveBatch<Real>::capacity>(i);
    };

/// The product of the reflectances of all bounces of a way.
/// @param facet facet reflectance
/// @param cos_eta cos η, the length of the direction of the light in the plane across the groove
/// @param elevation of the light above the panel that is met first, in that plane
/// @param half_aperture α/2
/// @param bounces how many there are
template <class Real, ComponentsOverDirections<Real> Facet>
VCAVITY_INLINE value_t<Facet, Real> throughput_in_lanes(const Facet& facet, const Real& cos_eta,
                                                        const Real& elevation, const Real& half_aperture,
                                                        int bounces) {
  using Value = value_t<Facet, Real>;
  using Lanes = typename GrooveBatch<Real>::Lanes;
  constexpr std::size_t lanes = GrooveBatch<Real>::capacity;
  constexpr std::size_t components = number_count<Value>;
  std::array<Lanes, components> products;
  products.fill(Lanes(Real(1)));
  Lanes number = GrooveBatch<Real>::lane_numbers() + Lanes(Real(0.5));  // of the bounce, less ½
  const Real aperture = Real(2) * half_aperture;
  for (int done = 0; done < bounces; done += static_cast<int>(lanes)) {
    const auto exists = number < Real(bounces);
    const Lanes angle = select(exists, Lanes(elevation) - aperture * number, Lanes(Real(0)));
    const Lanes cosine = at_least(cos_eta * detail::acute_cosine(angle), Real(0));
    for (std::size_t c = 0; c < components; ++c) {
      const Lanes reflectance = facet.template over_directions<lanes>(c)(cosine);
      products[c] = products[c] * select(exists, reflectance, Lanes(Real(1)));
    }
    number = number + Lanes(Real(static_cast<int>(lanes)));
  }
  std::array<Real, components> result;
  for (std::size_t c = 0; c < components; ++c) {
    Lanes& product = products[c];
    for (std::size_t half = lanes / 2; half > 0; half /= 2)
      for (std::size_t lane = 0; lane < half; ++lane) product[lane] *= product[lane + half];
    result[c] = product[0];
  }
  if constexpr (Number<Value>)
    return result[0];
  else
    return Value(result);
}

}  // namespace vcavity
