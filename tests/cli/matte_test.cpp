// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vcavity/matte/lambertian_cavity.hpp>
#include <vcavity/matte/lambertian_specular.hpp>

#include "cli/json_result.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"

using nlohmann::json;
using namespace vcavity;

TEST_CASE("table knows matte grooves of one albedo and of two") {
  const json result = result_of("table --finish matte --albedo 0.8,0.9/0.3 --aperture 60,180");
  REQUIRE(result["rows"].size() == 4);
  // Reference cases; flat panels of two albedos side by side reflect the mean.
  const double expected[] = {0.6726458679685511, 0.8, 0.4099234631395311, 0.6};
  for (std::size_t i = 0; i < 4; ++i) {
    const json& row = result["rows"][i];
    CHECK(row["finish"] == "matte");
    CHECK(row["albedo"] == (i < 2 ? "0.8" : "0.9/0.3"));
    CHECK_FALSE(row.contains("material"));
    CHECK(std::abs(row["reflectance"].get<double>() - expected[i]) <= row["error_estimate"].get<double>());
  }
}

TEST_CASE("an albedo may be a range") {
  const json rows = result_of("table --finish matte --albedo 0.1:0.9:0.4,0.3 --aperture 60")["rows"];
  REQUIRE(rows.size() == 4);
  const char* expected[] = {"0.1", "0.5", "0.9", "0.3"};
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i]["albedo"] == expected[i]);
}

TEST_CASE("direction tells reflectance and BRDF of a matte groove, which panel is which included") {
  const json result = result_of(
      "direction --finish matte --albedo 0.9/0.3 --aperture 60 --theta 50 --phi 20 --toward 40,200");
  const LambertianCavity<double> matte(Cavity<double>(radians(60.0)), 0.9, 0.3);
  const Vec3<double> light = direction(radians(50.0), radians(20.0));
  const Vec3<double> viewer = direction(radians(40.0), radians(200.0));
  CHECK(result["reflectance"] == matte.directional_reflectance(light));
  CHECK(result["brdf"] == matte.brdf(light, viewer));
  CHECK(result["brdf_cos"] == Approx(matte.brdf(light, viewer) * viewer.z));
  CHECK(result["error_estimate"] == matte.brdf_error(light, viewer));
  // At 0 degrees of phi light comes from +y and lights panel one.
  const json bright = result_of("direction --finish matte --albedo 0.9/0.3 --aperture 60 --theta 70 --phi 0");
  const json dark = result_of("direction --finish matte --albedo 0.9/0.3 --aperture 60 --theta 70 --phi 180");
  CHECK(bright["reflectance"].get<double>() > 2 * dark["reflectance"].get<double>());
}

TEST_CASE("an albedo is a table of wavelengths or a colour") {
  const ScratchFolder folder;
  std::ofstream(folder / "paint.csv") << "# a paint\nwavelength_nm,reflectance\n500,0.2\n600,0.6\n";
  const json table =
      result_of("table --finish matte --albedo paint.csv --aperture 180 --wavelength 500,525", folder.path());
  CHECK(table["rows"][0]["albedo"] == "paint");
  CHECK(table["rows"][0]["reflectance"] == Approx(0.2));
  CHECK(table["rows"][1]["reflectance"] == Approx(0.3));
  // Greys are the same at all wavelengths: 0xbc is linear 0.5029.
  const json grey = result_of("table --finish matte --albedo #bcbcbc --aperture 180 --wavelength 400,650");
  CHECK(grey["rows"][0]["reflectance"] == Approx(0.502886).epsilon(1e-5));
  CHECK(grey["rows"][1]["reflectance"] == grey["rows"][0]["reflectance"]);
  const json two =
      result_of("table --finish matte --albedo paint.csv/0.1 --aperture 180 --wavelength 600", folder.path());
  CHECK(two["rows"][0]["reflectance"] == Approx(0.35));
}

