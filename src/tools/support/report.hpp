// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a command prints: rows of typed cells with where they come from, as Markdown for people, CSV for
/// spreadsheets and JSON for programs. A column is named once, where its cell is filled in.
///
/// Method: each row is a list of named cells; the columns of the tables are all names in the order in which
/// they first appear, and a row without a cell of that name stays blank there.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vcavity::tools {

/// How a command prints its results.
enum class Format { md, csv, json };

/// A value of JSON as a cell of a table: numbers exactly, nothing for null, arrays separated by "; ", the
/// members of an object by ":".
std::string text_of(const nlohmann::ordered_json& value);

/// One row of a report.
class ReportRow {
 public:
  /// Adds a cell to the row in all formats.
  /// @param column its name
  /// @param value a number, a text, a truth value or null; a number that is not finite becomes null in JSON
  /// @param shown what Markdown shows; empty for the same as CSV
  ReportRow& add(const std::string& column, const nlohmann::ordered_json& value,
                 const std::string& shown = {});

  /// Adds a cell that says in words what JSON says with null.
  ReportRow& add_null(const std::string& column, const std::string& words);

  /// Adds a cell to the tables only.
  /// @param shown what Markdown shows; empty for the same as CSV
  ReportRow& add_to_tables(const std::string& column, const std::string& text, const std::string& shown = {});

  /// Adds a member, of any structure, to the row in JSON only.
  ReportRow& add_to_json(const std::string& name, nlohmann::ordered_json value);

  /// Adds all members of a JSON object as cells in all formats.
  ReportRow& add_fields(const nlohmann::ordered_json& fields);

 private:
  friend class Report;

  struct Cell {
    std::string column;
    nlohmann::ordered_json value;
    std::string csv;
    std::string markdown;
    enum class Place { everywhere, tables, json } place;
  };

  std::vector<Cell> cells_;
};

/// All that a command has to say.
class Report {
 public:
  std::string title;               ///< the lines above the table in Markdown; may be empty
  nlohmann::ordered_json head;     ///< members of the JSON object before the rows
  std::string rows_name = "rows";  ///< the member of the JSON object that holds the rows; empty: none does
  std::vector<std::string> provenance;  ///< lines above the table in CSV, without their '#'
  std::vector<std::string> notes;       ///< points of a list below the table in Markdown

  /// Begins a part of the report, to which all rows belong that follow. Its heading stands above them in Markdown and in
  /// a column `section` in CSV; JSON has an array `sections` of objects with the rows of one each.
  /// @param heading of the part; `title` in JSON
  /// @param members of that object, before its rows
  void begin_section(const std::string& heading, const nlohmann::ordered_json& members = {});

  /// Adds a row, which stays valid until the next one is added.
  ReportRow& add_row() { return rows_.emplace_back(); }

  /// Adds a line to provenance and notes, unless it is empty or has been added before.
  void tell(const std::string& origin);

  std::string to_markdown() const;
  std::string to_csv() const;
  std::string to_json() const;

  /// The report in a format, with the end of its last line.
  std::string in(Format format) const;

 private:
  std::vector<std::string> columns() const;

  struct Section {
    std::string heading;
    nlohmann::ordered_json members;
    std::size_t first_row;
  };

  nlohmann::ordered_json json_of_rows(std::size_t begin, std::size_t end) const;

  std::vector<ReportRow> rows_;
  std::vector<Section> sections_;
};

}  // namespace vcavity::tools
