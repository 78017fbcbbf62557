// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>
#include <vcavity/vcavity.hpp>

#include "cli/json_result.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"

using nlohmann::json;
using namespace vcavity;

namespace {

const Conductor<double> silver(0.1249, 3.3391);

bool has_keys(const json& object, const std::set<std::string>& expected) {
  for (const std::string& key : expected)
    if (!object.contains(key)) return false;
  return true;
}

Vec3<double> vector_of(const json& array) {
  REQUIRE(array.size() == 3);
  return {array[0], array[1], array[2]};
}

}  // namespace

TEST_CASE("JSON of a table has a row for each aperture with every digit of the library") {
  const json result = result_of("table --material 0.1249+3.3391i --aperture 45,90:180:90 --tolerance 1e-9");
  CHECK(result["material"] == "0.1249+3.3391i");
  REQUIRE(result["rows"].size() == 3);
  const std::vector<double> apertures_deg{45, 90, 180};
  for (std::size_t i = 0; i < apertures_deg.size(); ++i) {
    const json& row = result["rows"][i];
    CHECK(has_keys(row, {"aperture_deg", "wavelength_nm", "n", "k", "max_bounces", "reflectance",
                         "error_estimate", "fresnel_evaluations"}));
    const Cavity<double> cavity(radians(apertures_deg[i]));
    const auto expected = bihemispherical_reflectance(cavity, silver, 1e-9);
    CHECK(row["aperture_deg"] == apertures_deg[i]);
    CHECK(row["wavelength_nm"] == 550);
    CHECK(row["n"] == 0.1249);
    CHECK(row["k"] == 3.3391);
    CHECK(row["max_bounces"].is_null());
    CHECK(row["reflectance"] == expected.value);
    CHECK(row["error_estimate"] == expected.error);
    CHECK(row["fresnel_evaluations"] == expected.evaluations);
  }
}

TEST_CASE("JSON of a table says when bounces were left out") {
  const json result = result_of("table --material 0.1249+3.3391i --aperture 45 --max-bounces 1");
  CHECK(result["rows"][0]["max_bounces"] == 1);
  // Table 2 of the paper, computed exactly; shared with the tests of the library.
  CHECK(result["rows"][0]["reflectance"].get<double>() == Catch::Approx(0.146005148243).epsilon(1e-10));
}

TEST_CASE("a table of several materials and wavelengths has a row for every combination") {
  const json result =
      result_of("table --material Ag,1.5 --material Cu --wavelength 500,600 --aperture 60:90:30");
  CHECK(result["material"] == json{"Ag-Johnson", "1.5", "Cu-Johnson"});
  std::set<std::tuple<std::string, double, double>> combinations;
  for (const json& row : result["rows"])
    combinations.emplace(row["material"], row["wavelength_nm"], row["aperture_deg"]);
  CHECK(result["rows"].size() == 12);
  CHECK(combinations.size() == 12);
  const json single = result_of("table --material Cu --wavelength 600 --aperture 90");
  CHECK(result["rows"][11]["reflectance"] == single["rows"][0]["reflectance"]);
}

TEST_CASE("JSON of a direction has every digit of the library") {
  const json result =
      result_of("direction --material 0.1249+3.3391i --aperture 45 --theta 30 --phi 20 --position 0.25");
  CHECK(has_keys(result, {"n", "k", "reflectance", "absorptance", "lobes", "ray"}));
  const Cavity<double> cavity(radians(45.0));
  const auto e = vcavity::direction(radians(30.0), radians(20.0));
  CHECK(result["n"] == 0.1249);
  CHECK(result["k"] == 3.3391);
  CHECK(result["reflectance"] == directional_reflectance(cavity, e, silver));
  CHECK(result["absorptance"] == directional_absorptance(cavity, e, silver));

  const auto expected = lobes(cavity, e, silver);
  std::size_t i = 0;
  for (const auto& lobe : expected) {
    const json& found = result["lobes"].at(i++);
    CHECK(has_keys(found, {"first_panel", "bounces", "weight", "throughput", "direction"}));
    CHECK(found["first_panel"] == static_cast<int>(lobe.first_panel));
    CHECK(found["bounces"] == lobe.bounces);
    CHECK(found["weight"] == lobe.weight);
    CHECK(found["throughput"] == lobe.throughput);
    CHECK(vector_of(found["direction"]) == lobe.direction);
  }
  CHECK(result["lobes"].size() == i);

  const RayPath path = ray_path(cavity, e, 0.25);
  const json& ray = result["ray"];
  CHECK(has_keys(ray, {"position", "first_panel", "bounces", "reflectance", "direction"}));
  CHECK(ray["position"] == 0.25);
  CHECK(ray["first_panel"] == static_cast<int>(path.first_panel));
  CHECK(ray["bounces"] == path.bounces);
  CHECK(ray["reflectance"] == ray_reflectance(cavity, e, path, silver));
  CHECK(vector_of(ray["direction"]) == ray_exit_direction(cavity, e, path));
}

