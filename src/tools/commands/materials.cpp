// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "tools/commands/commands.hpp"
#include "tools/commands/material_plot.hpp"
#include "tools/commands/options.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/materials/facet.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/report.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

struct MaterialsOptions {
  std::optional<std::string> material;  // all of the collection unless given
  std::optional<double> wavelength_nm;
  MissingExtinction missing_k = MissingExtinction::refused;
  std::string plot;  // empty: none
  Format format = Format::md;
};

void list_collection(Format format) {
  Report report;
  report.rows_name = "materials";
  report.provenance = {software(), "command: " + command_line()};
  for (const CatalogueEntry& entry : list_materials()) {
    const auto& [min_um, max_um] = entry.material.range();
    report.add_row()
        .add("name", entry.material.name())
        .add_to_json("default_for", entry.short_names)
        .add_to_tables("default for", joined(entry.short_names, ", "))
        .add_to_json("range_um", {min_um, max_um})
        .add_to_tables("from um", exact(min_um))
        .add_to_tables("to um", exact(max_um))
        .add("source", entry.material.reference())
        .add_to_json("comments", entry.material.comments());
  }
  std::cout << report.in(format);
}

double normal_reflectance(const RefractiveIndex& index) {
  return with_facet(index, [](const auto& facet) { return facet(1.0); });
}

Report report_on(const Material& material, std::optional<double> wavelength_nm) {
  Report report;
  report.rows_name.clear();
  report.provenance = provenance_lines(material);
  const auto& [min_um, max_um] = material.range();
  ReportRow& row = report.add_row();
  row.add_to_tables("name", material.name())
      .add_to_tables("from um", exact(min_um))
      .add_to_tables("to um", exact(max_um));
  report.head["material"] = material.name();
  if (wavelength_nm) {
    const RefractiveIndex index = material.at(*wavelength_nm);
    for (const auto& [name, value] :
         {std::pair("wavelength_nm", *wavelength_nm), std::pair("n", index.n), std::pair("k", index.k),
          std::pair("normal_reflectance", normal_reflectance(index))}) {
      report.head[name] = value;
      row.add_to_tables(name, exact(value), with_digits(value, 8));
    }
  }
  row.add_to_tables("source", material.reference());
  report.head.update({{"range_um", {min_um, max_um}},  // JSON writes infinity as null
                      {"source", material.reference()},
                      {"comments", material.comments()},
                      {"software", software()},
                      {"command", command_line()}});
  return report;
}

void run_materials(const MaterialsOptions& options) {
  if (!options.material) {
    list_collection(options.format);
    return;
  }
  const Material material = load_material(*options.material, options.missing_k);
  std::optional<AtomicFile> picture;
  if (!options.plot.empty()) {
    picture.emplace(options.plot);
    write_plots(*picture, material_plots(material));
  }
  std::cout << report_on(material, options.wavelength_nm).in(options.format);
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
  add_missing_k(*command, options->missing_k);
  add_picture(*command, "--plot", options->plot,
              "also draw n, k and the normal reflectance over all wavelengths into this file")
      ->needs(material);
  add_format(*command, options->format);
  command->callback([options] { run_materials(*options); });
}

}  // namespace vcavity::tools
