// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/program.hpp"
#include "output/small_disk.hpp"
#include "support/catch.hpp"

namespace {

// A command line that is refused, and what stderr says after the name of the program.
struct Refusal {
  std::string line;
  std::string text;
};

void check_refused(const Outcome& outcome, int status, const std::string& text) {
  CHECK(outcome.status == status);
  CHECK(outcome.out.empty());
  CHECK(outcome.err == "vcavity_maps: " + text + "\n");
}

void check_usage_errors(const std::vector<Refusal>& refusals) {
  for (const auto& [line, text] : refusals) {
    CAPTURE(line);
    const ScratchFolder folder;
    check_refused(run(line, folder.path()), 2, text);
    CHECK(folder.names().empty());
  }
}

const std::string a_ray = "direction --material Ag --theta 30 --phi 20 --aperture ";
const std::string a_groove = "direction --material Ag --aperture 45 ";
const std::string a_table = "table --material Ag ";
const std::string a_map = "map --material Ag --aperture 45 --out a.exr ";

}  // namespace

TEST_CASE("what is no number of the accepted range is refused with option, value and range") {
  check_usage_errors(
      {{a_ray + "0", "--aperture: '0' is not accepted, expected a number above 0 to 180"},
       {a_ray + "-1", "--aperture: '-1' is not accepted, expected a number above 0 to 180"},
       {a_ray + "180.5", "--aperture: '180.5' is not accepted, expected a number above 0 to 180"},
       {a_ray + "nan", "--aperture: 'nan' is not accepted, expected a number above 0 to 180"},
       {a_ray + "inf", "--aperture: 'inf' is not accepted, expected a number above 0 to 180"},
       {a_ray + "1e400", "--aperture: '1e400' is not accepted, expected a number above 0 to 180"},
       {a_ray + "45deg", "--aperture: '45deg' is not accepted, expected a number above 0 to 180"},
       {a_ray + "1e-9", "--aperture: '1e-09' is too narrow, expected at least 1.15e-07 degrees"},
       {a_groove + "--theta 91 --phi 0", "--theta: '91' is not accepted, expected a number from 0 to 90"},
       {a_groove + "--theta nan --phi 0", "--theta: 'nan' is not accepted, expected a number from 0 to 90"},
       {a_groove + "--theta 0 --phi 361", "--phi: '361' is not accepted, expected a number from -360 to 360"},
       {a_ray + "45 --position 1.5", "--position: '1.5' is not accepted, expected a number from -1 to 1"},
       {a_ray + "45 --position nan", "--position: 'nan' is not accepted, expected a number from -1 to 1"},
       {a_ray + "45 --wavelength 0", "--wavelength: '0' is not accepted, expected a number above 0 to 1e+12"},
       {a_table + "--aperture 45,,60",
        "--aperture: '45,,60' is not accepted, expected something before and behind every comma"},
       {a_table + "--aperture 30:180:0", "--aperture: '0' is not accepted, expected a number above 0"},
       {a_table + "--aperture 180:30:5",
        "--aperture: '180:30:5' is not accepted, expected LOW:HIGH:STEP with LOW not above HIGH"},
       {a_table + "--aperture 45 --tolerance 0",
        "--tolerance: '0' is not accepted, expected a number above 1e-15 and below 1"},
       {a_table + "--aperture 45 --max-bounces 1.5",
        "--max-bounces: '1.5' is not accepted, expected a whole number from 1 to 2147483647"},
       {a_map + "--size 0", "--size: '0' is not accepted, expected a whole number from 1 to 32768"},
       {a_map + "--wavelengths 400:700", "--wavelengths: '400:700' is not accepted, expected LOW:HIGH:STEP"},
       {"paper --size 3", "--size: '3' is not accepted, expected a whole number from 16 to 4096"}});
}

TEST_CASE("unknown words are refused with what was expected") {
  check_usage_errors(
      {{"mapp",
        "unknown command 'mapp', expected one of paper, map, table, direction, export, cost, materials"},
       {"map --materail Ag", "unknown option '--materail'; did you mean '--material'?"},
       {"map --gloss 3", "unknown option '--gloss'"},
       {"--verison", "unknown option '--verison'; did you mean '--version'?"},
       {"paper now", "The following argument was not expected: now"},
       {"map --out a.exr --aperture 45", "--material is required"},
       {"map --material Ag --aperture 45", "--out or --png is required"},
       {a_map + "--quantity gloss",
        "--quantity: 'gloss' is not accepted, expected reflectance, bounces, dop or absorptance"},
       {"materials --format xml", "--format: 'xml' is not accepted, expected md, csv or json"},
       {"materials --wavelength 550", "--wavelength requires M"},
       {"materials Cu --plot Cu.jpg",
        "--plot: 'Cu.jpg' is not accepted, expected the name of a .png or .svg file"}});
}

