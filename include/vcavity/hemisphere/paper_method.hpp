// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The paper's own way to the directional and bi-hemispherical reflectance, kept as a reference to compare
/// accuracy and time against: every ray on its own, arcsine and floor for its number of bounces, and the
/// midpoint rule over position and direction (Eqs. 7–17, 20 and 26).
///
/// When not to use it: for results. `directional_reflectance` and `bihemispherical_reflectance` give the same
/// limits without discretisation error and much faster (`vcavity_maps cost`).

#include "vcavity/groove/ray.hpp"
#include "vcavity/hemisphere/bihemispherical.hpp"

namespace vcavity::paper_method {

/// Directional reflectance by the midpoint rule over the opening (Eq. 20).
/// @param cavity the groove
/// @param e direction towards the light, e.z ≥ 0
/// @param positions number of rays across the opening, ≥ 1
/// @param max_bounces rays of more bounces count as black
/// @param facet facet reflectance
template <class Real, FacetReflectance<Real> Facet>
power_t<Facet, Real> directional_reflectance(const Cavity<Real>& cavity, const Vec3<Real>& e,
                                             const Facet& facet, int positions,
                                             int max_bounces = all_bounces) {
  using Value = power_t<Facet, Real>;
  using Scalar = scalar_t<Value>;
  Value sum(0);
  for (int i = 0; i < positions; ++i) {
    const Real position = (Real(2 * i + 1) - Real(positions)) / Real(positions);
    const RayPath path = ray_path(cavity, e, position);
    if (path.bounces <= max_bounces) sum = sum + ray_reflectance(cavity, e, path, facet);
  }
  return (Scalar(1) / Scalar(positions)) * sum;
}

/// Bi-hemispherical reflectance by the midpoint rule over position, polar angle and azimuth (Eq. 26).
/// @param cavity the groove
/// @param positions number of positions across the opening, ≥ 1
/// @param polar number of polar angles θ in [0, π/2], ≥ 1
/// @param azimuthal number of azimuths φ in [0, 2π), ≥ 1
/// @param max_bounces rays of more bounces count as black
/// @param facet facet reflectance
template <class Real, FacetReflectance<Real> Facet>
power_t<Facet, Real> bihemispherical_reflectance(const Cavity<Real>& cavity, const Facet& facet,
                                                 int positions, int polar, int azimuthal,
                                                 int max_bounces = all_bounces) {
  using std::cos;
  using std::sin;
  using Value = power_t<Facet, Real>;
  using Scalar = scalar_t<Value>;
  const Real theta_step = pi<Real>() / Real(2 * polar);
  const Real phi_step = Real(2) * pi<Real>() / Real(azimuthal);
  Value sum(0);
  for (int i = 0; i < polar; ++i) {
    const Real theta = (Real(i) + Real(0.5)) * theta_step;
    Value ring(0);
    for (int j = 0; j < azimuthal; ++j) {
      const Vec3<Real> e = direction(theta, Real((Real(j) + Real(0.5)) * phi_step));
      ring = ring + paper_method::directional_reflectance(cavity, e, facet, positions, max_bounces);
    }
    sum = sum + static_cast<Scalar>(cos(theta) * sin(theta)) * ring;
  }
  return static_cast<Scalar>(theta_step * phi_step / pi<Real>()) * sum;
}

}  // namespace vcavity::paper_method
