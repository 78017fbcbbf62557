// SPDX-License-Identifier: BSD-3-Clause
#include "closed_form.hpp"

#include <vcavity/vcavity.hpp>

namespace agreement {
namespace {

using vcavity::Cavity;

// Calls `use` with the facet of a material, which is of one type for dielectrics and of another for metals.
template <class Use>
auto with_facet(const Material& material, Use&& use) {
  if (material.index.imag() == 0) return use(vcavity::Dielectric<double>{material.index.real()});
  return use(vcavity::Conductor<double>{material.index.real(), material.index.imag()});
}

constexpr double quadrature_tolerance = 1e-9;

}  // namespace

RayAnswer closed_form_ray(const LightRay& ray, const Material& material) {
  const Cavity<double> cavity(ray.aperture);
  const auto e = vcavity::direction(ray.theta, ray.phi);
  const vcavity::RayPath path = vcavity::ray_path(cavity, e, ray.position);
  const double reflectance = with_facet(
      material, [&](const auto& facet) { return vcavity::ray_reflectance(cavity, e, path, facet); });
  return {static_cast<int>(path.first_panel), path.bounces, vcavity::ray_exit_direction(cavity, e, path),
          reflectance};
}

double closed_form_directional(const LightRay& ray, const Material& material) {
  return with_facet(material, [&](const auto& facet) {
    return vcavity::directional_reflectance(Cavity<double>(ray.aperture),
                                            vcavity::direction(ray.theta, ray.phi), facet);
  });
}

double closed_form_hemispherical(double aperture, const Material& material, int max_bounces) {
  return with_facet(material, [&](const auto& facet) {
    return vcavity::bihemispherical_reflectance(Cavity<double>(aperture), facet, quadrature_tolerance,
                                                max_bounces)
        .value;
  });
}

}  // namespace agreement
