// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/spd_pair.hpp"

#include <stdexcept>
#include <string>

#include "support/catch.hpp"
#include "tools/failure.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/error.hpp"
#include "tools/temporary_file.hpp"

namespace vcavity::tools::testing {
namespace {

TEST_CASE("a pair of .spd files is one material, whichever of the two is named") {
  const TemporaryFolder folder;
  const auto eta_file = folder.write("Cu.eta.spd", "# nm n\n400 1\n600 2\n");
  const auto k_file = folder.write("Cu.k.spd", "300 2\n500 4\n");
  for (const auto& file : {eta_file, k_file}) {
    const Material copper = load_material(file);
    CHECK(copper.name() == "Cu");
    CHECK(copper.reference() == "Cu.eta.spd and Cu.k.spd");
    CHECK(copper.range().min_um == 0.4);
    CHECK(copper.range().max_um == 0.5);
    CHECK(copper.at(400).n == 1);
    CHECK(copper.at(400).k == Catch::Approx(3).epsilon(1e-14));
    CHECK(copper.at(500).n == Catch::Approx(1.5).epsilon(1e-14));
    CHECK_THROWS_AS(copper.at(501), UsageError);
  }
}

TEST_CASE("half a pair is not enough") {
  const TemporaryFolder folder;
  const auto eta_file = folder.write("Cu.eta.spd", "400 1\n600 2\n");
  CHECK(failure<std::runtime_error>([&] { load_material(eta_file); }) ==
        (folder.path() / "Cu.k.spd").string() + ": cannot read: No such file or directory");
  CHECK(failure<UsageError>([&] { load_material("light.spd"); }) ==
        "'light.spd' is not half of a pair: expected a name such as Cu.eta.spd or Cu.k.spd");
}

TEST_CASE("bad rows are reported with the file of the pair they are in") {
  const TemporaryFolder folder;
  const auto eta_file = folder.write("Cu.eta.spd", "400 1\n600 2\n");
  const auto k_file = folder.write("Cu.k.spd", "400 1\n600 2 3\n");
  CHECK(failure<std::runtime_error>([&] { load_material(eta_file); }) ==
        k_file + ":2: expected 2 numbers, found 3");
  folder.write("Cu.k.spd", "\n700 1\n800 2\n");
  CHECK(failure<std::runtime_error>([&] { load_material(eta_file); }) ==
        k_file +
            ":2: n is given from 400 to 600 nm but k from 700 to 800 nm: no wavelength has both"
            "; --missing-k zero takes k as 0 where only n is given");
  folder.write("Cu.k.spd", "400 1\n600 -2\n");
  CHECK(failure<std::runtime_error>([&] { load_material(eta_file).at(600); }) ==
        k_file + ":1: k is -2 at 600 nm; it must not be negative");
  folder.write("Cu.k.spd", "# nothing\n");
  CHECK(failure<std::runtime_error>([&] { load_material(eta_file); }) == k_file + ":1: the table is empty");
}

}  // namespace
}  // namespace vcavity::tools::testing
