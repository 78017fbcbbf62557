// SPDX-License-Identifier: BSD-3-Clause
/// Fields carried along the paths that Embree finds, against the Mueller matrices of the closed form.

#include <cmath>
#include <random>
#include <vcavity/vcavity.hpp>

#include "light_ray.hpp"
#include "support/catch.hpp"
#include "support/wave.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// The normal of a panel of a relief, on its upper side.
Vec3<double> normal_of(const tracer::Relief& relief, int panel) {
  const auto index = static_cast<std::size_t>(panel);
  const glm::dvec2 along = glm::normalize(relief.profile[index + 1] - relief.profile[index]);
  return {0, -along.y, along.x};
}

}  // namespace

TEST_CASE("Stokes parameters after every path of the tracer are those of the closed form") {
  std::mt19937_64 random(307);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const double aperture_deg : {10.0, 45.0, 60.0, 100.0, 150.0}) {
    const double aperture = radians(aperture_deg);
    const tracer::Tracer grooves = tracer::wide_groove_array(aperture);
    const Cavity<double> cavity(aperture);
    int compared = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      const tracer::LightRay ray{aperture, std::acos(std::sqrt(0.01 + 0.99 * unit(random))),
                                 2 * pi<double>() * unit(random), 2 * unit(random) - 1};
      const tracer::Path path = tracer::trace(grooves, ray);
      if (path.ending != tracer::Ending::upwards || path.clearance < 1e-9) continue;

      const std::complex<double> index{0.05 + 3 * unit(random), 4 * unit(random)};
      const Vec3<double> e = direction(ray.theta, ray.phi);
      const Vec3<double> a = polarization_axis(-e);
      Wave wave{-e, along(a, {unit(random), unit(random)}) +
                        along(glm::cross(-e, a), {unit(random), unit(random)})};
      const Stokes<double> light = stokes(wave);
      for (const tracer::Bounce& bounce : path.bounces)
        wave = reflected(wave, normal_of(grooves.relief(), bounce.panel), index);
      const Stokes<double> expected = stokes(wave);

      const auto facet = polarized(Conductor<double>(index.real(), index.imag()));
      const Stokes<double> actual = ray_reflectance(cavity, e, ray.position, facet) * light;
      for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(actual[i] - expected[i]) <= 1e-9 * expected[0]);
      ++compared;
    }
    CHECK(compared > 3900);
  }
}
