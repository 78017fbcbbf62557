// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cost/cost_report.hpp"

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/text_table.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/output/plot.hpp"
#include "tools/provenance.hpp"

namespace vcavity::tools {
namespace {

struct CostOptions {
  std::string material;
  double aperture_deg = 0;
  double wavelength_nm = default_wavelength_nm;
  Format format = Format::md;
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

TextTable table_of(const CostSection& section) {
  TextTable table{{"method", "setting", "error", "time", "evaluations"}, {}};
  if (compares(section)) table.heading.push_back("speed-up");
  for (const Measurement& row : section.rows) {
    table.rows.push_back({row.method, row.setting, with_digits(row.error, 2), in_seconds(row.seconds),
                          row.evaluations > 0 ? std::to_string(row.evaluations) : ""});
    if (compares(section)) table.rows.back().push_back(speed_up(section, row));
  }
  return table;
}

void print_markdown(const std::vector<CostSection>& sections, const std::string& what) {
  std::cout << "What accuracy costs: " << what << "\n";
  for (const CostSection& section : sections) {
    std::cout << "\n"
              << section.title << " (error: " << section.error << ")\n\n"
              << to_markdown(table_of(section));
    if (compares(section))
      std::cout
          << "\nSpeed-up: the time of the midpoint rule for the same error, extrapolated along its slope, "
             "over this time.\n";
  }
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
  plot.footnote = what + ". Errors below 1e-16, the rounding of the result, are drawn there.";
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

void run_cost(const CostOptions& options) {
  const Material material = load_material(options.material);
  const RefractiveIndex index = material.at(options.wavelength_nm);
  std::vector<CostSection> sections{
      cost_of_integrals(options.aperture_deg, index), cost_of_effects(options.aperture_deg, index),
      cost_of_map(options.aperture_deg, index), cost_of_polarization(options.aperture_deg, index)};
  if (CostSection wavelengths = cost_of_wavelengths(options.aperture_deg, material);
      !wavelengths.rows.empty())
    sections.push_back(std::move(wavelengths));

  std::string what = in_one_line(material);
  what.append(", n = ").append(exact(index.n)).append(", k = ").append(exact(index.k));
  what.append(", aperture ").append(exact(options.aperture_deg)).append("°");
  if (!options.plot.empty()) {
    AtomicFile file(options.plot);
    write_plot(file, plot_of(sections.front(), what));
    file.commit();
  }
  if (options.format == Format::json) {
    print_json(sections, {{"material", material.name()},
                          {"source", material.reference()},
                          {"software", software()},
                          {"command", command_line()},
                          {"aperture_deg", options.aperture_deg},
                          {"wavelength_nm", options.wavelength_nm},
                          {"n", index.n},
                          {"k", index.k}});
  } else if (options.format == Format::csv) {
    print_csv(sections, provenance_lines(material));
  } else {
    print_markdown(sections, what);
  }
}

}  // namespace

void add_cost_command(CLI::App& program) {
  auto options = std::make_shared<CostOptions>();
  CLI::App* command = program.add_subcommand("cost", "what accuracy costs in time, measured on this machine");
  add_material(*command, options->material);
  add_number(*command, "--aperture", options->aperture_deg, aperture_range_deg,
             "angle between the panels in degrees, above 0 to 180")
      ->type_name("DEG")
      ->required();
  add_number(*command, "--wavelength", options->wavelength_nm, wavelength_range_nm,
             "vacuum wavelength in nanometres (default 550)")
      ->type_name("NM");
  add_format(*command, options->format);
  command->add_option("--plot", options->plot, "also draw error against time")
      ->type_name("FILE.svg|FILE.png");
  command->callback([options] { run_cost(*options); });
}

}  // namespace vcavity::tools
