// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vcavity/bihemispherical.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/text_table.hpp"
#include "tools/facet.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/provenance.hpp"

namespace vcavity::tools {
namespace {

struct TableOptions {
  std::string material;
  std::vector<double> apertures_deg;
  double wavelength_nm = default_wavelength_nm;
  int most_bounces = all_bounces;
  Polarization polarization = Polarization::none;
  double tolerance = 1e-10;
  Format format = Format::md;
};

// Below this, rounding in double precision is all that is left to see.
constexpr Interval tolerance_range{1e-15, 1, Interval::Ends::open_both};

struct Row {
  double aperture_deg;
  Integral<double> reflectance;
};

// As many digits as the error estimate vouches for.
std::string trusted(const Integral<double>& integral) {
  const double error = std::max(integral.error, 1e-16);
  return with_decimals(integral.value, std::clamp(static_cast<int>(std::floor(-std::log10(error))), 1, 15));
}

void run_table(const TableOptions& options) {
  const Material material = load_material(options.material);
  const RefractiveIndex index = material.at(options.wavelength_nm);
  std::vector<Row> rows;
  for (const double aperture_deg : options.apertures_deg) {
    const Cavity<double> cavity(radians(aperture_deg));
    rows.push_back({aperture_deg, with_facet(index, [&](const auto& facet) {
                      return with_polarization(options.polarization, facet, [&](const auto& model) {
                        return bihemispherical_reflectance(cavity, model, options.tolerance,
                                                           options.most_bounces);
                      });
                    })});
  }

  const bool limited = options.most_bounces != all_bounces;
  if (options.format == Format::json) {
    nlohmann::ordered_json result{{"material", material.name()},
                                  {"source", material.reference()},
                                  {"software", software()},
                                  {"command", command_line()},
                                  {"polarization", name_of(options.polarization)},
                                  {"rows", nlohmann::ordered_json::array()}};
    for (const Row& row : rows) {
      nlohmann::ordered_json entry{{"aperture_deg", row.aperture_deg},
                                   {"wavelength_nm", options.wavelength_nm},
                                   {"n", index.n},
                                   {"k", index.k},
                                   {"max_bounces", nullptr},
                                   {"reflectance", row.reflectance.value},
                                   {"error_estimate", row.reflectance.error},
                                   {"fresnel_evaluations", row.reflectance.evaluations}};
      if (limited) entry["max_bounces"] = options.most_bounces;
      result["rows"].push_back(entry);
    }
    std::cout << result.dump(2) << '\n';
    return;
  }

  const bool markdown = options.format == Format::md;
  TextTable table{{"aperture_deg", "wavelength_nm", "n", "k", "polarization", "max_bounces", "reflectance",
                   "error_estimate", "fresnel_evaluations"},
                  {}};
  for (const Row& row : rows)
    table.rows.push_back({exact(row.aperture_deg), exact(options.wavelength_nm), exact(index.n),
                          exact(index.k), name_of(options.polarization),
                          limited ? std::to_string(options.most_bounces) : "all",
                          markdown ? trusted(row.reflectance) : exact(row.reflectance.value),
                          markdown ? with_digits(row.reflectance.error, 2) : exact(row.reflectance.error),
                          std::to_string(row.reflectance.evaluations)});
  if (markdown) {
    std::cout << "Bi-hemispherical reflectance of V-grooves, " << in_one_line(material) << "\n\n"
              << to_markdown(table);
  } else {
    std::cout << to_csv(table, provenance_lines(material));
  }
}

}  // namespace

void add_table_command(CLI::App& program) {
  auto options = std::make_shared<TableOptions>();
  CLI::App* command =
      program.add_subcommand("table", "bi-hemispherical reflectance for one or more apertures");
  add_material(*command, options->material);
  command
      ->add_option_function<std::string>(
          "--aperture",
          [options](const std::string& words) {
            options->apertures_deg = checked_numbers(words, "--aperture", aperture_range_deg);
          },
          "angles between the panels in degrees, above 0 to 180; a list A,B,C or a range LOW:HIGH:STEP")
      ->type_name("DEG[,DEG...]")
      ->required();
  add_number(*command, "--wavelength", options->wavelength_nm, wavelength_range_nm,
             "vacuum wavelength in nanometres (default 550)")
      ->type_name("NM");
  add_polarization(*command, options->polarization);
  add_max_bounces(*command, options->most_bounces);
  add_number(*command, "--tolerance", options->tolerance, tolerance_range,
             "absolute error of the reflectance to aim at, above 1e-15 and below 1 (default 1e-10)")
      ->type_name("T");
  add_format(*command, options->format);
  command->callback([options] { run_table(*options); });
}

}  // namespace vcavity::tools
