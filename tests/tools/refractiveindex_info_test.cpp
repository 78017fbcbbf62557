// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/refractiveindex_info.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "tools/failure.hpp"
#include "tools/support/error.hpp"
#include "tools/temporary_file.hpp"

namespace vcavity::tools::testing {
namespace {

/// A file with the given content, as long as the test runs.
struct File {
  explicit File(std::string_view content) : path(folder.write("stuff.yml", content)) {}
  Material read() const { return read_refractiveindex_info(path, "stuff"); }
  std::string failure_to_read() const {
    return failure<std::runtime_error>([this] { read(); });
  }

  TemporaryFolder folder;
  std::string path;
};

TEST_CASE("a table of n and k is linear between its rows") {
  const Material stuff =
      File("DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1 3\n        0.6 2 5\n").read();
  CHECK(stuff.at(400).n == 1);
  CHECK(stuff.at(600).k == 5);
  CHECK(stuff.at(450).n == Catch::Approx(1.25).epsilon(1e-15));
  CHECK(stuff.at(450).k == Catch::Approx(3.5).epsilon(1e-15));
  CHECK(stuff.range().min_um == 0.4);
  CHECK(stuff.range().max_um == 0.6);
  CHECK(stuff.extinction_given());
  CHECK_FALSE(stuff.constant());
}

TEST_CASE("nothing is extrapolated") {
  const Material stuff =
      File("DATA:\n  - type: tabulated nk\n    data: |\n        0.4368 1 3\n        0.6 2 5\n").read();
  CHECK(stuff.at(436.8).n == 1);
  CHECK(failure<UsageError>([&] { stuff.at(436.79); }) ==
        "wavelength 436.79 nm is outside the data of stuff, 436.8 to 600 nm");
  CHECK_THROWS_AS(stuff.at(436.8 * (1 - 1e-12)), UsageError);
  CHECK(failure<UsageError>([&] { stuff.at(600.01); }) ==
        "wavelength 600.01 nm is outside the data of stuff, 436.8 to 600 nm");
  CHECK(failure<UsageError>([&] { stuff.at(std::nan("")); }) ==
        "wavelength nan nm is outside the data of stuff, 436.8 to 600 nm");
}

TEST_CASE("n and k may come from different entries, and count where both are given") {
  const Material stuff = File(R"(DATA:
  - type: tabulated k
    data: |
        0.5 0.1
        0.9 0.5
  - type: formula 5
    wavelength_range: 0.3 0.7
    coefficients: 1.5
)")
                             .read();
  CHECK(stuff.range().min_um == 0.5);
  CHECK(stuff.range().max_um == 0.7);
  CHECK(stuff.at(600).n == 1.5);
  CHECK(stuff.at(600).k == Catch::Approx(0.2).epsilon(1e-14));
  CHECK_THROWS_AS(stuff.at(499), UsageError);
  CHECK_THROWS_AS(stuff.at(701), UsageError);
}

TEST_CASE("the older layouts are read: 'range' for 'wavelength_range', DATA without a list") {
  CHECK(File("DATA:\n  - type: formula 5\n    range: 0.3 0.7\n    coefficients: 1.5\n").read().at(300).n ==
        1.5);
  CHECK(File("DATA:\n  type: formula 5\n  range: 0.3 0.7\n  coefficients: 1.5\n").read().at(700).n == 1.5);
}

TEST_CASE("keys may stand in any order and properties may hold formulas of their own") {
  const Material stuff = File(R"(PROPERTIES:
    thermal_dispersion:
      - type: formula A
        coefficients: 1.86e-06 1.31e-08
        wavelength_range: 1 2
DATA:
  - coefficients: 1.5
    wavelength_range: 0.3 0.7
    type: formula 5
CONDITIONS:
    temperature: 293
REFERENCES: |
    A. Author.<br>
    <a href="https://example.org/a&b"><i>Journal</i> <b>1</b></a> (k < 2×10<sup>-4</sup>)
COMMENTS: "20 °C")")
                             .read();
  CHECK(stuff.at(500).n == 1.5);
  CHECK(stuff.reference() == "A. Author. Journal 1 (k < 2×10-4)");
  CHECK(stuff.comments() == "20 °C");
}

TEST_CASE("data for n alone are those of a transparent material") {
  const Material stuff =
      File("DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.6 1.4\n").read();
  CHECK(stuff.at(500).k == 0);
  CHECK_FALSE(stuff.extinction_given());
}

TEST_CASE("rows may stand in any order, and the last line needs no end") {
  const Material stuff =
      File("DATA:\n  - type: tabulated nk\n    data: |\n        0.8 4 8\n        0.4 1 3\n\n        0.6 2 5")
          .read();
  CHECK(stuff.at(400).n == 1);
  CHECK(stuff.at(500).n == Catch::Approx(1.5).epsilon(1e-15));
  CHECK(stuff.at(700).k == Catch::Approx(6.5).epsilon(1e-15));
}

TEST_CASE("rows of the same wavelength are replaced by their mean") {
  const Material stuff = File(
                             "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1\n        0.6 2\n      "
                             "  0.6 4\n        0.8 3\n")
                             .read();
  CHECK(stuff.at(600).n == 3);
  CHECK(stuff.at(500).n == Catch::Approx(2).epsilon(1e-15));
}

TEST_CASE("a table of one row holds at its wavelength only") {
  const Material stuff = File("DATA:\n  - type: tabulated nk\n    data: |\n        0.5893 1.5 0\n").read();
  CHECK(stuff.at(589.3).n == 1.5);
  CHECK_THROWS_AS(stuff.at(589.4), UsageError);
}

TEST_CASE("line ends of other systems do no harm") {
  CHECK(File("DATA:\r\n  - type: tabulated nk\r\n    data: |\r\n        0.4 1 3\r\n        0.6 2 5\r\n")
            .read()
            .at(600)
            .k == 5);
}

TEST_CASE("a malformed number is reported with its line") {
  const File file(
      "# comment\nDATA:\n  - type: tabulated nk\n    data: |\n        0.4 1 3\n\n        0.6 2 1.80-17\n");
  CHECK(file.failure_to_read() == file.path + ":7: '1.80-17' is not a finite number");
  const File signs("DATA:\n  - type: tabulated n\n    data: |\n        0.4 +-1\n");
  CHECK(signs.failure_to_read() == signs.path + ":4: '+-1' is not a finite number");
  const File infinite("DATA:\n  - type: tabulated n\n    data: |\n        0.4 inf\n");
  CHECK(infinite.failure_to_read() == infinite.path + ":4: 'inf' is not a finite number");
  const File formula(
      "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 0.7\n    coefficients: 1.5 abc\n");
  CHECK(formula.failure_to_read() == formula.path + ":4: 'abc' is not a finite number");
}

TEST_CASE("a row of the wrong length is reported with its line") {
  const File file("DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1 3\n        0.6 2\n");
  CHECK(file.failure_to_read() == file.path + ":5: expected 3 numbers, found 2");
}

TEST_CASE("a table without rows or with a wavelength of 0 is an error") {
  const File empty("DATA:\n  - type: tabulated nk\n    data: |\n\nREFERENCES: none\n");
  CHECK(empty.failure_to_read() == empty.path + ":3: the table is empty");
  const File zero("DATA:\n  - type: tabulated n\n    data: |\n        0 1.5\n");
  CHECK(zero.failure_to_read() == zero.path + ":4: the wavelength is not above 0");
}

TEST_CASE("k without n is an error, and so is the nonlinear index alone") {
  const File k_only("REFERENCES: me\nDATA:\n  - type: tabulated k\n    data: |\n        0.4 1\n");
  CHECK(k_only.failure_to_read() == k_only.path + ":3: k is given but n is not");
  const File n2_only("REFERENCES: me\nDATA:\n  - type: tabulated n2\n    data: |\n        0.4 1e-20\n");
  CHECK(n2_only.failure_to_read() == n2_only.path + ":3: DATA gives no refractive index n");
}

TEST_CASE("n and k without a common wavelength are an error") {
  const File file(
      "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 1.4\n"
      "  - type: tabulated k\n    data: |\n        0.6 1e-3\n        0.7 1e-3\n");
  CHECK(file.failure_to_read() ==
        file.path +
            ":6: n is given from 400 to 500 nm but k from 600 to 700 nm: no wavelength has both"
            "; --missing-k zero takes k as 0 where only n is given");
}

TEST_CASE("n given twice by tables or twice by formulas is an error") {
  const File tables(
      "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n"
      "  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n");
  CHECK(tables.failure_to_read() == tables.path + ":5: n was already given by the entry on line 2");
  const std::string formula = "  - type: formula 5\n    wavelength_range: 0.3 0.7\n    coefficients: 1.5\n";
  const File formulas("DATA:\n" + formula + formula);
  CHECK(formulas.failure_to_read() == formulas.path + ":5: n was already given by the entry on line 2");
  const std::string table = "  - type: tabulated k\n    data: |\n        0.4 0\n";
  const File extinctions("DATA:\n" + formula + table + table);
  CHECK(extinctions.failure_to_read() == extinctions.path + ":8: k was already given by the entry on line 5");
}

TEST_CASE("of a formula and a table for n the table counts, in either order, and the comments say so") {
  const std::string formula = "  - type: formula 5\n    wavelength_range: 0.3 0.7\n    coefficients: 1.5\n";
  const std::string table = "  - type: tabulated nk\n    data: |\n        0.4 1.6 0.1\n        0.5 1.8 0.3\n";
  const Material first = File("COMMENTS: film\nDATA:\n" + formula + table).read();
  const Material second = File("DATA:\n" + table + formula).read();
  for (const Material& stuff : {first, second}) {
    CHECK(stuff.at(400).n == 1.6);
    CHECK(stuff.at(400).k == 0.1);
    CHECK_THROWS_AS(stuff.at(600), UsageError);
  }
  CHECK(first.comments() == "film; n from the table on line 6, not from the formula on line 3");
  CHECK(second.comments() == "n from the table on line 2, not from the formula on line 6");
}

TEST_CASE(
    "where n is known and k is not the wavelength is refused with what is known, or k is 0 on request") {
  const File file(
      "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 2\n    coefficients: 1.5\n"
      "  - type: tabulated k\n    data: |\n        1 1e-3\n        2 3e-3\n");
  CHECK(failure<UsageError>([&] { file.read().at(550); }) ==
        "wavelength 550 nm is outside the data of k of stuff, 1000 to 2000 nm, though n is 1.5 there; "
        "--missing-k zero "
        "takes k as 0 where only n is given");
  CHECK(failure<UsageError>([&] { file.read().at(200); }) ==
        "wavelength 200 nm is outside the data of stuff, 1000 to 2000 nm");
  const Material glass = read_refractiveindex_info(file.path, "stuff", MissingExtinction::zero);
  CHECK(glass.at(550).k == 0);
  CHECK(glass.at(550).n == 1.5);
  CHECK(glass.at(1500).k == Catch::Approx(2e-3).epsilon(1e-12));
  CHECK_THROWS_AS(glass.at(200), UsageError);
  CHECK(glass.reference().ends_with("(k taken as 0 where it is not given)"));
  const File apart(
      "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 1.4\n"
      "  - type: tabulated k\n    data: |\n        0.6 1e-3\n        0.7 1e-3\n");
  CHECK(read_refractiveindex_info(apart.path, "stuff", MissingExtinction::zero).at(450).k == 0);
}

TEST_CASE("text that is not UTF-8 is refused with its line and how to convert it") {
  const File latin1(
      "REFERENCES: me\nCOMMENTS: M\xfcller\nDATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n");
  CHECK(latin1.failure_to_read() ==
        latin1.path + ":2: the text is not UTF-8 but perhaps Latin-1; 'iconv -f latin1 -t utf8' converts it");
}

TEST_CASE("wavelengths of X-rays and of radio waves are read") {
  const Material stuff =
      File("DATA:\n  - type: tabulated nk\n    data: |\n        1e-5 0.99999 1e-6\n        5e4 1.9 0.01\n")
          .read();
  CHECK(stuff.at(0.01).n == 0.99999);
  CHECK(stuff.at(5e7).k == 0.01);
}

TEST_CASE("what is not a file of refractiveindex.info is refused") {
  const File list("- 1\n- 2\n");
  CHECK(list.failure_to_read() == list.path + ":1: not a file of refractiveindex.info: there is no key DATA");
  const File empty("");
  CHECK(empty.failure_to_read() ==
        empty.path + ":1: not a file of refractiveindex.info: there is no key DATA");
  const File not_yaml("DATA:\n  - type: [tabulated\n    data: x\n");
  CHECK(not_yaml.failure_to_read().starts_with(not_yaml.path + ":"));
  const File unknown("DATA:\n  - data: |\n        0.4 1\n    type: tabulated epsilon\n");
  CHECK(unknown.failure_to_read() ==
        unknown.path +
            ":4: unknown type 'tabulated epsilon', expected tabulated nk, n or k, or formula 1 to 9");
  CHECK(File("DATA:\n  - type: formula 10\n")
            .failure_to_read()
            .ends_with("expected tabulated nk, n or k, or formula 1 to 9"));
  const File no_type("DATA:\n  - data: |\n        0.4 1\n");
  CHECK(no_type.failure_to_read() == no_type.path + ":2: the entry has no 'type'");
  const File words("DATA: none\n");
  CHECK(words.failure_to_read() == words.path + ":1: expected an entry with the keys 'type' and 'data'");
}

TEST_CASE("a formula needs its range, and no more coefficients than it has") {
  const File no_range("DATA:\n  - type: formula 5\n    coefficients: 1.5\n");
  CHECK(no_range.failure_to_read() == no_range.path + ":2: the entry has no 'wavelength_range'");
  const File reversed("DATA:\n  - type: formula 5\n    coefficients: 1.5\n    wavelength_range: 0.7 0.3\n");
  CHECK(reversed.failure_to_read() ==
        reversed.path + ":4: '0.7 0.3' is not a range of two increasing wavelengths above 0");
  const File too_many(
      "DATA:\n  - type: formula 8\n    wavelength_range: 0.3 0.7\n    coefficients: 1 2 3 4 5\n");
  CHECK(too_many.failure_to_read() == too_many.path + ":4: formula 8 takes 1 to 4 coefficients, found 5");
}

TEST_CASE("negative k is noise if tiny, else an error where it is asked for") {
  const File file(
      "DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 -1e-5\n        0.5 1.5 0.1\n        0.6 "
      "1.5 -0.1\n");
  const Material stuff = file.read();
  CHECK(stuff.at(400).k == 0);
  CHECK(stuff.at(500).k == 0.1);
  CHECK(failure<std::runtime_error>([&] { stuff.at(600); }) ==
        file.path + ":2: k is -0.1 at 600 nm; it must not be negative");
}

TEST_CASE("n must be positive and finite where it is asked for") {
  const File file("DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 -2\n");
  CHECK(file.read().at(400).n == 1.5);
  CHECK(failure<std::runtime_error>([&] { file.read().at(500); }) ==
        file.path + ":2: n is -2 at 500 nm; it must be above 0 and finite");
  const File imaginary("DATA:\n  - type: formula 3\n    wavelength_range: 0.3 0.7\n    coefficients: -1\n");
  CHECK(failure<std::runtime_error>([&] {
          imaginary.read().at(500);
        }).starts_with(imaginary.path + ":2: n is "));
}

TEST_CASE("a file that cannot be read is reported with the reason") {
  CHECK(failure<std::runtime_error>([] { read_refractiveindex_info("/nowhere/stuff.yml", "stuff"); }) ==
        "/nowhere/stuff.yml: cannot read: No such file or directory");
  const TemporaryFolder folder;
  CHECK(failure<std::runtime_error>([&] { read_refractiveindex_info(folder.path(), "stuff"); }) ==
        folder.path().string() + ": cannot read: it is a folder");
}

}  // namespace
}  // namespace vcavity::tools::testing
