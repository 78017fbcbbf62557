// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/report.hpp"

#include <algorithm>

#include "tools/support/text_table.hpp"

namespace vcavity::tools {

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return exact(value.get<double>());
  if (!value.is_structured()) return value.dump();
  std::string text;
  for (const auto& [name, part] : value.items())
    text.append(text.empty() ? "" : value.is_array() ? "; " : ":").append(text_of(part));
  return text;
}

ReportRow& ReportRow::add(const std::string& column, const nlohmann::ordered_json& value,
                          const std::string& shown) {
  const std::string text = text_of(value);
  cells_.push_back({column, value, text, shown.empty() ? text : shown, Cell::Place::everywhere});
  return *this;
}

ReportRow& ReportRow::add_null(const std::string& column, const std::string& words) {
  cells_.push_back({column, nullptr, words, words, Cell::Place::everywhere});
  return *this;
}

ReportRow& ReportRow::add_to_tables(const std::string& column, const std::string& text,
                                    const std::string& shown) {
  cells_.push_back({column, nullptr, text, shown.empty() ? text : shown, Cell::Place::tables});
  return *this;
}

ReportRow& ReportRow::add_to_json(const std::string& name, nlohmann::ordered_json value) {
  cells_.push_back({name, std::move(value), {}, {}, Cell::Place::json});
  return *this;
}

ReportRow& ReportRow::add_fields(const nlohmann::ordered_json& fields) {
  for (const auto& [name, value] : fields.items()) add(name, value);
  return *this;
}

// A column that only later rows have stands behind the one that it follows there.
std::vector<std::string> Report::columns() const {
  std::vector<std::string> names;
  for (const ReportRow& row : rows_) {
    auto place = names.begin();
    for (const ReportRow::Cell& cell : row.cells_) {
      if (cell.place == ReportRow::Cell::Place::json) continue;
      const auto known = std::find(names.begin(), names.end(), cell.column);
      place = (known != names.end() ? known : names.insert(place, cell.column)) + 1;
    }
  }
  return names;
}

namespace {

/// @param cell_text the text of the cell of a row in a column
template <class Rows, class CellText>
TextTable table_of(const std::vector<std::string>& columns, const Rows& rows, const CellText& cell_text) {
  TextTable table{columns, {}};
  for (const auto& row : rows) {
    table.rows.emplace_back();
    for (const std::string& column : columns) table.rows.back().push_back(cell_text(row, column));
  }
  return table;
}

template <class Cells, class Text>
std::string found(const Cells& cells, const std::string& column, Text text) {
  const auto cell =
      std::find_if(cells.begin(), cells.end(), [&](const auto& any) { return any.column == column; });
  return cell == cells.end() ? std::string() : (*cell).*text;
}

}  // namespace

void Report::tell(const std::string& origin) {
  if (origin.empty() || std::find(notes.begin(), notes.end(), origin) != notes.end()) return;
  notes.push_back(origin);
  provenance.push_back(origin);
}

void Report::begin_section(const std::string& heading, const nlohmann::ordered_json& members) {
  sections_.push_back({heading, members, rows_.size()});
}

std::string Report::to_markdown() const {
  std::string text = title.empty() ? "" : title + "\n\n";
  TextTable table = table_of(columns(), rows_, [](const ReportRow& row, const std::string& column) {
    return found(row.cells_, column, &ReportRow::Cell::markdown);
  });
  // From the last one, so that the places of the others stay right.
  for (auto section = sections_.rbegin(); section != sections_.rend(); ++section) {
    std::vector<std::string> line(table.heading.size());
    line.front() = "**" + section->heading + "**";
    table.rows.insert(table.rows.begin() + static_cast<std::ptrdiff_t>(section->first_row), line);
  }
  text += tools::to_markdown(table);
  if (!notes.empty()) text += '\n';
  for (const std::string& note : notes) text.append("- ").append(note).append("\n");
  return text;
}

std::string Report::to_csv() const {
  TextTable table = table_of(columns(), rows_, [](const ReportRow& row, const std::string& column) {
    return found(row.cells_, column, &ReportRow::Cell::csv);
  });
  if (!sections_.empty()) {
    table.heading.insert(table.heading.begin(), "section");
    for (std::size_t section = 0, row = 0; row < rows_.size(); ++row) {
      while (section + 1 < sections_.size() && sections_[section + 1].first_row <= row) ++section;
      table.rows[row].insert(table.rows[row].begin(), sections_[section].heading);
    }
  }
  return tools::to_csv(table, provenance);
}

nlohmann::ordered_json Report::json_of_rows(std::size_t begin, std::size_t end) const {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t row = begin; row < end; ++row) {
    nlohmann::ordered_json entry = nlohmann::ordered_json::object();
    for (const ReportRow::Cell& cell : rows_[row].cells_)
      if (cell.place != ReportRow::Cell::Place::tables) entry[cell.column] = cell.value;
    json.push_back(entry);
  }
  return json;
}

std::string Report::to_json() const {
  nlohmann::ordered_json json = head;
  if (sections_.empty()) {
    if (!rows_name.empty()) json[rows_name] = json_of_rows(0, rows_.size());
    return json.dump(2) + '\n';
  }
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    nlohmann::ordered_json section = {{"title", sections_[i].heading}};
    if (!sections_[i].members.is_null()) section.update(sections_[i].members);
    section[rows_name] = json_of_rows(sections_[i].first_row,
                                      i + 1 < sections_.size() ? sections_[i + 1].first_row : rows_.size());
    json["sections"].push_back(section);
  }
  return json.dump(2) + '\n';
}

std::string Report::in(Format format) const {
  switch (format) {
    case Format::csv:
      return to_csv();
    case Format::json:
      return to_json();
    default:
      return to_markdown();
  }
}

}  // namespace vcavity::tools
