// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cost/traced_reflectance.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "light_ray.hpp"
#include "textbook_fresnel.hpp"

namespace vcavity::tools {

DiffuseTracer diffuse_tracer(double aperture, std::complex<double> index) {
  return [aperture, material = tracer::Material{"", index}, grooves = tracer::wide_groove_array(aperture)](
             int rays, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    TracedReflectance result{0, 0};
    for (int i = 0; i < rays; ++i) {
      tracer::LightRay ray{aperture, 0, 0, 0};
      ray.theta = std::asin(std::sqrt(unit(random)));
      ray.phi = 2 * std::numbers::pi * unit(random);
      ray.position = 2 * unit(random) - 1;
      const tracer::Path path = trace(grooves, ray);
      result.mean += tracer::reflectance(path, material) / rays;
      result.reflections += static_cast<long long>(path.bounces.size());
    }
    return result;
  };
}

}  // namespace vcavity::tools
