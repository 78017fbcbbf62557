// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The question that is put both to the tracer and to the closed form: a ray, by the angles of its direction
/// and the point where it enters a groove.

#include <glm/vec3.hpp>

#include "tracer.hpp"

namespace tracer {

/// A ray of light. Angles in radians.
struct LightRay {
  double aperture;  ///< of the groove that it falls into
  double theta;     ///< angle between the direction towards the light and the mean normal, in [0, pi/2)
  double phi;       ///< azimuth of the light, from +y
  double position;  ///< where it crosses the opening, a fraction of its half width in [-1, 1]
};

/// The unit vector towards the light.
glm::dvec3 towards_light(const LightRay& ray);

/// The point where the ray crosses the opening of the middle groove of its array.
glm::dvec3 entrance(const LightRay& ray);

/// An array that the rays of the checks cannot leave sideways: nine grooves, long enough for 89.9 degrees of
/// incidence.
Tracer wide_groove_array(double aperture);

/// Follows the ray from half a panel width above the opening of the middle groove.
/// @pre the relief is a groove_array() of the ray's aperture
Path trace(const Tracer& grooves, const LightRay& ray);

}  // namespace tracer
