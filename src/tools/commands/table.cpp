// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vcavity/groove/lobes.hpp>
#include <vector>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/surface_options.hpp"
#include "tools/commands/table_plot.hpp"
#include "tools/images/progress.hpp"
#include "tools/maps/map_plan.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/report.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

struct TableOptions {
  SurfaceOptions surfaces;
  std::vector<double> wavelengths_nm{default_wavelength_nm};
  LightModel light{Polarization::none, all_bounces};
  EffectsOptions effects;
  double tolerance = 1e-10;
  Format format = Format::md;
  std::string plot;
};

// Below this, rounding in double precision is all that is left to see.
constexpr Interval tolerance_range{1e-15, 1, Interval::Ends::open_both};

struct Row {
  SurfaceAtWavelength at;
  std::optional<RefractiveIndex> index;
  LightModel light;
  Integral<double> reflectance;
  std::optional<EffectsPlan> plan;
};

Row computed(const TableOptions& options, const SurfaceAtWavelength& at) {
  const auto surface = make_surface(at.surface, at.wavelength_nm, options.light);
  return {at, surface->index(), options.light, surface->bihemispherical(options.tolerance), std::nullopt};
}

/// The same with the effects that the tolerance calls for; without a value if that is all there is to know.
Row planned(const TableOptions& options, const SurfaceAtWavelength& at) {
  const auto surface = make_surface(at.surface, at.wavelength_nm, options.light);
  const EffectsPlan plan = surface->plan(options.tolerance, Illumination::diffuse);
  const LightModel light{plan.polarization ? Polarization::full : Polarization::none, plan.max_bounces};
  if (options.effects.explain)
    return {at, surface->index(), light, {std::nan(""), plan.bounds.total(), 0}, plan};
  return {at, surface->index(), light, surface->bihemispherical(plan), plan};
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

std::vector<Row> computed_rows(const TableOptions& options,
                               const std::vector<SurfaceAtWavelength>& surfaces) {
  std::vector<std::optional<Row>> computed_ones(surfaces.size());
  Progress progress(surfaces.size());
  tbb::parallel_for(std::size_t{0}, surfaces.size(), [&](std::size_t i) {
    computed_ones[i] =
        options.effects.automatic ? planned(options, surfaces[i]) : computed(options, surfaces[i]);
    progress.advance();
  });
  std::vector<Row> rows;
  for (std::optional<Row>& row : computed_ones) rows.push_back(std::move(*row));
  return rows;
}

/// Which row a plan belongs to.
std::string plan_in_words(const Row& row) {
  return material_of(row.at.surface) + ", " + exact(row.at.wavelength_nm) + " nm, " +
         in_words(row.at.surface) + ": " + in_words(*row.plan);
}

void add_row(Report& report, const Row& row) {
  ReportRow& line = report.add_row();
  line.add_fields(fields_of(row.at.surface)).add("wavelength_nm", row.at.wavelength_nm);
  if (row.index) line.add("n", row.index->n).add("k", row.index->k);
  line.add("polarization", name_of(row.light.polarization));
  if (row.light.max_bounces == all_bounces)
    line.add_null("max_bounces", "all");
  else
    line.add("max_bounces", row.light.max_bounces);
  line.add("reflectance", row.reflectance.value, trusted(row.reflectance))
      .add("error_estimate", row.reflectance.error, with_digits(row.reflectance.error, 2))
      .add("fresnel_evaluations", row.reflectance.evaluations);
  if (row.plan) line.add_to_json("plan", json_of(*row.plan));
}

/// Where the error of a row exceeds the tolerance, or is no number: one line for the row.
std::vector<std::string> broken_promises(const TableOptions& options, const std::vector<Row>& rows) {
  std::vector<std::string> lines;
  for (const Row& row : rows)
    if (!(row.reflectance.error <= options.tolerance) || !std::isfinite(row.reflectance.value))
      lines.push_back(row.at.surface.material.name() + ", " + exact(row.at.wavelength_nm) + " nm, " +
                      in_words(row.at.surface) + ": the error may reach " +
                      with_digits(row.reflectance.error, 2) + ", more than the tolerance of " +
                      exact(options.tolerance));
  return lines;
}

void draw(const std::vector<Row>& rows, const std::string& path) {
  std::vector<PlottedRow> points;
  for (const Row& row : rows) {
    points.push_back({fields_of(row.at.surface), row.reflectance.value});
    points.back().fields["wavelength_nm"] = row.at.wavelength_nm;
  }
  AtomicFile file(path);
  write_plot(file, plot_of(points, "bi-hemispherical reflectance"));
  file.commit();
}

void run_table(const TableOptions& options) {
  const std::vector<Row> rows = computed_rows(options, surfaces_at(options.surfaces, options.wavelengths_nm));
  if (options.effects.explain) {
    for (const Row& row : rows) std::cout << plan_in_words(row) << '\n';
    return;
  }
  if (!options.plot.empty()) draw(rows, options.plot);
  Report report;
  report.title = "Bi-hemispherical reflectance of V-grooves";
  std::vector<Material> materials;
  for (const Row& row : rows)
    for (const Material& material : materials_of(row.at.surface)) materials.push_back(material);
  tell_origin(report, materials);
  for (const Row& row : rows) report.tell(albedo_in_words(row.at.surface));
  for (const Row& row : rows) {
    add_row(report, row);
    if (!row.plan) continue;
    report.provenance.push_back(plan_in_words(row));
    report.notes.push_back(plan_in_words(row));
  }
  std::cout << report.in(options.format);

  std::vector<std::string> broken = broken_promises(options, rows);
  if (broken.empty()) return;
  std::cout.flush();
  for (std::size_t i = 0; i + 1 < broken.size(); ++i) std::cerr << "vcavity_maps: " << broken[i] << '\n';
  throw std::runtime_error(broken.back());
}

}  // namespace

void add_table_command(CLI::App& program) {
  auto options = std::make_shared<TableOptions>();
  CLI::App* command =
      program.add_subcommand("table", "bi-hemispherical reflectance of grooves, every combination a row");
  add_surface_options(*command, options->surfaces);
  add_wavelengths(*command, options->wavelengths_nm);
  add_polarization(*command, options->light.polarization);
  add_max_bounces(*command, options->light.max_bounces);
  add_effects(*command, options->effects);
  add_number(*command, "--tolerance", options->tolerance, tolerance_range,
             "absolute error of the reflectance to aim at, above 1e-15 and below 1 (default 1e-10)")
      ->type_name("T");
  add_format(*command, options->format);
  add_picture(*command, "--plot", options->plot,
              "also draw the reflectance over the number that changes most often, such as the aperture");
  command->callback([options] { run_table(*options); });
}

}  // namespace vcavity::tools
