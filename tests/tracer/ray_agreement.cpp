// SPDX-License-Identifier: BSD-3-Clause
#include "ray_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

namespace agreement {
namespace {

int panel_of(const tracer::Bounce& bounce) {
  return bounce.panel % 2 + 1;
}

std::string describe(const LightRay& ray, const Material& material, const tracer::Path& path,
                     const RayAnswer& answer) {
  const double degree = std::numbers::pi / 180;
  std::ostringstream text;
  text.precision(17);
  text << "aperture " << ray.aperture / degree << " deg, theta " << ray.theta / degree << " deg, phi "
       << ray.phi / degree << " deg, position " << ray.position << ", " << material.name << ": traced ";
  if (path.ending == tracer::Ending::upwards)
    text << "panel " << panel_of(path.bounces.front()) << " first, ";
  else
    text << "without coming out, ";
  text << path.bounces.size() << " bounces, exit (" << path.direction.x << ", " << path.direction.y << ", "
       << path.direction.z << "), reflectance " << tracer::reflectance(path, material)
       << "; closed form panel " << answer.first_panel << " first, " << answer.bounces << " bounces, exit ("
       << answer.exit_direction.x << ", " << answer.exit_direction.y << ", " << answer.exit_direction.z
       << "), reflectance " << answer.reflectance << "; clearance " << path.clearance;
  return text.str();
}

}  // namespace

double expected_inside_margin(const LightRay& ray) {
  const glm::dvec3 light = tracer::towards_light(ray);
  const double cos_across = light.z / std::hypot(light.y, light.z);
  const double beam_width = 2 * std::sin(ray.aperture / 2) * cos_across;
  return std::min(1.0, 7 * 2 * edge_margin / beam_width);
}

void RayAgreement::add(const LightRay& ray, const Material& material, const tracer::Path& path,
                       const RayAnswer& answer) {
  const bool is_same_path = path.ending == tracer::Ending::upwards &&
                            panel_of(path.bounces.front()) == answer.first_panel &&
                            static_cast<int>(path.bounces.size()) == answer.bounces;
  const double traced = tracer::reflectance(path, material);
  const double direction_error = glm::distance(path.direction, answer.exit_direction);
  const double product_error = std::abs(answer.reflectance - traced) / traced;
  // Written so that a NaN is a difference.
  const bool agrees =
      is_same_path && direction_error <= direction_tolerance && product_error <= product_tolerance;

  ++rays;
  refined += path.refined;
  expected_inside += expected_inside_margin(ray);
  if (path.clearance < edge_margin) {
    ++inside_margin;
    mismatches_inside += !agrees;
    return;
  }
  met_another_groove += tracer::bounces_in_other_grooves(path) > 0;
  mismatches += !agrees;
  if (!agrees && first_mismatch.empty()) first_mismatch = describe(ray, material, path, answer);
  if (is_same_path) {
    largest_direction_error = std::max(largest_direction_error, direction_error);
    largest_product_error = std::max(largest_product_error, product_error);
  }
}

RayAgreement& RayAgreement::operator+=(const RayAgreement& other) {
  rays += other.rays;
  inside_margin += other.inside_margin;
  mismatches_inside += other.mismatches_inside;
  refined += other.refined;
  mismatches += other.mismatches;
  met_another_groove += other.met_another_groove;
  expected_inside += other.expected_inside;
  largest_direction_error = std::max(largest_direction_error, other.largest_direction_error);
  largest_product_error = std::max(largest_product_error, other.largest_product_error);
  if (first_mismatch.empty()) first_mismatch = other.first_mismatch;
  return *this;
}

bool RayAgreement::margin_is_narrow() const {
  return static_cast<double>(inside_margin) <= expected_inside + 5 * std::sqrt(expected_inside + 1);
}

}  // namespace agreement
