// SPDX-License-Identifier: BSD-3-Clause
/// Reference cases of grooves with unequal panels, floors and land, from interval tracing in 35-digit arithmetic.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <variant>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/facet/panel_facets.hpp>
#include <vcavity/profiles/bihemispherical.hpp>
#include <vcavity/profiles/trench.hpp>
#include <vcavity/profiles/truncated_groove.hpp>

#include "profiles/random_profiles.hpp"
#include "support/catch.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

const nlohmann::json& cases() {
  static const nlohmann::json data =
      nlohmann::json::parse(std::ifstream(VCAVITY_TEST_DATA "/profile_cases.json"));
  return data;
}

/// A metal or, without k, a glass: the same formula serves both.
Conductor<double> facet_of(const nlohmann::json& index) {
  return {index[0].get<double>(), index[1].get<double>()};
}

AsymmetricGroove<double> groove_of(const nlohmann::json& row) {
  return {radians(row["aperture_deg"].get<double>()), radians(row["tilt_deg"].get<double>())};
}

Vec3<double> light_of(const nlohmann::json& row) {
  return direction(radians(row["theta_deg"].get<double>()), radians(row["phi_deg"].get<double>()));
}

/// The reference's names for the faces, which calls panels left and right.
std::string renamed(std::string way) {
  std::replace(way.begin(), way.end(), '1', 'L');
  std::replace(way.begin(), way.end(), '2', 'R');
  return way;
}

void check_direction(const Vec3<double>& actual, const nlohmann::json& expected) {
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(actual[static_cast<glm::length_t>(i)] - expected[i].get<double>()) < 1e-12);
}

void check_number(double actual, const nlohmann::json& expected) {
  CHECK(std::abs(actual - expected.get<double>()) < 1e-12);
}

/// Lobes and reflectances of a profile with one facet on all faces.
template <class Shape>
void check_profile(const Shape& profile, const nlohmann::json& row) {
  const Vec3<double> e = light_of(row);
  const auto facet = facet_of(row["index"]);
  const auto found = lobes(profile.groove(), e, facet);
  const auto with_fields = lobes(profile.groove(), e, polarized(facet));
  REQUIRE(found.size() == row["lobes"].size());
  for (const auto& expected : row["lobes"]) {
    CAPTURE(expected.dump());
    const auto lobe = std::find_if(found.begin(), found.end(), [&](const auto& l) {
      return renamed(l.path.text()) == expected["facets"].get<std::string>();
    });
    REQUIRE(lobe != found.end());
    const auto i = static_cast<std::size_t>(lobe - found.begin());
    check_number(lobe->weight, expected["weight"]);
    check_number(lobe->throughput, expected["throughput_none"]);
    check_number(unpolarized(power(with_fields[i].throughput)), expected["throughput_full"]);
    check_direction(lobe->direction, expected["out"]);
  }
  check_number(directional_reflectance(profile.groove(), e, facet), row["R_groove_none"]);
  check_number(unpolarized(directional_reflectance(profile.groove(), e, polarized(facet))),
               row["R_groove_full"]);
  check_number(directional_reflectance(profile, e, facet), row["R_none"]);
  check_number(unpolarized(directional_reflectance(profile, e, polarized(facet))), row["R_full"]);
}

}  // namespace

TEST_CASE("lobes of asymmetric grooves agree with the reference cases") {
  REQUIRE(cases()["asymmetric_directional"].size() == 6);
  for (const auto& row : cases()["asymmetric_directional"]) {
    CAPTURE(row.dump());
    const auto groove = groove_of(row);
    const Vec3<double> e = light_of(row);
    const PanelFacets facets{facet_of(row["panel1"]), facet_of(row["panel2"])};
    const PanelFacets with_fields{polarized(facets.one), polarized(facets.two)};
    const auto found = lobes(groove, e, facets);
    const auto polarized_lobes = lobes(groove, e, with_fields);
    REQUIRE(found.size() == row["lobes"].size());
    for (const auto& expected : row["lobes"]) {
      CAPTURE(expected.dump());
      const auto lobe = std::find_if(found.begin(), found.end(), [&](const auto& l) {
        return static_cast<int>(l.first_panel) == expected["first_panel"].get<int>() &&
               l.bounces == expected["bounces"].get<int>();
      });
      REQUIRE(lobe != found.end());
      check_number(lobe->weight, expected["weight"]);
      check_number(lobe->throughput, expected["throughput_none"]);
      const auto i = static_cast<std::size_t>(lobe - found.begin());
      check_number(unpolarized(power(polarized_lobes[i].throughput)), expected["throughput_full"]);
      check_direction(lobe->direction, expected["out"]);
    }
    check_number(directional_reflectance(groove, e, facets), row["R_none"]);
    check_number(unpolarized(directional_reflectance(groove, e, with_fields)), row["R_full"]);
  }
}

TEST_CASE("lobes of grooves with floor and land agree with the reference cases") {
  REQUIRE(cases()["truncated_directional"].size() == 4);
  for (const auto& row : cases()["truncated_directional"]) {
    CAPTURE(row.dump());
    const double slope_one = row["beta1_deg"], slope_two = row["beta2_deg"], floor = row["floor_over_depth"],
                 land = row["land_fraction"];
    if (slope_one == 90 && slope_two == 90)
      check_profile(Land(Trench<double>(floor), land), row);
    else
      check_profile(Land(TruncatedGroove<double>(radians(slope_one), radians(slope_two), floor), land), row);
  }
}

TEST_CASE("bi-hemispherical reflectances of asymmetric grooves agree with the reference cases") {
  REQUIRE(cases()["asymmetric_bihemispherical"].size() == 5);
  for (const auto& row : cases()["asymmetric_bihemispherical"]) {
    CAPTURE(row.dump());
    const auto groove = groove_of(row);
    const PanelFacets facets{facet_of(row["panel1"]), facet_of(row["panel2"])};
    const auto scalar = bihemispherical_reflectance(groove, facets, 1e-13);
    check_number(scalar.value, row["none"]);
    CHECK(scalar.error < 1e-12);
    const PanelFacets with_fields{polarized(facets.one), polarized(facets.two)};
    check_number(bihemispherical_reflectance(groove, with_fields, 1e-13).value, row["full"]);
  }
}
