// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/albedo.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "tools/colour/srgb_spectrum.hpp"
#include "tools/support/error.hpp"
#include "tools/support/linear_table.hpp"
#include "tools/support/text_file.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

using Spectrum = std::function<double(double)>;

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

UsageError unknown(const std::string& word) {
  return UsageError(
      "--albedo: '" + word +
      "' is not accepted, expected a number from 0 to 1, a colour such as #b87333, a CSV file with "
      "wavelength_nm,reflectance, or two of them as ONE/TWO");
}

Spectrum spectrum_of_colour(const std::string& word, const std::array<int, 3>& components) {
  const auto linear = [&](std::size_t i) { return decode_srgb(components[i] / 255.0); };
  const auto spectrum = std::make_shared<const SrgbSpectrum>(LinearRgb{linear(0), linear(1), linear(2)});
  return [spectrum, word](double wavelength_nm) {
    constexpr double first_nm = 360, last_nm = 780;
    if (!(wavelength_nm >= first_nm && wavelength_nm <= last_nm))
      throw UsageError("--albedo: the colour " + word + " says nothing of " + exact(wavelength_nm) +
                       " nm, expected a visible wavelength, 360 to 780 nm");
    return spectrum->at(wavelength_nm);
  };
}

Spectrum spectrum_of_file(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  // The heading is the first line with content.
  int line = 1;
  std::string_view rest = text;
  std::string heading;
  while (!rest.empty() && heading.empty()) {
    const std::string_view content = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(content.size() + 1, rest.size()));
    for (const std::string_view word : split_words(content.substr(0, content.find('#'))))
      heading.append(heading.empty() ? "" : ",").append(lower_case(word));
    ++line;
  }
  if (heading != "wavelength_nm,reflectance")
    throw malformed(file, line - 1, "the heading is '" + heading + "', expected wavelength_nm,reflectance");
  std::vector<LinearTable::Sample> samples;
  for (const auto& [row, values] : parse_rows(rest, 2, file, line)) {
    if (!(values[0] > 0))
      throw malformed(file, row, "wavelength " + exact(values[0]) + ", expected more than 0");
    if (!(values[1] >= 0 && values[1] <= 1))
      throw malformed(file, row, "reflectance " + exact(values[1]) + ", expected 0 to 1");
    samples.push_back({values[0], values[1]});
  }
  if (samples.empty()) throw malformed(file, line - 1, "the table is empty");
  const auto table = std::make_shared<const LinearTable>(std::move(samples));
  return [table, file](double wavelength_nm) {
    if (!(wavelength_nm >= table->min_x() && wavelength_nm <= table->max_x()))
      throw UsageError("--albedo: '" + file.string() + "' has no data at " + exact(wavelength_nm) +
                       " nm, expected " + exact(table->min_x()) + " to " + exact(table->max_x()) + " nm");
    return table->at(wavelength_nm);
  };
}

bool is_albedo(const std::string& word) {
  return parse_number(word) || components_of(word) || is_file(word);
}

}  // namespace

Albedo::Albedo(const std::string& specification) : name_(specification) {
  if (const std::optional<double> number = parse_number(specification)) {
    if (!(*number >= 0 && *number <= 1)) throw unknown(specification);
    source_ = "albedo " + specification;
    at_ = [value = *number](double) { return value; };
  } else if (const auto components = components_of(specification)) {
    source_ = "albedo " + specification + ", sRGB, with the smooth spectrum of Jakob and Hanika (2019)";
    at_ = spectrum_of_colour(specification, *components);
  } else if (is_file(specification)) {
    const std::filesystem::path file(specification);
    name_ = file.stem().string();
    source_ = "albedo from " + file.filename().string();
    at_ = spectrum_of_file(file);
  } else {
    throw unknown(specification);
  }
}

PanelAlbedos load_albedos(std::string_view specification) {
  const std::string words(specification);
  if (!is_albedo(words)) {
    // Paths have slashes too: the one that parts two albedos is the one with an albedo on either side.
    for (auto slash = words.find('/'); slash != words.npos; slash = words.find('/', slash + 1)) {
      const std::string one = words.substr(0, slash), two = words.substr(slash + 1);
      if (is_albedo(one) && is_albedo(two)) return {Albedo(one), Albedo(two), true};
    }
  }
  const Albedo both(words);
  return {both, both, false};
}

}  // namespace vcavity::tools
