// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The answers of the closed form, behind plain functions so that a test can put a wrong theory in their
/// place.

#include <functional>
#include <glm/vec3.hpp>
#include <limits>

#include "light_ray.hpp"
#include "textbook_fresnel.hpp"

namespace agreement {

using tracer::LightRay;
using tracer::Material;

/// What a theory says about one ray.
struct RayAnswer {
  int first_panel;            ///< 1 at y < 0, 2 at y > 0
  int bounces;                ///< number of reflections
  glm::dvec3 exit_direction;  ///< of travel, after the last bounce
  double reflectance;         ///< product over the bounces
};

/// A theory of single rays.
using RayTheory = std::function<RayAnswer(const LightRay&, const Material&)>;

/// A theory of the reflectance averaged over the opening; the position of the ray plays no part.
using DirectionalTheory = std::function<double(const LightRay&, const Material&)>;

/// Stands for no limit to the number of bounces.
inline constexpr int every_bounce = std::numeric_limits<int>::max();

/// A theory of the reflectance under diffuse light; paths of more than `max_bounces` are left out.
using HemisphericalTheory = std::function<double(double aperture, const Material&, int max_bounces)>;

/// vcavity on one ray.
RayAnswer closed_form_ray(const LightRay& ray, const Material& material);

/// vcavity's directional reflectance.
double closed_form_directional(const LightRay& ray, const Material& material);

/// vcavity's bi-hemispherical reflectance, to 1e-9.
double closed_form_hemispherical(double aperture, const Material& material, int max_bounces);

}  // namespace agreement
