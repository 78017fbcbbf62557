// SPDX-License-Identifier: BSD-3-Clause
/// --film: thin films on the command line.

#include <cmath>
#include <nlohmann/json.hpp>
#include <vcavity/vcavity.hpp>

#include "cli/json_result.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"
#include "tools/materials/catalogue.hpp"

using namespace vcavity;

namespace {

/// What the library says of a groove of titanium under films of TiO2 and SiO2.
double by_library(double aperture_deg, const Vec3<double>& e, double wavelength_nm, double tio2_nm,
                  double sio2_nm) {
  const auto film = [&](const char* name, double thickness_nm) {
    const auto index = tools::load_material(name).at(wavelength_nm);
    return Film<double>::of_thickness_nm(index.n, index.k, thickness_nm, wavelength_nm);
  };
  const auto titanium = tools::load_material("Ti").at(wavelength_nm);
  const Coated facet(Conductor<double>(titanium.n, titanium.k), film("TiO2-Siefke", tio2_nm),
                     film("SiO2-Malitson", sio2_nm));
  return directional_reflectance(Cavity<double>(radians(aperture_deg)), e, facet);
}

const std::string a_direction = "direction --material Ti --aperture 45 --theta 30 --phi 20 ";

}  // namespace

TEST_CASE("films stand on the facets, the top one first, as dispersive as their materials") {
  const auto answer =
      result_of(a_direction + "--wavelength 450,600 --film TiO2-Siefke:20:60:40 --film SiO2-Malitson:35");
  const auto& rows = answer["rows"];
  REQUIRE(rows.size() == 4);
  for (const auto& row : rows) {
    REQUIRE(row["films"].size() == 2);
    CHECK(row["films"][0]["material"] == "TiO2-Siefke");
    CHECK(row["films"][1] == nlohmann::json{{"material", "SiO2-Malitson"}, {"thickness_nm", 35.0}});
    const double expected = by_library(45, direction(radians(30.0), radians(20.0)), row["wavelength_nm"],
                                       row["films"][0]["thickness_nm"], 35);
    CHECK(row["reflectance"].get<double>() == Approx(expected).epsilon(1e-14));
    CHECK(row["absorptance"].get<double>() == Approx(1 - expected).epsilon(1e-12));
  }
  CHECK(rows[0]["films"][0]["thickness_nm"] == 20);
  CHECK(rows[1]["films"][0]["thickness_nm"] == 60);
}

TEST_CASE("a film of thickness 0 changes no digit") {
  for (const std::string line :
       {"table --material Ti --aperture 45", "table --material 1.5 --aperture 60 --polarization full"}) {
    const auto bare = result_of(line), coated = result_of(line + " --film TiO2-Siefke:0 --film 1.3+0.2i:0");
    CHECK(coated["rows"][0]["reflectance"] == bare["rows"][0]["reflectance"]);
    CHECK(coated["rows"][0]["error_estimate"] == bare["rows"][0]["error_estimate"]);
    CHECK(coated["rows"][0]["films"].size() == 2);
    CHECK_FALSE(bare["rows"][0].contains("films"));
  }
}

TEST_CASE("maps of films hold each wavelength with its own indices, and name the films") {
  const ScratchFolder folder;
  const Outcome outcome =
      run("map --material Ti --aperture 60 --size 8 --wavelengths 450:600:150 --film TiO2-Siefke:40,60 "
          "--film SiO2-Malitson:35 --out maps",
          folder.path());
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto image =
      tools::read_exr(folder / "maps/Ti-Johnson_60deg_TiO2-Siefke-60nm_SiO2-Malitson-35nm_450-600nm.exr");
  CHECK(std::get<std::string>(image.attributes.at("films")) == "TiO2-Siefke:60; SiO2-Malitson:35");
  // The pixel right of the middle and above it: u = v = √2/8.
  const double u = std::sqrt(2.0) / 8;
  const Vec3<double> e = direction(2 * std::asin(std::hypot(u, u) / 2), pi<double>() / 4);
  const std::size_t pixel = 3 * 8 + 4;
  CHECK(image.plane("T.450,000000nm")[pixel] == Approx(by_library(60, e, 450, 60, 35)).epsilon(1e-6));
  CHECK(image.plane("T.600,000000nm")[pixel] == Approx(by_library(60, e, 600, 60, 35)).epsilon(1e-6));
}

