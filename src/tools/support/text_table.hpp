// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tables as people and programs read them: Markdown and CSV.

#include <string>
#include <string_view>
#include <vector>

namespace vcavity::tools {

/// Rows of text under a heading.
struct TextTable {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;
};

/// A Markdown table, its columns aligned in the source.
std::string to_markdown(const TextTable& table);

/// Comma-separated values with the heading first and `#` lines of provenance before it; RFC 4180 quoting.
/// @param provenance one line each
std::string to_csv(const TextTable& table, const std::vector<std::string>& provenance);

/// Words with a separator between each two.
std::string joined(const std::vector<std::string>& words, std::string_view separator);

/// A number with the given count of significant digits, trailing zeros included.
std::string with_digits(double value, int significant_digits);

/// A number with the given count of decimals.
std::string with_decimals(double value, int decimals);

/// The shortest text that reads back as exactly this number, at most 17 digits.
std::string exact(double value);

}  // namespace vcavity::tools
