// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>

namespace agreement {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double grazing = 89.9 * pi / 180;

// Traces at least `rays` rays, the same number in each replicate, and averages a value of each path for every
// element of `traced`.
template <class RayAt, class Value, class Traced>
void average(const tracer::Tracer& grooves, RayAt ray_at, Value value, std::vector<Traced>& traced,
             std::int64_t rays, std::uint64_t seed) {
  const int points = static_cast<int>((rays + replicates - 1) / replicates);
  for (int replicate = 0; replicate < replicates; ++replicate) {
    const ShiftedLattice lattice(seed, replicate);
    for (int i = 0; i < points; ++i) {
      const tracer::Path path = trace(grooves, ray_at(lattice[i]));
      for (Traced& of : traced) of.mean.add(value(of, path));
    }
    for (Traced& of : traced) of.mean.end_replicate();
  }
}

template <class Range>
auto choose(const Range& range, Uniform& uniform) {
  return range[static_cast<std::size_t>(uniform() * static_cast<double>(std::size(range)))];
}

// One ray in two comes from a special direction, the others from anywhere above; the position is left open.
LightRay some_direction(double aperture, Uniform& uniform) {
  if (uniform() < 0.5) return choose(special_directions(aperture), uniform);
  return {aperture, grazing * uniform(), 2 * pi * uniform(), 0};
}

// Compares the rays that `next_ray(uniform)` makes, each for one of the example materials.
template <class NextRay>
RayAgreement compare_each(const RayTheory& theory, double aperture, std::int64_t rays, std::uint64_t seed,
                          NextRay next_ray) {
  const tracer::Tracer grooves = tracer::wide_groove_array(aperture);
  const std::vector<Material> materials = tracer::example_materials();
  Uniform uniform(seed);
  RayAgreement agreement;
  for (std::int64_t i = 0; i < rays; ++i) {
    const LightRay ray = next_ray(uniform);
    const Material material = choose(materials, uniform);
    agreement.add(ray, material, trace(grooves, ray), theory(ray, material));
  }
  return agreement;
}

}  // namespace

double radians(double degrees) {
  return degrees * (pi / 180);
}
double degrees(double radians) {
  return radians * (180 / pi);
}

LightRay diffuse_ray(double aperture, const std::array<double, 3>& u) {
  return {aperture, std::asin(std::sqrt(u[1])), 2 * pi * u[2], 2 * u[0] - 1};
}

std::vector<LightRay> special_directions(double aperture) {
  const double parallel = std::min(aperture / 2, grazing);
  return {
      {aperture, 0, 0, 0},
      {aperture, grazing, 0, 0},
      {aperture, grazing, pi, 0},
      {aperture, grazing, 1, 0},
      {aperture, grazing, pi / 2, 0},
      {aperture, pi / 4, pi / 2, 0},
      {aperture, pi / 6, 0, 0},
      {aperture, pi / 3, 5, 0},
      {aperture, parallel, 0, 0},
      {aperture, 0.98 * parallel, 0, 0},
  };
}

RayAgreement compare_rays(const RayTheory& theory, double aperture, std::int64_t rays, std::uint64_t seed) {
  return compare_each(theory, aperture, rays, seed, [&](Uniform& uniform) {
    LightRay ray = some_direction(aperture, uniform);
    ray.position = 2 * uniform() - 1;
    return ray;
  });
}

RayAgreement compare_rays_beside_edges(const RayTheory& theory, double aperture, std::int64_t rays,
                                       std::uint64_t seed) {
  return compare_each(theory, aperture, rays, seed, [&](Uniform& uniform) {
    for (;;) {
      LightRay ray = some_direction(aperture, uniform);
      const glm::dvec3 light = towards_light(ray);
      const double slope = light.y / light.z;
      const double apex = slope / std::tan(aperture / 2);
      const double edge = choose(std::array{-1.0, apex, 1.0}, uniform);
      const double distance = 10 * edge_margin * std::pow(1e6, uniform()) * (uniform() < 0.5 ? -1 : 1);
      ray.position = edge + distance * std::sqrt(1 + slope * slope) / std::sin(aperture / 2);
      if (std::abs(ray.position) <= 1) return ray;
    }
  });
}

std::vector<TracedDirection> trace_directions(double aperture, std::int64_t rays, std::uint64_t seed) {
  std::vector<LightRay> directions = special_directions(aperture);
  for (const double turn : {0.05, 0.15, 0.6, 0.9})
    directions.push_back({aperture, turn * pi / 2, turn * 2 * pi, 0});

  const tracer::Tracer grooves = tracer::wide_groove_array(aperture);
  std::vector<TracedDirection> traced;
  for (const LightRay& direction : directions) {
    std::vector<TracedDirection> of_direction;
    for (const Material& material : tracer::example_materials())
      of_direction.push_back({direction, material, {}});
    const auto ray_at = [&](const std::array<double, 3>& u) {
      return LightRay{aperture, direction.theta, direction.phi, 2 * u[0] - 1};
    };
    const auto value = [](const TracedDirection& of, const tracer::Path& path) {
      return tracer::reflectance(path, of.material);
    };
    average(grooves, ray_at, value, of_direction, rays, seed++);
    traced.insert(traced.end(), of_direction.begin(), of_direction.end());
  }
  return traced;
}

std::vector<TracedHemisphere> trace_hemisphere(double aperture, std::span<const DiffuseQuantity> quantities,
                                               std::int64_t rays, std::uint64_t seed) {
  std::vector<TracedHemisphere> traced;
  for (const DiffuseQuantity& quantity : quantities) traced.push_back({aperture, quantity, {}});
  const auto ray_at = [&](const std::array<double, 3>& u) { return diffuse_ray(aperture, u); };
  const auto value = [](const TracedHemisphere& of, const tracer::Path& path) {
    const bool counts = std::ssize(path.bounces) <= of.quantity.max_bounces;
    return counts ? tracer::reflectance(path, of.quantity.material) : 0;
  };
  average(tracer::wide_groove_array(aperture), ray_at, value, traced, rays, seed);
  return traced;
}

std::vector<MeanComparison> compare(const DirectionalTheory& theory,
                                    std::span<const TracedDirection> traced) {
  std::vector<MeanComparison> comparisons;
  for (const auto& [ray, material, mean] : traced) {
    std::ostringstream what;
    what << material.name << ", aperture " << degrees(ray.aperture) << " deg, theta " << degrees(ray.theta)
         << " deg, phi " << degrees(ray.phi) << " deg";
    comparisons.push_back({what.str(), theory(ray, material), mean.mean(), mean.standard_error()});
  }
  return comparisons;
}

std::vector<MeanComparison> compare(const HemisphericalTheory& theory,
                                    std::span<const TracedHemisphere> traced) {
  std::vector<MeanComparison> comparisons;
  for (const auto& [aperture, quantity, mean] : traced) {
    std::ostringstream what;
    what << quantity.material.name << ", aperture " << degrees(aperture) << " deg, diffuse light";
    if (quantity.max_bounces < every_bounce) what << ", at most " << quantity.max_bounces << " bounces";
    comparisons.push_back({what.str(), theory(aperture, quantity.material, quantity.max_bounces), mean.mean(),
                           mean.standard_error()});
  }
  return comparisons;
}

}  // namespace agreement
