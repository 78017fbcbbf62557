// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "tools/commands/commands.hpp"
#include "tools/commands/material_plot.hpp"
#include "tools/commands/options.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/materials/facet.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

struct MaterialsOptions {
  std::optional<std::string> material;  // all of the collection unless given
  std::optional<double> wavelength_nm;
  std::string plot;  // empty: none
  Format format = Format::md;
};

void list_collection(Format format) {
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
    table.rows.push_back({entry.material.name(), joined(entry.short_names, ", "),
                          exact(entry.material.range().min_um), exact(entry.material.range().max_um),
                          entry.material.reference()});
  if (format == Format::md) {
    std::cout << to_markdown(table);
  } else {
    std::cout << to_csv(table, {software(), "command: " + command_line()});
  }
}

double normal_reflectance(const RefractiveIndex& index) {
  return with_facet(index, [](const auto& facet) { return facet(1.0); });
}

void print_json(const Material& material, std::optional<double> wavelength_nm) {
  nlohmann::ordered_json json{{"material", material.name()}};
  if (wavelength_nm) {
    const RefractiveIndex index = material.at(*wavelength_nm);
    json["wavelength_nm"] = *wavelength_nm;
    json["n"] = index.n;
    json["k"] = index.k;
    json["normal_reflectance"] = normal_reflectance(index);
  }
  json["range_um"] = {material.range().min_um, material.range().max_um};  // JSON writes infinity as null
  json["source"] = material.reference();
  json["comments"] = material.comments();
  json["software"] = software();
  json["command"] = command_line();
  std::cout << json.dump(2) << '\n';
}

void print_table(const Material& material, std::optional<double> wavelength_nm, Format format) {
  const bool markdown = format == Format::md;
  const auto number = [markdown](double x) { return markdown ? with_digits(x, 8) : exact(x); };
  TextTable table{{"name", "from um", "to um"}, {{material.name()}}};
  std::vector<std::string>& row = table.rows.front();
  row.insert(row.end(), {exact(material.range().min_um), exact(material.range().max_um)});
  if (wavelength_nm) {
    const RefractiveIndex index = material.at(*wavelength_nm);
    table.heading.insert(table.heading.end(), {"wavelength_nm", "n", "k", "normal_reflectance"});
    row.insert(row.end(),
               {exact(*wavelength_nm), exact(index.n), exact(index.k), number(normal_reflectance(index))});
  }
  table.heading.push_back("source");
  row.push_back(material.reference());
  std::cout << (markdown ? to_markdown(table) : to_csv(table, provenance_lines(material)));
}

void run_materials(const MaterialsOptions& options) {
  if (!options.material) {
    list_collection(options.format);
    return;
  }
  const Material material = load_material(*options.material);
  std::optional<AtomicFile> picture;
  if (!options.plot.empty()) {
    picture.emplace(options.plot);
    write_plots(*picture, material_plots(material));
  }
  if (options.format == Format::json) {
    print_json(material, options.wavelength_nm);
  } else {
    print_table(material, options.wavelength_nm, options.format);
  }
  if (picture) picture->commit();
}

}  // namespace

void add_materials_command(CLI::App& program) {
  auto options = std::make_shared<MaterialsOptions>();
  CLI::App* command = program.add_subcommand(
      "materials", "the refractive indices that come with the program, or one of them, or a file");
  CLI::Option* material =
      command
          ->add_option(material_placeholder, options->material,
                       "a name, a file (.yml of refractiveindex.info, .csv, .spd) or an index such as "
                       "0.1249+3.3391i; all names unless given")
          ->type_name("");
  add_number(*command, "--wavelength", options->wavelength_nm, wavelength_range_nm,
             "also n, k and the normal reflectance at this vacuum wavelength in nanometres")
      ->type_name("NM")
      ->needs(material);
  add_picture(*command, "--plot", options->plot,
              "also draw n, k and the normal reflectance over all wavelengths into this file")
      ->needs(material);
  add_format(*command, options->format);
  command->callback([options] { run_materials(*options); });
}

}  // namespace vcavity::tools