TEST_CASE("tables of an albedo are read as spreadsheets write them, percentages where they say so") {
  const ScratchFolder folder;
  std::ofstream(folder / "paint.csv")
      << "\"Wavelength (\u00b5m)\";\"Reflectance (%)\"\r\n0,5;20,0\r\n\r\n0,6;60,0\r\n";
  const json table =
      result_of("table --finish matte --albedo paint.csv --aperture 180 --wavelength 525", folder.path());
  CHECK(table["rows"][0]["reflectance"] == Approx(0.3));
  for (const auto& [rows, words] : std::vector<std::pair<std::string, std::string>>{
           {"wavelength_nm,reflectance\n500,20\n", "bad.csv:2: reflectance 20, expected 0 to 1"},
           {"wavelength_nm,reflectance\n500,0.2,0.3\n", "bad.csv:2: expected 2 numbers, found 3"},
           {"wavelength_nm,reflectance\n500,red\n", "bad.csv:2: 'red' is not a finite number"},
           {"wavelength_nm;reflectance\n1,550;0.2\n", "bad.csv:2: '1,550'"},
           {"wavelength_nm,transmittance\n500,0.2\n",
            "bad.csv:1: the heading is 'wavelength_nm,transmittance'"},
           {"wavelength,reflectance\n500,0.2\n", "bad.csv:1: the heading is 'wavelength,reflectance'"},
           {"# nothing\nwavelength_nm,reflectance\n", "bad.csv:2: the table is empty"}}) {
    std::ofstream(folder / "bad.csv") << rows;
    const Outcome outcome = run("table --finish matte --albedo bad.csv --aperture 60", folder.path());
    CAPTURE(rows, outcome.err);
    CHECK(outcome.status == 1);
    CHECK(outcome.err.find(words) != std::string::npos);
    CHECK(lines_of(outcome.err).size() == 1);
  }
}

TEST_CASE("matte panels may be of unequal slope") {
  const json tilted = result_of("table --finish matte --albedo 0.8 --aperture 60 --tilt 0,20,45");
  // Reference cases; without a tilt the closed form.
  const std::vector<double> expected{0.6726458679685511, 0.6879969023423, 0.7472560977507};
  REQUIRE(tilted["rows"].size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const json& row = tilted["rows"][i];
    CHECK(row["tilt_deg"] == std::vector{0, 20, 45}[i]);
    CHECK(std::abs(row["reflectance"].get<double>() - expected[i]) < 1e-12);
  }
  const json sloped = result_of("table --finish matte --albedo 0.8 --slopes 80:40");
  CHECK(std::abs(sloped["rows"][0]["reflectance"].get<double>() - expected[1]) < 1e-12);

  const json there = result_of(
      "direction --finish matte --albedo 0.9/0.3 --aperture 60 --tilt 20 --theta 50 --phi 20 --toward "
      "40,200");
  const json back = result_of(
      "direction --finish matte --albedo 0.9/0.3 --aperture 60 --tilt 20 --theta 40 --phi 200 --toward "
      "50,20");
  CHECK(std::abs(there["brdf"].get<double>() - back["brdf"].get<double>()) <=
        2 * there["error_estimate"].get<double>());
  // From +y the steeper panel one is seen, which is the brighter one.
  const json bright =
      result_of("direction --finish matte --albedo 0.9/0.1 --aperture 60 --tilt 20 --theta 80 --phi 0");
  const json dark =
      result_of("direction --finish matte --albedo 0.9/0.1 --aperture 60 --tilt 20 --theta 80 --phi 180");
  CHECK(bright["reflectance"].get<double>() > 2 * dark["reflectance"].get<double>());
}

TEST_CASE("a constant specular part of matte panels is known under diffuse light") {
  const json table = result_of("table --finish matte --albedo 0.5 --specular 0.3 --aperture 60,180");
  const SpecularInterreflectionKernel<double> kernel(Cavity<double>(radians(60.0)));
  CHECK(table["rows"][0]["albedo"] == "0.5");
  CHECK(table["rows"][0]["specular"] == "0.3");
  CHECK(table["rows"][0]["reflectance"] == bihemispherical_reflectance(kernel, 0.5, 0.3));
  CHECK(table["rows"][1]["reflectance"] == Approx(0.8));
}

