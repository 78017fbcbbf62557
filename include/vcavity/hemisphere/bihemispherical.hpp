// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bi-hemispherical reflectance of a grooved surface: diffuse light in, all reflected light out (Eq. 26).
///
/// Method. Light is sorted by the number of its bounces (bounce_series.hpp). What remains is an integral over a
/// rectangle of two angles, smooth except at angles that are known beforehand: where a cosine of incidence
/// passes the critical angle of the facet, if it has one. There the rectangle is cut, and Gauss–Legendre
/// quadrature on the pieces converges exponentially (hemisphere_quadrature.hpp). Narrow grooves are as good as even across
/// but for the rays of most bounces, which are integrated apart (bounce_series.hpp).
///
/// When not to use it: for a facet reflectance with steps or kinks of its own it still converges, but slowly.

#include "vcavity/hemisphere/cavity_integrand.hpp"
#include "vcavity/hemisphere/hemisphere_quadrature.hpp"
#include "vcavity/numbers/invalid_argument.hpp"

namespace vcavity {

/// Bi-hemispherical reflectance (Eq. 26), with an estimate of its error and its cost.
///
/// @param cavity the groove
/// @param facet facet reflectance, in [0, 1]; the same for both panels and for every bounce
/// @param tolerance absolute error to aim at, > 0; what rounding forbids is not attempted, so that the error
/// estimate may come out larger (about 1e-15 in double), and so it may where 2e7 evaluations do not suffice
/// @param max_bounces light that needs more bounces is left out
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the reflectance of unpolarised light
template <class Real, FacetReflectance<Real> Facet>
Integral<unpolarized_t<Facet, Real>> bihemispherical_reflectance(
    const Cavity<Real>& cavity, const Facet& facet, const scalar_t<unpolarized_t<Facet, Real>>& tolerance,
    int max_bounces = all_bounces) {
  using Scalar = scalar_t<unpolarized_t<Facet, Real>>;
  if (!(tolerance > Scalar(0))) {
    throw_invalid_argument("the tolerance of the bi-hemispherical reflectance must be positive, not ",
                           tolerance);
  }
  detail::CavityIntegrand<Real, Facet> integrand(cavity, facet, max_bounces);
  return detail::HemisphereQuadrature<Real, Facet, detail::CavityIntegrand<Real, Facet>>(
      integrand, facet)(static_cast<double>(tolerance));
}

}  // namespace vcavity
