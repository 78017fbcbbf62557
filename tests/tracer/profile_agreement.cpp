// SPDX-License-Identifier: BSD-3-Clause
#include "profile_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

#include "light_ray.hpp"
#include "ray_agreement.hpp"

namespace agreement {
namespace {

constexpr double pi = std::numbers::pi;

/// The names of the panels of a relief, in order.
std::string faces_of(const ProfileShape& shape) {
  return std::string(shape.floor > 0 ? "1F2" : "12") + (shape.land > 0 ? "L" : "");
}

/// The cross-section of a period, its longest face of unit length and its deepest point at the origin.
std::vector<glm::dvec2> period_of(const ProfileShape& shape) {
  const auto cotangent = [](double angle) { return std::cos(angle) / std::sin(angle); };
  const glm::dvec2 foot_one{0, 0}, foot_two{shape.floor, 0};
  std::vector<glm::dvec2> period{{-cotangent(shape.slope_one), 1}, foot_one};
  if (shape.floor > 0) period.push_back(foot_two);
  period.push_back(foot_two + glm::dvec2{cotangent(shape.slope_two), 1});
  const double opening = period.back().x - period.front().x;
  if (shape.land > 0)
    period.push_back(period.back() + glm::dvec2{opening * shape.land / (1 - shape.land), 0});
  double longest = 0;
  for (std::size_t i = 1; i < period.size(); ++i)
    longest = std::max(longest, glm::distance(period[i], period[i - 1]));
  for (glm::dvec2& point : period) point /= longest;
  // Rims at exactly the same height, whatever the rounding.
  for (glm::dvec2& point : period)
    if (point.y > 0) point.y = 1 / longest;
  return period;
}

std::string describe(const ProfileShape& shape, const ProfileRay& ray, const std::string& faces,
                     const tracer::Path& path, double reflectance, const ProfileAnswer& answer) {
  std::ostringstream text;
  text.precision(17);
  text << "slopes " << shape.slope_one * 180 / pi << " and " << shape.slope_two * 180 / pi << " deg, floor "
       << shape.floor << ", land " << shape.land << ", theta " << ray.theta * 180 / pi << " deg, phi "
       << ray.phi * 180 / pi << " deg, position " << ray.position << ": traced " << faces
       << (path.ending == tracer::Ending::upwards ? "" : " without coming out") << ", exit ("
       << path.direction.x << ", " << path.direction.y << ", " << path.direction.z << "), reflectance "
       << reflectance << "; closed form " << answer.faces << ", exit (" << answer.exit_direction.x << ", "
       << answer.exit_direction.y << ", " << answer.exit_direction.z << "), reflectance "
       << answer.reflectance << "; clearance " << path.clearance;
  return text.str();
}

ProfileRay random_ray(ShapeKind kind, Uniform& uniform) {
  // In trenches grazing light bounces without end.
  const double most = (kind == ShapeKind::trench ? 88 : 89.9) * pi / 180;
  const double phi = uniform() < 0.2 ? (uniform() < 0.5 ? 0 : pi) : 2 * pi * uniform();
  return {most * uniform(), phi, uniform()};
}

const tracer::Material& material_of(char face, const FaceMaterials& materials) {
  const std::size_t index = std::string("12FL").find(face);
  return materials[index];
}

}  // namespace

ProfileShape random_shape(ShapeKind kind, Uniform& uniform) {
  const double degree = pi / 180;
  const double land = uniform() < 0.5 ? 0.05 + 0.85 * uniform() : 0;
  if (kind == ShapeKind::trench)
    return {pi / 2, pi / 2, std::pow(10, 1.5 * uniform() - 0.5), std::max(land, 0.05)};
  if (kind == ShapeKind::floor) {
    const double floor = std::pow(10, 2.5 * uniform() - 1.5);
    const double one = uniform() < 0.1 ? pi / 2 : degree * (10 + 79 * uniform());
    return {one, degree * (10 + 79 * uniform()), floor, land};
  }
  for (;;) {
    const double one = degree * (2 + 150 * uniform()), two = degree * (2 + 150 * uniform());
    if (one + two < degree * 176) return {one, two, 0, land};
  }
}

ProfileAgreement& ProfileAgreement::operator+=(const ProfileAgreement& other) {
  rays += other.rays;
  inside_margin += other.inside_margin;
  mismatches += other.mismatches;
  met_another_groove += other.met_another_groove;
  max_bounces = std::max(max_bounces, other.max_bounces);
  largest_direction_error = std::max(largest_direction_error, other.largest_direction_error);
  largest_product_error = std::max(largest_product_error, other.largest_product_error);
  if (first_mismatch.empty()) first_mismatch = other.first_mismatch;
  return *this;
}

ProfileAgreement compare_profile_rays(const ProfileTheory& theory, ShapeKind kind, int shapes,
                                      std::int64_t rays_each, std::uint64_t seed) {
  Uniform uniform(seed);
  const std::vector<tracer::Material> examples = tracer::example_materials();
  const auto some_material = [&] {
    return examples[static_cast<std::size_t>(uniform() * static_cast<double>(examples.size()))];
  };
  ProfileAgreement result;
  for (int i = 0; i < shapes; ++i) {
    const ProfileShape shape = random_shape(kind, uniform);
    const std::vector<glm::dvec2> period = period_of(shape);
    const std::string names = faces_of(shape);
    const double width = period.back().x - period.front().x;
    // Long enough for light that travels almost along the grooves.
    const tracer::Tracer grooves(tracer::profile_array(period, 9, 20000));
    for (std::int64_t j = 0; j < rays_each; ++j) {
      const FaceMaterials materials{some_material(), some_material(), some_material(), some_material()};
      const ProfileRay ray = random_ray(kind, uniform);
      const glm::dvec3 light = tracer::towards_light({0, ray.theta, ray.phi, 0});
      const glm::dvec3 entrance{0, period.front().x + ray.position * width, period.front().y};
      const tracer::Path path = grooves.trace(entrance + 0.5 * light, -light);

      std::string faces;
      double reflectance = 1;
      for (const tracer::Bounce& bounce : path.bounces) {
        faces += names[static_cast<std::size_t>(bounce.panel) % names.size()];
        reflectance *=
            tracer::fresnel_reflectance(material_of(faces.back(), materials).index, bounce.cos_incidence);
      }
      ++result.rays;
      result.max_bounces = std::max(result.max_bounces, faces.size());
      if (path.clearance < edge_margin) {
        ++result.inside_margin;
        continue;
      }
      const ProfileAnswer answer = theory(shape, ray, materials);
      const bool same_faces = path.ending == tracer::Ending::upwards && faces == answer.faces;
      const double direction_error = glm::distance(path.direction, answer.exit_direction);
      const double product_error = std::abs(answer.reflectance - reflectance) / reflectance;
      // Written so that a NaN is a difference.
      const bool agrees =
          same_faces && direction_error <= direction_tolerance && product_error <= product_tolerance;
      result.met_another_groove += tracer::bounces_in_other_grooves(path) > 0;
      result.mismatches += !agrees;
      if (!agrees && result.first_mismatch.empty())
        result.first_mismatch = describe(shape, ray, faces, path, reflectance, answer);
      if (same_faces) {
        result.largest_direction_error = std::max(result.largest_direction_error, direction_error);
        result.largest_product_error = std::max(result.largest_product_error, product_error);
      }
    }
  }
  return result;
}

}  // namespace agreement
