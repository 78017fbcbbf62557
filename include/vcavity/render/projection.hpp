// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Lambert azimuthal equal-area projection: the hemisphere of directions as a disc of radius √2.
///
/// u = 2 sin(θ/2) cos φ points across the groove (+y), v = 2 sin(θ/2) sin φ along it (+x): equal areas of the
/// disc are equal solid angles (the paper's second Eq. 21).

#include <cmath>
#include <optional>

#include "vcavity/conventions.hpp"

namespace vcavity {

/// The point of the disc that shows a direction.
/// @param e unit vector, e.z ≥ 0
/// @return (u, v) with u² + v² ≤ 2
template <class Real>
Vec2<Real> project_to_disc(const Vec3<Real>& e) {
  using std::sqrt;
  const Real scale = sqrt(Real(2) / (Real(1) + e.z));
  return {e.y * scale, e.x * scale};
}

/// The direction that a point of the disc shows.
/// @return a unit vector with z ≥ 0, or nothing outside the disc of radius √2
template <class Real>
std::optional<Vec3<Real>> direction_on_disc(const Vec2<Real>& point) {
  using std::sqrt;
  const Real r2 = point.x * point.x + point.y * point.y;
  if (!(r2 <= Real(2))) return std::nullopt;
  const Real scale = sqrt(Real(1) - r2 / Real(4));
  return Vec3<Real>{point.y * scale, point.x * scale, Real(1) - r2 / Real(2)};
}

}  // namespace vcavity
