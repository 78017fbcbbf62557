// SPDX-License-Identifier: BSD-3-Clause
/// Radiosity along the panels, and with it light from beyond the aperture.

#include <cmath>
#include <vcavity/matte/lambertian_cavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

/// ∫ f(x) dx over [from, to]
template <class Function>
double integral(double from, double to, const Function& f) {
  double sum = 0;
  for (const auto& node : gauss_legendre<double>(40))
    sum += node.weight * (to - from) / 2 * f(from + (to - from) * (1 + node.x) / 2);
  return sum;
}

/// The same for functions that vary on every scale towards 0.
template <class Function>
double integral_from_apex(const Function& f) {
  double sum = 0, to = 1;
  for (int i = 0; i < 30; ++i, to /= 2) sum += integral(to / 2, to, f);
  return sum + to * f(0.0);
}

Vec3<double> across(double theta) {
  return {0, std::sin(theta), std::cos(theta)};
}

}  // namespace

TEST_CASE(
    "gain by interreflection: its mean is H², at the rim it is H, at the apex that of an endless wedge") {
  for (const double aperture_deg : {20.0, 45.0, 60.0, 90.0, 120.0, 150.0})
    for (const double albedo : {0.2, 0.5, 0.9}) {
      CAPTURE(aperture_deg, albedo);
      const Cavity<double> cavity(radians(aperture_deg));
      const LambertianCavity<double> matte(cavity, albedo);
      const auto expected = matte.geometry()->kernel.gain(albedo);
      const auto gain = [&](double s) { return (1 - matte.radiosity(Panel::one, s)) / (1 - albedo); };
      CHECK(std::abs(integral_from_apex(gain) - expected.mean()) < 2e-11);
      CHECK(std::abs(gain(1) - expected.rim()) < 2e-11);
      CHECK(std::abs(gain(0) - 1 / (1 - albedo * cavity.cos_half() * cavity.cos_half())) < 1e-14);
    }
}

TEST_CASE("radiosity solves the integral equation of the panels") {
  const double aperture = radians(70.0);
  const LambertianCavity<double> matte(Cavity<double>(aperture), 0.9, 0.4);
  const auto kernel = [&](double s, double t) {
    return s * t * std::pow(std::sin(aperture), 2) / 2 *
           std::pow(s * s + t * t - 2 * s * t * std::cos(aperture), -1.5);
  };
  for (const double s : {0.02, 0.3, 0.8, 1.0})
    for (const Panel panel : {Panel::one, Panel::two}) {
      const auto from_other = [&](double t) { return kernel(s, t) * matte.radiosity(opposite(panel), t); };
      const double open = 1 - integral_from_apex([&](double t) { return kernel(s, t); });
      const double expected = matte.albedo(panel) * (open + integral_from_apex(from_other));
      CHECK(std::abs(matte.radiosity(panel, s) - expected) < 1e-11);
    }
}

TEST_CASE("the mean of the directional reflectance over diffuse light is the bi-hemispherical one") {
  for (const double aperture_deg : {8.0, 45.0, 90.0, 130.0})
    for (const auto& [one, two] : {std::pair{0.5, 0.5}, {0.9, 0.9}, {0.9, 0.2}}) {
      CAPTURE(aperture_deg, one, two);
      const double half = radians(aperture_deg) / 2;
      const LambertianCavity<double> matte(Cavity<double>(2 * half), one, two);
      const auto weighted = [&](double theta) {
        return std::cos(theta) / 2 * matte.directional_reflectance(across(theta));
      };
      double mean = integral(-half, half, weighted);
      // Beyond the aperture, on scales that shrink towards it.
      for (const double side : {-1.0, 1.0}) {
        double gap = pi<double>() / 2 - half;
        for (int i = 0; i < 30; ++i, gap /= 2)
          mean += integral(gap / 2, gap, [&](double beyond) { return weighted(side * (half + beyond)); });
      }
      CHECK(std::abs(mean - matte.bihemispherical_reflectance()) < 1e-9);
    }
}

TEST_CASE("beyond the aperture no error exceeds its estimate, and the estimate is small") {
  for (const double aperture_deg : {0.01, 1.0, 20.0, 45.0, 100.0, 170.0})
    for (const double albedo : {0.3, 0.95}) {
      CAPTURE(aperture_deg, albedo);
      const double aperture = radians(aperture_deg);
      const LambertianCavity<double> matte(Cavity<double>(aperture), albedo);
      const LambertianCavity<long double> finer(Cavity<long double>(static_cast<long double>(aperture)),
                                                static_cast<long double>(albedo));
      for (const double theta_deg : {aperture_deg / 2 + 0.5, 30.0, 60.0, 85.0, 89.99}) {
        if (theta_deg <= aperture_deg / 2 || theta_deg >= 90) continue;
        CAPTURE(theta_deg);
        const Vec3<double> e = across(radians(theta_deg));
        const double error =
            std::abs(matte.directional_reflectance(e) -
                     static_cast<double>(finer.directional_reflectance(Vec3<long double>(e))));
        CHECK(error <= matte.directional_error(e));
        CHECK(matte.directional_error(e) < 1e-8);
      }
    }
}

TEST_CASE("reflectance is continuous at the edge of the aperture and at grazing incidence") {
  for (const double aperture_deg : {3.0, 45.0, 110.0}) {
    const double half = radians(aperture_deg) / 2;
    const LambertianCavity<double> matte(Cavity<double>(2 * half), 0.7);
    const auto reflectance = [&](double theta) { return matte.directional_reflectance(across(theta)); };
    CHECK(std::abs(reflectance(half * (1 + 1e-9)) - reflectance(half * (1 - 1e-9))) < 1e-8);
    CHECK(std::abs(matte.directional_reflectance({0, 1, 1e-13}) - matte.directional_reflectance({0, 1, 0})) <
          1e-10);
    CHECK(matte.directional_reflectance({1, 0, 0}) == reflectance(0));
  }
}

TEST_CASE("absorptance keeps its digits where panels are almost white") {
  const LambertianCavity<double> matte(Cavity<double>(radians(60.0)), 1 - 1e-12);
  const double lack = 1 - (1 - 1e-12);
  const double gain = matte.geometry()->kernel.gain(1 - 1e-12).mean();
  CHECK(matte.directional_absorptance({0, 0, 1}) == Approx(lack * gain).epsilon(1e-13));
}

TEST_CASE("float and long double agree with double beyond the aperture") {
  const LambertianCavity<double> matte(Cavity<double>(radians(60.0)), 0.8);
  const LambertianCavity<float> single(Cavity<float>(radians(60.0f)), 0.8f);
  const LambertianCavity<long double> extended(Cavity<long double>(radians(60.0L)), 0.8L);
  for (const double theta_deg : {35.0, 60.0, 89.0}) {
    const double expected = matte.directional_reflectance(direction(radians(theta_deg), 0.0));
    const float theta = radians(static_cast<float>(theta_deg));
    CHECK(single.directional_reflectance(direction(theta, 0.0f)) == Approx(expected).epsilon(2e-6));
    const long double long_theta = radians(static_cast<long double>(theta_deg));
    CHECK(static_cast<double>(extended.directional_reflectance(direction(long_theta, 0.0L))) ==
          Approx(expected).epsilon(1e-11));
  }
}
