// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cost/cost_report.hpp"

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/surface_options.hpp"
#include "tools/cost/brdf_cost.hpp"
#include "tools/images/plot.hpp"
#include "tools/images/progress.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/report.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

/// How much of the table is printed.
enum class Length { one_screen, whole };

struct CostOptions {
  SurfaceOptions surfaces;
  double wavelength_nm = default_wavelength_nm;
  Format format = Format::md;
  Length length = Length::one_screen;
  std::string plot;
};

/// Whether other methods of a section are compared with its first one.
bool compares(const CostSection& section) {
  return section.rows.front().method == "the paper's midpoint rule";
}

/// The first and the last setting of each method: what it costs to begin with, and what it comes to.
std::vector<Measurement> extremes(const std::vector<Measurement>& rows) {
  std::vector<Measurement> result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool first = i == 0 || rows[i - 1].method != rows[i].method;
    const bool last = i + 1 == rows.size() || rows[i + 1].method != rows[i].method;
    if (first || last) result.push_back(rows[i]);
  }
  return result;
}

/// How much sooner than the first method of its section; that one has no such cell.
void add_speed_up(ReportRow& line, const CostSection& section, const Measurement& row) {
  // An extrapolation beyond this says no more than "never".
  constexpr double most = 1e9;
  if (!compares(section) || row.method == section.rows.front().method) return;
  const double factor = seconds_of_first_method(section, row.error) / row.seconds;
  if (factor < most)
    line.add("speed_up", factor, with_digits(factor, 2));
  else
    line.add_null("speed_up", "> 1e9");
}

/// All sections; in the short one the rows that tell the story on one screen.
Report report_of(const std::vector<CostSection>& sections, Length length) {
  Report report;
  for (const CostSection& section : sections) {
    report.begin_section(section.title, {{"error", section.error}});
    for (const Measurement& row : length == Length::whole ? section.rows : extremes(section.rows)) {
      ReportRow& line = report.add_row();
      line.add("method", row.method)
          .add("setting", row.setting)
          .add("error", row.error, with_digits(row.error, 2))
          .add("seconds", row.seconds, with_digits(row.seconds, 2));
      add_speed_up(line, section, row);
      line.add("evaluations", row.evaluations, row.evaluations > 0 ? "" : "-");
    }
    report.tell(section.title + ": " + section.error);
  }
  return report;
}

/// Error against time, one line for each method.
Plot plot_of(const CostSection& section, const std::string& what) {
  // Errors below the rounding of the value are all the same.
  constexpr double rounding = 1e-16;
  Plot plot;
  plot.title = section.title + ": error against time";
  plot.x = {"time in seconds, median of repeats", Axis::Scale::logarithmic, std::nullopt};
  plot.y = {section.error, Axis::Scale::logarithmic, std::nullopt};
  plot.footnote = what + ". Errors below 1e-16, the rounding of the result, are drawn there. " + software() +
                  ", " + command_line();
  for (const Measurement& row : section.rows) {
    if (plot.series.empty() || plot.series.back().name != row.method)
      plot.series.push_back({row.method, {}, {}});
    plot.series.back().x.push_back(row.seconds);
    plot.series.back().y.push_back(std::max(row.error, rounding));
  }
  for (Series& series : plot.series) {
    std::string slope = with_digits(-convergence_exponent(section, series.name), 2);
    series.name.append(" (slope ").append(slope).append(")");
  }
  return plot;
}

/// What can be asked of a surface, of a bare symmetric groove how other methods do; with progress while it is measured.
std::vector<CostSection> sections_of(const SurfaceDescription& surface, double wavelength_nm) {
  std::vector<CostSection> sections;
  const bool bare = is_bare_symmetric_groove(surface);
  const bool polarizes = !surface.albedos;  // an albedo says nothing of polarised light
  // The integrals of a rough surface are integrals of integrals: to the last digits they would take an hour.
  if (surface.roughness && surface.films.empty()) return costs_of_brdf(surface, wavelength_nm);
  Progress progress(bare ? 5 : polarizes ? 2 : 1);
  const auto add = [&](CostSection section) {
    if (!section.rows.empty()) sections.push_back(std::move(section));
    progress.advance();
  };
  if (!bare) {
    add(cost_of_surface(surface, wavelength_nm));
    if (polarizes) add(cost_of_polarization(surface, wavelength_nm));
    return sections;
  }
  const RefractiveIndex index = surface.material.at(wavelength_nm);
  add(cost_of_integrals(surface.aperture_deg, index));
  add(cost_of_effects(surface.aperture_deg, index));
  add(cost_of_map(surface.aperture_deg, index));
  add(cost_of_polarization(surface.aperture_deg, index));
  add(cost_of_wavelengths(surface.aperture_deg, surface.material));
  return sections;
}

void run_cost(const CostOptions& options) {
  const std::vector<SurfaceDescription> surfaces = surfaces_of(options.surfaces);
  if (surfaces.size() != 1)
    throw UsageError("cost: measures one surface, expected no list or range of " +
                     std::to_string(surfaces.size()));
  const SurfaceDescription& surface = surfaces.front();
  const Material& material = surface.material;
  const RefractiveIndex index = material.at(options.wavelength_nm);
  const std::vector<CostSection> sections = sections_of(surface, options.wavelength_nm);

  const std::string groove = "n = " + exact(index.n) + ", k = " + exact(index.k) + ", " + in_words(surface);
  if (!options.plot.empty()) {
    AtomicFile file(options.plot);
    write_plot(file, plot_of(sections.front(), in_one_line(material) + ", " + groove));
    file.commit();
  }
  const Length length = options.format == Format::md ? options.length : Length::whole;
  Report report = report_of(sections, length);
  report.title = "What accuracy costs: " + material.name() + ", " + groove;
  if (compares(sections.front()))
    report.tell("speed_up: over the midpoint rule, its time extrapolated to the same error");
  if (length == Length::one_screen)
    report.notes.push_back("first and last setting of each method; --all shows every one");
  report.notes.push_back(in_one_line(material));
  const std::vector<std::string> origin = provenance_lines(material);
  report.provenance.insert(report.provenance.begin(), origin.begin(), origin.end());
  report.head = fields_of(surface);
  report.head.update({{"source", material.reference()},
                      {"software", software()},
                      {"command", command_line()},
                      {"wavelength_nm", options.wavelength_nm},
                      {"n", index.n},
                      {"k", index.k}});
  std::cout << report.in(options.format);
}

}  // namespace

void add_cost_command(CLI::App& program) {
  auto options = std::make_shared<CostOptions>();
  CLI::App* command = program.add_subcommand("cost", "what accuracy costs in time, measured on this machine");
  add_surface_options(*command, options->surfaces);
  add_wavelength(*command, options->wavelength_nm);
  add_format(*command, options->format);
  command->add_flag_callback(
      "--all", [options] { options->length = Length::whole; },
      "print every setting of each method; csv and json always do");
  add_picture(*command, "--plot", options->plot, "also draw error against time");
  command->callback([options] { run_cost(*options); });
}

}  // namespace vcavity::tools
