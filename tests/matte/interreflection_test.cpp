// SPDX-License-Identifier: BSD-3-Clause
/// H and the closed forms around it: identities, limits, and accuracy in every number type.

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <vcavity/matte/lambertian_cavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// κ̂(τ) from its definition, the Fourier integral of κ(u), by the trapezoidal rule: the route that the library does
/// not take.
double fourier_transform(double aperture, double tau) {
  const double step = std::min(0.25, pi<double>() * aperture / 42);
  double sum = 0;
  for (double u = 0; u <= 28; u += step) {
    const double kernel =
        std::pow(std::sin(aperture), 2) / 2 *
        std::pow(4 * (std::pow(std::sinh(u / 2), 2) + std::pow(std::sin(aperture / 2), 2)), -1.5);
    sum += (u > 0 ? 2 : 1) * step * kernel * std::cos(tau * u);
  }
  return sum;
}

}  // namespace

TEST_CASE("the transform of the kernel is its Fourier integral") {
  for (const double aperture_deg : {5.0, 45.0, 60.0, 90.0, 150.0, 179.0}) {
    const double aperture = radians(aperture_deg);
    const InterreflectionKernel<double> kernel{Cavity<double>(aperture)};
    const double step =
        std::acos(-1.0) * std::acos(-1.0) / (2.0 - std::log(std::numeric_limits<double>::epsilon()));
    for (std::size_t i = 0; i < kernel.nodes().size(); ++i) {
      const double tau = std::sinh(static_cast<double>(i) * step) / 2;
      CAPTURE(aperture_deg, tau);
      CHECK(std::abs(kernel.nodes()[i].transform - fourier_transform(aperture, tau)) < 1e-14);
      CHECK(std::abs(kernel.nodes()[i].transform + kernel.nodes()[i].complement - 1) < 1e-15);
    }
  }
}

TEST_CASE("the mean of what the kernel lacks from one is the sine of half the aperture") {
  for (const double aperture_deg : {1e-3, 1.0, 30.0, 90.0, 175.0}) {
    const Cavity<double> cavity(radians(aperture_deg));
    const InterreflectionKernel<double> kernel(cavity);
    double sum = kernel.tail_weight();
    for (const auto& node : kernel.nodes()) sum += node.weight * node.complement;
    CHECK(std::abs(sum / cavity.sin_half() - 1) < 3e-15);
  }
}

TEMPLATE_LIST_TEST_CASE("every number type has nearly all digits of H, however extreme aperture and albedo",
                        "", HardwareReals) {
  using Real = TestType;
  double worst = 0;
  for (const double aperture_deg : {1e-3, 0.7, 5.0, 45.0, 90.0, 150.0, 179.9}) {
    const Real aperture = radians(Real(aperture_deg));
    const InterreflectionKernel<Real> kernel{Cavity<Real>(aperture)};
    const InterreflectionKernel<Digits50> exact{Cavity<Digits50>(Digits50(aperture))};
    for (const double albedo : {-0.8, 1e-12, 1e-3, 0.2, 0.5, 0.8, 0.99, 0.9999}) {
      CAPTURE(aperture_deg, albedo);
      const auto gain = kernel.gain(Real(albedo));
      const auto expected = exact.gain(Digits50(Real(albedo)));
      const auto check = [&](const Real& actual, const Digits50& wanted, double allowed) {
        const double error = error_in_epsilons(actual, wanted);
        worst = std::max(worst, error);
        CHECK(error < allowed);
      };
      check(gain.rim(), expected.rim(), 8);
      if (albedo < 0) continue;  // of light that is odd across the groove H alone means something
      check(gain.bihemispherical, expected.bihemispherical, 12);
      check(gain.reflectance, expected.reflectance, 12);
    }
  }
  CHECK(worst > 0);
}

TEST_CASE("white panels lose no light, black ones return none, a flat surface has its albedo") {
  for (const double aperture_deg : {1e-3, 1.0, 45.0, 120.0, 180.0}) {
    CAPTURE(aperture_deg);
    const Cavity<double> cavity(radians(aperture_deg));
    const LambertianCavity<double> white(cavity, 1.0), black(cavity, 0.0);
    CHECK(white.bihemispherical_reflectance() == 1);
    CHECK(black.bihemispherical_reflectance() == 0);
    for (const double theta_deg : {-90.0, -70.0, 0.0, 30.0, 89.0}) {
      const Vec3<double> e = direction(radians(std::abs(theta_deg)), theta_deg < 0 ? pi<double>() : 0.0);
      CHECK(white.directional_reflectance(e) == 1);
      CHECK(std::abs(black.directional_reflectance(e)) < 1e-14);
    }
  }
  const LambertianCavity<double> flat(Cavity<double>(pi<double>()), 0.37);
  CHECK(std::abs(flat.bihemispherical_reflectance() - 0.37) < 1e-15);
  CHECK(std::abs(flat.brdf(direction(0.3, 1.0), direction(1.2, 4.0)) - 0.37 / pi<double>()) < 1e-15);
}

TEST_CASE("colours and packs of wavelengths are computed component by component") {
  const InterreflectionKernel<double> kernel{Cavity<double>(radians(50.0))};
  const glm::dvec3 colour = bihemispherical_reflectance(kernel, glm::dvec3(0.2, 0.5, 0.9));
  const auto pack = bihemispherical_reflectance(kernel, Pack<double, 5>({0.1, 0.3, 0.5, 0.7, 0.95}),
                                                Pack<double, 5>({0.1, 0.2, 0.5, 0.1, 0.0}));
  const glm::vec3 single = bihemispherical_reflectance(kernel, glm::vec3(0.2f, 0.5f, 0.9f));
  CHECK(colour.x == bihemispherical_reflectance(kernel, 0.2));
  CHECK(colour.z == bihemispherical_reflectance(kernel, 0.9));
  CHECK(single.y == Approx(colour.y).epsilon(1e-6));
  CHECK(pack[0] == bihemispherical_reflectance(kernel, 0.1));
  CHECK(pack[3] == bihemispherical_reflectance(kernel, 0.7, 0.1));
  CHECK(pack[4] == bihemispherical_reflectance(kernel, 0.95, 0.0));
}

TEST_CASE("two albedos that are nearly equal have nearly the reflectance of the mean") {
  for (const double aperture_deg : {1.0, 30.0, 90.0, 160.0})
    for (const double albedo : {1e-6, 0.3, 0.9}) {
      const InterreflectionKernel<double> kernel{Cavity<double>(radians(aperture_deg))};
      const double apart = 1e-7 * albedo;
      const double different = bihemispherical_reflectance(kernel, albedo - apart, albedo + apart);
      CHECK(std::abs(different - bihemispherical_reflectance(kernel, albedo)) <
            1e-13 / radians(aperture_deg));
    }
}

TEST_CASE("an albedo out of range is refused by its value") {
  const Cavity<double> cavity(1.0);
  for (const double albedo : {-0.1, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS((LambertianCavity<double>(cavity, albedo)), std::invalid_argument);
    CHECK_THROWS_AS(bihemispherical_reflectance(InterreflectionKernel<double>(cavity), albedo),
                    std::invalid_argument);
  }
  CHECK_THROWS_WITH((LambertianCavity<double>(cavity, 0.5, 1.5)), Catch::Matchers::ContainsSubstring("1.5"));
}
