// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

namespace vcavity::tools {

std::string read_text(const std::filesystem::path& file) {
  const auto fail = [&file](const std::string& reason) {
    return std::runtime_error(file.string() + ": cannot read: " + reason);
  };
  if (std::filesystem::is_directory(file)) throw fail("it is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw fail(std::generic_category().message(errno));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw fail(std::generic_category().message(errno));
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

std::runtime_error malformed(const std::filesystem::path& file, int line, std::string_view reason) {
  return std::runtime_error(file.string() + ":" + std::to_string(line) + ": " + std::string(reason));
}

std::vector<std::string_view> split_words(std::string_view line) {
  constexpr std::string_view separators = " \t\r\n,";
  std::vector<std::string_view> words;
  for (auto begin = line.find_first_not_of(separators); begin != line.npos;) {
    const auto end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if ('A' <= letter && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

std::optional<double> parse_number(std::string_view word) {
  // from_chars, unlike the functions of the C library, does not depend on the user's locale. It refuses a
  // plus sign.
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<double> parse_numbers(std::string_view line, const std::filesystem::path& file, int line_number) {
  std::vector<double> numbers;
  for (const std::string_view word : split_words(line)) {
    const auto number = parse_number(word);
    if (!number) throw malformed(file, line_number, "'" + std::string(word) + "' is not a finite number");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<NumberRow> parse_rows(std::string_view text, std::size_t columns,
                                  const std::filesystem::path& file, int first_line) {
  std::vector<NumberRow> rows;
  for (int line_number = first_line; !text.empty(); ++line_number) {
    const auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    auto values = parse_numbers(line.substr(0, line.find('#')), file, line_number);
    if (values.empty()) continue;
    if (values.size() != columns) {
      throw malformed(
          file, line_number,
          "expected " + std::to_string(columns) + " numbers, found " + std::to_string(values.size()));
    }
    rows.push_back({line_number, std::move(values)});
  }
  return rows;
}

}  // namespace vcavity::tools
