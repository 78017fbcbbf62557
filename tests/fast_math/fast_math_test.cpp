// SPDX-License-Identifier: BSD-3-Clause
/// What docs/accuracy.md promises to programs that are compiled with -ffast-math.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

template <class Real>
Vec3<Real> direction_of(const nlohmann::json& row) {
  return direction(radians(row["theta_deg"].get<Real>()), radians(row["phi_deg"].get<Real>()));
}

}  // namespace

TEMPLATE_TEST_CASE("with -ffast-math directional reflectances are still those of real-space tracing", "",
                   float, double) {
  using Real = TestType;
  const auto cases = nlohmann::json::parse(std::ifstream(VCAVITY_TEST_DATA "/reference_cases.json"));
  const auto& rows = cases["directions"];
  REQUIRE(rows.size() == 20);
  for (const auto& row : rows) {
    CAPTURE(row.dump());
    const Cavity<Real> cavity(radians(row["aperture_deg"].get<Real>()));
    // In float n = 1.0003 itself cannot carry the contrast.
    const double n = row["n"];
    const auto facet = Conductor<Real>::from_contrast(static_cast<Real>(n - 1), row["k"].get<Real>());
    const Real reflectance = directional_reflectance(cavity, direction_of<Real>(row), facet);
    const double expected = row["scalar"];
    // The reference has 12 digits; angles and indices are rounded to Real.
    const double tolerance =
        std::max(1e-11, 200.0 * static_cast<double>(std::numeric_limits<Real>::epsilon()));
    CHECK(std::abs(static_cast<double>(reflectance) - expected) <= tolerance * expected);
  }
}

TEMPLATE_TEST_CASE("with -ffast-math weights still add up to one and nothing exceeds its limits", "", float,
                   double) {
  using Real = TestType;
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  const Conductor<Real> silver(Real(0.1249), Real(3.3391));
  for (const Real& aperture_deg : {Real(0.5), Real(30), Real(45), Real(90), Real(133), Real(180)})
    for (int theta_deg = 0; theta_deg <= 90; ++theta_deg)
      for (int phi_deg = 0; phi_deg <= 90; phi_deg += 15) {
        const Cavity<Real> cavity(radians(aperture_deg));
        Vec3<Real> e = direction(radians(Real(theta_deg)), radians(Real(phi_deg)));
        if (theta_deg == 90) e.z = Real(0);
        CAPTURE(aperture_deg, theta_deg, phi_deg);
        Real sum(0);
        for (const auto& lobe : lobes(cavity, e, silver)) {
          CHECK(lobe.weight > Real(0));
          CHECK(lobe.bounces >= 1);
          CHECK(lobe.bounces <= cavity.max_bounces());
          sum += lobe.weight;
        }
        CHECK(std::abs(sum - Real(1)) <= Real(4) * epsilon);
        const Real total =
            directional_reflectance(cavity, e, silver) + directional_absorptance(cavity, e, silver);
        CHECK(std::abs(total - Real(1)) <= Real(16 + 8 * cavity.max_bounces()) * epsilon);
      }
}

TEST_CASE("with -ffast-math thousands of bounces do not drift") {
  const Cavity<double> slit(radians(0.01));
  UnfoldedRay<double> ray(slit, {0.0, 0.0, 1.0}, Panel::one);
  while (ray.number() < slit.max_bounces()) ray.advance();
  const double expected = std::sin((slit.max_bounces() - 0.5) * slit.aperture());
  CHECK(std::abs(ray.normal_component() - expected) <= 16 * std::numeric_limits<double>::epsilon());
}

TEST_CASE("with -ffast-math what lies out of range is still refused, except what is not a number") {
  CHECK_THROWS_AS(Cavity<double>(0.0), std::invalid_argument);
  CHECK_THROWS_AS(Cavity<double>(3.2), std::invalid_argument);
  CHECK_THROWS_AS(Conductor<double>(-1, 1), std::invalid_argument);
  CHECK_THROWS_AS(Dielectric<double>(1e100), std::invalid_argument);
}
