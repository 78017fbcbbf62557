// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Conventions: the axes, angles, panels and vectors that every other header uses.
///
///  - x runs along the groove, z is the normal of the mean surface, y crosses the groove.
///  - A groove has two panels of unit width that meet at the apex, the origin. The aperture α in (0, π] is the
///    angle between them; the opening lies at z = cos(α/2), |y| ≤ sin(α/2). Panel one is at y < 0, panel two at
///    y > 0.
///  - Directions are unit vectors. The direction `e` of a function's arguments points away from the surface,
///    TOWARDS the light or the viewer: e = (sin θ sin φ, sin θ cos φ, cos θ), so the azimuth φ starts at +y.
///  - θ' = atan2(e_y, e_z) is the angle of the direction in the plane across the groove, sin ψ = e_x its
///    elevation out of that plane.
///  - The complex refractive index is n + ik with k ≥ 0 (time dependence exp(−iωt)), relative to the incident
///    medium.
///  - Polarised light that travels along the unit vector k is described in the axes a, b, k, right-handed:
///    a = `polarization_axis(k)` lies in the plane of k and the groove, b = k × a. With field components E_a and
///    E_b its Stokes parameters are I = |E_a|² + |E_b|², Q = |E_a|² − |E_b|² and U + iV = 2 E_a E_b*; so V > 0
///    turns clockwise as seen by the receiver.
///  - Angles are radians unless the name ends in `_deg`. A position on the opening is a fraction in [−1, 1] of
///    its half width.
///
/// The notation is that of Saint-Pierre, Simonot and Hébert, "Reflectance computation for a specular only
/// V-cavity", Computational Color Imaging Workshop 2019 (hal-02087304), cited below as "the paper".

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A vector of two components; u, v on a projection plane.
template <class Real>
using Vec2 = glm::vec<2, Real>;

/// A vector of three components in the frame of the groove.
template <class Real>
using Vec3 = glm::vec<3, Real>;

/// The two mirrors of a groove: `one` at y < 0, `two` at y > 0.
enum class Panel { one = 1, two = 2 };

/// The panel that faces `panel` across the groove.
constexpr Panel opposite(Panel panel) {
  return panel == Panel::one ? Panel::two : Panel::one;
}

// Constrained, unlike the functions of GLM that have the same names: so `using namespace glm` and `using namespace
// vcavity` may stand side by side.

/// Degrees to radians. Multiples of 180/2^k give the correctly rounded multiple of π.
template <Number Real>
Real radians(Real angle_deg) {
  return angle_deg / Real(180) * pi<Real>();
}

/// Radians to degrees.
template <Number Real>
Real degrees(Real angle) {
  return angle / pi<Real>() * Real(180);
}

/// The unit vector at polar angle `theta` from the mean normal and azimuth `phi` from +y (Eq. 6).
/// @param theta polar angle in [0, π/2] for directions above the surface
/// @param phi azimuth, any real number; 0 lies across the groove, π/2 along it
template <class Real>
Vec3<Real> direction(Real theta, Real phi) {
  using std::cos;
  using std::sin;
  const Real sin_theta = sin(theta);
  return {sin_theta * sin(phi), sin_theta * cos(phi), cos(theta)};
}

/// The first axis of polarised light, the direction along the groove as far as it is normal to k.
///
/// Fixed to the groove and not to the mean normal, it exists for all light that enters or leaves a groove
/// except along it, and a reflection never turns it out of its plane.
///
/// @param k unit vector in the direction of travel
/// @return a unit vector normal to k; the mean normal z where k lies along the groove
template <class Real>
Vec3<Real> polarization_axis(const Vec3<Real>& k) {
  using std::abs;
  using std::max;
  using std::sqrt;
  const Real size = max(Real(abs(k.y)), Real(abs(k.z)));
  if (!(size > Real(0))) return {Real(0), Real(0), Real(1)};
  // Almost along the groove the squares of the components themselves would vanish.
  const Real y = k.y / size;
  const Real z = k.z / size;
  const Real across = sqrt(y * y + z * z);
  return {across * size, -k.x * y / across, -k.x * z / across};
}

}  // namespace vcavity