TEST_CASE("requests that contradict themselves are refused") {
  check_usage_errors(
      {{a_map + "--wavelengths 400:700:10 --wavelength 550", "--wavelength excludes --wavelengths"},
       {a_map + "--tolerance 1e-9",
        "--tolerance: '1e-09' is not accepted, expected at least 3e-08, which rounding of the numbers and "
        "their storage may reach"},
       {a_map + "--tolerance 1e-3 --quantity bounces",
        "--tolerance: bounds the error of --quantity reflectance or absorptance, not of others"},
       {a_map + "--tolerance 1e-3 --environment a.exr", "--tolerance excludes --environment"},
       {a_map + "--quantity bounces --max-bounces 3",
        "--max-bounces: limits the reflectance, not --quantity bounces or absorptance"},
       {a_map + "--wavelengths 400:400:10",
        "--wavelengths: '400:400:10' is a single wavelength, for which there is --wavelength"},
       {"materials 1.5 --plot a.png", "--plot: index '1.5' is the same at every wavelength"}});
}

TEST_CASE("materials that do not exist are refused, the nearest one is named") {
  const std::string rest =
      " expected a name such as Cu, a file such as ./my-copper.yml, or an index such as "
      "1.5 or 0.05+4i";
  const std::string physical = "n must be above 0 and k, in n + ik, must not be negative";
  check_usage_errors({{"materials Cuu", "unknown material 'Cuu'; did you mean 'Cu'?" + rest},
                      {"materials unobtainium", "unknown material 'unobtainium';" + rest},
                      {"materials notes.txt", "unknown material 'notes.txt';" + rest},
                      {"materials 0", "refractive index '0': " + physical},
                      {"materials -1.5", "refractive index '-1.5': " + physical},
                      {"materials 1.5-0.1i", "refractive index '1.5-0.1i': " + physical},
                      {"materials nan", "refractive index 'nan': " + physical}});
  const std::string domain = "the refractive index n must lie in [4.88535e-77, 2.8948e+76], not be ";
  check_usage_errors(
      {{"materials 1e400", "refractive index '1e400': " + domain + "inf"},
       {a_table.substr(0, 17) + "1e80 --aperture 45", "refractive index '1e80': " + domain + "1e+80"}});
}

TEST_CASE("lists with nothing before or behind a comma are refused") {
  const std::string expected = "' is not accepted, expected something before and behind every comma";
  check_usage_errors(
      {{"table --aperture 45 --material 1.5,,2", "--material: '1.5,,2" + expected},
       {"table --aperture 45 --material 1.5,", "--material: '1.5," + expected},
       {"table --aperture 45 --material ,1.5", "--material: ',1.5" + expected},
       {"table --aperture 45 --material \"1.5",
        "--material: '\"1.5' is not accepted, expected a second "
        "quotation mark"},
       {a_table + "--aperture 60,",
        "--aperture: '60,' is not accepted, expected something before and behind every comma"}});
}

TEST_CASE("a file with a comma in its name is a material of every command") {
  const ScratchFolder folder;
  put(folder / "Ag,film.csv", "wavelength_nm,n,k\n400,0.2,3\n700,0.3,4\n");
  for (const std::string name : {"Ag,film.csv", "./Ag,film.csv", "Ag\\,film.csv", "\"Ag,film.csv\"",
                                 "1.5,Ag\\,film.csv", "\"Ag,film.csv\",1.5"}) {
    for (const std::string& command :
         {std::string("table --aperture 60"), std::string("direction --aperture 60 --theta 10 --phi 0"),
          std::string("map --aperture 60 --size 4 --out maps/")}) {
      CAPTURE(name, command);
      const Outcome outcome = run(command + " --material " + name, folder.path());
      CHECK(outcome.status == 0);
      CHECK(outcome.err.empty());
    }
  }
  CHECK(run("materials Ag,film.csv", folder.path()).status == 0);
  CHECK(run("materials Ag,film.csv --plot a.svg", folder.path()).status == 0);
}

