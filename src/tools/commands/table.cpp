// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <vcavity/hemisphere/bihemispherical.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/images/progress.hpp"
#include "tools/maps/map_plan.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/materials/facet.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

struct TableOptions {
  std::vector<std::string> materials;
  std::vector<double> apertures_deg;
  std::vector<double> wavelengths_nm{default_wavelength_nm};
  int most_bounces = all_bounces;
  Polarization polarization = Polarization::none;
  EffectsOptions effects;
  double tolerance = 1e-10;
  Format format = Format::md;
};

// Below this, rounding in double precision is all that is left to see.
constexpr Interval tolerance_range{1e-15, 1, Interval::Ends::open_both};

/// What one row of the table is about.
struct Groove {
  std::string material;
  double wavelength_nm;
  RefractiveIndex index;
  double aperture_deg;
};

struct Row {
  Groove groove;
  Polarization polarization;
  int most_bounces;
  Integral<double> reflectance;
  std::optional<EffectsPlan> plan;
};

Row computed(const TableOptions& options, const Groove& groove) {
  const Cavity<double> cavity(radians(groove.aperture_deg));
  return {groove, options.polarization, options.most_bounces,
          with_facet(groove.index,
                     [&](const auto& facet) {
                       return with_polarization(options.polarization, facet, [&](const auto& model) {
                         return bihemispherical_reflectance(cavity, model, options.tolerance,
                                                            options.most_bounces);
                       });
                     }),
          std::nullopt};
}

/// The same with the effects that the tolerance calls for; without a value if that is all there is to know.
Row planned(const TableOptions& options, const Groove& groove) {
  const Cavity<double> cavity(radians(groove.aperture_deg));
  const EffectsPlan plan = with_facet(groove.index, [&](const auto& facet) {
    return plan_effects(cavity, facet, options.tolerance, Illumination::diffuse);
  });
  Row row{groove,
          plan.polarization ? Polarization::full : Polarization::none,
          plan.most_bounces,
          {std::nan(""), plan.bounds.total(), 0},
          plan};
  if (options.effects.explain) return row;
  row.reflectance =
      with_effects(plan, cavity, groove.index.n, groove.index.k, [&](const auto& shape, const auto& facet) {
        using Real = std::remove_cvref_t<decltype(shape.aperture())>;
        const auto integral = bihemispherical_reflectance(
            shape, facet, static_cast<Real>(plan.bounds.quadrature), plan.most_bounces);
        return Integral<double>{static_cast<double>(integral.value), plan.bounds.total(),
                                integral.evaluations};
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

/// Every material at every wavelength and aperture.
std::vector<Groove> combinations(const TableOptions& options, const std::vector<Material>& materials) {
  std::vector<Groove> grooves;
  for (const Material& material : materials)
    for (const double wavelength_nm : options.wavelengths_nm)
      for (const double aperture_deg : options.apertures_deg)
        grooves.push_back({material.name(), wavelength_nm, material.at(wavelength_nm), aperture_deg});
  return grooves;
}

std::vector<Row> computed_rows(const TableOptions& options, const std::vector<Groove>& grooves) {
  std::vector<Row> rows(grooves.size());
  Progress progress(grooves.size());
  tbb::parallel_for(std::size_t{0}, grooves.size(), [&](std::size_t i) {
    rows[i] = options.effects.automatic ? planned(options, grooves[i]) : computed(options, grooves[i]);
    progress.advance();
  });
  return rows;
}

/// Which row a plan belongs to.
std::string plan_in_words(const Row& row) {
  return row.groove.material + ", " + exact(row.groove.wavelength_nm) + " nm, " +
         exact(row.groove.aperture_deg) + "°: " + in_words(*row.plan);
}

void print_json(const std::vector<Material>& materials, const std::vector<Row>& rows) {
  nlohmann::ordered_json result;
  for (const Material& material : materials) {
    result["material"].push_back(material.name());
    result["source"].push_back(material.reference());
  }
  if (materials.size() == 1) {
    result["material"] = materials.front().name();
    result["source"] = materials.front().reference();
  }
  result["software"] = software();
  result["command"] = command_line();
  result["rows"] = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json entry{{"material", row.groove.material},
                                 {"aperture_deg", row.groove.aperture_deg},
                                 {"wavelength_nm", row.groove.wavelength_nm},
                                 {"n", row.groove.index.n},
                                 {"k", row.groove.index.k},
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
}

TextTable text_table(const std::vector<Row>& rows, bool markdown) {
  TextTable table{{"material", "aperture_deg", "wavelength_nm", "n", "k", "polarization", "max_bounces",
                   "reflectance", "error_estimate", "fresnel_evaluations"},
                  {}};
  for (const Row& row : rows)
    table.rows.push_back({row.groove.material, exact(row.groove.aperture_deg),
                          exact(row.groove.wavelength_nm), exact(row.groove.index.n),
                          exact(row.groove.index.k), name_of(row.polarization),
                          row.most_bounces != all_bounces ? std::to_string(row.most_bounces) : "all",
                          markdown ? trusted(row.reflectance) : exact(row.reflectance.value),
                          markdown ? with_digits(row.reflectance.error, 2) : exact(row.reflectance.error),
                          std::to_string(row.reflectance.evaluations)});
  return table;
}

void print_markdown(const std::vector<Material>& materials, const std::vector<Row>& rows) {
  std::cout << "Bi-hemispherical reflectance of V-grooves\n\n" << to_markdown(text_table(rows, true)) << '\n';
  for (const Material& material : materials) std::cout << "- " << in_one_line(material) << '\n';
  for (const Row& row : rows)
    if (row.plan) std::cout << "- " << plan_in_words(row) << '\n';
}

void print_csv(const std::vector<Material>& materials, const std::vector<Row>& rows) {
  std::vector<std::string> provenance = provenance_lines(materials.front());
  for (std::size_t i = 1; i < materials.size(); ++i)
    provenance.push_back("material: " + in_one_line(materials[i]));
  for (const Row& row : rows)
    if (row.plan) provenance.push_back(plan_in_words(row));
  std::cout << to_csv(text_table(rows, false), provenance);
}

void run_table(const TableOptions& options) {
  std::vector<Material> materials;
  for (const std::string& name : options.materials) materials.push_back(load_material(name));
  const std::vector<Row> rows = computed_rows(options, combinations(options, materials));
  if (options.effects.explain) {
    for (const Row& row : rows) std::cout << plan_in_words(row) << '\n';
  } else if (options.format == Format::json) {
    print_json(materials, rows);
  } else if (options.format == Format::md) {
    print_markdown(materials, rows);
  } else {
    print_csv(materials, rows);
  }
}

}  // namespace

void add_table_command(CLI::App& program) {
  auto options = std::make_shared<TableOptions>();
  CLI::App* command =
      program.add_subcommand("table", "bi-hemispherical reflectance of grooves, every combination a row");
  add_materials(*command, options->materials);
  add_apertures(*command, options->apertures_deg);
  add_wavelengths(*command, options->wavelengths_nm);
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
