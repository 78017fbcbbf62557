// SPDX-License-Identifier: BSD-3-Clause

/// vcavity's answers for profiles, and theories with one error each.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/groove/asymmetric_groove.hpp>
#include <vcavity/profiles/land.hpp>
#include <vcavity/profiles/trench.hpp>
#include <vcavity/profiles/truncated_groove.hpp>

#include "light_ray.hpp"
#include "profile_agreement.hpp"

namespace agreement {
namespace {

using vcavity::Conductor;
using vcavity::FacePath;
using vcavity::Panel;

constexpr double pi = std::numbers::pi;

auto facets_of(const FaceMaterials& materials) {
  const auto facet = [](const tracer::Material& material) {
    return Conductor<double>(material.index.real(), material.index.imag());
  };
  return vcavity::FaceFacets{facet(materials[0]), facet(materials[1]), facet(materials[2]),
                             facet(materials[3])};
}

template <class Profile>
ProfileAnswer answer_of(const Profile& profile, const ProfileRay& ray, const FaceMaterials& materials) {
  const glm::dvec3 e = tracer::towards_light({0, ray.theta, ray.phi, 0});
  const auto light = vcavity::pencil_at(profile, e, ray.position);
  double reflectance = 0;
  profile.follow(e, facets_of(materials), [&](const auto& pencil, double throughput) {
    if (pencil.path == light.path) reflectance = throughput;
  });
  return {light.path.text(), light.direction, reflectance};
}

/// The series of section "asymmetric grooves" in its plainest form, with room for errors: distances from the apex, one
/// trigonometric function after the other.
struct PlainSeries {
  bool swapped_lengths = false;
  bool last_value_only = false;  // in place of the running minimum
  double tilt_sign = 1;

  ProfileAnswer operator()(const ProfileShape& shape, const ProfileRay& ray,
                           const FaceMaterials& materials) const {
    const glm::dvec3 e = tracer::towards_light({0, ray.theta, ray.phi, 0});
    const auto facets = facets_of(materials);
    if (ray.position > 1 - shape.land) return {"L", {-e.x, -e.y, e.z}, facets.land(e.z)};
    const double aperture = pi - shape.slope_one - shape.slope_two;
    const double tilt = tilt_sign * (shape.slope_one - shape.slope_two) / 2;
    std::array lengths{1 / std::sin(shape.slope_one), 1 / std::sin(shape.slope_two)};
    const double opening = lengths[0] * lengths[1] * std::sin(aperture);
    if (swapped_lengths) std::swap(lengths[0], lengths[1]);
    const double across = std::hypot(e.y, e.z), theta = std::atan2(e.y, e.z);

    // The distance of the ray from the apex, to the side of panel one.
    const double y =
        -std::cos(shape.slope_one) / std::sin(shape.slope_one) + ray.position / (1 - shape.land) * opening;
    const double offset = (e.y - y * e.z) / across;
    const int side = offset > 0 ? 1 : -1;
    const auto angle = [&](int j) { return (j - 0.5) * aperture + side * (theta - tilt); };
    const auto length = [&](int j) { return lengths[(j % 2 != 0) == (side > 0) ? 0 : 1]; };
    int bounces = 1;
    double reached = length(1) * std::sin(angle(1));
    for (int j = 2; angle(j) < pi; ++j) {
      const double rim = length(j) * std::sin(angle(j));
      reached = last_value_only ? rim : std::min(reached, rim);
      if (std::abs(offset) < reached)
        bounces = j;
      else if (!last_value_only)
        break;
    }
    const vcavity::AsymmetricGroove<double> groove(aperture, tilt);
    const vcavity::RayPath path{side > 0 ? Panel::one : Panel::two, bounces};
    double reflectance = 1;
    for (int j = 1; j <= bounces; ++j) {
      const double cosine = std::min(across * std::sin(angle(j)), 1.0);
      reflectance *= (j % 2 != 0) == (side > 0) ? facets.one(cosine) : facets.two(cosine);
    }
    return {FacePath{path.first_panel, bounces, false, Panel::one, 0, false}.text(),
            vcavity::ray_exit_direction(groove, e, path), reflectance};
  }
};

ProfileAnswer floor_met_twice(const ProfileShape& shape, const ProfileRay& ray,
                              const FaceMaterials& materials) {
  ProfileAnswer answer = closed_form_profile_ray(shape, ray, materials);
  const std::size_t floor = answer.faces.find('F');
  if (floor != std::string::npos) {
    answer.faces.insert(answer.faces.begin() + static_cast<std::ptrdiff_t>(floor), 'F');
    answer.reflectance *= facets_of(materials).floor(std::abs(answer.exit_direction.z));
  }
  return answer;
}

ProfileAnswer walls_swapped(const ProfileShape& shape, const ProfileRay& ray,
                            const FaceMaterials& materials) {
  ProfileAnswer answer = closed_form_profile_ray(shape, ray, materials);
  for (char& face : answer.faces) face = face == '1' ? '2' : face == '2' ? '1' : face;
  return answer;
}

}  // namespace

ProfileAnswer closed_form_profile_ray(const ProfileShape& shape, const ProfileRay& ray,
                                      const FaceMaterials& materials) {
  if (shape.floor > 0 && shape.slope_one == pi / 2 && shape.slope_two == pi / 2)
    return answer_of(vcavity::Land(vcavity::Trench<double>(shape.floor), shape.land), ray, materials);
  if (shape.floor > 0)
    return answer_of(
        vcavity::Land(vcavity::TruncatedGroove<double>(shape.slope_one, shape.slope_two, shape.floor),
                      shape.land),
        ray, materials);
  const auto groove = vcavity::AsymmetricGroove<double>::from_slopes(shape.slope_one, shape.slope_two);
  if (shape.land > 0) return answer_of(vcavity::Land(groove, shape.land), ray, materials);
  // Without land as a single ray, as one asks for it.
  const glm::dvec3 e = tracer::towards_light({0, ray.theta, ray.phi, 0});
  const auto facets = facets_of(materials);
  const vcavity::RayPath path = vcavity::ray_path(groove, e, 2 * ray.position - 1);
  return {FacePath{path.first_panel, path.bounces, false, Panel::one, 0, false}.text(),
          vcavity::ray_exit_direction(groove, e, path),
          vcavity::ray_reflectance(groove, e, path, vcavity::PanelFacets{facets.one, facets.two})};
}

ProfileAnswer plain_series_ray(const ProfileShape& shape, const ProfileRay& ray,
                               const FaceMaterials& materials) {
  return PlainSeries{}(shape, ray, materials);
}

std::vector<ProfileMutant> profile_mutants() {
  return {
      {"lengths of the panels swapped", ShapeKind::asymmetric, PlainSeries{.swapped_lengths = true}},
      {"the last value in place of the running minimum", ShapeKind::asymmetric,
       PlainSeries{.last_value_only = true}},
      {"tilt of the wrong sign", ShapeKind::asymmetric, PlainSeries{.tilt_sign = -1}},
      {"floor met twice", ShapeKind::floor, floor_met_twice},
      {"floor met twice", ShapeKind::trench, floor_met_twice},
      {"walls swapped", ShapeKind::floor, walls_swapped},
  };
}

}  // namespace agreement
