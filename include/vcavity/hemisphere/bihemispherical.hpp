// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bi-hemispherical reflectance of a grooved surface: diffuse light in, all reflected light out (Eq. 26).
///
/// Method. With e = (sin ψ, cos ψ sin θ', cos ψ cos θ') the reflectance is
///
///     R = (4/π) ∫∫ R_1(e) cos²ψ cos θ' dψ dθ'   over θ' in [−α/2, π/2], ψ in [0, π/2],
///
/// where R_1 is the part of the reflectance that belongs to light which meets panel one first. By symmetry
/// the light that meets panel two first adds as much, and light from the other side, ψ < 0, too.
///
/// The integrand is smooth except at angles θ' that are known beforehand, where a lobe appears or its weight
/// changes slope, and where a cosine of incidence passes the critical angle of the facet, if it has one. The
/// rectangle is cut there, and Gauss–Legendre quadrature on the pieces converges exponentially. Its order is
/// the one that the singularities of the facet ask for; it rises until the Legendre series of the integrand
/// has fallen off, and a cell on which it never does is halved.
///
/// When not to use it: for a facet reflectance with steps or kinks of its own it still converges, but slowly.
/// And where n < 0.4 with hardly any absorption, the reflectance changes within so small an angle beside the
/// critical one that the quadrature can miss it: the error estimate may then be too small.

#include <sstream>

#include "vcavity/hemisphere/hemisphere_quadrature.hpp"
#include "vcavity/numbers/invalid_argument.hpp"

namespace vcavity {

/// Bi-hemispherical reflectance (Eq. 26), with an estimate of its error and its cost.
///
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param tolerance absolute error to aim at, > 0; what rounding forbids is not attempted, so that the error
/// estimate
///        may come out larger (about 1e-15 in double)
/// @param max_bounces light that needs more bounces is left out
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the reflectance of unpolarised light
template <class Real, FacetReflectance<Real> Facet>
Integral<unpolarized_t<Facet, Real>> bihemispherical_reflectance(
    const Cavity<Real>& cavity, const Facet& facet, const scalar_t<unpolarized_t<Facet, Real>>& tolerance,
    int max_bounces = all_bounces) {
  using Scalar = scalar_t<unpolarized_t<Facet, Real>>;
  if (!(tolerance > Scalar(0))) {
    std::ostringstream message;
    message << "the tolerance of the bi-hemispherical reflectance must be positive, not " << tolerance;
    throw_invalid_argument(message.str());
  }
  const Scalar norm = Scalar(4) / pi<Scalar>();
  detail::HemisphereQuadrature<Real, Facet> quadrature(cavity, facet, max_bounces);
  const auto part = quadrature(tolerance / norm);
  return {norm * part.value, norm * part.error, part.evaluations};
}

}  // namespace vcavity
