// SPDX-License-Identifier: BSD-3-Clause
#include "light_ray.hpp"

#include <cmath>

namespace tracer {

glm::dvec3 towards_light(const LightRay& ray) {
  return {std::sin(ray.theta) * std::sin(ray.phi), std::sin(ray.theta) * std::cos(ray.phi),
          std::cos(ray.theta)};
}

glm::dvec3 entrance(const LightRay& ray) {
  return {0, ray.position * std::sin(ray.aperture / 2), std::cos(ray.aperture / 2)};
}

Tracer wide_groove_array(double aperture) {
  // A path within a groove is no longer than 2 across it, so not longer than 2 / cos(89.9 degrees) = 1146
  // along it.
  return Tracer(groove_array(aperture, 9, 4000));
}

Path trace(const Tracer& grooves, const LightRay& ray) {
  const glm::dvec3 light = towards_light(ray);
  return grooves.trace(entrance(ray) + 0.5 * light, -light);
}

}  // namespace tracer
