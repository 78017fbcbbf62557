// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/json_result.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"

using nlohmann::json;

namespace {

const std::string rough_metal = "--material 0.2+3i --distribution ggx --roughness 0.3 ";

}  // namespace

TEST_CASE("direction prints the BRDF of rough metal, in total and by the number of bounces") {
  // A reference case, tests/data/distribution_reference.json; azimuths there start at +x, here at +y.
  const json result = result_of("direction " + rough_metal + "--theta 30 --phi 90 --toward 40,-80");
  CHECK(result["distribution"] == "ggx");
  CHECK(result["roughness"] == 0.3);
  CHECK_FALSE(result.contains("aperture_deg"));
  const double cosine = std::cos(40 * std::acos(-1) / 180);
  CHECK(result["brdf_cos"].get<double>() == Approx(result["brdf"].get<double>() * cosine).epsilon(1e-12));
  double sum = 0;
  for (const json& part : result["by_bounces"]) sum += part.get<double>();
  CHECK(sum == Approx(result["brdf_cos"].get<double>()).epsilon(1e-12));
  CHECK(result["by_bounces"].contains("1"));
  CHECK_FALSE(result["by_bounces"].contains("3"));

  const json full =
      result_of("direction " + rough_metal + "--theta 30 --phi 90 --toward 40,-80 --polarization full");
  CHECK(full["mueller"][0][0].get<double>() == Approx(0.88227128274722811).epsilon(1e-12));
  CHECK(full["mueller"][1][0].get<double>() == Approx(-0.018524280019606427).epsilon(1e-10));
  CHECK(full["mueller"][2][3].get<double>() == Approx(0.13926792895047168).epsilon(1e-10));
  CHECK(full["brdf_cos"].get<double>() == Approx(full["mueller"][0][0].get<double>()).epsilon(1e-12));
}

TEST_CASE(
    "next to the mirror direction, where the BRDF is infinite, it has the error of rounded directions") {
  const std::string from = "direction " + rough_metal + "--theta 30 --phi 90 --toward ";
  CHECK_FALSE(result_of(from + "30,-89").contains("error_estimate"));
  const json mirror = result_of(from + "30,-90");
  CHECK(mirror["error_estimate"].is_null());
  CHECK(mirror["brdf"].is_null());
  CHECK(mirror["brdf_cos"].is_null());
  CHECK(mirror["by_bounces"]["1"].get<double>() ==
        Approx(result_of(from + "30,-89.999")["by_bounces"]["1"].get<double>()).epsilon(1e-4));
  CHECK(result_of(from + "30,-90 --polarization full")["mueller"][0][0].is_null());
  // Both are this close to the mirror direction, one on either side of it.
  const json left = result_of(from + "30,-89.9999999"), right = result_of(from + "30,-90.0000001");
  const double error = left["error_estimate"].get<double>();
  CHECK(error > 1e-8 * left["brdf"].get<double>());
  CHECK(error < 1e-4 * left["brdf"].get<double>());
  CHECK(std::abs(left["brdf"].get<double>() - right["brdf"].get<double>()) < error);
}

TEST_CASE("axes of an anisotropic surface are those of the directions: AX along +x, AY along +y") {
  // The directions of the reference case "anisotropic", and everything turned by a right angle.
  const json result = result_of(
      "direction --material 0.2+3i --distribution ggx --roughness 0.1:0.5 --theta 30 --phi 70 --toward "
      "35,-100");
  const json turned = result_of(
      "direction --material 0.2+3i --distribution ggx --roughness 0.5:0.1 --theta 30 --phi -20 --toward "
      "35,170");
  CHECK(result["brdf_cos"].get<double>() == Approx(0.988335383896631777).epsilon(1e-10));
  CHECK(result["roughness_x"] == 0.1);
  CHECK(result["roughness_y"] == 0.5);
  CHECK(result["brdf"].get<double>() == Approx(turned["brdf"].get<double>()).epsilon(1e-10));
}

TEST_CASE("without a viewer the Mueller matrix is that of all reflected light") {
  const json result = result_of(
      "direction --material 1.5 --distribution ggx --roughness 0.3 --theta 55 --phi 20 --polarization full");
  const json& mueller = result["mueller"];
  CHECK(mueller[0][0].get<double>() == Approx(result["reflectance"].get<double>()).margin(2e-4));
  // Light polarised along the plane of incidence is hardly reflected near Brewster's angle.
  CHECK(mueller[0][1].get<double>() < -0.2 * mueller[0][0].get<double>());
}

TEST_CASE("without a viewer direction prints the albedo and the energies by the number of bounces") {
  const json result =
      result_of("direction --material 0.2+3i --distribution beckmann --roughness 0.6 --theta 20 --phi 0");
  double sum = 0;
  for (const json& part : result["by_bounces"]) sum += part.get<double>();
  CHECK(sum == Approx(result["reflectance"].get<double>()).margin(1e-5));
  CHECK(result["reflectance"].get<double>() > result["by_bounces"]["1"].get<double>());
}

TEST_CASE("table has a row for every roughness with an error estimate that holds") {
  const json result =
      result_of("table --material 1.5 --distribution beckmann --roughness 0.1,0.3:0.6:0.3 --tolerance 1e-6");
  REQUIRE(result["rows"].size() == 3);
  const double expected[] = {0.0881579, 0.0748064, 0.0591771};
  for (std::size_t i = 0; i < 3; ++i) {
    const json& row = result["rows"][i];
    CHECK(row["error_estimate"].get<double>() < 1e-6);
    CHECK(std::abs(row["reflectance"].get<double>() - expected[i]) <
          row["error_estimate"].get<double>() + 5e-8);
  }
}

TEST_CASE("table has a row for every concentration of brushed grooves") {
  const json rows = result_of(
      "table --material 1.5 --distribution brushed --roughness 0.2,0.5 --concentration 0,5:10:5 "
      "--tolerance 1e-3")["rows"];
  REQUIRE(rows.size() == 6);
  const double expected[] = {0, 5, 10};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(rows[i]["roughness"] == (i < 3 ? 0.2 : 0.5));
    CHECK(rows[i]["concentration"] == expected[i % 3]);
  }
}

TEST_CASE("options of distributions that do not fit are refused") {
  const std::string material = "direction --theta 0 --phi 0 --material 1.5 ";
  const auto check = [&](const std::string& options, const std::string& expected) {
    const Outcome outcome = run(material + options);
    CAPTURE(options, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(expected) != std::string::npos);
  };
  check("--roughness 0.3", "--roughness: ");
  check("--distribution ggx", "--roughness is required");
  check("--distribution ggx --roughness 0",
        "--roughness: '0' is not accepted, expected a number from 1e-06 to 1000");
  check("--distribution ggx --roughness 0.1:x", "--roughness: 'x' is not accepted");
  check("--distribution ggx --roughness 0.3 --aperture 45", "--aperture: ");
  check("--distribution ggx --roughness 0.3 --concentration 3", "--concentration: ");
  check("--distribution brushed --roughness 0.3:0.4", "--roughness: ");
  check("--distribution brushed --roughness 0.3 --concentration -1", "--concentration: '-1' is not accepted");
  check("--distribution phong --roughness 0.3", "--distribution: 'phong' is not accepted");
  check("--distribution ggx --roughness 0.3 --tilt 5 --aperture 45", "--aperture: ");
}