TEST_CASE("JSON of a direction has the absorptance of the model that was asked for") {
  const Cavity<double> cavity(radians(45.0));
  const auto e = vcavity::direction(radians(30.0), radians(20.0));
  const auto absorptance = [](const std::string& model) {
    return result_of("direction --material 0.1249+3.3391i --aperture 45 --theta 30 --phi 20 --polarization " +
                     model)["absorptance"];
  };
  CHECK(absorptance("full") == unpolarized(directional_absorptance(cavity, e, polarized(silver))));
  CHECK(absorptance("separate") ==
        unpolarized(directional_absorptance(cavity, e, separately_polarized(silver))));
}

TEST_CASE("several directions, positions, apertures and wavelengths give a row for every combination") {
  const json result = result_of(
      "direction --material Ag,1.5 --aperture 45,60 --theta 0:60:30 --phi 20,40 --wavelength 500,600 "
      "--position 0.2,0.3");
  CHECK(result["rows"].size() == 2 * 2 * 3 * 2 * 2 * 2);
  std::set<std::string> different;
  for (const json& row : result["rows"]) different.insert(row.dump());
  CHECK(different.size() == result["rows"].size());
  const json single =
      result_of("direction --material 1.5 --aperture 60 --theta 60 --phi 40 --wavelength 600 --position 0.3");
  for (const char* key : {"theta_deg", "n", "reflectance", "absorptance", "lobes", "ray"})
    CHECK(result["rows"].back()[key] == single[key]);

  const Outcome csv = run("direction --material 1.5 --aperture 60 --theta 10,20 --phi 40 --format csv");
  const std::vector<std::string> lines = lines_of(csv.out);
  REQUIRE(lines.size() > 5);
  CHECK(lines[3].starts_with(
      "material,aperture_deg,theta_deg,phi_deg,wavelength_nm,n,k,polarization,reflectance,"));
}

TEST_CASE("the values of a range have the digits that one would write") {
  const auto rows = result_of("direction --material Ag --aperture 45 --theta 0.1:0.5:0.2 --phi 0")["rows"];
  REQUIRE(rows.size() == 3);
  CHECK(rows[1]["theta_deg"] == 0.3);
  CHECK(rows[2]["theta_deg"] == 0.5);
}

TEST_CASE("a mirror has no BRDF") {
  const Outcome outcome = run("direction --material 1.5 --aperture 60 --theta 10 --phi 0 --toward 20,30");
  CHECK(outcome.status == 2);
  CHECK(outcome.err == "vcavity_maps: --toward: a mirror has no BRDF; its lobes say where the light goes\n");
  CHECK(run("direction --material 1.5 --aperture 60 --theta 10 --phi 0 --toward 20").err ==
        "vcavity_maps: --toward: '20' is not accepted, expected two angles THETA,PHI\n");
  CHECK(run("map --material 1.5 --aperture 60 --theta 10 --phi 0 --out a.exr").err ==
        "vcavity_maps: --theta: a mirror has no BRDF, expected a surface that scatters light\n");
}

TEST_CASE("a ray is told only where a position is given") {
  CHECK_FALSE(result_of("direction --material 1.5 --aperture 60 --theta 10 --phi 0").contains("ray"));
}

TEST_CASE("light at grazing incidence has a result") {
  const json result = result_of("direction --material 1.5 --aperture 60 --theta 90 --phi 20");
  CHECK(result["reflectance"].get<double>() > 0);
  CHECK(result["lobes"].size() > 0);
}

