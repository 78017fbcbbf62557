// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/spreadsheet.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "tools/support/text_file.hpp"
#include "tools/support/utf8.hpp"

namespace vcavity::tools {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// The first separator of cells that a line has outside of quotes; a blank for white space.
char separator_of(std::string_view line) {
  for (const char separator : {'\t', ';', ','}) {
    bool quoted = false;
    for (const char letter : line) {
      if (letter == '"') quoted = !quoted;
      if (letter == separator && !quoted) return separator;
    }
  }
  return ' ';
}

/// Cells between white space. A unit in brackets belongs to the word before it.
std::vector<std::string> words_as_cells(std::string_view line) {
  std::vector<std::string> cells;
  while (!(line = trimmed(line)).empty()) {
    const auto end = std::min(line.find_first_of(blanks), line.size());
    const std::string word(line.substr(0, end));
    if (!cells.empty() && (word.front() == '(' || word.front() == '['))
      cells.back() += word;
    else
      cells.push_back(word);
    line.remove_prefix(end);
  }
  for (std::string& cell : cells)
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
  return cells;
}

std::vector<std::string> cells_of(std::string_view line) {
  const char separator = separator_of(line);
  if (separator == ' ') return words_as_cells(line);
  std::vector<std::string> cells;
  std::string cell;
  bool quoted = false;
  const auto end_cell = [&] { cells.emplace_back(trimmed(std::exchange(cell, {}))); };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      cell += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == separator && !quoted)
      end_cell();
    else
      cell += line[i];
  }
  end_cell();
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

/// The next line of a text, which is removed from it with its end: LF, CRLF or CR.
std::string_view next_line(std::string_view& text) {
  const auto end = std::min(text.find_first_of("\r\n"), text.size());
  const auto line = text.substr(0, end);
  text.remove_prefix(end);
  if (text.starts_with("\r\n"))
    text.remove_prefix(2);
  else if (!text.empty())
    text.remove_prefix(1);
  return line;
}

template <std::size_t Size>
bool is_one_of(const std::array<std::string_view, Size>& known, std::string_view word) {
  return std::find(known.begin(), known.end(), word) != known.end();
}

/// How many of the unit that a word names make a micrometre; nothing for other words.
std::optional<double> unit_of(std::string_view word) {
  using Names = std::array<std::string_view, 8>;
  static const std::array<std::pair<double, Names>, 6> units{{
      {1e3, {"nm", "nanometer", "nanometers", "nanometre", "nanometres"}},
      // The micro sign, the Greek letter and what stands for them.
      {1, {"um", "\u00b5m", "\u03bcm", "micron", "microns", "micrometer", "micrometers", "micrometre"}},
      {1, {"micrometres", "mum"}},
      // The letter, small and capital, and the sign.
      {1e4,
       {"\u00e5", "\u00c5", "\u212b", "angstrom", "angstroms", "\u00e5ngstr\u00f6m", "\u00c5ngstr\u00f6m"}},
      {1e-3, {"mm", "millimeter", "millimeters", "millimetre", "millimetres"}},
      {1e-6, {"m", "meter", "meters", "metre", "metres"}},
  }};
  for (const auto& [count, names] : units)
    if (!word.empty() && is_one_of(names, word)) return count;
  return std::nullopt;
}

}  // namespace

std::vector<CellRow> read_spreadsheet(const std::filesystem::path& file) {
  std::string text = read_text(file);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw malformed(file, 1, "the text is UTF-16, expected UTF-8; 'iconv -f utf-16 -t utf-8' converts it");
  if (const auto zero = text.find('\0'); zero != text.npos)
    throw malformed(file,
                    1 + static_cast<int>(
                            std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n')),
                    "this is no text");
  if (first_not_utf8(text)) text = utf8_of_latin1(text);

  std::vector<CellRow> rows;
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::string_view line = trimmed(next_line(rest));
    const bool comment = line.starts_with('#');
    std::vector<std::string> cells =
        cells_of(comment ? trimmed(line.substr(1)) : trimmed(line.substr(0, line.find('#'))));
    if (!cells.empty()) rows.push_back({number, std::move(cells), comment});
  }
  return rows;
}

std::optional<double> cell_number(const std::string& cell) {
  const auto comma = cell.find(',');
  if (comma == cell.npos) return parse_number(cell);
  if (cell.find('.') != cell.npos || cell.find(',', comma + 1) != cell.npos) return std::nullopt;
  std::string with_point = cell;
  with_point[comma] = '.';
  return parse_number(with_point);
}

bool has_doubtful_comma(const std::string& cell) {
  const auto is_digit = [](char letter) { return '0' <= letter && letter <= '9'; };
  const auto comma = cell.find(',');
  if (comma == cell.npos || comma == 0 || comma > 3 || cell.front() == '0' || cell.size() != comma + 4)
    return false;
  return std::all_of(cell.begin(), cell.end(),
                     [&](char letter) { return letter == ',' || is_digit(letter); });
}

std::vector<std::string> heading_words(const std::string& heading) {
  std::vector<std::string> words(1);
  for (const char letter : lower_case(heading)) {
    const bool in_word = ('a' <= letter && letter <= 'z') || static_cast<unsigned char>(letter) >= 0x80;
    if (in_word)
      words.back() += letter;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::optional<double> units_per_um(const std::string& heading) {
  constexpr std::array<std::string_view, 8> names{"wavelength", "wavelengths", "lambda", "\u03bb",
                                                  "\u039b",     "wl",          "wvl",    "wellenl\u00e4nge"};
  constexpr std::array<std::string_view, 10> others{"ev",          "kev", "energy", "photon", "wavenumber",
                                                    "wavenumbers", "thz", "ghz",    "hz",     "frequency"};
  const std::vector<std::string> words = heading_words(heading);
  if (words.size() == 1 && words.front() == "wl") return 1;
  std::optional<double> unit;
  bool named = words.size() == 1;
  for (const std::string& word : words) {
    if (is_one_of(others, word)) return std::nullopt;
    if (is_one_of(names, word)) named = true;
    if (const auto found = unit_of(word)) {
      if (unit && *unit != *found) return std::nullopt;
      unit = found;
    }
  }
  return named ? unit : std::nullopt;
}

}  // namespace vcavity::tools
