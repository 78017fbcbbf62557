// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/table_plot.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"
#include "tools/support/report.hpp"

namespace vcavity::tools {
namespace {

using Json = nlohmann::ordered_json;

/// A path such as "/films/0/thickness_nm" for people.
std::string in_words(const std::string& path) {
  static const std::map<std::string, std::string> known{
      {"/aperture_deg", "aperture in degrees"},
      {"/tilt_deg", "tilt in degrees"},
      {"/wavelength_nm", "wavelength in nm"},
      {"/films/0/thickness_nm", "thickness of the film in nm"}};
  const auto found = known.find(path);
  if (found != known.end()) return found->second;
  std::string words = path.substr(1);
  std::replace_if(words.begin(), words.end(), [](char c) { return c == '/' || c == '_'; }, ' ');
  return words;
}

/// A field and its value for people, such as "wavelength 600 nm".
std::string in_words(const std::string& path, const std::string& value) {
  if (path == "/material") return value;
  std::string words = path.ends_with("/material") ? "film of " + value : in_words(path) + " " + value;
  for (const auto& [unit, shown] : {std::pair{" in nm", " nm"}, std::pair{" in degrees", "°"}}) {
    const auto at = words.find(unit);
    if (at == words.npos) continue;
    words.erase(at, std::string(unit).size());
    words += shown;
  }
  return words;
}

/// The different values of each field, its name as a path.
std::map<std::string, std::set<std::string>> different_values(const std::vector<Json>& rows) {
  std::map<std::string, std::set<std::string>> values;
  std::map<std::string, std::size_t> present;
  for (const Json& row : rows)
    for (const auto& [path, value] : row.items()) {
      values[path].insert(text_of(value));
      ++present[path];
    }
  // To be without a field is a value of its own.
  for (auto& [path, texts] : values)
    if (present[path] < rows.size()) texts.insert("");
  return values;
}

}  // namespace

Plot plot_of(const std::vector<PlottedRow>& rows, const std::string& value_label) {
  std::vector<Json> fields;
  for (const PlottedRow& row : rows) fields.push_back(row.fields.flatten());
  const auto values = different_values(fields);

  std::string x_path;
  std::size_t most = 1;
  for (const auto& [path, texts] : values) {
    const bool number = std::all_of(fields.begin(), fields.end(), [&path = path](const Json& row) {
      return row.contains(path) && row.at(path).is_number();
    });
    if (!number || texts.size() <= most) continue;
    most = texts.size();
    x_path = path;
  }
  if (x_path.empty())
    throw UsageError(
        "--plot: no number changes from row to row, expected a list or a range, such as of apertures");

  Plot plot;
  plot.x = {in_words(x_path), Axis::Scale::linear, std::nullopt};
  plot.y = {value_label, Axis::Scale::linear, std::nullopt};
  plot.footnote = software() + ", " + command_line();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string name, common;
    for (const auto& [path, texts] : values) {
      if (path == x_path || !fields[i].contains(path)) continue;
      std::string& words = texts.size() > 1 ? name : common;
      const std::string text = text_of(fields[i].at(path));
      words.append(words.empty() ? "" : ", ").append(in_words(path, text));
    }
    plot.title = common;
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&name](const Series& any) { return any.name == name; });
    if (series == plot.series.end()) series = plot.series.insert(series, {name, {}, {}, Series::Look::line});
    series->x.push_back(fields[i].at(x_path).get<double>());
    series->y.push_back(rows[i].value);
  }
  return plot;
}

}  // namespace vcavity::tools
