// SPDX-License-Identifier: BSD-3-Clause
/// Reference cases from the Wiener–Hopf integral in 30-digit arithmetic and from an independent Nyström solution.

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vcavity/matte/lambertian_cavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

const nlohmann::json& cases(const char* name, std::size_t count) {
  static const nlohmann::json data =
      nlohmann::json::parse(std::ifstream(VCAVITY_TEST_DATA "/lambertian_cases.json"));
  REQUIRE(data.at(name).size() == count);
  return data.at(name);
}

Cavity<double> cavity_of(const nlohmann::json& row) {
  return Cavity<double>(radians(row.at("aperture_deg").get<double>()));
}

Vec3<double> across(double theta_deg) {
  const double theta = radians(theta_deg);
  return {0, std::sin(theta), std::cos(theta)};
}

void check(double actual, const nlohmann::json& expected, double tolerance) {
  CHECK(std::abs(actual - expected.get<double>()) <= tolerance);
}

// The references have 16 digits; a few units in the last place of 1 are what both roundings leave.
constexpr double rounding = 2e-15;

}  // namespace

TEST_CASE(
    "interreflection within the aperture, at grazing incidence and in diffuse light is that of 30 digits") {
  for (const auto& row : cases("lambertian", 12)) {
    CAPTURE(row.dump());
    const InterreflectionKernel<double> kernel(cavity_of(row));
    const double albedo = row.at("albedo");
    const auto gain = kernel.gain(albedo);
    check(gain.rim(), row.at("H"), rounding);
    check(kernel.gain(-albedo).rim(), row.at("H_minus"), rounding);
    check(gain.reflectance, row.at("R_within_aperture"), rounding);
    check(gain.grazing(), row.at("R_grazing"), rounding);
    check(gain.bihemispherical, row.at("R_bihemispherical"), rounding);
    check(bihemispherical_reflectance(kernel, albedo), row.at("R_bihemispherical"), rounding);
  }
}

TEST_CASE("all directions within the aperture have the reference reflectance") {
  for (const auto& row : cases("lambertian", 12)) {
    CAPTURE(row.dump());
    const LambertianCavity<double> matte(cavity_of(row), row.at("albedo").get<double>());
    const double half = row.at("aperture_deg").get<double>() / 2;
    for (const double share : {-0.999, -0.4, 0.0, 0.7, 0.999})
      check(matte.directional_reflectance(across(share * half)), row.at("R_within_aperture"), rounding);
    check(matte.directional_reflectance({0, 1, 0}), row.at("R_grazing"), 1e-12);
  }
}

TEST_CASE("directions beyond the aperture agree with an independent Nyström solution") {
  for (const auto& row : cases("lambertian_outside_aperture", 3)) {
    CAPTURE(row.dump());
    const LambertianCavity<double> matte(cavity_of(row), row.at("albedo").get<double>());
    const double theta_deg = row.at("theta_prime_deg");
    // The references are given to 13 decimals.
    for (const double side : {-1.0, 1.0})
      check(matte.directional_reflectance(across(side * theta_deg)), row.at("R_directional_hemispherical"),
            5e-13);
  }
}

TEST_CASE("the BRDF within the aperture is that of the reference cases") {
  for (const auto& row : cases("lambertian_brdf_within_aperture", 2)) {
    CAPTURE(row.dump());
    const LambertianCavity<double> matte(cavity_of(row), row.at("albedo").get<double>());
    const Vec3<double> light = across(row.at("theta_prime_light_deg"));
    const Vec3<double> viewer = across(row.at("theta_prime_view_deg"));
    check(matte.brdf(light, viewer), row.at("brdf"), rounding);
    check(matte.brdf(viewer, light), row.at("brdf"), rounding);
  }
}

TEST_CASE("panels of two albedos have the reference reflectance, whichever is which") {
  for (const auto& row : cases("lambertian_two_albedos", 1)) {
    CAPTURE(row.dump());
    const InterreflectionKernel<double> kernel(cavity_of(row));
    const double one = row.at("albedo1"), two = row.at("albedo2");
    check(bihemispherical_reflectance(kernel, one, two), row.at("R_bihemispherical"), rounding);
    check(bihemispherical_reflectance(kernel, two, one), row.at("R_bihemispherical"), rounding);
  }
}
