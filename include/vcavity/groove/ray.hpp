// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A single ray: which panel it meets first, how often it bounces, and what is left of it.
///
/// Method. The ray is a straight line in the unfolded groove. The number of images of the panels that it
/// crosses inside the unit circle is the number of its bounces.

#include <cassert>
#include <cmath>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/unfoldable_groove.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The way of a ray through the groove, as far as geometry goes.
struct RayPath {
  Panel first_panel;  ///< the panel met first
  int bounces;        ///< the number of reflections, at least 1, at most `Cavity::max_bounces()`
};

/// First panel and number of bounces of the ray through a point of the opening (Eqs. 7–13).
///
/// With θ' the angle of the ray across the groove, δ = y cos θ' − cos(α/2) sin θ' its signed distance from
/// the apex and s = sign δ: panel one is met first if δ < 0, and m = ⌊γ/α − 1/2⌋ + 1, where
/// γ = π + s θ' − arcsin|δ| merges the paper's Eqs. 11 and 12. Here γ = (π/2 + s θ') + arccos|δ|, two angles
/// that are small together in a narrow groove under grazing light, and keep their digits.
///
/// Light along the groove counts as light from straight above, see `Cavity::least_up`.
///
/// A ray through the apex counts as meeting panel two first, one through the edge of a panel's image as
/// meeting that image. The answer is at least 1 and at most `max_bounces`, whatever the rounding.
///
/// @param cavity the groove
/// @param e direction towards the light, e.z ≥ 0
/// @param position where the ray crosses the opening, a fraction of its half width in [−1, 1]
template <class Real>
RayPath ray_path(const Cavity<Real>& cavity, const Vec3<Real>& e, const Real& position) {
  using std::atan2;
  using std::floor;
  using std::sqrt;
  assert(e.z >= Real(0) && position >= Real(-1) && position <= Real(1));

  // Light along the groove has an answer too, the same as for `lobes`.
  const Real up = at_least(e.z, cavity.least_up());
  const Real size = at_least(largest(e.y), up);
  // Only the ratio of y and z counts. Almost along the groove their squares would vanish.
  const Real y = e.y / size;
  const Real z = up / size;
  const Real across = sqrt(y * y + z * z);

  const Real aside = position * cavity.sin_half() * z;
  const Panel first = aside < cavity.cos_half() * y ? Panel::one : Panel::two;  // δ < 0
  const Real facing = first == Panel::one ? y : Real(-y);
  // 1 − |δ|, without forming |δ| = (cos(α/2) facing ∓ aside)/across
  const Real beyond = facing > Real(0) ? Real(z * (z / (across + facing))) : Real(across - facing);
  const Real rest = at_least(
      Real((beyond + cavity.versine_half() * facing + (first == Panel::one ? aside : Real(-aside))) / across),
      Real(0));
  const Real leaving = atan2(z, facing) + atan2(sqrt(rest * (Real(2) - rest)), Real(1) - rest);  // γ
  const Real count = floor(leaving / cavity.aperture() - Real(0.5)) + Real(1);
  if (count <= Real(1)) return {first, 1};
  const int most = cavity.max_bounces();
  return {first, count < Real(most) ? static_cast<int>(count) : most};
}

/// The direction in which the light of a ray leaves the groove.
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light, e.z ≥ 0
/// @param path of the ray
template <class Groove>
Vec3<scalar_t<Groove>> ray_exit_direction(const Groove& groove, const Vec3<scalar_t<Groove>>& e,
                                          const RayPath& path) {
  auto ray = unfold(groove, e, path.first_panel);
  while (ray.number() < path.bounces) ray.advance();
  return exit_direction(groove, ray);
}

/// Reflectance of a single ray, the product of the facet reflectances along its way (Eq. 17).
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light, e.z ≥ 0
/// @param path of the ray
/// @param facet facet reflectance
template <class Groove, FacetReflectance<scalar_t<Groove>> Facet>
power_t<Facet, scalar_t<Groove>> ray_reflectance(const Groove& groove, const Vec3<scalar_t<Groove>>& e,
                                                 const RayPath& path, const Facet& facet) {
  auto ray = unfold(groove, e, path.first_panel);
  auto throughput = reflect(facet, ray);
  while (ray.number() < path.bounces) {
    ray.advance();
    throughput = throughput * reflect(facet, ray);
  }
  return power(throughput);
}

/// Reflectance R(θ, φ, y) of the ray through a point of the opening (Eq. 17).
/// @param groove a `Cavity`, or another groove that has a `ray_path`
/// @param e direction towards the light, e.z ≥ 0
/// @param position where the ray crosses the opening, a fraction of its half width in [−1, 1]
/// @param facet facet reflectance
template <class Groove, FacetReflectance<scalar_t<Groove>> Facet>
power_t<Facet, scalar_t<Groove>> ray_reflectance(const Groove& groove, const Vec3<scalar_t<Groove>>& e,
                                                 const scalar_t<Groove>& position, const Facet& facet) {
  return ray_reflectance(groove, e, ray_path(groove, e, position), facet);
}

}  // namespace vcavity