TEST_CASE("mirrors of a given albedo lose it at each bounce") {
  const json result = result_of("direction --finish mirror --albedo 0.5 --aperture 60 --theta 0 --phi 0");
  for (const json& lobe : result["lobes"])
    CHECK(lobe["throughput"] == Approx(std::pow(0.5, lobe["bounces"].get<int>())));
}

TEST_CASE("what makes no sense of an albedo is refused with its words and status 2") {
  const ScratchFolder folder;
  std::ofstream(folder / "paint.csv") << "wavelength_nm,reflectance\n500,0.2\n600,0.6\n";
  for (const auto& [line, words] : std::vector<std::pair<std::string, std::string>>{
           {"table --finish matte --aperture 60", "--albedo is required"},
           {"table --albedo 0.5 --aperture 60", "--finish is required"},
           {"table --finish matte --material 1.5 --aperture 60", "expected no --material"},
           {"table --finish dull --albedo 0.5 --aperture 60", "'dull'"},
           {"table --finish matte --albedo 1.5 --aperture 60", "'1.5'"},
           {"table --finish matte --albedo #12345 --aperture 60", "'#12345'"},
           {"table --finish matte --albedo nowhere.csv --aperture 60", "'nowhere.csv'"},
           {"table --finish matte --albedo paint.csv --aperture 60 --wavelength 400", "no data at 400 nm"},
           {"table --finish matte --albedo #b87333 --aperture 60 --wavelength 1000", "1000 nm"},
           {"table --finish matte --albedo 0.5 --aperture 60 --max-bounces 2", "--max-bounces"},
           {"table --finish matte --albedo 0.5 --aperture 60 --polarization full", "--polarization"},
           {"table --finish mirror --albedo 0.5/0.2 --aperture 60", "0.5/0.2"},
           {"table --finish mirror --albedo 0.5 --aperture 60 --tilt 10", "--tilt"},
           {"table --finish matte --albedo 0.5 --aperture 60 --tilt 80", "--tilt"},
           {"table --finish matte --albedo 0.5 --aperture 60 --land 0.1", "--land"},
           {"table --finish matte --albedo 0.5 --slopes 60:60 --floor 0.5", "--floor"},
           {"table --finish matte --albedo 0.5 --aperture 60 --specular 1.5", "--specular: '1.5'"},
           {"table --finish matte --albedo 0.5 --aperture 60 --specular 0.6", "at most 1"},
           {"table --finish matte --albedo 0.5/0.4 --aperture 60 --specular 0.1", "--specular"},
           {"table --finish matte --albedo 0.5 --aperture 60 --tilt 5 --specular 0.1", "--specular"},
           {"table --finish mirror --albedo 0.5 --aperture 60 --specular 0.1", "--specular"},
           {"table --material Ag --aperture 60 --specular 0.1", "--specular"},
           {"direction --finish matte --albedo 0.5 --specular 0.1 --aperture 60 --theta 0 --phi 0",
            "--specular"},
           {"map --finish matte --albedo 0.5 --specular 0.1 --aperture 60 --out a.exr", "--specular"},
           {"direction --finish matte --albedo 0.5 --aperture 60 --theta 0 --phi 0 --position 0",
            "--position"},
           {"map --finish matte --albedo 0.5 --aperture 60 --quantity bounces --out a.exr", "bounces"}}) {
    CAPTURE(line);
    const Outcome outcome = run(line, folder.path());
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(words) != std::string::npos);
    CHECK(lines_of(outcome.err).size() == 1);
  }
  std::ofstream(folder / "bad.csv") << "wavelength_nm,reflectance\n500,0.2\n600,1.6\n";
  std::ofstream(folder / "other.csv") << "nm,percent\n500,20\n";
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::string>>{
           {"bad.csv", "bad.csv:3: reflectance 1.6"},
           {"other.csv", "other.csv:1: the heading is 'nm,percent'"}}) {
    const Outcome outcome = run("table --finish matte --albedo " + file + " --aperture 60", folder.path());
    CHECK(outcome.status == 1);
    CHECK(outcome.err.find(words) != std::string::npos);
  }
}
