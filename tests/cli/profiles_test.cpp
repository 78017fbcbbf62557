// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>
#include <vcavity/conventions.hpp>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/facet/panel_facets.hpp>
#include <vcavity/groove/asymmetric_groove.hpp>
#include <vcavity/profiles/bihemispherical.hpp>
#include <vcavity/profiles/land.hpp>
#include <vcavity/profiles/profile.hpp>
#include <vcavity/profiles/trench.hpp>
#include <vcavity/profiles/truncated_groove.hpp>

#include "cli/json_result.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"

using nlohmann::json;
using namespace vcavity;

namespace {

void check_refused(const std::string& line, const std::string& text) {
  CAPTURE(line);
  const Outcome outcome = run(line);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err == "vcavity_maps: " + text + "\n");
}

const Conductor<double> silver(0.1249, 3.3391);
const Vec3<double> light = direction(radians(30.0), radians(10.0));
const std::string from_there = " --theta 30 --phi 10";
const std::string of_silver = " --material 0.1249+3.3391i";

}  // namespace

TEST_CASE("a tilted groove of two materials is that of the library") {
  const json result = result_of("direction --panels 0.1249+3.3391i/1.5 --aperture 60 --tilt 20" + from_there);
  const AsymmetricGroove<double> groove(radians(60.0), radians(20.0));
  const PanelFacets facets{silver, Conductor<double>(1.5, 0)};
  CHECK(result["material"] == "0.1249+3.3391i/1.5");
  CHECK(result["aperture_deg"] == 60);
  CHECK(result["tilt_deg"] == 20);
  CHECK(result["reflectance"].get<double>() ==
        Approx(directional_reflectance(groove, light, facets)).epsilon(1e-14));
  CHECK(result["lobes"].size() == lobes(groove, light, facets).size());
  for (const json& lobe : result["lobes"]) CHECK_FALSE(lobe.contains("facets"));
  const json by_slopes = result_of("direction --panels 0.1249+3.3391i/1.5 --slopes 80:40" + from_there);
  CHECK(by_slopes["reflectance"] == result["reflectance"]);
  CHECK(by_slopes["aperture_deg"] == 60);
  CHECK(by_slopes["tilt_deg"] == 20);
}

TEST_CASE("floor and land are lobes that say which faces they meet") {
  const json result = result_of("direction" + of_silver +
                                " --slopes 60:70 --floor 0.5 --land 0.25 --land-material 1.5" + from_there);
  const TruncatedGroove<double> groove(radians(60.0), radians(70.0), 0.5);
  const double inside = directional_reflectance(groove, light, silver);
  const double flat = Conductor<double>(1.5, 0)(light.z);
  CHECK(result["groove_reflectance"].get<double>() == Approx(inside).epsilon(1e-13));
  CHECK(result["reflectance"].get<double>() == Approx(0.75 * inside + 0.25 * flat).epsilon(1e-13));
  CHECK(result["land"] == 0.25);
  CHECK(result["floor"] == 0.5);
  CHECK(result["land_material"] == "1.5");
  double weights = 0;
  bool has_land = false, has_floor = false;
  for (const json& lobe : result["lobes"]) {
    weights += lobe["weight"].get<double>();
    const std::string faces = lobe["facets"];
    CHECK(faces.size() == lobe["bounces"].get<std::size_t>());
    has_land = has_land || faces == "L";
    has_floor = has_floor || faces.find('F') != std::string::npos;
  }
  CHECK(weights == Approx(1).epsilon(1e-13));
  CHECK(has_land);
  CHECK(has_floor);
}

TEST_CASE("tables of profiles take lists and ranges, and have the columns that were asked for") {
  const json result =
      result_of("table" + of_silver + " --aperture 60 --tilt 0:20:10 --land 0,0.5 --tolerance 1e-8");
  REQUIRE(result["rows"].size() == 6);
  std::size_t i = 0;
  for (const double tilt_deg : {0.0, 10.0, 20.0}) {
    const AsymmetricGroove<double> groove(radians(60.0), radians(tilt_deg));
    const double grooves = bihemispherical_reflectance(groove, silver, 1e-10).value;
    const double flat = bihemispherical_reflectance(Cavity<double>(pi<double>()), silver, 1e-10).value;
    for (const double land : {0.0, 0.5}) {
      const json& row = result["rows"][i++];
      CHECK(row["tilt_deg"] == tilt_deg);
      CHECK(row["land"] == land);
      CHECK(std::abs(row["reflectance"].get<double>() - (1 - land) * grooves - land * flat) < 1e-8);
    }
  }
}

TEST_CASE("single rays over a floor meet the faces of their lobe") {
  const json result =
      result_of("direction" + of_silver + " --slopes 60:60 --floor 1 --theta 0 --phi 0 --position 0");
  CHECK(result["ray"]["facets"] == "F");
  CHECK(result["ray"]["bounces"] == 1);
  CHECK_FALSE(result["ray"].contains("first_panel"));
}

