// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/text_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace vcavity::tools {
namespace {

// Letters, not bytes: continuation bytes of UTF-8 take no room.
std::size_t display_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == text.npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

template <class... Format>
std::string converted(double value, Format... format) {
  std::array<char, 400> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...).ptr;
  return {buffer.data(), end};
}

}  // namespace

std::string to_markdown(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const auto& cell : table.heading) widths.push_back(std::max<std::size_t>(3, display_width(cell)));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));

  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text.append("| ").append(row[i]).append(widths[i] - display_width(row[i]) + 1, ' ');
    text += "|\n";
  };
  add(table.heading);
  for (const std::size_t width : widths) text.append("|").append(width + 2, '-');
  text += "|\n";
  for (const auto& row : table.rows) add(row);
  return text;
}

std::string to_csv(const TextTable& table, const std::vector<std::string>& provenance) {
  std::string text;
  for (const auto& line : provenance) text.append("# ").append(line).append("\n");
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) text.append(i == 0 ? "" : ",").append(quoted(row[i]));
    text += "\n";
  };
  add(table.heading);
  for (const auto& row : table.rows) add(row);
  return text;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : separator).append(word);
  return text;
}

std::string with_digits(double value, int significant_digits) {
  return converted(value, std::chars_format::general, significant_digits);
}

std::string with_decimals(double value, int decimals) {
  return converted(value, std::chars_format::fixed, decimals);
}

std::string exact(double value) {
  return converted(value);
}

}  // namespace vcavity::tools
