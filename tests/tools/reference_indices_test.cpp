// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <fstream>
#include <set>
#include <string>

#include "support/catch.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/data_path.hpp"
#include "tools/support/text_file.hpp"

namespace vcavity::tools::testing {
namespace {

TEST_CASE("every material of the collection agrees with another reader of the same files") {
  std::ifstream table(VCAVITY_TEST_DATA "/reference_indices.csv");
  REQUIRE(table);
  std::set<std::string> files;
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with('#')) continue;
    const auto words = split_words(line);
    REQUIRE(words.size() == 4);
    const std::string file(words[3]);
    files.insert(file);
    const double wavelength_nm = *parse_number(words[0]);
    const auto index = load_material((data_directory() / "nk" / file).string()).at(wavelength_nm);
    INFO(line);
    // The wavelengths are rounded on their way through nanometres, which steep tables magnify.
    CHECK(index.n == Catch::Approx(*parse_number(words[1])).epsilon(1e-12));
    CHECK(index.k == Catch::Approx(*parse_number(words[2])).epsilon(1e-12));
  }
  CHECK(files.size() == list_materials().size());
}

}  // namespace
}  // namespace vcavity::tools::testing