TEST_CASE("maps of profiles are written") {
  const ScratchFolder folder;
  CHECK(run("map" + of_silver + " --aperture 60 --tilt 20 --size 16 --out a.exr", folder.path()).status == 0);
  CHECK(run("map" + of_silver + " --aperture 60 --land 0.5 --size 16 --out b.exr", folder.path()).status ==
        0);
}

TEST_CASE("the way of the light is drawn") {
  const ScratchFolder folder;
  for (const std::string shape :
       {" --aperture 45", " --slopes 80:40", " --slopes 110:20 --land 0.2",
        " --slopes 70:60 --floor 0.4 --land 0.1", " --slopes 90:90 --floor 0.5 --land 0.3", " --aperture 180",
        " --aperture 2"}) {
    CAPTURE(shape);
    const Outcome outcome =
        run("direction" + of_silver + shape + from_there + " --plot way.svg --format json", folder.path());
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(content(folder / "way.svg").find("</svg>") != std::string::npos);
  }
  CHECK(run("direction" + of_silver + " --aperture 45" + from_there + " --plot way.png", folder.path())
            .status == 0);
}

TEST_CASE("profiles that cannot be are refused with value and domain") {
  const std::string start = "direction" + of_silver + from_there;
  check_refused(
      start + " --aperture 60 --tilt 60",
      "--tilt: '60' makes no groove of aperture 60, expected more than -60 and less than 60 degrees");
  check_refused(start + " --slopes 120:60",
                "--slopes: '120:60' makes no groove, expected slopes that add up to less than 180 degrees");
  check_refused(
      start + " --slopes 90:90",
      "--slopes: '90:90' makes no groove, expected slopes that add up to less than 180 degrees, or a "
      "--floor above 0");
  check_refused(
      start + " --slopes 90:90 --floor 1",
      "--slopes: '90:90' leaves walls of no thickness, expected --land above 0 with vertical walls");
  check_refused(
      start + " --slopes 100:60 --floor 1",
      "--slopes: '100:60' leans over a floor, to which light may come back without end: expected slopes up "
      "to 90 degrees with --floor");
  check_refused(start + " --slopes 60",
                "--slopes: '60' is not accepted, expected the angles of panel one and panel two "
                "to the mean plane: B1:B2, or B1/B2 with a range LOW:HIGH:STEP for one or both");
  check_refused(start + " --slopes 60:80:10",
                "--slopes: '60:80:10' is not accepted, expected the angles of panel one and panel two "
                "to the mean plane: B1:B2, or B1/B2 with a range LOW:HIGH:STEP for one or both");
  check_refused(start + " --slopes 80:60:10/40",
                "--slopes: '80:60:10' is not accepted, expected LOW:HIGH:STEP with LOW not above HIGH");
  check_refused(start + " --slopes 0:60",
                "--slopes: '0' is not accepted, expected a number above 0 and below 180");
  check_refused(start + " --aperture 60 --floor 1", "--floor: '1' needs --slopes, the angles of the walls");
  check_refused(start + " --aperture 60 --land 1", "--land: '1' leaves no groove, expected 0 to less than 1");
  check_refused(start + " --aperture 60 --land -0.1",
                "--land: '-0.1' is not accepted, expected a number from 0 to 1");
  check_refused(start + " --aperture 60 --slopes 60:60",
                "--slopes: stand in place of --aperture, expected one of them");
  check_refused(start + " --tilt 5 --slopes 60:60",
                "--tilt: --slopes say how the groove is tilted, expected one of them");
  check_refused("direction --panels Ag --aperture 60" + from_there,
                "--panels: 'Ag' is not accepted, expected the materials of panel one and panel two, M1/M2");
  check_refused(start + " --panels 1.5/1.5 --aperture 60",
                "--panels: stands in place of --material, expected one of them");
  check_refused(start + " --aperture 60 --land-material 1.5",
                "--land-material: there is no land, expected --land above 0");
  check_refused("direction" + of_silver + " --aperture 60 --theta 90 --phi 0 --plot a.svg",
                "--plot: light that grazes the surface enters no groove, expected --theta below 90");
  check_refused(start + " --aperture 60,90 --plot a.svg",
                "--plot: shows one direction on one surface, expected no list or range");
}

TEST_CASE("the cost of any surface is that of its own quadrature") {
  const json result = result_of("cost" + of_silver + " --slopes 80:40 --land 0.1");
  CHECK(result["tilt_deg"] == 20);
  REQUIRE(result["sections"].size() == 2);
  REQUIRE(result["sections"][0]["rows"].size() == 5);
  CHECK(result["sections"][0]["rows"][4]["error"].get<double>() < 1e-10);
  CHECK(result["sections"][1]["rows"].size() == 3);
  check_refused("cost" + of_silver + " --aperture 60,90",
                "cost: measures one surface, expected no list or range of 2");
}

