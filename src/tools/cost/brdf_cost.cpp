// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cost/brdf_cost.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "tools/cost/measurement.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

using Directions = std::vector<Vec3<double>>;

/// Directions of the hemisphere, by cosine, as diffuse light has them.
Directions random_directions(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Directions directions(count);
  for (Vec3<double>& e : directions) {
    const double sine2 = unit(random), azimuth = 2 * pi<double>() * unit(random);
    e = direction(std::asin(std::sqrt(sine2)), azimuth);
  }
  return directions;
}

std::string counted(const char* what, int number) {
  std::string text = what;
  return text.append(" ").append(std::to_string(number));
}

/// Values of the BRDF × cosine at pairs of directions.
template <class Distribution, class Facet>
CostSection cost_of_values(const Distribution& distribution, const Facet& facet) {
  constexpr std::size_t pairs = 2000;
  const Directions from = random_directions(pairs, 1), to = random_directions(pairs, 2);
  const auto values = [&](int limit) {
    const RoughGrooveBsdf bsdf(distribution, facet, limit);
    std::vector<double> result(pairs);
    for (std::size_t i = 0; i < pairs; ++i) result[i] = bsdf.evaluate(from[i], to[i]);
    return result;
  };
  constexpr int reference = 4096;
  const std::vector<double> expected = values(reference);
  double size = 0;
  for (const double value : expected) size += value;
  CostSection section{
      "BRDF of " + std::to_string(pairs) + " pairs of directions",
      "mean absolute error of BRDF x cosine over its mean, against a limit of " + std::to_string(reference),
      {}};
  for (const int limit : {1, 2, 4, 8, 16, 32, 64, 128}) {
    std::vector<double> found;
    const double seconds = median_seconds([&] { found = values(limit); });
    double error = 0;
    for (std::size_t i = 0; i < pairs; ++i) error += std::abs(found[i] - expected[i]);
    section.rows.push_back({"closed form", counted("bounces", limit), error / size, seconds, 0});
  }
  return section;
}

/// The mean of random rays, each in a groove of its own.
template <class Distribution, class Facet>
double random_walks(const Distribution& distribution, const Vec3<double>& e, const Facet& facet, int rays,
                    unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  double sum = 0;
  for (int i = 0; i < rays; ++i) {
    const double u_slope = unit(random), u_azimuth = unit(random);
    const Vec3<double> m = distribution.sample({u_slope, u_azimuth});
    const double across = std::hypot(m.x, m.y);
    const Cavity<double> groove(2 * std::atan2(m.z, across));
    const Vec3<double> in_groove{(e.x * m.y - e.y * m.x) / across, (e.x * m.x + e.y * m.y) / across, e.z};
    sum += ray_reflectance(groove, in_groove, 2 * unit(random) - 1, facet);
  }
  return sum / rays;
}

/// The directional albedo of some directions.
template <class Distribution, class Facet>
CostSection cost_of_albedo(const Distribution& distribution, const Facet& facet) {
  constexpr double finest = 1e-6;
  const std::array angles_deg{0.0, 45.0, 80.0};
  Directions directions;
  for (const double angle : angles_deg) directions.push_back(direction(radians(angle), 0.3));
  const auto albedos = [&](auto&& albedo) {
    std::vector<double> result;
    for (const Vec3<double>& e : directions) result.push_back(albedo(e));
    return result;
  };
  const std::vector<double> expected = albedos(
      [&](const Vec3<double>& e) { return directional_albedo(distribution, e, facet, finest).value; });
  CostSection section{"albedo of 3 directions",
                      "largest absolute error of a directional albedo (of random walks: root mean square), "
                      "against quadrature to 1e-6",
                      {}};
  const auto add = [&](const char* method, std::string setting, auto&& albedo) {
    std::vector<double> found;
    const double seconds = median_seconds([&] { found = albedos(albedo); });
    section.rows.push_back({method, std::move(setting), largest_error(found, expected), seconds, 0});
  };
  for (const int exponent : {-2, -3, -4})
    add("quadrature, all bounces", "tolerance 1e" + std::to_string(exponent), [&](const Vec3<double>& e) {
      return directional_albedo(distribution, e, facet, std::pow(10, exponent)).value;
    });
  for (const int limit : {1, 2, 4, 8, 16})
    add("quadrature to 1e-4, bounce limit", counted("bounces", limit),
        [&](const Vec3<double>& e) { return directional_albedo(distribution, e, facet, 1e-4, limit).value; });
  const RoughAlbedoTable<double> table(distribution, facet, 1e-4);
  add("albedo table", "asked, once made", [&](const Vec3<double>& e) { return table(e); });
  for (const int rays : {100, 1'000, 10'000}) {
    double squares = 0;
    constexpr unsigned runs = 8;
    for (unsigned seed = 1; seed <= runs; ++seed)
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const double error = random_walks(distribution, directions[i], facet, rays, seed) - expected[i];
        squares += error * error / (runs * static_cast<double>(directions.size()));
      }
    unsigned seed = runs;
    const double seconds = median_seconds([&] {
      ++seed;
      for (const Vec3<double>& e : directions) random_walks(distribution, e, facet, rays, seed);
    });
    section.rows.push_back({"random walks, explicit grooves", counted("rays", rays), std::sqrt(squares),
                            seconds, rays * static_cast<long long>(directions.size())});
  }
  return section;
}

template <class Distribution>
std::vector<CostSection> costs_of(const Distribution& distribution, const RefractiveIndex& index) {
  const Conductor<double> facet(index.n, index.k);
  return {cost_of_values(distribution, facet), cost_of_albedo(distribution, facet)};
}

}  // namespace

std::vector<CostSection> costs_of_brdf(const SurfaceDescription& surface, double wavelength_nm) {
  const RefractiveIndex index = surface.material.at(wavelength_nm);
  const Roughness& roughness = *surface.roughness;
  switch (roughness.distribution) {
    case Roughness::Distribution::ggx:
      return costs_of(GgxSlopes<double>(roughness.along_x, roughness.along_y), index);
    case Roughness::Distribution::beckmann:
      return costs_of(BeckmannSlopes<double>(roughness.along_x, roughness.along_y), index);
    default:
      return costs_of(BrushedSlopes(BeckmannSlopes<double>(roughness.along_x), roughness.concentration),
                      index);
  }
}

}  // namespace vcavity::tools
