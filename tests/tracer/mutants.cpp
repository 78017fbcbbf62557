// SPDX-License-Identifier: BSD-3-Clause
#include "mutants.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vcavity/vcavity.hpp>

namespace agreement {
namespace {

using vcavity::Cavity;
using vcavity::Conductor;
using vcavity::RayPath;
using Direction = vcavity::Vec3<double>;

Conductor<double> facet_of(const Material& material) {
  return {material.index.real(), material.index.imag()};
}

auto perpendicular(const Material& material) {
  return [facet = facet_of(material)](double cos_theta_i) { return norm(facet.amplitudes(cos_theta_i).r_s); };
}

auto parallel(const Material& material) {
  return [facet = facet_of(material)](double cos_theta_i) { return norm(facet.amplitudes(cos_theta_i).r_p); };
}

// The theory whose path is changed before anything follows from it.
template <class Change>
RayTheory wrong_path(Change change) {
  return [change](const LightRay& ray, const Material& material) -> RayAnswer {
    const Cavity<double> cavity(ray.aperture);
    const Direction e = vcavity::direction(ray.theta, ray.phi);
    const RayPath path = change(vcavity::ray_path(cavity, e, ray.position));
    return {static_cast<int>(path.first_panel), path.bounces, vcavity::ray_exit_direction(cavity, e, path),
            vcavity::ray_reflectance(cavity, e, path, facet_of(material))};
  };
}

// The theory whose path is right and whose product along it is wrong.
template <class Product>
RayTheory wrong_product(Product product) {
  return [product](const LightRay& ray, const Material& material) {
    const Cavity<double> cavity(ray.aperture);
    const Direction e = vcavity::direction(ray.theta, ray.phi);
    RayAnswer answer = closed_form_ray(ray, material);
    answer.reflectance = product(cavity, e, vcavity::ray_path(cavity, e, ray.position), material);
    return answer;
  };
}

RayPath one_bounce_more(RayPath path) {
  return {path.first_panel, path.bounces + 1};
}
RayPath one_bounce_less(RayPath path) {
  return {path.first_panel, std::max(1, path.bounces - 1)};
}
RayPath panels_swapped(RayPath path) {
  return {vcavity::opposite(path.first_panel), path.bounces};
}

double last_reflection_missing(const Cavity<double>& cavity, const Direction& e, const RayPath& path,
                               const Material& material) {
  return path.bounces == 1 ? 1.0
                           : vcavity::ray_reflectance(cavity, e, one_bounce_less(path), facet_of(material));
}

double perpendicular_alone(const Cavity<double>& cavity, const Direction& e, const RayPath& path,
                           const Material& material) {
  return vcavity::ray_reflectance(cavity, e, path, perpendicular(material));
}

double averaged_over_the_path(const Cavity<double>& cavity, const Direction& e, const RayPath& path,
                              const Material& material) {
  return (vcavity::ray_reflectance(cavity, e, path, perpendicular(material)) +
          vcavity::ray_reflectance(cavity, e, path, parallel(material))) /
         2;
}

LightRay azimuth_from_x(LightRay ray) {
  ray.phi = std::numbers::pi / 2 - ray.phi;
  return ray;
}

// The theory whose lobes are right and carry a wrong product; `product` is one of those above.
template <class Product>
DirectionalTheory wrong_lobes(Product product) {
  return [product](const LightRay& ray, const Material& material) {
    const Cavity<double> cavity(ray.aperture);
    const Direction e = vcavity::direction(ray.theta, ray.phi);
    double sum = 0;
    for (const auto& lobe : vcavity::lobes(cavity, e, facet_of(material)))
      sum += lobe.weight * product(cavity, e, RayPath{lobe.first_panel, lobe.bounces}, material);
    return sum;
  };
}

double with_one_bounce_more(const Cavity<double>& cavity, const Direction& e, const RayPath& path,
                            const Material& material) {
  return vcavity::ray_reflectance(cavity, e, one_bounce_more(path), facet_of(material));
}

}  // namespace

std::vector<Mutant<RayTheory>> ray_mutants() {
  return {
      {"one bounce too many", wrong_path(one_bounce_more)},
      {"one bounce too few", wrong_path(one_bounce_less)},
      {"panels swapped", wrong_path(panels_swapped)},
      {"phi measured from the x axis",
       [](const LightRay& ray, const Material& material) {
         RayAnswer answer = closed_form_ray(azimuth_from_x(ray), material);
         std::swap(answer.exit_direction.x, answer.exit_direction.y);
         return answer;
       }},
      {"last reflection missing from the product", wrong_product(last_reflection_missing)},
      {"s polarisation in place of the average", wrong_product(perpendicular_alone)},
      {"s and p averaged over the path, not at each bounce", wrong_product(averaged_over_the_path)},
  };
}

std::vector<Mutant<DirectionalTheory>> directional_mutants() {
  return {
      {"one bounce too many", wrong_lobes(with_one_bounce_more)},
      {"last reflection missing from the product", wrong_lobes(last_reflection_missing)},
      {"s polarisation in place of the average", wrong_lobes(perpendicular_alone)},
      {"s and p averaged over the path, not at each bounce", wrong_lobes(averaged_over_the_path)},
      {"phi measured from the x axis",
       [](const LightRay& ray, const Material& material) {
         return closed_form_directional(azimuth_from_x(ray), material);
       }},
      {"series cut off one bounce early",
       [](const LightRay& ray, const Material& material) {
         const Cavity<double> cavity(ray.aperture);
         return vcavity::directional_reflectance(cavity, vcavity::direction(ray.theta, ray.phi),
                                                 facet_of(material), cavity.max_bounces() - 1);
       }},
  };
}

std::vector<Mutant<HemisphericalTheory>> hemispherical_mutants() {
  const auto reflectance = [](double aperture, const auto& facet, int max_bounces) {
    return vcavity::bihemispherical_reflectance(Cavity<double>(aperture), facet, 1e-7, max_bounces).value;
  };
  return {
      {"series cut off one bounce early",
       [=](double aperture, const Material& material, int max_bounces) {
         const int most = std::min(max_bounces, Cavity<double>(aperture).max_bounces());
         return reflectance(aperture, facet_of(material), most - 1);
       }},
      {"s polarisation in place of the average",
       [=](double aperture, const Material& material, int max_bounces) {
         return reflectance(aperture, perpendicular(material), max_bounces);
       }},
  };
}

}  // namespace agreement
