// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tables as spreadsheets, instruments and other programs write them: rows of cells as texts.
///
/// Method: cells are separated by tabs, semicolons, commas or white space, the first of these that a line has; they may
/// stand in double quotes; lines end in LF, CRLF or CR. Texts that are not UTF-8 are taken as Latin-1, blank lines are
/// left out, and '#' starts a comment.
/// When not to use it: for files of one known form there is parse_rows().

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vcavity::tools {

/// A line of a table.
struct CellRow {
  int line;                        ///< counted from 1
  std::vector<std::string> cells;  ///< without blanks and quotes around them; the last is not empty
  bool comment;  ///< whether the whole line is a comment; its cells are those behind the '#'
};

/// All lines with content.
/// @throws std::runtime_error "FILE:LINE: reason" for UTF-16 and for files that are no text; "FILE: cannot read: reason"
std::vector<CellRow> read_spreadsheet(const std::filesystem::path& file);

/// The number in a cell, with a point or a comma before its decimals; nothing if there is none.
std::optional<double> cell_number(const std::string& cell);

/// Whether a number in a cell could be read in two ways: "1,550" is 1.55 or, with a comma between thousands, 1550.
bool has_doubtful_comma(const std::string& cell);

/// Lengths of the unit that the heading of a column of wavelengths names in words ("Wavelength (nm)", "lambda [µm]",
/// "wavelength in vacuum, Angstrom", "nm"), as their number in a micrometre; `wl` alone is micrometres, as in the tables
/// of refractiveindex.info. Nothing if it names none or several, or something else than a wavelength.
std::optional<double> units_per_um(const std::string& heading);

/// The words of a heading in lower case: letters between blanks, brackets, digits and punctuation.
std::vector<std::string> heading_words(const std::string& heading);

}  // namespace vcavity::tools
