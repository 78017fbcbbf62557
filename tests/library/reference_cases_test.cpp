// SPDX-License-Identifier: BSD-3-Clause
/// Reference cases from explicit real-space tracing in 40-digit arithmetic: no unfolding, no bounce-count
/// formula.

#include <fstream>
#include <nlohmann/json.hpp>
#include <variant>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

const nlohmann::json& cases() {
  static const nlohmann::json data =
      nlohmann::json::parse(std::ifstream(VCAVITY_TEST_DATA "/reference_cases.json"));
  return data;
}

using Facet = std::variant<Dielectric<double>, Conductor<double>>;

Facet facet_of(const nlohmann::json& row) {
  const double n = row["n"];
  const double k = row["k"];
  if (k == 0) return Dielectric<double>(n);
  return Conductor<double>(n, k);
}

Cavity<double> cavity_of(const nlohmann::json& row) {
  return Cavity<double>(radians(row["aperture_deg"].get<double>()));
}

Vec3<double> direction_of(const nlohmann::json& row) {
  return direction(radians(row["theta_deg"].get<double>()), radians(row["phi_deg"].get<double>()));
}

void check_direction(const Vec3<double>& actual, const nlohmann::json& expected) {
  for (glm::length_t i = 0; i < 3; ++i)
    CHECK(actual[i] ==
          Approx(expected[static_cast<std::size_t>(i)].get<double>()).epsilon(1e-9).margin(1e-12));
}

}  // namespace

TEST_CASE("single rays agree with real-space tracing") {
  REQUIRE(cases()["rays"].size() == 40);
  for (const auto& row : cases()["rays"]) {
    CAPTURE(row.dump());
    const Cavity<double> cavity = cavity_of(row);
    const Vec3<double> e = direction_of(row);
    const RayPath path = ray_path(cavity, e, row["y"].get<double>());
    CHECK(path.bounces == row["bounces"].get<int>());
    CHECK(static_cast<int>(path.first_panel) == row["first_panel"].get<int>());
    check_direction(ray_exit_direction(cavity, e, path), row["out"]);
    const double reflectance =
        std::visit([&](const auto& facet) { return ray_reflectance(cavity, e, path, facet); }, facet_of(row));
    CHECK(reflectance == Approx(row["scalar"].get<double>()).epsilon(1e-9));
    const double with_fields = std::visit(
        [&](const auto& facet) { return unpolarized(ray_reflectance(cavity, e, path, polarized(facet))); },
        facet_of(row));
    CHECK(with_fields == Approx(row["polarized"].get<double>()).epsilon(1e-9));
  }
}

TEST_CASE("directional reflectance and lobes agree with real-space tracing") {
  REQUIRE(cases()["directions"].size() == 20);
  for (const auto& row : cases()["directions"]) {
    CAPTURE(row.dump());
    const Cavity<double> cavity = cavity_of(row);
    const Vec3<double> e = direction_of(row);
    const Facet facet = facet_of(row);
    CHECK(std::visit([&](const auto& f) { return directional_reflectance(cavity, e, f); }, facet) ==
          Approx(row["scalar"].get<double>()).epsilon(1e-9));
    CHECK(std::visit(
              [&](const auto& f) { return unpolarized(directional_reflectance(cavity, e, polarized(f))); },
              facet) == Approx(row["polarized"].get<double>()).epsilon(1e-9));

    const auto found = std::visit([&](const auto& f) { return lobes(cavity, e, f); }, facet);
    REQUIRE(found.size() == row["lobes"].size());
    for (const auto& expected : row["lobes"]) {
      const auto lobe = std::find_if(found.begin(), found.end(), [&](const auto& l) {
        return static_cast<int>(l.first_panel) == expected["first_panel"].get<int>() &&
               l.bounces == expected["bounces"].get<int>();
      });
      REQUIRE(lobe != found.end());
      CHECK(lobe->weight == Approx(expected["weight"].get<double>()).epsilon(1e-9));
      CHECK(lobe->throughput == Approx(expected["scalar"].get<double>()).epsilon(1e-9));
      const double with_fields = std::visit(
          [&](const auto& f) {
            const auto index = static_cast<std::size_t>(lobe - found.begin());
            return unpolarized(power(lobes(cavity, e, polarized(f))[index].throughput));
          },
          facet);
      CHECK(with_fields == Approx(expected["polarized"].get<double>()).epsilon(1e-9));
      check_direction(lobe->direction, expected["out"]);
    }
  }
}
