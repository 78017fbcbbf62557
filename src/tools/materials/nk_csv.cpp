// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/nk_csv.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/materials/tabulated.hpp"
#include "tools/support/spreadsheet.hpp"

namespace vcavity::tools {
namespace {

/// What the columns hold, read off the heading.
struct Heading {
  int line;
  double units_per_um;
  std::optional<std::size_t> n;
  std::optional<std::size_t> k;
  std::size_t columns;
};

/// A heading and the rows below it.
struct Block {
  Heading heading;
  std::vector<NumberRow> rows;
};

bool are_among(const std::vector<std::string>& words, std::initializer_list<std::string_view> known) {
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(known.begin(), known.end(), word) != known.end();
  });
}

bool has_one_of(const std::vector<std::string>& words, std::initializer_list<std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

bool means_n(const std::vector<std::string>& words) {
  return are_among(words, {"n", "refractive", "index", "real", "part", "re"}) &&
         has_one_of(words, {"n", "refractive"});
}

bool means_k(const std::vector<std::string>& words) {
  return are_among(words, {"k", "kappa", "\u03ba", "extinction", "coefficient", "imaginary", "part", "im"}) &&
         has_one_of(words, {"k", "kappa", "\u03ba", "extinction"});
}

Heading parse_heading(const CellRow& row, const std::filesystem::path& file) {
  const auto unit = units_per_um(row.cells.front());
  if (!unit) {
    throw malformed(
        file, row.line,
        "the first line with content must be a heading that names the unit, such as wavelength_nm,n,k or "
        "wavelength_um,n,k");
  }
  Heading heading{row.line, *unit, {}, {}, row.cells.size()};
  for (std::size_t column = 1; column < row.cells.size(); ++column) {
    const std::vector<std::string> words = heading_words(row.cells[column]);
    auto& constant = means_k(words) ? heading.k : heading.n;
    if ((!means_k(words) && !means_n(words)) || constant)
      throw malformed(file, row.line,
                      "column '" + lower_case(row.cells[column]) + "': expected n and k, each once");
    constant = column;
  }
  return heading;
}

/// Whether a line that is no row of numbers can be a heading.
bool looks_like_heading(const CellRow& row) {
  return units_per_um(row.cells.front()).has_value();
}

NumberRow parse_row(const CellRow& row, std::size_t columns, const std::filesystem::path& file) {
  NumberRow numbers{row.line, {}};
  for (const std::string& cell : row.cells) {
    if (cell.empty()) continue;
    const auto number = cell_number(cell);
    if (!number) throw malformed(file, row.line, "'" + cell + "' is not a finite number");
    numbers.values.push_back(*number);
  }
  if (numbers.values.size() != columns || row.cells.size() != columns)
    throw malformed(
        file, row.line,
        "expected " + std::to_string(columns) + " numbers, found " + std::to_string(numbers.values.size()));
  return numbers;
}

/// A comma in a wavelength must stand before decimals beyond doubt, at least in one row of the file.
void check_commas(const std::vector<CellRow>& rows, const std::filesystem::path& file) {
  const CellRow* doubtful = nullptr;
  for (const CellRow& row : rows) {
    const std::string& cell = row.cells.front();
    if (row.comment || cell.find(',') == cell.npos || !cell_number(cell)) continue;
    if (!has_doubtful_comma(cell)) return;
    if (!doubtful) doubtful = &row;
  }
  if (doubtful)
    throw malformed(
        file, doubtful->line,
        "'" + doubtful->cells.front() + "' may mean thousands or decimals; write it with a point or without");
}

std::vector<Block> read_blocks(const std::vector<CellRow>& rows, const std::filesystem::path& file) {
  std::vector<Block> blocks;
  std::optional<Heading> commented;  // a heading behind a '#', for rows that have no other
  for (const CellRow& row : rows) {
    if (row.comment) {
      if (looks_like_heading(row) && row.cells.size() > 1) {
        try {
          commented = parse_heading(row, file);
        } catch (const std::runtime_error&) {  // only a comment that speaks of wavelengths
        }
      }
      continue;
    }
    const bool is_heading = !cell_number(row.cells.front()) && (blocks.empty() || looks_like_heading(row));
    if (is_heading) {
      blocks.push_back({parse_heading(row, file), {}});
      continue;
    }
    if (blocks.empty() && commented) blocks.push_back({*commented, {}});
    if (blocks.empty()) blocks.push_back({parse_heading(row, file), {}});
    blocks.back().rows.push_back(parse_row(row, blocks.back().heading.columns, file));
  }
  return blocks;
}

/// Puts a constant from a block where it belongs, unless another block has given it.
void set(std::optional<OpticalConstant>& constant, const char* name, const Block& block, std::size_t column,
         const std::filesystem::path& file) {
  if (constant)
    throw malformed(
        file, block.heading.line,
        std::string(name) + " was already given by the table on line " + std::to_string(constant->line));
  constant = tabulated(block.rows, column, block.heading.units_per_um, file, block.rows.front().line);
}

}  // namespace

Material read_nk_csv(const std::filesystem::path& file, MissingExtinction missing) {
  const std::vector<CellRow> rows = read_spreadsheet(file);
  const std::vector<Block> blocks = read_blocks(rows, file);
  if (blocks.empty()) throw malformed(file, 1, "the file is empty");
  check_commas(rows, file);
  std::optional<OpticalConstant> n, k;
  for (const Block& block : blocks) {
    if (block.rows.empty()) throw malformed(file, block.heading.line, "the table is empty");
    if (block.heading.n) set(n, "n", block, *block.heading.n, file);
    if (block.heading.k) set(k, "k", block, *block.heading.k, file);
  }
  if (!n) throw malformed(file, blocks.front().heading.line, "there is no column n");
  return Material({.name = file.stem().string(),
                   .file = file,
                   .reference = file.filename().string(),
                   .comments = {},
                   .n = *n,
                   .k = k},
                  missing);
}

}  // namespace vcavity::tools
