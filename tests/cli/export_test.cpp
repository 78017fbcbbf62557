// SPDX-License-Identifier: BSD-3-Clause
/// Exported BRDFs, read by small readers of the three formats, against what the other commands say.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "cli/json_result.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"

namespace {

const double degree = std::acos(-1.0) / 180;

const std::string rough_metal = "--material 0.2+3i --distribution beckmann --roughness 0.4 ";

/// Angles in degrees as a command takes them; azimuths of files start at +x, those of the program at +y.
std::string in_degrees(double theta, double phi, char separator) {
  std::ostringstream text;
  text.precision(17);
  text << theta / degree << separator << 90 - phi / degree;
  return text.str();
}

double theta_of(const std::vector<double>& e) {
  return std::atan2(std::hypot(e[0], e[1]), e[2]);
}

double phi_of(const std::vector<double>& e) {
  return std::atan2(e[1], e[0]);
}

/// What `direction` says of a pair of vectors.
double brdf(const std::vector<double>& e, const std::vector<double>& o) {
  std::string from = in_degrees(theta_of(e), phi_of(e), ' ');
  return result_of("direction " + rough_metal + "--theta " + from.replace(from.find(' '), 1, " --phi ") +
                   " --toward " + in_degrees(theta_of(o), phi_of(o), ','))["brdf"];
}

std::string exported(const std::string& options, const std::string& name) {
  const ScratchFolder folder;
  const Outcome outcome = run("export " + options + " --out " + name, folder.path());
  CAPTURE(options, name, outcome.err);
  REQUIRE(outcome.status == 0);
  REQUIRE(outcome.out.empty());
  return content(folder / name);
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number;
  REQUIRE(at + sizeof number <= bytes.size());
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// The 145 × 145 numbers between two tags.
std::vector<double> matrix_of(const std::string& xml) {
  const std::string open = "<ScatteringData>";
  const std::size_t first = xml.find(open) + open.size(), last = xml.find("</ScatteringData>");
  REQUIRE(last != xml.npos);
  std::istringstream text(xml.substr(first, last - first));
  std::vector<double> numbers;
  for (std::string word; std::getline(text, word, ',');) numbers.push_back(std::stod(word));
  return numbers;
}

/// Projected solid angles of the patches of Klems' full basis.
std::vector<double> solid_angles() {
  std::vector<double> result;
  const double bounds_deg[] = {0, 5, 15, 25, 35, 45, 55, 65, 75, 90};
  const int patches[] = {1, 8, 16, 20, 24, 24, 24, 16, 12};
  for (int ring = 0; ring < 9; ++ring)
    for (int patch = 0; patch < patches[ring]; ++patch)
      result.push_back((std::pow(std::sin(bounds_deg[ring + 1] * degree), 2) -
                        std::pow(std::sin(bounds_deg[ring] * degree), 2)) *
                       std::acos(-1.0) / patches[ring]);
  return result;
}

/// The tables of a file of Mitsuba's `measured`, floats only.
std::map<std::string, std::vector<float>> tables_of(const std::string& bytes) {
  REQUIRE(bytes.substr(0, 12) == std::string("tensor_file\0", 12));
  std::map<std::string, std::vector<float>> tables;
  const auto count = number_at<std::uint32_t>(bytes, 14);
  std::size_t at = 18;
  for (std::uint32_t table = 0; table < count; ++table) {
    const auto letters = number_at<std::uint16_t>(bytes, at);
    const std::string name = bytes.substr(at + 2, letters);
    at += 2u + letters;
    const auto dimensions = number_at<std::uint16_t>(bytes, at);
    const auto type = number_at<std::uint8_t>(bytes, at + 2);
    const auto offset = number_at<std::uint64_t>(bytes, at + 3);
    at += 11;
    std::size_t size = 1;
    for (int i = 0; i < dimensions; ++i, at += 8) size *= number_at<std::uint64_t>(bytes, at);
    constexpr int floats = 10;
    if (type != floats) continue;
    for (std::size_t i = 0; i < size; ++i)
      tables[name].push_back(number_at<float>(bytes, offset + sizeof(float) * i));
  }
  return tables;
}

}  // namespace

TEST_CASE("patches of a matte plane have one BRDF") {
  const auto matrix = matrix_of(exported("--finish matte --albedo 0.5 --aperture 180", "plane.xml"));
  REQUIRE(matrix.size() == 145 * 145);
  for (const double value : matrix) CHECK(value == Approx(0.5 / std::acos(-1.0)).epsilon(1e-5));
}

TEST_CASE("patches of rough metal reflect what it reflects, and as much backwards") {
  const auto matrix = matrix_of(exported(rough_metal, "metal.xml"));
  const auto omega = solid_angles();
  REQUIRE(matrix.size() == omega.size() * omega.size());
  // The patch around the normal: the mean of two directions, each of half of its projected solid angle.
  double reflected = 0, expected = 0;
  for (std::size_t row = 0; row < omega.size(); ++row) reflected += omega[row] * matrix[row * omega.size()];
  for (const double share : {0.25, 0.75}) {
    const double theta = std::asin(std::sqrt(share) * std::sin(5 * degree));
    expected += result_of("direction " + rough_metal + "--theta " + std::to_string(theta / degree) +
                          " --phi 0")["reflectance"]
                    .get<double>() /
                2;
  }
  CHECK(reflected == Approx(expected).epsilon(2e-5));  // the file has six digits
  // Between rings of 20 and 60 degrees, at right angles, there is no peak: reciprocal but for the points of a patch.
  const std::size_t at_20 = 9, at_60 = 9 + 16 + 20 + 24 + 24 + 6;
  CHECK(matrix[at_60 * 145 + at_20] == Approx(matrix[at_20 * 145 + at_60]).epsilon(0.02));
}

TEST_CASE("a file for `measured` has BRDF times cosine at its nodes") {
  auto tables = tables_of(exported(rough_metal + "--wavelength 500,600", "metal.bsdf"));
  CHECK(tables.at("wavelengths") == std::vector<float>{500, 600});
  constexpr std::size_t nodes = 64;
  const std::size_t incidence = 20, row = 40, column = 30;
  REQUIRE(tables.at("spectra").size() == tables.at("theta_i").size() * 2 * nodes * nodes);
  const double theta_i = tables.at("theta_i")[incidence];
  CHECK(theta_i == Approx(89.5 * 20 / 45 * degree));
  const double theta_m = std::pow(column / (nodes - 1.0), 2) * 90 * degree;
  const double phi_m = (2.0 * row / (nodes - 1.0) - 1) * 180 * degree;
  const std::vector<double> e{std::sin(theta_i), 0, std::cos(theta_i)};
  const std::vector<double> m{std::sin(theta_m) * std::cos(phi_m), std::sin(theta_m) * std::sin(phi_m),
                              std::cos(theta_m)};
  const double twice = 2 * (e[0] * m[0] + e[2] * m[2]);
  const std::vector<double> o{twice * m[0] - e[0], twice * m[1], twice * m[2] - e[2]};
  REQUIRE(o[2] > 0.1);
  const double value = tables.at("spectra")[((incidence * 2 + 1) * nodes + row) * nodes + column];
  CHECK(value == Approx(brdf(e, o) * o[2]).epsilon(1e-6));
}

TEST_CASE("a file of the MERL database has the BRDF at the centres of its cells, in its units") {
  const std::string bytes = exported(rough_metal, "metal.binary");
  REQUIRE(bytes.size() == 12 + sizeof(double) * 3 * 90 * 90 * 180);
  CHECK(number_at<std::int32_t>(bytes, 0) == 90);
  CHECK(number_at<std::int32_t>(bytes, 8) == 180);
  const double theta_h = std::pow(30.5 / 90, 2) * 90 * degree, theta_d = 40.5 * degree, phi_d = 70.5 * degree;
  const double d[] = {std::sin(theta_d) * std::cos(phi_d), std::sin(theta_d) * std::sin(phi_d),
                      std::cos(theta_d)};
  const std::vector<double> e{std::cos(theta_h) * d[0] + std::sin(theta_h) * d[2], d[1],
                              std::cos(theta_h) * d[2] - std::sin(theta_h) * d[0]};
  const double twice = 2 * (e[0] * std::sin(theta_h) + e[2] * std::cos(theta_h));
  const std::vector<double> o{twice * std::sin(theta_h) - e[0], -e[1], twice * std::cos(theta_h) - e[2]};
  const std::size_t cell = (30 * 90 + 40) * 180 + 70, cells = 90 * 90 * 180;
  const double expected = brdf(e, o);
  const double units[] = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
  for (std::size_t colour = 0; colour < 3; ++colour)
    CHECK(number_at<double>(bytes, 12 + sizeof(double) * (colour * cells + cell)) * units[colour] ==
          Approx(expected).epsilon(1e-10));
}

TEST_CASE("what a format cannot hold is refused, and nothing is written") {
  const std::pair<std::string, std::string> refusals[] = {
      {"--material Ag --aperture 60 --out a.xml",
       "export: a mirror has no BRDF, expected a rough or a matte surface"},
      {rough_metal + "--out a.txt",
       "export writes .xml (Radiance), .bsdf (Mitsuba) and .binary (MERL), not 'a.txt'"},
      {rough_metal + "--wavelength 500,600 --out a.xml",
       "export: BSDF XML is written at one wavelength; take one value of --wavelength"},
      {rough_metal + "--wavelength 500,600 --out a.binary",
       "export: a MERL file has three colours; give one wavelength, or those of blue, green and red"},
      {"--finish matte --albedo 0.5 --aperture 60 --out a.bsdf",
       "export: this format is for isotropic surfaces: ggx or beckmann with one roughness; write .xml "
       "instead"}};
  for (const auto& [options, text] : refusals) {
    CAPTURE(options);
    const ScratchFolder folder;
    const Outcome outcome = run("export " + options, folder.path());
    CHECK(outcome.status == 2);
    CHECK(outcome.err == "vcavity_maps: " + text + "\n");
    CHECK(folder.names().empty());
  }
}
