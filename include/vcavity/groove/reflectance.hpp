// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Directional reflectance and absorptance of a grooved surface, exact in the position on the opening.
///
/// The directional-hemispherical reflectance for collimated light from a direction is, by Helmholtz
/// reciprocity, also the hemispherical-directional reflectance seen from that direction under diffuse light;
/// one function serves both.

#include "vcavity/facet/energy_balance.hpp"
#include "vcavity/groove/lobes.hpp"
#include "vcavity/numbers/compiler.hpp"

namespace vcavity {

namespace detail {

/// The sum of weight times `measure(throughput)` over the lobes of a direction.
template <class Sum, class Groove, class Real, class Facet, class Measure>
VCAVITY_INLINE Sum sum_over_lobes(const Groove& groove, const Vec3<Real>& e, const Facet& facet,
                                  const Measure& measure, const Follow& follow) {
  Sum sum(0);
  for_each_lobe(groove, e, facet,
                [&](const UnfoldedRay<Real>&, const Real& weight, const value_t<Facet, Real>& throughput) {
                  sum = sum + scaled(weight, measure(throughput));
                },
                {follow.max_bounces, DarkLight::merged, follow.first_panel});
  return sum;
}

}  // namespace detail

/// Directional reflectance R(θ, φ), Eq. 20 without its quadrature.
///
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light, or towards the viewer under diffuse light; e.z ≥ 0. Or a `Vec3` of a
///          `Pack`: as many directions at once, all with e.y ≥ 0; then the facet is one of packs too, see
///          `over_directions`
/// @param facet facet reflectance
/// @param max_bounces light that needs more bounces is left out
/// @return a value of the facet's type, or what its `power` makes of it
template <class Groove, class Facet, class Direction = Vec3<scalar_t<Groove>>>
  requires UnfoldableGroove<Groove, typename Direction::value_type> &&
           FacetReflectance<Facet, typename Direction::value_type>
auto directional_reflectance(const Groove& groove, const Direction& e, const Facet& facet,
                             int max_bounces = all_bounces) {
  using Real = typename Direction::value_type;
  return detail::sum_over_lobes<power_t<Facet, Real>>(
      groove, e, facet, [](const value_t<Facet, Real>& throughput) { return power(throughput); },
      {.max_bounces = max_bounces});
}

/// Directional reflectance of unpolarised light in any model of polarisation: `unpolarized` of the
/// directional reflectance, without computing what this leaves out of a Mueller matrix.
///
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light, or towards the viewer under diffuse light, or a pack of them, as for
///          `directional_reflectance`
/// @param facet facet reflectance
/// @param max_bounces light that needs more bounces is left out
/// @param first_panel light that meets another panel first is left out
template <class Groove, class Facet, class Direction = Vec3<scalar_t<Groove>>>
  requires UnfoldableGroove<Groove, typename Direction::value_type> &&
           FacetReflectance<Facet, typename Direction::value_type>
auto unpolarized_reflectance(const Groove& groove, const Direction& e, const Facet& facet,
                             int max_bounces = all_bounces, FirstPanel first_panel = {}) {
  using Real = typename Direction::value_type;
  return detail::sum_over_lobes<unpolarized_t<Facet, Real>>(
      groove, e, facet, [](const value_t<Facet, Real>& throughput) { return unpolarized(power(throughput)); },
      {.max_bounces = max_bounces, .first_panel = first_panel});
}

/// Directional absorptance 1 − R(θ, φ), and by Kirchhoff's law the directional emissivity; a sum of positive
/// terms that keeps its digits where the reflectance is close to 1.
///
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light or the observer, e.z ≥ 0
/// @param facet facet reflectance with a member `absorptance`, such as `Conductor`
template <class Groove, class Facet, class Direction = Vec3<scalar_t<Groove>>>
  requires UnfoldableGroove<Groove, typename Direction::value_type> &&
           AbsorbingFacet<Facet, typename Direction::value_type>
auto directional_absorptance(const Groove& groove, const Direction& e, const Facet& facet) {
  return directional_reflectance(groove, e, EnergyBalanced<Facet>(facet)).absorbed;
}

/// Mean number of bounces of the rays of a direction over the opening.
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light, e.z ≥ 0
template <class Groove>
  requires UnfoldableGroove<Groove, scalar_t<Groove>>
scalar_t<Groove> mean_bounces(const Groove& groove, const Vec3<scalar_t<Groove>>& e) {
  using Real = scalar_t<Groove>;
  Real mean(0);
  for_each_lobe(
      groove, e, [](const Real&) { return Real(1); },
      [&](const UnfoldedRay<Real>& last, const Real& weight, const Real&) {
        mean += weight * Real(last.number());
      });
  return mean;
}

}  // namespace vcavity
