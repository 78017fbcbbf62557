// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Small text files of numbers, and errors that say at which line they went wrong.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vcavity::tools {

/// The content of a file, without the byte order mark that some programs put first. Throws std::runtime_error
/// "FILE: cannot read: reason".
std::string read_text(const std::filesystem::path& file);

/// The error "FILE:LINE: reason" for the content of a file, to be thrown. Lines are counted from 1.
std::runtime_error malformed(const std::filesystem::path& file, int line, std::string_view reason);

/// The words of a line; they are separated by white space, commas or both.
std::vector<std::string_view> split_words(std::string_view line);

/// The text in lower-case letters (ASCII; others are kept).
std::string lower_case(std::string_view text);

/// A finite decimal number such as 1.5, +2 or 1e-3 that makes up the whole word; nothing otherwise.
std::optional<double> parse_number(std::string_view word);

/// The numbers of a line. Throws malformed() where a word is not a finite number.
std::vector<double> parse_numbers(std::string_view line, const std::filesystem::path& file, int line_number);

/// A row of a table and the line it stands on.
struct NumberRow {
  int line;
  std::vector<double> values;
};

/// A table of numbers. Empty lines and everything after '#' are skipped.
/// @param text the table
/// @param columns how many numbers every row must have
/// @param file where the text is from, for errors
/// @param first_line line of the file on which the text starts
/// Throws malformed() where a row is not made of `columns` finite numbers.
std::vector<NumberRow> parse_rows(std::string_view text, std::size_t columns,
                                  const std::filesystem::path& file, int first_line = 1);

}  // namespace vcavity::tools
