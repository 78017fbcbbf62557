// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/text_table.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/provenance.hpp"

namespace vcavity::tools {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void run_materials(Format format) {
  const std::vector<CatalogueEntry> entries = list_materials();
  if (format == Format::json) {
    nlohmann::ordered_json json{{"materials", nlohmann::ordered_json::array()}};
    for (const CatalogueEntry& entry : entries)
      json["materials"].push_back(
          {{"name", entry.material.name()},
           {"default_for", entry.short_names},
           {"range_um", {entry.material.range().min_um, entry.material.range().max_um}},
           {"source", entry.material.reference()},
           {"comments", entry.material.comments()}});
    std::cout << json.dump(2) << '\n';
    return;
  }
  TextTable table{{"name", "default for", "from um", "to um", "source"}, {}};
  for (const CatalogueEntry& entry : entries)
    table.rows.push_back({entry.material.name(), joined(entry.short_names),
                          exact(entry.material.range().min_um), exact(entry.material.range().max_um),
                          entry.material.reference()});
  if (format == Format::md) {
    std::cout << to_markdown(table);
  } else {
    std::cout << to_csv(table, {software(), "command: " + command_line()});
  }
}

}  // namespace

void add_materials_command(CLI::App& program) {
  auto format = std::make_shared<Format>(Format::md);
  CLI::App* command =
      program.add_subcommand("materials", "the refractive indices that come with the program");
  add_format(*command, *format);
  command->callback([format] { run_materials(*format); });
}

}  // namespace vcavity::tools
