// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cost/cost_report.hpp"

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/surface_options.hpp"
#include "tools/images/plot.hpp"
#include "tools/images/progress.hpp"
#include "tools/materials/provenance.hpp"
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

/// Two digits, or a whole number where that is short.
std::string rounded(double value) {
  return value < 100 || value >= 1e5 ? with_digits(value, 2) : with_decimals(value, 0);
}

std::string in_seconds(double seconds) {
  const auto scaled = [seconds](double unit, const char* name) {
    return rounded(seconds / unit).append(" ").append(name);
  };
  if (seconds < 1e-3) return scaled(1e-6, "us");
  if (seconds < 1) return scaled(1e-3, "ms");
  return scaled(1, "s");
}

/// How much sooner than the first method of its section; nothing for the first method itself.
std::string speed_up(const CostSection& section, const Measurement& row) {
  // An extrapolation beyond this says no more than "never".
  constexpr double most = 1e9;
  const double factor = seconds_of_first_method(section, row.error) / row.seconds;
  if (row.method == section.rows.front().method) return "";
  if (!(factor < most)) return "> 1e9";
  return rounded(factor);
}

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

/// One table of all sections; in the short one the rows that tell the story on one screen.
TextTable table_of(const std::vector<CostSection>& sections, Length length) {
  TextTable table{{"method", "setting", "error", "time", "speed-up", "evaluations"}, {}};
  for (const CostSection& section : sections) {
    table.rows.push_back({"**" + section.title + "**"});
    table.rows.back().resize(table.heading.size());
    for (const Measurement& row : length == Length::whole ? section.rows : extremes(section.rows))
      table.rows.push_back({row.method, row.setting, with_digits(row.error, 2), in_seconds(row.seconds),
                            compares(section) ? speed_up(section, row) : "",
                            row.evaluations > 0 ? std::to_string(row.evaluations) : ""});
  }
  return table;
}

void print_markdown(const std::vector<CostSection>& sections, const Material& material,
                    const std::string& groove, Length length) {
  std::cout << "What accuracy costs: " << material.name() << ", " << groove << "\n\n"
            << to_markdown(table_of(sections, length)) << '\n';
  for (const CostSection& section : sections)
    std::cout << "- " << section.title << ": " << section.error << '\n';
  std::cout << "- speed-up: over the midpoint rule, its time extrapolated to the same error\n";
  std::cout << "- " << in_one_line(material) << '\n';
  if (length == Length::one_screen)
    std::cout << "- first and last setting of each method; --all shows every one\n";
}

void print_csv(const std::vector<CostSection>& sections, std::vector<std::string> provenance) {
  TextTable table{{"section", "method", "setting", "error", "seconds", "evaluations"}, {}};
  for (const CostSection& section : sections) {
    provenance.push_back(section.title + ": " + section.error);
    for (const Measurement& row : section.rows)
      table.rows.push_back({section.title, row.method, row.setting, exact(row.error), exact(row.seconds),
                            std::to_string(row.evaluations)});
  }
  std::cout << to_csv(table, provenance);
}

void print_json(const std::vector<CostSection>& sections, nlohmann::ordered_json json) {
  json["sections"] = nlohmann::ordered_json::array();
  for (const CostSection& section : sections) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Measurement& row : section.rows)
      rows.push_back({{"method", row.method},
                      {"setting", row.setting},
                      {"error", row.error},
                      {"seconds", row.seconds},
                      {"evaluations", row.evaluations}});
    json["sections"].push_back({{"title", section.title}, {"error", section.error}, {"rows", rows}});
  }
  std::cout << json.dump(2) << '\n';
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
  if (options.format == Format::json) {
    nlohmann::ordered_json about = fields_of(surface);
    about.update({{"source", material.reference()}, {"software", software()}, {"command", command_line()}});
    about.update({{"wavelength_nm", options.wavelength_nm}, {"n", index.n}, {"k", index.k}});
    print_json(sections, about);
  } else if (options.format == Format::csv) {
    print_csv(sections, provenance_lines(material));
  } else {
    print_markdown(sections, material, groove, options.length);
  }
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
