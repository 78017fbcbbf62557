// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Rays for the comparison of tracer and theory, and the traced side of every comparison.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "closed_form.hpp"
#include "ray_agreement.hpp"
#include "statistics.hpp"

namespace agreement {

/// Degrees to radians, and back.
double radians(double degrees);
double degrees(double radians);

/// A ray of diffuse light, for a point of the unit cube.
LightRay diffuse_ray(double aperture, const std::array<double, 3>& u);

/// The directions where closed forms go wrong, the position left open: along the normal, grazing across,
/// along and askew to the groove, in the plane of the groove's length, and parallel and almost parallel to a
/// panel, where the second panel stops being lit directly.
std::vector<LightRay> special_directions(double aperture);

/// Traces rays of one aperture, one half in special directions and the other in directions spread over the
/// hemisphere up to 89.9 degrees, and compares each with the theory for one of the example materials.
RayAgreement compare_rays(const RayTheory& theory, double aperture, std::int64_t rays, std::uint64_t seed);

/// The same for rays that enter 1e-11 to 1e-5 panel widths beside the apex or a rim, just outside the margin.
RayAgreement compare_rays_beside_edges(const RayTheory& theory, double aperture, std::int64_t rays,
                                       std::uint64_t seed);

/// A traced directional reflectance.
struct TracedDirection {
  LightRay ray;  ///< its position plays no part
  Material material;
  ReplicatedMean mean;
};

/// Traces the directional reflectance of the example materials in the special directions and in four others.
/// @param rays  per direction
std::vector<TracedDirection> trace_directions(double aperture, std::int64_t rays, std::uint64_t seed);

/// What is averaged under diffuse light: the reflectance of paths of at most `max_bounces`; longer ones
/// count as black.
struct DiffuseQuantity {
  Material material;
  int max_bounces = every_bounce;
};

/// A traced bi-hemispherical reflectance.
struct TracedHemisphere {
  double aperture;
  DiffuseQuantity quantity;
  ReplicatedMean mean;
};

/// Traces bi-hemispherical reflectances, all from the same rays.
std::vector<TracedHemisphere> trace_hemisphere(double aperture, std::span<const DiffuseQuantity> quantities,
                                               std::int64_t rays, std::uint64_t seed);

/// Puts the theory beside what was traced.
std::vector<MeanComparison> compare(const DirectionalTheory& theory, std::span<const TracedDirection> traced);
std::vector<MeanComparison> compare(const HemisphericalTheory& theory,
                                    std::span<const TracedHemisphere> traced);

}  // namespace agreement
