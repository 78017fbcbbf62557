// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>
#include <string>

#include "support/catch.hpp"
#include "tools/failure.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/temporary_file.hpp"

namespace vcavity::tools::testing {
namespace {

/// n of a file that holds just a formula.
double index(const std::string& formula, const std::string& coefficients, double wavelength_um) {
  const TemporaryFolder folder;
  const auto file = folder.write("glass.yml", "DATA:\n  - type: formula " + formula + "\n    coefficients: " +
                                                  coefficients + "\n    wavelength_range: 0.1 10\n");
  return load_material(file).at(1000 * wavelength_um).n;
}

Catch::Approx near(double value) {
  return Catch::Approx(value).epsilon(1e-15);
}

TEST_CASE("formula 1 is Sellmeier's with resonance wavelengths") {
  CHECK(index("1", "0 1 1", 2) == near(std::sqrt(1 + 4.0 / 3)));
  CHECK(index("1", "0.5 1 0.5 2 3", 2) == near(std::sqrt(1.5 + 4 / 3.75 - 8 / 5.0)));
}

TEST_CASE("formula 2 is Sellmeier's with squared resonance wavelengths") {
  CHECK(index("2", "0.5 1 0.25 2 9", 2) == near(std::sqrt(1.5 + 4 / 3.75 - 8 / 5.0)));
}

TEST_CASE("formula 3 is a sum of powers for the square of the index") {
  CHECK(index("3", "2 0.5 2 1 -2", 2) == near(std::sqrt(4.25)));
}

TEST_CASE("formula 4 has two resonances and a sum of powers") {
  CHECK(index("4", "1 3 2 0.5 2", 2) == near(std::sqrt(4.2)));
  CHECK(index("4", "1 3 2 0.5 2 2 0 3 1 0.2 2", 2) == near(std::sqrt(7)));
}

TEST_CASE("formula 4 without its second resonance is finite at 1 um, where L^2 - 0^0 vanishes") {
  CHECK(index("4", "1 3 2 0.5 2", 1) == near(std::sqrt(5)));
  CHECK(index("4", "1 3 2 0.5 2 0 0 0 0", 1) == near(std::sqrt(5)));
  CHECK(index("4", "1", 1) == 1);
}

TEST_CASE("formula 5 is Cauchy's") {
  CHECK(index("5", "1.5 0.02 -2 0.16 -4", 2) == near(1.515));
}

TEST_CASE("formula 6 is that of gases") {
  CHECK(index("6", "0.1 2 1.25", 2) == near(3.1));
}

TEST_CASE("formula 7 is Herzberger's") {
  // At L^2 = 1.028 both denominators are 1.
  CHECK(index("7", "1 2 3 0.1 0.01 0.001", std::sqrt(1.028)) ==
        near(6 + 0.1 * 1.028 + 0.01 * 1.028 * 1.028 + 0.001 * 1.028 * 1.028 * 1.028));
}

TEST_CASE("the second denominator of formula 7 is a square") {
  // At 2 um both denominators are q = 4 − 0.028.
  const double q = 4 - 0.028;
  CHECK(index("7", "1 2 3 0.1 0.01 0.001", 2) ==
        near(1 + 2 / q + 3 / (q * q) + 0.1 * 4 + 0.01 * 16 + 0.001 * 64));
}

TEST_CASE("formula 8 gives (n^2 - 1) / (n^2 + 2)") {
  CHECK(index("8", "0.1 0.2 1 0.05", 2) == near(std::sqrt(64.0 / 13)));  // x = 17/30
}

TEST_CASE("formula 9 has a pole and a dispersive line") {
  CHECK(index("9", "1 2 3 0.4 1 0.6", 2) == near(std::sqrt(3.25)));
}

TEST_CASE("a term of strength 0 does not count, not even at its own resonance") {
  CHECK(index("1", "0 0 2 3 1", 2) == near(std::sqrt(5)));
  CHECK(index("2", "0 0 4 3 1", 2) == near(std::sqrt(5)));
  CHECK(index("6", "0.5 0 0.25", 2) == 1.5);
  CHECK(index("8", "0.4 0 4", 2) == near(std::sqrt(3)));
  CHECK(index("9", "4 0 4", 2) == 2);
  CHECK(index("9", "4 0 0 0 2 0", 2) == 2);
}

TEST_CASE("coefficients at the end of a formula may be absent") {
  CHECK(index("1", "3", 2) == 2);
  CHECK(index("4", "4 0 2", 2) == 2);
  CHECK(index("6", "0.5", 2) == 1.5);
  CHECK(index("7", "1.5", 2) == 1.5);
  CHECK(index("8", "0.4", 2) == near(std::sqrt(3)));
  CHECK(index("9", "4", 2) == 2);
}

TEST_CASE("a list of coefficients that ends inside a term is refused") {
  const auto refusal = [](const std::string& formula, const std::string& coefficients) {
    const std::string text = failure<std::runtime_error>([&] { index(formula, coefficients, 2); });
    const auto reason = text.find(":3: ");
    return reason == text.npos ? text : text.substr(reason + 4);
  };
  const std::string cut = "the list of coefficients ends in the middle of the term that begins with C";
  CHECK(refusal("1", "0 3") == cut + "2");
  CHECK(refusal("2", "3.6453 2.2057 0.1879 1.8377") ==
        cut + "4");  // AgGaSe2, Boyd-o, in the database of 2026-05-24
  CHECK(refusal("3", "2 1") == cut + "2");
  CHECK(refusal("4", "1 3 2 0.5") == cut + "2");
  CHECK(refusal("4", "1 3 2 0.5 2 2 0") == cut + "6");
  CHECK(refusal("4", "1 3 2 0.5 2 2 0 3 1 7") == cut + "10");
  CHECK(refusal("5", "1.5 0.02 -2 0.16") == cut + "4");
  CHECK(refusal("6", "0.1 2") == cut + "2");
  CHECK(refusal("8", "0.1 0.2") == cut + "2");
  CHECK(refusal("9", "1 2") == cut + "2");
  CHECK(refusal("9", "1 2 3 0.4 1") == cut + "4");
}

}  // namespace
}  // namespace vcavity::tools::testing