TEST_CASE("planned effects of every profile print a bound that holds") {
  for (const char* scene : {"--material Ag --aperture 60 --tilt 20", "--panels Ag/1.5 --slopes 80:40",
                            "--material Ag --aperture 60 --land 0.2 --land-material Al",
                            "--material Ag --slopes 60:70 --floor 0.5 --floor-material 1.5",
                            "--material Ag --slopes 90:90 --floor 1 --land 0.5",
                            "--panels Ag/Si --aperture 60 --tilt 20 --film SiO2-Malitson:90"}) {
    CAPTURE(scene);
    const std::string line = std::string("table ") + scene;
    for (const char* tolerance : {"1e-2", "1e-4"}) {
      const json planned = result_of(line + " --effects auto --tolerance " + tolerance)["rows"][0];
      const json exact = result_of(line + " --polarization full --tolerance 1e-6")["rows"][0];
      CHECK(std::abs(planned["reflectance"].get<double>() - exact["reflectance"].get<double>()) <=
            planned["error_estimate"].get<double>() + 1e-6);
      CHECK(planned["error_estimate"].get<double>() <= std::stod(tolerance));
      CHECK(planned["plan"]["error_bounds"]["rounding"].get<double>() > 0);
    }
    const Outcome explained = run(line + " --effects auto --tolerance 1e-2 --explain");
    CHECK(explained.status == 0);
    CHECK_THAT(explained.out, Catch::Matchers::ContainsSubstring("together error at most "));
  }
}

TEST_CASE("a planned map of a profile says what it is computed in") {
  const Outcome outcome =
      run("map --material Ag --slopes 60:70 --floor 0.5 --size 16 --effects auto --tolerance 0.1 --explain");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Matchers::ContainsSubstring("polarisation left out"));
  CHECK_THAT(outcome.out, Catch::Matchers::ContainsSubstring("double"));
}

TEST_CASE("diffuse reflectance over a floor counts no more bounces than asked for") {
  const std::string line = "table --slopes 60:70 --floor 0.5 --tolerance 1e-9 --max-bounces ";
  const TruncatedGroove<double> groove(radians(60.0), radians(70.0), 0.5);
  for (const int most : {1, 2, 3}) {
    const json row = result_of(line + std::to_string(most) + of_silver)["rows"][0];
    CHECK(row["max_bounces"] == most);
    CHECK(std::abs(row["reflectance"].get<double>() -
                   bihemispherical_reflectance(groove, silver, 1e-9, most).value) <= 1e-9);
  }
}

TEST_CASE("slopes take lists and ranges") {
  const auto slopes_of = [](const std::string& words) {
    const json rows = result_of("table --material Ag --tolerance 1e-2 --slopes " + words)["rows"];
    std::vector<std::pair<double, double>> result;
    for (const json& row : rows)
      result.emplace_back(row["aperture_deg"].get<double>(), row["tilt_deg"].get<double>());
    return result;
  };
  using Pairs = std::vector<std::pair<double, double>>;
  CHECK(slopes_of("80:40,90:45") == Pairs{{60, 20}, {45, 22.5}});
  CHECK(slopes_of("80/40") == Pairs{{60, 20}});
  CHECK(slopes_of("60:80:10/40") == Pairs{{80, 10}, {70, 15}, {60, 20}});
  CHECK(slopes_of("50:60:10/30:40:10,80:40") == Pairs{{100, 10}, {90, 5}, {90, 15}, {80, 10}, {60, 20}});
}

TEST_CASE("equal slopes are a symmetric groove, at its cost") {
  const json slopes = result_of("table --material Ag --slopes 70:70 --land 0.2")["rows"][0];
  const json aperture = result_of("table --material Ag --aperture 40 --land 0.2")["rows"][0];
  CHECK(slopes["reflectance"] == aperture["reflectance"]);
  CHECK(slopes["fresnel_evaluations"] == aperture["fresnel_evaluations"]);
}

TEST_CASE("k that a file does not give is 0 on request for every face and film") {
  const ScratchFolder folder;
  put(folder / "glass.csv", "wl,n\n0.4,1.5\n0.7,1.5\n\nwl,k\n0.6,1e-3\n0.7,1e-3\n");
  for (const std::string options :
       {"--panels Ag/./glass.csv --slopes 80:40", "--panels ./glass.csv/Ag --slopes 80:40",
        "--material Ag --slopes 60:60 --floor 1 --floor-material glass.csv",
        "--material Ag --aperture 60 --land 0.2 --land-material glass.csv",
        "--material Ag --aperture 60 --film glass.csv:50"}) {
    CAPTURE(options);
    const std::string line = "direction --theta 10 --phi 0 --wavelength 500 " + options;
    CHECK(run(line, folder.path()).status == 2);
    CHECK(run(line + " --missing-k zero", folder.path()).status == 0);
  }
}
