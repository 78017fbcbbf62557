// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/nk_csv.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/materials/tabulated.hpp"

namespace vcavity::tools {
namespace {

/// What the columns hold, read off the heading.
struct Heading {
  WavelengthUnit unit;
  std::optional<std::size_t> n;
  std::optional<std::size_t> k;
  std::size_t columns;
};

/// The headings between the commas, in lower case and without blanks and brackets.
std::vector<std::string> plain_headings(std::string_view line) {
  std::vector<std::string> headings(1);
  for (const char letter : lower_case(line)) {
    if (letter == ',') {
      headings.emplace_back();
    } else if (std::string_view(" \t\r()[]").find(letter) == std::string_view::npos) {
      headings.back() += letter;
    }
  }
  return headings;
}

std::optional<WavelengthUnit> unit_of(const std::string& heading) {
  if (heading.ends_with("nm")) return WavelengthUnit::nm;
  // "um" is also written with the micro sign or with the Greek letter.
  for (const char* unit : {"um", "\u00b5m", "\u03bcm"}) {
    if (heading.ends_with(unit)) return WavelengthUnit::um;
  }
  return heading == "wl" ? std::optional(WavelengthUnit::um) : std::nullopt;
}

Heading parse_heading(std::string_view line, const std::filesystem::path& file, int line_number) {
  const auto headings = plain_headings(line);
  const auto unit = unit_of(headings[0]);
  if (!unit) {
    throw malformed(
        file, line_number,
        "the first line with content must be a heading that names the unit, such as wavelength_nm,n,k or "
        "wavelength_um,n,k");
  }
  Heading heading{*unit, {}, {}, headings.size()};
  for (std::size_t column = 1; column < headings.size(); ++column) {
    auto& constant = headings[column] == "k" ? heading.k : heading.n;
    if ((headings[column] != "n" && headings[column] != "k") || constant) {
      throw malformed(file, line_number, "column '" + headings[column] + "': expected n and k, each once");
    }
    constant = column;
  }
  if (!heading.n) throw malformed(file, line_number, "there is no column n");
  return heading;
}

}  // namespace

Material read_nk_csv(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  std::string_view rest = text;
  for (int line_number = 1; !rest.empty(); ++line_number) {
    const auto line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const auto content = line.substr(0, line.find('#'));
    if (split_words(content).empty()) continue;

    const Heading heading = parse_heading(content, file, line_number);
    const auto rows = parse_rows(rest, heading.columns, file, line_number + 1);
    if (rows.empty()) throw malformed(file, line_number, "the table is empty");
    const auto constant = [&](std::size_t column) {
      return tabulated(rows, column, heading.unit, file, rows.front().line);
    };
    return Material({.name = file.stem().string(),
                     .file = file,
                     .reference = file.filename().string(),
                     .comments = {},
                     .n = constant(*heading.n),
                     .k = heading.k ? std::optional(constant(*heading.k)) : std::nullopt});
  }
  throw malformed(file, 1, "the file is empty");
}

}  // namespace vcavity::tools
