// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "tools/materials/refractiveindex_info.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_file.hpp"

namespace vcavity::tools::testing {
namespace {

namespace fs = std::filesystem;

/// An index that another reader found in a file.
struct Reading {
  double wavelength_nm;
  RefractiveIndex index;  ///< NaN where that reader has no value
};

/// The readings printed by scripts/reference_indices.py, by file; file names may hold blanks and commas.
std::map<std::string, std::vector<Reading>> read_readings(const fs::path& table) {
  std::map<std::string, std::vector<Reading>> readings;
  std::ifstream stream(table);
  REQUIRE(stream);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string wavelength_nm, n, k, file;
    std::getline(words, wavelength_nm, ',');
    std::getline(words, n, ',');
    std::getline(words, k, ',');
    std::getline(words, file);
    readings[file].push_back({std::stod(wavelength_nm), {std::stod(n), std::stod(k)}});
  }
  return readings;
}

/// "k is # at # nm; ..." for "FILE:12: k is -0.1 at 600 nm; ...": the same for all errors of a kind.
std::string kind_of(const std::exception& error, const fs::path& file) {
  std::string_view reason(error.what());
  reason.remove_prefix(std::min(reason.size(), file.string().size() + 1));  // FILE:
  reason.remove_prefix(std::min(reason.size(), reason.find(": ") + 2));     // LINE:
  std::string kind;
  for (const std::string_view word : split_words(reason)) {
    if (!kind.empty()) kind += ' ';
    kind += parse_number(word) ? "#" : word;
  }
  return kind;
}

/// Whether two readings are the same. Wavelengths are rounded on their way through nanometres, which shows
/// where k falls to 0.
bool agree(double a, double b) {
  return std::abs(a - b) <= 1e-12 + 1e-9 * std::abs(b);
}

/// Whether a table gives different values at the same wavelength. The other reader jumps from one to the
/// other there, this one takes their mean.
bool repeats_wavelength(const fs::path& file) {
  std::ifstream stream(file);
  std::map<double, std::string> rows;
  for (std::string line; std::getline(stream, line);) {
    const auto words = split_words(line);
    const auto wavelength = words.empty() ? std::nullopt : parse_number(words[0]);
    if (!wavelength) {
      rows.clear();
    } else if (rows.emplace(*wavelength, line).first->second != line) {
      return true;
    }
  }
  return false;
}

/// The outcome for all files.
struct Report {
  int files = 0;
  int values = 0;
  int beside_repeated_wavelength = 0;
  std::map<std::string, int> files_refused;
  std::map<std::string, int> points_refused;
  std::vector<std::string> disagreements;

  void print(std::ostream& out) const {
    out << files << " files, " << values << " values compared, " << beside_repeated_wavelength
        << " of them differ in tables that give a wavelength twice\n";
    for (const auto& [reason, count] : files_refused) out << count << " files refused: " << reason << '\n';
    for (const auto& [reason, count] : points_refused) out << count << " points refused: " << reason << '\n';
    for (const std::string& disagreement : disagreements) out << "disagreement: " << disagreement << '\n';
  }
};

void compare(const Material& material, const Reading& reading, Report& report) {
  const double wavelength_nm = reading.wavelength_nm;
  const RefractiveIndex& expected = reading.index;
  const auto disagree = [&](const std::string& here) {
    report.disagreements.push_back(material.name() + " at " + std::to_string(wavelength_nm) + " nm: " + here +
                                   ", the other reader has " + std::to_string(expected.n) + " + " +
                                   std::to_string(expected.k) + "i");
  };
  const bool usable = expected.n > 0 && expected.k >= -2e-5;
  try {
    const auto [n, k] = material.at(wavelength_nm);
    ++report.values;
    if (usable && agree(n, expected.n) && agree(k, std::max(expected.k, 0.0))) return;
    if (usable && repeats_wavelength(material.file())) {
      ++report.beside_repeated_wavelength;
    } else {
      disagree(std::to_string(n) + " + " + std::to_string(k) + "i");
    }
  } catch (const UsageError& error) {
    disagree(error.what());
  } catch (const std::runtime_error& error) {
    ++report.points_refused[kind_of(error, material.file())];
    if (usable) disagree(error.what());
  }
}

TEST_CASE("the whole database is read as another reader reads it, or refused with a reason") {
  const fs::path folder = VCAVITY_DATABASE;
  const auto readings = read_readings(VCAVITY_DATABASE_INDICES);
  Report report;
  for (const auto& item : fs::recursive_directory_iterator(folder)) {
    const fs::path& file = item.path();
    if (file.extension() != ".yml" || file.filename() == "about.yml") continue;
    ++report.files;
    const std::string name = fs::relative(file, folder).generic_string();
    const auto found = readings.find(name);
    try {
      const Material material = read_refractiveindex_info(file, name);
      if (found == readings.end()) {
        report.disagreements.push_back(name + " is read here, the other reader refuses it");
      } else {
        for (const Reading& reading : found->second) compare(material, reading, report);
      }
    } catch (const std::runtime_error& error) {
      ++report.files_refused[kind_of(error, file)];
      if (found != readings.end())
        report.disagreements.push_back(std::string("only refused here: ") + error.what());
    }
  }
  report.print(std::cout);
  CHECK(report.values > 10000);
  CHECK(report.disagreements.empty());
}

}  // namespace
}  // namespace vcavity::tools::testing
