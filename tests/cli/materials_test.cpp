// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/catch.hpp"

using nlohmann::json;

TEST_CASE("the collection is listed with ranges and sources") {
  const json list = json::parse(run("materials --format json").out)["materials"];
  CHECK(list.size() > 20);
  bool copper = false;
  for (const json& material : list) {
    CHECK(material["range_um"][0] < material["range_um"][1]);
    CHECK_FALSE(material["source"].get<std::string>().empty());
    for (const json& name : material["default_for"]) copper = copper || name == "Cu";
  }
  CHECK(copper);
}

TEST_CASE("JSON of a material at a wavelength has n, k, range and source") {
  const json copper = json::parse(run("materials Cu --wavelength 548.6 --format json").out);
  // Johnson and Christy 1972, Table I: 2.26 eV (0.5486 um).
  CHECK(copper["n"] == 1.02);
  CHECK(copper["k"] == 2.577);
  CHECK(copper["normal_reflectance"].get<double>() ==
        Catch::Approx((0.02 * 0.02 + 2.577 * 2.577) / (2.02 * 2.02 + 2.577 * 2.577)).epsilon(1e-12));
  CHECK(copper["range_um"] == json{0.1879, 1.937});
  CHECK(copper["source"].get<std::string>().find("Johnson") != std::string::npos);
}

TEST_CASE("a file is a material like any other") {
  const ScratchFolder folder;
  put(folder / "my.csv", "wavelength_nm,n,k\n500,1,2\n600,2,4\n");
  const Outcome outcome = run("materials my.csv --wavelength 550 --format json", folder.path());
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const json mine = json::parse(outcome.out);
  CHECK(mine["material"] == "my");
  CHECK(mine["n"].get<double>() == Catch::Approx(1.5).epsilon(1e-12));
  CHECK(mine["k"].get<double>() == Catch::Approx(3).epsilon(1e-12));
  CHECK(mine["range_um"] == json{0.5, 0.6});
}

TEST_CASE("names of files that are not UTF-8 reach neither JSON nor pictures as they are") {
  const ScratchFolder folder;
  const std::string name = "M\xfcller.csv";
  put(folder / name, "wavelength_nm,n,k\n400,1,2\n700,2,4\n");
  const Outcome outcome = run("materials " + name + " --format json --plot a.svg", folder.path());
  CHECK(outcome.status == 0);
  const json mine = json::parse(outcome.out);
  CHECK(mine["material"] == "M\uFFFDller");
  CHECK(mine["command"] == "vcavity_maps materials 'M\uFFFDller.csv' --format json --plot a.svg");
  for (const std::string& command : {std::string("table --aperture 60 --format json"),
                                     std::string("direction --aperture 60 --theta 0 --phi 0 --format json"),
                                     std::string("map --aperture 60 --size 4 --out a.exr --png a.png")})
    CHECK(run(command + " --material " + name, folder.path()).status == 0);
}

TEST_CASE("k that a file does not give at a wavelength is 0 on request, in every command") {
  const ScratchFolder folder;
  put(folder / "glass.csv", "wl,n\n0.4,1.5\n0.7,1.5\n\nwl,k\n0.6,1e-3\n0.7,1e-3\n");
  for (const std::string command :
       {"table --aperture 60 --wavelength 500 --material", "materials --wavelength 500",
        "direction --aperture 60 --theta 0 --phi 0 --wavelength 500 --material"}) {
    const Outcome refused = run(command + " glass.csv", folder.path());
    CHECK(refused.status == 2);
    CHECK(refused.err ==
          "vcavity_maps: wavelength 500 nm is outside the data of k of glass, 600 to 700 nm, though n is 1.5 "
          "there; "
          "--missing-k zero takes k as 0 where only n is given\n");
    CHECK(run(command + " glass.csv --missing-k zero", folder.path()).status == 0);
  }
}

TEST_CASE("without a wavelength a material has no index but still a range") {
  const json silver = json::parse(run("materials Ag --format json").out);
  CHECK_FALSE(silver.contains("n"));
  CHECK(silver["range_um"] == json{0.1879, 1.937});
}

TEST_CASE("a plot of a material is a picture of the kind that its name says") {
  const ScratchFolder folder;
  CHECK(run("materials Cu --plot cu.png", folder.path()).status == 0);
  CHECK(run("materials SiO2 --plot glass.svg", folder.path()).status == 0);
  CHECK(content(folder / "cu.png").starts_with("\x89PNG"));
  const std::string svg = content(folder / "glass.svg");
  CHECK(svg.find("<svg") != std::string::npos);
}
