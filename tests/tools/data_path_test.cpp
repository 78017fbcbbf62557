// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/data_path.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

#include "support/catch.hpp"
#include "tools/failure.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/error.hpp"
#include "tools/temporary_file.hpp"

namespace vcavity::tools::testing {
namespace {

/// VCAVITY_DATA set for the time of a test.
struct ChosenData {
  explicit ChosenData(const std::string& folder) { setenv("VCAVITY_DATA", folder.c_str(), 1); }
  ~ChosenData() { unsetenv("VCAVITY_DATA"); }
};

TEST_CASE("a program in the build tree finds the data in the source tree") {
  unsetenv("VCAVITY_DATA");
  CHECK(std::filesystem::exists(data_directory() / "nk" / "Cu-Johnson.yml"));
  CHECK(std::filesystem::exists(data_directory() / "cie" / "cie_1931_2deg.csv"));
}

TEST_CASE("VCAVITY_DATA names another folder") {
  const TemporaryFolder folder;
  const ChosenData chosen(folder.path().string());
  std::filesystem::create_directory(folder.path() / "nk");
  folder.write("nk/defaults.yml", "glass: window\n");
  folder.write("nk/window.yml",
               "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 0.7\n    coefficients: 1.52\n");
  CHECK(data_directory() == folder.path());
  CHECK(load_material("glass").at(500).n == 1.52);
  CHECK_THROWS_AS(load_material("Cu"), UsageError);

  folder.write("nk/GLASS.yml",
               "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 0.7\n    coefficients: 1.9\n");
  CHECK(load_material("GLASS").at(500).n == 1.9);
  CHECK(load_material("glass").at(500).n == 1.52);
}

TEST_CASE("VCAVITY_DATA must be a folder") {
  const ChosenData chosen("/nowhere");
  CHECK(failure<UsageError>([] { data_directory(); }) ==
        "VCAVITY_DATA is '/nowhere', expected a folder that holds nk and cie");
}

}  // namespace
}  // namespace vcavity::tools::testing
