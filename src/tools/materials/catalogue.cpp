// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/catalogue.hpp"

#include <yaml-cpp/yaml.h>

#include <charconv>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "tools/materials/nearest_name.hpp"
#include "tools/materials/nk_csv.hpp"
#include "tools/materials/refractiveindex_info.hpp"
#include "tools/materials/spd_pair.hpp"
#include "tools/support/data_path.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_file.hpp"

namespace vcavity::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view defaults_name = "defaults";

/// What the short names stand for: "Cu" -> "Cu-Johnson".
std::map<std::string, std::string> read_defaults(const fs::path& folder) {
  const fs::path file = folder / (std::string(defaults_name) + ".yml");
  try {
    return YAML::Load(read_text(file)).as<std::map<std::string, std::string>>();
  } catch (const YAML::Exception& error) {
    throw malformed(file, error.mark.line + 1, error.msg);
  }
}

/// The names of the files in the collection, without extension.
std::set<std::string> source_names(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& item : fs::directory_iterator(folder)) {
    if (item.path().extension() == ".yml" && item.path().stem() != defaults_name)
      names.insert(item.path().stem().string());
  }
  return names;
}

Material read_source(const fs::path& folder, const std::string& name,
                     MissingExtinction missing = MissingExtinction::refused) {
  return read_refractiveindex_info(folder / (name + ".yml"), name, missing);
}

std::string extension_of(const fs::path& file) {
  return lower_case(file.extension().string());
}

bool is_file(const fs::path& specification) {
  const std::string extension = extension_of(specification);
  return specification.has_parent_path() || extension == ".yml" || extension == ".yaml" ||
         extension == ".csv" || extension == ".tsv" || extension == ".spd";
}

Material read_file(const fs::path& file, MissingExtinction missing) {
  const std::string extension = extension_of(file);
  if (extension == ".yml" || extension == ".yaml")
    return read_refractiveindex_info(file, file.stem().string(), missing);
  if (extension == ".csv" || extension == ".tsv" || extension == ".txt") return read_nk_csv(file, missing);
  if (extension == ".spd") return read_spd_pair(file, missing);
  throw UsageError("'" + file.string() +
                   "' is no material file: expected .yml, .yaml, .csv, .tsv, .txt or .spd");
}

/// N or N+Ki, as numbers without regard to what is physical; nothing if the text is no number at all.
std::optional<RefractiveIndex> parse_index(std::string_view text) {
  const auto number = [&text]() -> std::optional<double> {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range)
      value = std::numeric_limits<double>::infinity();  // a number all the same
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
  };
  const auto n = number();
  if (!n) return std::nullopt;
  if (text.empty()) return RefractiveIndex{*n, 0};
  if (!text.starts_with('+') && !text.starts_with('-')) return std::nullopt;
  const auto k = number();
  if (!k || (text != "i" && text != "j")) return std::nullopt;
  return RefractiveIndex{*n, *k};
}

}  // namespace

std::vector<CatalogueEntry> list_materials() {
  const fs::path folder = data_directory() / "nk";
  std::map<std::string, std::vector<std::string>> short_names;
  for (const auto& [short_name, source] : read_defaults(folder)) short_names[source].push_back(short_name);

  std::vector<CatalogueEntry> entries;
  for (const std::string& name : source_names(folder))
    entries.push_back({read_source(folder, name), short_names[name]});
  return entries;
}

Material load_material(std::string_view specification, MissingExtinction missing) {
  const std::string text(specification);
  if (const auto index = parse_index(text)) return Material::from_index(*index, text);
  if (is_file(text)) return read_file(text, missing);

  const fs::path folder = data_directory() / "nk";
  std::map<std::string, std::string> sources = read_defaults(folder);
  for (const std::string& name : source_names(folder)) sources.emplace(name, name);

  // First the exact name: Co is cobalt, CO would be carbon monoxide.
  if (const auto exact = sources.find(text); exact != sources.end())
    return read_source(folder, exact->second, missing);
  std::vector<std::string> names;
  for (const auto& [name, source] : sources) {
    if (lower_case(name) == lower_case(text)) return read_source(folder, source, missing);
    names.push_back(name);
  }
  const auto nearest = nearest_name(text, names);
  throw UsageError(
      "unknown material '" + text + "'" + (nearest ? "; did you mean '" + *nearest + "'?" : ";") +
      " expected a name such as Cu, a file such as ./my-copper.yml, or an index such as 1.5 or 0.05+4i");
}

}  // namespace vcavity::tools
