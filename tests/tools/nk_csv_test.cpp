// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/nk_csv.hpp"

#include <stdexcept>
#include <string>

#include "support/catch.hpp"
#include "tools/failure.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/error.hpp"
#include "tools/temporary_file.hpp"

namespace vcavity::tools::testing {
namespace {

Material read(const std::string& content) {
  const TemporaryFolder folder;
  return load_material(folder.write("mine.csv", content));
}

/// What is wrong with a file: "LINE: reason".
std::string complaint(const std::string& content) {
  const TemporaryFolder folder;
  const std::string file = folder.write("mine.csv", content);
  const std::string text = failure<std::runtime_error>([&] { load_material(file); });
  return text.starts_with(file + ":") ? text.substr(file.size() + 1) : text;
}

TEST_CASE("a table of comma-separated values has a wavelength, n and k") {
  const Material mine = read("# my own copper\nwavelength_nm,n,k\n400,1,3\n600,2,5\n");
  CHECK(mine.name() == "mine");
  CHECK(mine.reference() == "mine.csv");
  CHECK(mine.at(400).n == 1);
  CHECK(mine.at(500).n == Catch::Approx(1.5).epsilon(1e-15));
  CHECK(mine.at(600).k == 5);
  CHECK_THROWS_AS(mine.at(601), UsageError);
}

TEST_CASE("the heading tells the unit") {
  for (const std::string heading :
       {"wavelength_nm", "Wavelength (nm)", "lambda [nm]", "nm", "Wavelength in nanometers",
        "wavelength_nm_vacuum", "Wellenl\u00e4nge / nm", "\u03bb (nm)", "WL(NM)"}) {
    CHECK(read(heading + ",n,k\n400,1,3\n").at(400).n == 1);
  }
  for (const std::string heading : {"wavelength_um", "Wavelength (um)", "lambda [\u00b5m]", "\u03bcm", "wl",
                                    "Wavelength in microns", "wavelength in vacuum [micrometres]"}) {
    CHECK(read(heading + ",n,k\n0.4,1,3\n").at(400).n == 1);
  }
}

TEST_CASE("a heading without unit is refused, and so is a table without heading") {
  const std::string wanted =
      "1: the first line with content must be a heading that names the unit, such as wavelength_nm,n,k or "
      "wavelength_um,n,k";
  for (const std::string heading : {"wavelength", "wavelength vacuum", "column", "energy (eV)", "nm or um",
                                    "wavenumber (cm-1)", "photon energy in nm", "medium"}) {
    CAPTURE(heading);
    CHECK(complaint(heading + ",n,k\n400,1,3\n") == wanted);
  }
  CHECK(complaint("400,1,3\n") == wanted);
}

TEST_CASE("columns may stand in either order, and k may be absent") {
  const Material mine = read("wavelength_nm, K, N\r\n400, 3, 1\r\n");
  CHECK(mine.at(400).n == 1);
  CHECK(mine.at(400).k == 3);
  const Material glass = read("wavelength_nm,n\n400,1.5\n");
  CHECK(glass.at(400).k == 0);
  CHECK_FALSE(glass.extinction_given());
}

TEST_CASE("other columns, repeated ones and a missing n are refused") {
  CHECK(complaint("wavelength_nm,n,k,R\n400,1,3,0.5\n") == "1: column 'r': expected n and k, each once");
  CHECK(complaint("wavelength_nm,n,n\n400,1,3\n") == "1: column 'n': expected n and k, each once");
  CHECK(complaint("wavelength_nm,k,k\n400,1,3\n") == "1: column 'k': expected n and k, each once");
  CHECK(complaint("wavelength_nm,k\n400,1\n") == "1: there is no column n");
}

TEST_CASE("rows may stand in any order and those of the same wavelength are replaced by their mean") {
  const Material mine = read("wavelength_nm,n\n600,3\n400,1\n600,5\n");
  CHECK(mine.at(600).n == 4);
  CHECK(mine.at(500).n == Catch::Approx(2.5).epsilon(1e-15));
}

TEST_CASE("bad rows are reported with their line") {
  CHECK(complaint("wavelength_nm,n,k\n\n400,1,x\n") == "3: 'x' is not a finite number");
  CHECK(complaint("wavelength_nm,n,k\n400,1,3\n500,,3\n") == "3: expected 3 numbers, found 2");
  CHECK(complaint("wavelength_nm,n,k\n400/1/3\n") == "2: '400/1/3' is not a finite number");
  CHECK(complaint("wavelength_nm,n,k\n-400,1,3\n") == "2: the wavelength is not above 0");
  CHECK(complaint("# nothing\nwavelength_nm,n,k\n") == "2: the table is empty");
  CHECK(complaint("") == "1: the file is empty");
}

TEST_CASE("numbers may have a sign and an exponent") {
  CHECK(read("wavelength_nm,n\n+4e2,+1.5\n").at(400).n == 1.5);
}

TEST_CASE("the exports of refractiveindex.info have a block for n and one for k") {
  const Material both = read("wl,n\n0.4,1\n0.6,3\n\nwl,k\n0.45,4\n0.65,6\n");
  CHECK(both.at(500).n == Catch::Approx(2).epsilon(1e-15));
  CHECK(both.at(500).k == Catch::Approx(4.5).epsilon(1e-15));
  CHECK_THROWS_AS(both.at(420), UsageError);  // no k there
  CHECK(read("wl\tk\n0.4\t2\n\nwl\tn\n0.4\t1\n").at(400).k == 2);
  CHECK(complaint("wl,n\n0.4,1\n\nwl,n\n0.4,2\n") == "4: n was already given by the table on line 2");
  CHECK(complaint("wl,n\n\nwl,k\n0.4,2\n") == "1: the table is empty");
  CHECK(complaint("wl,k\n0.4,2\n") == "1: there is no column n");
}

TEST_CASE("cells are separated and quoted as spreadsheets and instruments do") {
  for (const std::string text :
       {"wavelength_nm;n;k\n400;1.25;3\n500;1.5;4\n", "wavelength_nm\tn\tk\n400\t1.25\t3\n500\t1.5\t4\n",
        "wavelength_nm n k\n400 1.25 3\n500   1.5  4\n", "Wavelength (nm)  n  k\n400  1.25  3\n500 1.5 4\n",
        "\"Wavelength (nm)\",\"n\",\"k\"\r\n\"400\",\"1.25\",\"3\"\r\n500,1.5,4\r\n",
        "wavelength_nm,n,k\r400,1.25,3\r500,1.5,4\r",
        "wavelength_nm;n;k;;\n400;1.25;3;;\n;;;;\n500;1.5;4;;\n",
        "wavelength_nm;n;k\n400;1,25;3\n500;1,5;4,0\n",
        "Wavelength (\xb5m)\tn\tk\n0,4\t1,25\t3\n0,5\t1,5\t4\n",
        "# wavelength_nm, n, k\n400, 1.25, 3\n500, 1.5, 4\n",
        "Wavelength [nm],Refractive index,Extinction coefficient\n"
        "400,1.25,3\n500,1.5,4\n",
        "nm,n,kappa\n400,1.25,3\n500,1.5,4\n", "Wavelength (\u212b),n,k\n4000,1.25,3\n5000,1.5,4\n"}) {
    CAPTURE(text);
    const Material mine = read(text);
    CHECK(mine.at(400).n == 1.25);
    CHECK(mine.at(400).k == 3);
    CHECK(mine.at(500).n == 1.5);
    CHECK(mine.at(500).k == 4);
  }
}

TEST_CASE("what could be read in two ways is refused with its line") {
  CHECK(complaint("wavelength_nm,n,k\n400,1,25,3\n") == "2: expected 3 numbers, found 4");
  CHECK(complaint("wavelength_nm;n\n400;1.234,5\n") == "2: '1.234,5' is not a finite number");
  CHECK(complaint("wavelength_nm;n\n1,550;1,5\n1,560;1,5\n") ==
        "2: '1,550' may mean thousands or decimals; write it with a point or without");
  CHECK(read("wavelength_um;n\n0,900;1,5\n1,550;1,5\n").at(1550).n == 1.5);  // no thousands begin with 0
  CHECK(complaint("wavelength_nm;n;k\n400;;3\n") == "2: expected 3 numbers, found 2");
  CHECK(complaint("wavelength_nm,n,k\n400,1,3\nfive hundred,1,3\n") ==
        "3: 'five hundred' is not a finite number");
  CHECK(complaint("wavelength_nm n\n400 1,5\n") == "2: '400 1' is not a finite number");
}

TEST_CASE("what is no text is refused") {
  CHECK(complaint(std::string("\xff\xfew\0l\0", 6)) ==
        "1: the text is UTF-16, expected UTF-8; 'iconv -f utf-16 -t utf-8' converts it");
  CHECK(complaint(std::string("wl,n\n0.4\0,1\n", 12)) == "2: this is no text");
}

TEST_CASE("a byte order mark does no harm") {
  CHECK(read("\xef\xbb\xbfwl,n\n0.4,1.5\n").at(400).n == 1.5);
}

}  // namespace
}  // namespace vcavity::tools::testing
