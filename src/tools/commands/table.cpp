// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <vcavity/bihemispherical.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/text_table.hpp"
#include "tools/facet.hpp"
#include "tools/map_plan.hpp"
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
  EffectsOptions effects;
  double tolerance = 1e-10;
  Format format = Format::md;
};

// Below this, rounding in double precision is all that is left to see.
constexpr Interval tolerance_range{1e-15, 1, Interval::Ends::open_both};

struct Row {
  double aperture_deg;
  Polarization polarization;
  int most_bounces;
  Integral<double> reflectance;
  std::optional<EffectsPlan> plan;
};

Row computed(const TableOptions& options, const RefractiveIndex& index, double aperture_deg) {
  const Cavity<double> cavity(radians(aperture_deg));
  return {aperture_deg, options.polarization, options.most_bounces,
          with_facet(index,
                     [&](const auto& facet) {
                       return with_polarization(options.polarization, facet, [&](const auto& model) {
                         return bihemispherical_reflectance(cavity, model, options.tolerance,
                                                            options.most_bounces);
                       });
                     }),
          std::nullopt};
}

/// The same with the effects that the tolerance calls for; without a value if that is all there is to know.
Row planned(const TableOptions& options, const RefractiveIndex& index, double aperture_deg) {
  const Cavity<double> cavity(radians(aperture_deg));
  const EffectsPlan plan = with_facet(index, [&](const auto& facet) {
    return plan_effects(cavity, facet, options.tolerance, Illumination::diffuse);
  });
  Row row{aperture_deg,
          plan.polarization ? Polarization::full : Polarization::none,
          plan.most_bounces,
          {std::nan(""), plan.bounds.total(), 0},
          plan};
  if (options.effects.explain) return row;
  row.reflectance = with_effects(plan, cavity, index.n, index.k, [&](const auto& groove, const auto& facet) {
    using Real = std::remove_cvref_t<decltype(groove.aperture())>;
    const auto integral = bihemispherical_reflectance(
        groove, facet, static_cast<Real>(plan.bounds.quadrature), plan.most_bounces);
    return Integral<double>{static_cast<double>(integral.value), plan.bounds.total(), integral.evaluations};
  });
  return row;
}

nlohmann::ordered_json json_of(const EffectsPlan& plan) {
  return {{"precision", plan.single_precision ? "single" : "double"},
          {"error_bounds",
           {{"polarization", plan.bounds.polarization},
            {"bounces", plan.bounds.bounces},
            {"rounding", plan.bounds.rounding},
            {"quadrature", plan.bounds.quadrature}}}};
}

// As many digits as the error estimate vouches for.
std::string trusted(const Integral<double>& integral) {
  const double error = std::max(integral.error, 1e-16);
  return with_decimals(integral.value, std::clamp(static_cast<int>(std::floor(-std::log10(error))), 1, 15));
}

void run_table(const TableOptions& options) {
  const Material material = load_material(options.material);
  const RefractiveIndex index = material.at(options.wavelength_nm);
  std::vector<Row> rows;
  for (const double aperture_deg : options.apertures_deg)
    rows.push_back(options.effects.automatic ? planned(options, index, aperture_deg)
                                             : computed(options, index, aperture_deg));
  if (options.effects.explain) {
    for (const Row& row : rows) std::cout << exact(row.aperture_deg) << "°: " << in_words(*row.plan) << '\n';
    return;
  }

  if (options.format == Format::json) {
    nlohmann::ordered_json result{{"material", material.name()},
                                  {"source", material.reference()},
                                  {"software", software()},
                                  {"command", command_line()},
                                  {"rows", nlohmann::ordered_json::array()}};
    for (const Row& row : rows) {
      nlohmann::ordered_json entry{{"aperture_deg", row.aperture_deg},
                                   {"wavelength_nm", options.wavelength_nm},
                                   {"n", index.n},
                                   {"k", index.k},
                                   {"polarization", name_of(row.polarization)},
                                   {"max_bounces", nullptr},
                                   {"reflectance", row.reflectance.value},
                                   {"error_estimate", row.reflectance.error},
                                   {"fresnel_evaluations", row.reflectance.evaluations}};
      if (row.most_bounces != all_bounces) entry["max_bounces"] = row.most_bounces;
      if (row.plan) entry["plan"] = json_of(*row.plan);
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
                          exact(index.k), name_of(row.polarization),
                          row.most_bounces != all_bounces ? std::to_string(row.most_bounces) : "all",
                          markdown ? trusted(row.reflectance) : exact(row.reflectance.value),
                          markdown ? with_digits(row.reflectance.error, 2) : exact(row.reflectance.error),
                          std::to_string(row.reflectance.evaluations)});
  if (markdown) {
    std::cout << "Bi-hemispherical reflectance of V-grooves, " << in_one_line(material) << "\n\n"
              << to_markdown(table);
    for (const Row& row : rows)
      if (row.plan) std::cout << '\n' << exact(row.aperture_deg) << "°: " << in_words(*row.plan) << '\n';
  } else {
    std::vector<std::string> provenance = provenance_lines(material);
    for (const Row& row : rows)
      if (row.plan) provenance.push_back(exact(row.aperture_deg) + " deg: " + in_words(*row.plan));
    std::cout << to_csv(table, provenance);
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
  add_effects(*command, options->effects);
  add_number(*command, "--tolerance", options->tolerance, tolerance_range,
             "absolute error of the reflectance to aim at, above 1e-15 and below 1 (default 1e-10)")
      ->type_name("T");
  add_format(*command, options->format);
  command->callback([options] { run_table(*options); });
}

}  // namespace vcavity::tools
