// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Directional reflectance and absorptance of a grooved surface, exact in the position on the opening.
///
/// The directional-hemispherical reflectance for collimated light from a direction is, by Helmholtz
/// reciprocity, also the hemispherical-directional reflectance seen from that direction under diffuse light;
/// one function serves both.

#include <optional>

#include "vcavity/facet/energy_balance.hpp"
#include "vcavity/groove/lobes.hpp"
#include "vcavity/numbers/inline.hpp"

namespace vcavity {

namespace detail {

/// The sum of weight times `measure(throughput)` over the lobes of a direction.
/// @param only if given, light that meets the other panel first is left out
template <class Sum, class Real, class Facet, class Measure>
VCAVITY_INLINE Sum sum_over_lobes(const Cavity<scalar_t<Real>>& cavity, const Vec3<Real>& e,
                                  const Facet& facet, int most_bounces, const Measure& measure,
                                  std::optional<Panel> only = std::nullopt) {
  using Value = value_t<Facet, Real>;
  Sum sum(0);
  for_each_lobe(
      cavity, e, facet, most_bounces,
      [&](const PanelImages<Real>&, const Real& weight, const Value& throughput) {
        if (cheaper_than_branch<Value> || any_positive(weight))
          sum = sum + scaled(weight, measure(throughput));
      },
      DarkLight::merged, only);
  return sum;
}

}  // namespace detail

/// Directional reflectance R(θ, φ), Eq. 20 without its quadrature.
///
/// @tparam Real number type, or a `Pack` of numbers for as many directions at once, all with e.y ≥ 0; then
/// the
///         facet is one of packs too, see `over_directions`
/// @param e direction towards the light, or towards the viewer under diffuse light; e.z ≥ 0. Or a `Vec3` of a
/// `Pack`:
///        as many directions at once, all with e.y ≥ 0; then the facet is one of packs too, see
///        `over_directions`
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param most_bounces light that needs more bounces is left out
/// @return a value of the facet's type, or what its `power` makes of it
template <class Scalar, class Facet, class Direction = Vec3<Scalar>>
  requires FacetReflectance<Facet, typename Direction::value_type>
auto directional_reflectance(const Cavity<Scalar>& cavity, const Direction& e, const Facet& facet,
                             int most_bounces = all_bounces) {
  using Real = typename Direction::value_type;
  return detail::sum_over_lobes<power_t<Facet, Real>>(
      cavity, e, facet, most_bounces,
      [](const value_t<Facet, Real>& throughput) { return power(throughput); });
}

/// Directional reflectance of unpolarised light in any model of polarisation: `unpolarized` of the
/// directional reflectance, without computing what this leaves out of a Mueller matrix. The parameters are
/// the same, and
/// @param only if given, light that meets the other panel first is left out
template <class Scalar, class Facet, class Direction = Vec3<Scalar>>
  requires FacetReflectance<Facet, typename Direction::value_type>
auto unpolarized_reflectance(const Cavity<Scalar>& cavity, const Direction& e, const Facet& facet,
                             int most_bounces = all_bounces, std::optional<Panel> only = std::nullopt) {
  using Real = typename Direction::value_type;
  return detail::sum_over_lobes<unpolarized_t<Facet, Real>>(
      cavity, e, facet, most_bounces,
      [](const value_t<Facet, Real>& throughput) { return unpolarized(power(throughput)); }, only);
}

/// Directional absorptance 1 − R(θ, φ), and by Kirchhoff's law the directional emissivity; a sum of positive
/// terms that keeps its digits where the reflectance is close to 1.
///
/// @param e direction towards the light or the observer, e.z ≥ 0
/// @param facet facet reflectance with a member `absorptance`, such as `Conductor`
template <class Scalar, class Facet, class Direction = Vec3<Scalar>>
  requires AbsorbingFacet<Facet, typename Direction::value_type>
auto directional_absorptance(const Cavity<Scalar>& cavity, const Direction& e, const Facet& facet) {
  return directional_reflectance(cavity, e, EnergyBalanced<Facet>(facet)).absorbed;
}

/// Mean number of bounces of the rays of a direction over the opening.
/// @param e direction towards the light, e.z ≥ 0
template <class Real>
Real mean_bounces(const Cavity<Real>& cavity, const Vec3<Real>& e) {
  Real mean(0);
  for_each_lobe(
      cavity, e, [](const Real&) { return Real(1); }, all_bounces,
      [&](const PanelImages<Real>& last, const Real& weight, const Real&) {
        mean += weight * Real(last.bounce());
      });
  return mean;
}

}  // namespace vcavity
