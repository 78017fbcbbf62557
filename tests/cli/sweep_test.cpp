// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "cli/program.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"

using vcavity::tools::read_exr;

namespace {

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

}  // namespace

TEST_CASE("a sweep writes every combination into a file of a predictable name") {
  const ScratchFolder folder;
  const Outcome outcome = run(
      "map --material Ag,1.5 --material Cu --aperture 22.5,60:120:60 --wavelength 500 --size 8 --out maps",
      folder.path());
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  std::set<std::string> expected;
  for (const char* material : {"Ag-Johnson", "1.5", "Cu-Johnson"})
    for (const char* aperture : {"22.5", "60", "120"})
      expected.insert(std::string(material) + "_" + aperture + "deg_500nm.exr");
  CHECK(files_in(folder / "maps") == expected);
}

TEST_CASE("names tell the grid of wavelengths and the quantity") {
  const ScratchFolder folder;
  REQUIRE(run("map --material Cu --aperture 60 --size 8 --wavelengths 400:700:100 --out .", folder.path())
              .status == 0);
  REQUIRE(run("map --material Cu --aperture 60 --size 8 --quantity bounces --out ./", folder.path()).status ==
          0);
  CHECK(files_in(folder.path()) ==
        std::set<std::string>{"Cu-Johnson_60deg_400-700nm.exr", "Cu-Johnson_60deg_550nm_bounces.exr"});
}

TEST_CASE("a map of a sweep is the one that is made alone") {
  const ScratchFolder folder;
  REQUIRE(run("map --material Cu,Ag --aperture 45,60 --size 48 --out maps", folder.path()).status == 0);
  REQUIRE(run("map --material Ag --aperture 60 --size 48 --out alone.exr", folder.path()).status == 0);
  CHECK(read_exr(folder / "maps/Ag-Johnson_60deg_550nm.exr").plane("Y") ==
        read_exr(folder / "alone.exr").plane("Y"));
}

TEST_CASE("a resumed sweep leaves maps alone that it would make again, whatever the command line") {
  const ScratchFolder folder;
  const auto map = folder / "maps/Cu-Johnson_60deg_550nm.exr";
  const std::string sweep = "map --material Cu --aperture 45,60,90 --size 8 --out maps";
  REQUIRE(
      run("map --aperture 60 --material Cu --size 8 --wavelength 550 --out maps/", folder.path()).status ==
      0);
  const std::string earlier = content(map);
  REQUIRE(run(sweep + " --skip-existing", folder.path()).status == 0);
  CHECK(content(map) == earlier);
  CHECK(read_exr(folder / "maps/Cu-Johnson_90deg_550nm.exr").width == 8);
  REQUIRE(run(sweep, folder.path()).status == 0);
  CHECK(content(map) != earlier);  // made again: it tells the command that made it
}

TEST_CASE("a resumed sweep replaces maps of other options, data or versions, and other files") {
  const ScratchFolder folder;
  const auto made = [&](const std::string& options) {
    REQUIRE(run("map --aperture 60 --out a.exr " + options, folder.path()).status == 0);
    return content(folder / "a.exr");
  };
  const auto is_replaced = [&](const std::string& options) {
    const std::string earlier = content(folder / "a.exr");
    return made(options + " --skip-existing") != earlier;
  };
  put(folder / "own.csv", "wavelength_nm,n,k\n400,0.2,3\n700,0.3,4\n");
  const std::string usual = "--material ./own.csv --size 8 --wavelengths 400:700:100";
  made(usual);
  CHECK_FALSE(is_replaced(usual));
  for (const char* option :
       {"--precision half", "--compression zip", "--polarization full", "--max-bounces 1", "--illuminant a",
        "--observer 10", "--rgb rec2020", "--polarization full --quantity dop", "--quantity absorptance",
        "--quantity bounces", "--effects auto --tolerance 1"}) {
    CAPTURE(option);
    made(usual);
    CHECK(is_replaced(usual + " " + option));
    CHECK_FALSE(is_replaced(usual + " " + option));
    CHECK(is_replaced(usual));
  }
  CHECK(is_replaced("--material ./own.csv --size 9 --wavelengths 400:700:100"));
  CHECK(is_replaced("--material ./own.csv --size 8 --wavelengths 400:700:50"));
  CHECK(is_replaced("--material Ag --size 8 --wavelengths 400:700:100"));
  made(usual);
  put(folder / "own.csv", "wavelength_nm,n,k\n400,0.2,3\n700,0.3,5\n");
  CHECK(is_replaced(usual));
  vcavity::tools::ExrImage image = read_exr(folder / "a.exr");
  vcavity::tools::write_exr(folder / "a.exr", image);
  CHECK_FALSE(is_replaced(usual));
  image.attributes["software"] = std::string("vcavity 0.0.1");
  vcavity::tools::write_exr(folder / "a.exr", image);
  CHECK(is_replaced(usual));
  put(folder / "a.exr", "no image");
  CHECK(is_replaced(usual));
}

TEST_CASE("a sweep that is killed and resumed ends with complete files only") {
  const ScratchFolder folder, streams;
  const std::string sweep = "map --material Cu --aperture 5:180:5 --size 256 --out maps --skip-existing";
  {
    RunningProgram program(words(sweep), folder.path(), streams / "out", streams / "err");
    while (!program.ended() &&
           (!std::filesystem::exists(folder / "maps") || files_in(folder / "maps").size() < 5))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    program.send(SIGKILL);
    program.status();
  }
  REQUIRE(run(sweep, folder.path()).status == 0);
  int maps = 0;
  for (const std::string& name : files_in(folder / "maps"))
    if (name.ends_with(".exr")) {
      ++maps;
      CHECK(read_exr(folder / "maps" / name).height == 256);
    }
  CHECK(maps == 36);
}

TEST_CASE("sweeps that cannot be named are refused before anything is written") {
  const ScratchFolder folder;
  const auto refusal = [&](const std::string& line) {
    const Outcome outcome = run("map --size 8 " + line, folder.path());
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  CHECK(refusal("--material Cu --aperture 45,60 --out a.exr") ==
        "vcavity_maps: --out: 'a.exr' is one file for 2 maps, expected a folder\n");
  std::filesystem::create_directory(folder / "folder.exr");
  CHECK(run("map --size 8 --material Cu --aperture 45 --out folder.exr", folder.path()).status == 0);
  CHECK(files_in(folder / "folder.exr") == std::set<std::string>{"Cu-Johnson_45deg_550nm.exr"});
  std::filesystem::remove_all(folder / "folder.exr");
  CHECK(refusal("--material Cu,Cu --aperture 45 --out maps") ==
        "vcavity_maps: two maps would go into 'maps/Cu-Johnson_45deg_550nm.exr'\n");
  CHECK(refusal("--material Cu --aperture 5:180:5 --png a.png") ==
        "vcavity_maps: --png: 36 maps do not fit on a page, at most 24 do\n");
  CHECK(refusal("--material Cu,Ag --aperture 45 --wavelength 100 --out maps") ==
        "vcavity_maps: wavelength 100 nm is outside the data of Cu-Johnson, 187.9 to 1937 nm\n");
  CHECK(folder.names().empty());
}