TEST_CASE("plans know films") {
  const auto answer =
      result_of("table --material Ti --aperture 90 --film TiO2-Siefke:60 --effects auto --tolerance 1e-3");
  const auto exact = result_of("table --material Ti --aperture 90 --film TiO2-Siefke:60 --polarization full");
  const auto& row = answer["rows"][0];
  CHECK(std::abs(row["reflectance"].get<double>() - exact["rows"][0]["reflectance"].get<double>()) <=
        row["error_estimate"].get<double>());
  CHECK(row["error_estimate"].get<double>() <= 1e-3);
}

TEST_CASE("a table draws the reflectance over the number that changes") {
  const ScratchFolder folder;
  const std::string line = "table --material Si --film TiO2-Siefke:0,65 --wavelength 600 --tolerance 1e-4 ";
  CHECK(run(line + "--aperture 30:90:30 --plot a.svg", folder.path()).status == 0);
  const std::string drawn = content(folder / "a.svg");
  CHECK(drawn.find("<svg") != std::string::npos);
  const Outcome outcome =
      run("table --material Si --aperture 60 --tolerance 1e-4 --plot b.svg", folder.path());
  CHECK(outcome.status == 2);
  CHECK(outcome.err.starts_with("vcavity_maps: --plot: no number changes from row to row"));
}

TEST_CASE("films that are none are refused in one line that names the word") {
  const std::vector<std::pair<std::string, std::string>> refusals{
      {"TiO2-Siefke:-3", "--film: '-3' is not accepted, expected a number from 0 to 1e+06"},
      {"TiO2-Siefke",
       "--film: 'TiO2-Siefke' is not accepted, expected a material and a thickness in nm, M:NM or "
       "M:LO:HI:STEP"},
      {":60",
       "--film: ':60' is not accepted, expected a material and a thickness in nm, M:NM or M:LO:HI:STEP"},
      {"TiO2-Siefke:", "--film: '' is not accepted, expected a number from 0 to 1e+06"},
      {"TiO2-Siefke:60:50:1",
       "--film: '60:50:1' is not accepted, expected LOW:HIGH:STEP with LOW not above HIGH"},
      {"1e5:60",
       "--film: 1e5 at 550 nm: the refractive index |n + ik| in a stack of films must lie in [0.0001, "
       "10000], "
       "not be 100000"}};
  for (const auto& [film, text] : refusals) {
    const Outcome outcome = run(a_direction + "--film " + film);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "vcavity_maps: " + text + "\n");
  }
  // A film whose data end before the wavelength, on a substrate that is known there.
  const Outcome outcome = run(
      "direction --material 1.5 --aperture 45 --theta 30 --phi 20 --wavelength 200000 --film TiO2-Siefke:60");
  CHECK(outcome.status == 2);
  CHECK(lines_of(outcome.err).size() == 1);
  CHECK(outcome.err.starts_with("vcavity_maps: wavelength 200000 nm is outside the data of TiO2-Siefke"));
}

TEST_CASE("the file of a film may have colons in its name") {
  const ScratchFolder folder;
  put(folder / "oxide:60.csv", "wavelength_nm,n,k\n400,2.4,0\n700,2.4,0\n");
  const std::string line =
      "table --material Ti --aperture 60 --tolerance 1e-4 --format json --film ./oxide:60.csv";
  const Outcome one = run(line + ":30", folder.path());
  CAPTURE(one.err);
  REQUIRE(one.status == 0);
  CHECK(nlohmann::json::parse(one.out)["rows"][0]["films"][0]["thickness_nm"] == 30);
  const Outcome range = run(line + ":20:40:10", folder.path());
  REQUIRE(range.status == 0);
  CHECK(nlohmann::json::parse(range.out)["rows"].size() == 3);
  CHECK(run(line, folder.path()).status != 0);
}