TEST_CASE("CSV starts with its provenance and repeats the numbers of JSON") {
  const std::string line = "table --material 1.5 --aperture 45,60";
  const json rows = result_of(line)["rows"];
  const Outcome outcome = run(line + " --format csv");
  std::vector<std::string> lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 6);
  CHECK(lines[0].starts_with("# vcavity "));
  CHECK(lines[1] == "# command: vcavity_maps " + line + " --format csv");
  CHECK(lines[2] == "# material: index 1.5");
  CHECK(lines[3] ==
        "material,aperture_deg,wavelength_nm,n,k,polarization,max_bounces,reflectance,error_estimate,fresnel_"
        "evaluations");
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<std::string> cells;
    std::istringstream stream(lines[4 + i]);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    REQUIRE(cells.size() == 10);
    CHECK(std::stod(cells[7]) == rows[i]["reflectance"].get<double>());
    CHECK(cells[6] == "all");
  }
}

TEST_CASE("Markdown shows no digit that the error estimate does not vouch for") {
  const Outcome outcome = run("table --material 1.5 --aperture 60 --tolerance 1e-4");
  const std::vector<std::string> lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 7);
  CHECK(lines[2].starts_with("| material | aperture_deg | wavelength_nm |"));
  std::vector<std::string> cells;
  std::istringstream stream(lines[4]);
  for (std::string cell; std::getline(stream, cell, '|');)
    cells.push_back(words(cell).empty() ? "" : words(cell)[0]);
  const double error = std::stod(cells.at(9));
  const auto decimals = static_cast<double>(cells.at(8).size() - 2);  // behind "0."
  CHECK(std::pow(10, -decimals) >= error);
}

TEST_CASE("the paper's figures, tables and report are written, and nothing else") {
  const ScratchFolder folder;
  const Outcome outcome = run("paper --size 16 --out results", folder.path());
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  std::set<std::string> expected{"report.md",
                                 "table1.md",
                                 "table1.csv",
                                 "table2.md",
                                 "table2.csv",
                                 "fig5_glass.png",
                                 "fig5_copper.png",
                                 "fig6_silver.png",
                                 "fig6_silver_45deg_one_bounce.exr",
                                 "fig6_silver_45deg_all_bounces.exr"};
  for (const char* map : {"fig5_glass_", "fig5_copper_"})
    for (const char* aperture : {"45", "60", "90", "120", "150", "180"})
      expected.insert(std::string(map) + aperture + "deg.exr");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "results"))
    found.insert(entry.path().filename());
  CHECK(found == expected);
}

TEST_CASE("a table names the rows whose error is above the tolerance, prints them all the same, and fails") {
  // Total reflection in a narrow groove, docs/accuracy.md.
  constexpr double tolerance = 1e-10;
  const Outcome outcome = run("table --material 0.7 --aperture 0.01,0.03,90 --tolerance 1e-10 --format json");
  CHECK(outcome.status == 1);
  const json rows = json::parse(outcome.out)["rows"];
  CHECK(rows.size() == 3);
  const auto broken = std::count_if(rows.begin(), rows.end(), [](const json& row) {
    return row["error_estimate"].get<double>() > tolerance;
  });
  CHECK(broken == 2);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == broken);
  CHECK_THAT(outcome.err, Catch::Matchers::ContainsSubstring("more than the tolerance of 1e-10"));
}

TEST_CASE(
    "planned effects print an error that covers the quadrature's own, and no error where there is none") {
  for (const char* scene :
       {"--material 0.11554+8.8894e-05i --aperture 60 --tolerance 1e-2",
        "--material Ag --aperture 45 --tolerance 1e-3", "--material 1.5 --aperture 1 --tolerance 1e-3"}) {
    const json planned = result_of(std::string("table --effects auto ") + scene)["rows"][0];
    const json exact = result_of(std::string("table --polarization full ") + scene)["rows"][0];
    CAPTURE(scene);
    CHECK(std::abs(planned["reflectance"].get<double>() - exact["reflectance"].get<double>()) <=
          planned["error_estimate"].get<double>() + exact["error_estimate"].get<double>());
    CHECK(planned["error_estimate"].get<double>() <= 1e-2);
  }
  for (const char* material : {"1", "1e70"}) {
    CAPTURE(material);
    const json row = result_of(
        std::string("table --effects auto --tolerance 1e-8 --aperture 60 --material ") + material)["rows"][0];
    CHECK(row["error_estimate"].get<double>() <= 1e-8);
    CHECK(row["reflectance"].get<double>() == Catch::Approx(material[1] == 0 ? 0 : 1).margin(1e-12));
  }
}
