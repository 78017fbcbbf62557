// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/catalogue.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "support/catch.hpp"
#include "tools/failure.hpp"
#include "tools/materials/nearest_name.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_file.hpp"
#include "tools/temporary_file.hpp"

namespace vcavity::tools::testing {
namespace {

std::string usage_error(const std::string& specification) {
  return failure<UsageError>([&] { load_material(specification); });
}

TEST_CASE("a material is found by its full name, its short name and in any letter case") {
  CHECK(load_material("Cu-Johnson").name() == "Cu-Johnson");
  CHECK(load_material("Cu").name() == "Cu-Johnson");
  CHECK(load_material("cu").name() == "Cu-Johnson");
  CHECK(load_material("n-bk7").name() == "N-BK7-Schott");
  CHECK(load_material("water").name() == "H2O-Hale");
  CHECK(load_material("Cu").reference() ==
        "P. B. Johnson and R. W. Christy. Optical constants of the noble metals. Phys. Rev. B 6, 4370-4379 "
        "(1972)");
}

TEST_CASE("copper has the published index") {
  // Johnson and Christy 1972, Table I: 2.26 eV (0.5486 um).
  const auto index = load_material("Cu").at(548.6);
  CHECK(index.n == 1.02);
  CHECK(index.k == 2.577);
}

TEST_CASE("an unknown name is answered with the nearest one") {
  CHECK(usage_error("Cuu") ==
        "unknown material 'Cuu'; did you mean 'Cu'? expected a name such as Cu, a file such as "
        "./my-copper.yml, or an "
        "index such as 1.5 or 0.05+4i");
  CHECK(usage_error("Ag-Jonson").find("did you mean 'Ag-Johnson'?") != std::string::npos);
  for (const char* word : {"@@@@@@", "notes.txt"})
    CHECK(usage_error(word).find("did you mean") == std::string::npos);
  CHECK(usage_error("") ==
        "unknown material ''; expected a name such as Cu, a file such as ./my-copper.yml, or an index such "
        "as 1.5 or "
        "0.05+4i");
}

TEST_CASE("the edit distance counts insertions, removals and replacements") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("silver", "sliver") == 2);
}

TEST_CASE("a number is a material of that index at every wavelength") {
  const Material glass = load_material("1.5");
  CHECK(glass.at(1).n == 1.5);
  CHECK(glass.at(1e9).n == 1.5);
  CHECK(glass.at(550).k == 0);
  CHECK(glass.name() == "1.5");
  CHECK(glass.constant());

  const auto silver = load_material("0.1249+3.3391i").at(550);
  CHECK(silver.n == 0.1249);
  CHECK(silver.k == 3.3391);
  CHECK(load_material("0.05+4j").at(550).k == 4);
  CHECK(load_material("1e-1+3e0i").at(550).n == 0.1);
  CHECK(load_material("+1.5+0i").at(550).k == 0);
}

TEST_CASE("an index that is not physical is refused with its text") {
  for (const std::string text : {"0", "-1.5", "nan", "1.5-0.1i", "1.5+nani", "0+3i"}) {
    CHECK(usage_error(text) ==
          "refractive index '" + text + "': n must be above 0 and k, in n + ik, must not be negative");
  }
}

TEST_CASE("an index beyond what the library computes with is refused with the domain") {
  for (const std::string text : {"inf", "1e80", "1e999", "1e-80", "1.5+infi", "1.5+1e400i"}) {
    CAPTURE(text);
    const std::string error = usage_error(text);
    CHECK(error.starts_with("refractive index '" + text + "': "));
    CHECK(error.find("must lie in [") != std::string::npos);
  }
}

TEST_CASE("a text that only begins like a number is no index") {
  for (const std::string text : {"1,5", "1.5+", "1.5i", "1.5+2", "1.5 + 2i", "1.5+2ii", "1e999x"}) {
    CHECK(usage_error(text).starts_with("unknown material '" + text + "'"));
  }
}

TEST_CASE("a file is recognised by a slash or its extension and named after its stem") {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "my-glass.YML", "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 0.7\n    coefficients: 1.5\n");
  CHECK(load_material(file).name() == "my-glass");
  CHECK(load_material(file).file() == file);
  CHECK(failure<std::runtime_error>([] { load_material("missing.yml"); }) ==
        "missing.yml: cannot read: No such file or directory");
  CHECK(usage_error("./Cu") == "'./Cu' is no material file: expected .yml, .yaml, .csv, .tsv, .txt or .spd");
}

TEST_CASE("every short name stands for a file, and the default sources cover the visible range") {
  std::size_t short_names = 0;
  for (const auto& [material, names] : list_materials()) {
    short_names += names.size();
    for (const std::string& name : names) {
      INFO(name << " is " << material.name());
      CHECK(load_material(name).name() == material.name());
      // No source of bulk PMMA reaches below 400 nm.
      CHECK(material.range().min_um <= (name == "PMMA" ? 0.4 : 0.38));
      CHECK(material.range().max_um >= 0.78);
    }
  }
  CHECK(short_names > 20);
}

TEST_CASE("names differ in more than letter case") {
  std::set<std::string> names;
  std::size_t count = 0;
  for (const auto& [material, short_names] : list_materials()) {
    for (const std::string& name : short_names) names.insert(lower_case(name));
    names.insert(lower_case(material.name()));
    count += 1 + short_names.size();
  }
  CHECK(names.size() == count);
}

TEST_CASE("every material of the collection names its publication") {
  for (const auto& [material, names] : list_materials()) {
    INFO(material.name());
    CHECK(material.reference().size() > 10);
    CHECK(material.reference().find('<') == std::string::npos);
  }
}

}  // namespace
}  // namespace vcavity::tools::testing
