// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/albedo.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/colour/srgb_spectrum.hpp"
#include "tools/support/error.hpp"
#include "tools/support/linear_table.hpp"
#include "tools/support/spreadsheet.hpp"
#include "tools/support/text_file.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

using Spectrum = std::function<double(double)>;

constexpr const char* albedo_option = "--albedo";

/// The components of `#rrggbb`, 0 to 255; nothing for other words.
std::optional<std::array<int, 3>> components_of(const std::string& word) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::string plain = lower_case(word);
  if (plain.size() != 7 || plain[0] != '#' || plain.find_first_not_of(digits, 1) != plain.npos)
    return std::nullopt;
  std::array<int, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<int>(16 * digits.find(plain[2 * i + 1]) + digits.find(plain[2 * i + 2]));
  return result;
}

bool is_file(const std::string& word) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(word, ignored);
}

UsageError unknown(const std::string& word, const std::string& option) {
  return UsageError(
      option + ": '" + word + "' is not accepted, expected a number from 0 to 1, a colour such as #b87333, " +
      (option == albedo_option ? "a CSV file with wavelength_nm,reflectance, or two of them as ONE/TWO"
                               : "or a CSV file with wavelength_nm,reflectance"));
}

Spectrum spectrum_of_colour(const std::string& word, const std::array<int, 3>& components,
                            const std::string& option) {
  const auto linear = [&](std::size_t i) { return decode_srgb(components[i] / 255.0); };
  const auto spectrum = std::make_shared<const SrgbSpectrum>(LinearRgb{linear(0), linear(1), linear(2)});
  return [spectrum, word, option](double wavelength_nm) {
    constexpr double first_nm = 360, last_nm = 780;
    if (!(wavelength_nm >= first_nm && wavelength_nm <= last_nm))
      throw UsageError(option + ": the colour " + word + " says nothing of " + exact(wavelength_nm) +
                       " nm, expected a visible wavelength, 360 to 780 nm");
    return spectrum->at(wavelength_nm);
  };
}

/// What a heading says of the numbers below it.
struct Columns {
  double nm_per_unit;
  double whole;  ///< what stands for all light: 1 or, of percentages, 100
};

Columns columns_of(const CellRow& heading, const std::filesystem::path& file) {
  const auto units = units_per_um(heading.cells.front());
  if (heading.cells.size() == 2 && units) {
    constexpr std::array<std::string_view, 4> names{"reflectance", "reflectivity", "albedo", "r"};
    constexpr std::array<std::string_view, 3> others{"percent", "pct", "factor"};
    const std::vector<std::string> words = heading_words(heading.cells[1]);
    const auto is_among = [](const auto& list, const std::string& word) {
      return std::find(list.begin(), list.end(), word) != list.end();
    };
    const auto named = [&](const std::string& word) { return is_among(names, word); };
    const auto known = [&](const std::string& word) { return named(word) || is_among(others, word); };
    const bool percent = heading.cells[1].find('%') != std::string::npos ||
                         std::any_of(words.begin(), words.end(), [](const std::string& word) {
                           return word == "percent" || word == "pct";
                         });
    if (std::any_of(words.begin(), words.end(), named) && std::all_of(words.begin(), words.end(), known))
      return {1000 / *units, percent ? 100.0 : 1.0};
  }
  std::string words;
  for (const std::string& cell : heading.cells)
    words.append(words.empty() ? "" : ",").append(lower_case(cell));
  throw malformed(file, heading.line, "the heading is '" + words + "', expected wavelength_nm,reflectance");
}

/// A number of a row, beyond doubt.
double number_of(const std::string& cell, const CellRow& row, const std::filesystem::path& file) {
  const auto number = cell_number(cell);
  if (!number || has_doubtful_comma(cell))
    throw malformed(file, row.line, "'" + cell + "' is not a finite number");
  return *number;
}

Spectrum spectrum_of_file(const std::filesystem::path& file, const std::string& option) {
  std::optional<Columns> columns;
  std::vector<LinearTable::Sample> samples;
  int last_line = 1;
  for (const CellRow& row : read_spreadsheet(file)) {
    if (row.comment) continue;
    last_line = row.line;
    if (!columns) {
      columns = columns_of(row, file);
      continue;
    }
    if (row.cells.size() != 2)
      throw malformed(file, row.line, "expected 2 numbers, found " + std::to_string(row.cells.size()));
    const double wavelength = number_of(row.cells[0], row, file), share = number_of(row.cells[1], row, file);
    if (!(wavelength > 0))
      throw malformed(file, row.line, "wavelength " + exact(wavelength) + ", expected more than 0");
    if (!(share >= 0 && share <= columns->whole))
      throw malformed(file, row.line,
                      "reflectance " + exact(share) + ", expected 0 to " + exact(columns->whole));
    samples.push_back({wavelength * columns->nm_per_unit, share / columns->whole});
  }
  if (samples.empty()) throw malformed(file, last_line, "the table is empty");
  const auto table = std::make_shared<const LinearTable>(std::move(samples));
  return [table, file, option](double wavelength_nm) {
    if (!(wavelength_nm >= table->min_x() && wavelength_nm <= table->max_x()))
      throw UsageError(option + ": '" + file.string() + "' has no data at " + exact(wavelength_nm) +
                       " nm, expected " + exact(table->min_x()) + " to " + exact(table->max_x()) + " nm");
    return table->at(wavelength_nm);
  };
}

bool is_albedo(const std::string& word) {
  return parse_number(word) || components_of(word) || is_file(word);
}

}  // namespace

Albedo::Albedo(const std::string& specification, const std::string& option) : name_(specification) {
  if (const std::optional<double> number = parse_number(specification)) {
    if (!(*number >= 0 && *number <= 1)) throw unknown(specification, option);
    source_ = "albedo " + specification;
    at_ = [value = *number](double) { return value; };
  } else if (const auto components = components_of(specification)) {
    source_ = "albedo " + specification + ", sRGB, with the smooth spectrum of Jakob and Hanika (2019)";
    at_ = spectrum_of_colour(specification, *components, option);
  } else if (is_file(specification)) {
    const std::filesystem::path file(specification);
    name_ = file.stem().string();
    source_ = "albedo from " + file.filename().string();
    at_ = spectrum_of_file(file, option);
  } else {
    throw unknown(specification, option);
  }
}

PanelAlbedos load_albedos(std::string_view specification) {
  const std::string words(specification);
  if (!is_albedo(words)) {
    // Paths have slashes too: the one that parts two albedos is the one with an albedo on either side.
    for (auto slash = words.find('/'); slash != words.npos; slash = words.find('/', slash + 1)) {
      const std::string one = words.substr(0, slash), two = words.substr(slash + 1);
      if (is_albedo(one) && is_albedo(two))
        return {Albedo(one, albedo_option), Albedo(two, albedo_option), true};
    }
  }
  const Albedo both(words, albedo_option);
  return {both, both, false};
}

}  // namespace vcavity::tools