TEST_CASE("a wavelength without data is refused wherever it is asked for") {
  const std::string text = "wavelength 100 nm is outside the data of Ag-Johnson, 187.9 to 1937 nm";
  for (const std::string& line :
       {a_ray + "45 --wavelength 100", a_table + "--aperture 45 --wavelength 100", a_map + "--wavelength 100",
        a_map + "--wavelengths 100:700:10", std::string("materials Ag --wavelength 100")})
    check_usage_errors({{line, text}});
}

TEST_CASE("files that cannot be read or make no sense fail with file and line") {
  const ScratchFolder folder;
  put(folder / "word.yml", "DATA:\n  - type: tabulated nk\n    data: |\n      0.4 1 2\n      0.5 x 3\n");
  put(folder / "bracket.yml", "DATA: [1,\n");
  put(folder / "row.csv", "wavelength_um,n,k\n0.4,1,2\n0.5,1\n");
  put(folder / "unit.csv", "wavelength,n,k\n0.4,1,2\n");
  const auto check_failure = [&](const std::string& file, const std::string& beginning) {
    const Outcome outcome =
        run("direction --aperture 45 --theta 0 --phi 0 --material ./" + file, folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("vcavity_maps: ./" + file + beginning));
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
  };
  check_failure("missing.yml", ": cannot read: No such file or directory\n");
  check_failure("word.yml", ":5: 'x' is not a finite number\n");
  check_failure("bracket.yml", ":2: ");
  check_failure("row.csv", ":3: ");
  check_failure("unit.csv", ":1: the first line with content must be a heading that names the unit");
}

TEST_CASE("outputs that cannot be written fail before the work starts") {
  const ScratchFolder folder;
  put(folder / "file", "");
  const std::string enormous = "map --material Ag --aperture 45,60 --size 32768 --out ";
  check_refused(run(enormous + "file", folder.path()), 1, "cannot write 'file': Not a directory");
  check_refused(run(enormous + "maps --png missing/a.png", folder.path()), 1,
                "cannot write 'missing/a.png': No such file or directory");
  const std::string single = "map --material Ag --aperture 45 --size 32768 --out ";
  check_refused(run(single + "missing/a.exr", folder.path()), 1,
                "cannot write 'missing/a.exr': No such file or directory");
  check_refused(run(single + "file/a.exr", folder.path()), 1, "cannot write 'file/a.exr': Not a directory");
  check_refused(run("paper --out file", folder.path()), 1, "cannot write 'file': Not a directory");
}

TEST_CASE("a full disk is reported and earlier files stay as they were") {
  const SmallDisk disk;
  if (!disk.mounted()) {
    WARN("not permitted to mount a small disk, test skipped");
    return;
  }
  const auto& folder = disk.folder();
  REQUIRE(run("map --material Ag --aperture 45 --size 16 --out a.exr", folder.path()).status == 0);
  const std::string earlier = content(folder / "a.exr");
  check_refused(run("map --material Ag --aperture 60 --size 512 --out a.exr", folder.path()), 1,
                "cannot write 'a.exr': No space left on device");
  CHECK(content(folder / "a.exr") == earlier);
  CHECK(folder.names() == std::vector<std::string>{"a.exr"});
}

TEST_CASE("no command that writes a file loses the earlier one when the disk is full") {
  const SmallDisk disk;
  if (!disk.mounted()) {
    WARN("not permitted to mount a small disk, test skipped");
    return;
  }
  const auto& folder = disk.folder();
  const std::string groove = " --material Ag --aperture 45";
  for (const auto& [name, command] : std::vector<std::pair<std::string, std::string>>{
           {"a.xml", "export --finish matte --albedo 0.5 --aperture 180 --out"},
           {"a.svg", "direction" + groove + " --theta 30 --phi 20 --plot"},
           {"b.svg", "table --material Ag --aperture 45,60 --plot"},
           {"c.svg", "materials Cu --plot"},
           {"a.png", "map" + groove + " --size 64 --png"}}) {
    CAPTURE(command);
    std::ofstream(folder / name) << "earlier" << std::flush;
    std::ofstream(folder / "filler") << std::string(100'000, 'x') << std::flush;
    const Outcome outcome = run(command + " " + name, folder.path());
    CHECK(outcome.status == 1);
    CHECK(outcome.err == "vcavity_maps: cannot write '" + name + "': No space left on device\n");
    CHECK(content(folder / name) == "earlier");
    CHECK(folder.names().size() == 2);
    std::filesystem::remove(folder / name);
  }
}

TEST_CASE("a device without space is reported") {
  check_refused(run("map --material Ag --aperture 45 --size 16 --out /dev/full"), 1,
                "cannot write '/dev/full': No space left on device");
}
