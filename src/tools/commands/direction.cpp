// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vcavity/conventions.hpp>
#include <vcavity/groove/lobes.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/direction_plot.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/surface_options.hpp"
#include "tools/images/atomic_file.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/report.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

using Json = nlohmann::ordered_json;

struct DirectionOptions {
  SurfaceOptions surfaces;
  std::vector<double> thetas_deg;
  std::vector<double> phis_deg;
  std::vector<double> wavelengths_nm{default_wavelength_nm};
  std::vector<double> positions;
  std::vector<double> toward_deg;  // θ and φ, or empty
  Polarization polarization = Polarization::none;
  Format format = Format::md;
  std::string plot;  // empty: none
};

/// A direction on the hemisphere, at θ = 90° exactly on the horizon: cos(π/2) is not 0 in floating point.
Vec3<double> direction_at(double theta_deg, double phi_deg) {
  Vec3<double> e = direction(radians(theta_deg), radians(phi_deg));
  if (theta_deg == 90) e.z = 0;
  return e;
}

/// One question, and all there is to say about it.
struct Result {
  SurfaceAtWavelength at;
  double theta_deg;
  double phi_deg;
  Polarization polarization;
  std::optional<RefractiveIndex> index;
  Reflected reflectance;
  std::optional<double> absorptance;
  Json more;
  std::vector<SurfaceLobe> lobes;
  std::optional<SurfaceRay> ray;
  std::optional<SurfaceBrdf> brdf;
  double cos_toward = 0;
  std::map<int, double> by_bounces;
};

/// What is printed where a BRDF is infinite: null in JSON, for every element of a matrix too.
void make_infinite(Reflected& brdf) {
  brdf.unpolarized = std::numeric_limits<double>::infinity();
  if (brdf.mueller) brdf.mueller = std::numeric_limits<double>::quiet_NaN() * *brdf.mueller;
}

Result follow(const SurfaceAtWavelength& at, double theta_deg, double phi_deg, std::optional<double> position,
              const DirectionOptions& options) {
  const auto surface = make_surface(at.surface, at.wavelength_nm, {options.polarization, all_bounces});
  const Vec3<double> e = direction_at(theta_deg, phi_deg);
  Result result{at,
                theta_deg,
                phi_deg,
                options.polarization,
                surface->index(),
                surface->reflectance(e),
                surface->absorptance(e),
                surface->more_about(e),
                surface->lobes(e),
                std::nullopt,
                std::nullopt,
                0,
                {}};
  if (position) {
    result.ray = surface->ray(e, *position);
    if (!result.ray) throw UsageError("--position: no single ray can be followed on this surface");
  }
  if (options.toward_deg.empty()) {
    result.by_bounces = surface->by_bounces(e);
  } else {
    const Vec3<double> toward = direction_at(options.toward_deg[0], options.toward_deg[1]);
    result.brdf = surface->brdf(e, toward);
    if (!result.brdf) throw UsageError("--toward: a mirror has no BRDF; its lobes say where the light goes");
    if (std::isinf(result.brdf->error)) make_infinite(result.brdf->value);
    result.cos_toward = toward.z;
    result.by_bounces = surface->by_bounces(e, toward);
    for (auto& [bounces, part] : result.by_bounces) part *= toward.z;
  }
  return result;
}

std::vector<Result> results_of(const DirectionOptions& options) {
  std::vector<std::optional<double>> positions(options.positions.begin(), options.positions.end());
  if (positions.empty()) positions.emplace_back();
  std::vector<Result> results;
  for (const SurfaceAtWavelength& at : surfaces_at(options.surfaces, options.wavelengths_nm))
    for (const double theta_deg : options.thetas_deg)
      for (const double phi_deg : options.phis_deg)
        for (const std::optional<double>& position : positions)
          results.push_back(follow(at, theta_deg, phi_deg, position, options));
  return results;
}

Json json_of(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}

// The rows of a matrix, if there is one.
void add_mueller(Json& json, const Reflected& light) {
  if (!light.mueller) return;
  json["mueller"] = Json::array();
  for (std::size_t row = 0; row < 4; ++row) {
    const auto element = [&](std::size_t column) { return (*light.mueller)(row, column); };
    json["mueller"].push_back({element(0), element(1), element(2), element(3)});
  }
}

/// What was asked.
Json question(const Result& result) {
  Json json = fields_of(result.at.surface);
  json.update({{"theta_deg", result.theta_deg}, {"phi_deg", result.phi_deg}});
  json["wavelength_nm"] = result.at.wavelength_nm;
  if (result.index) json.update({{"n", result.index->n}, {"k", result.index->k}});
  json["polarization"] = name_of(result.polarization);
  return json;
}

/// The numbers for the whole direction.
Json totals(const Result& result) {
  Json json{{"reflectance", result.reflectance.unpolarized}};
  if (result.absorptance) json["absorptance"] = *result.absorptance;
  json.update(result.more);
  if (result.brdf) {
    json["brdf"] = result.brdf->value.unpolarized;
    json["brdf_cos"] = result.brdf->value.unpolarized * result.cos_toward;
    if (result.brdf->error > 0) json["error_estimate"] = result.brdf->error;
  }
  return json;
}

/// What light on one way has in common, be it a lobe or a ray; without its weight.
template <class Way>
Json way_of(const Way& way) {
  Json json = Json::object();
  if (way.first_panel) json["first_panel"] = static_cast<int>(*way.first_panel);
  if (!way.facets.empty()) json["facets"] = way.facets;
  json["bounces"] = way.bounces;
  return json;
}

Json json_of(const SurfaceLobe& lobe) {
  Json json = way_of(lobe);
  json.update({{"weight", lobe.weight}, {"throughput", lobe.throughput.unpolarized}});
  json["direction"] = json_of(lobe.direction);
  add_mueller(json, lobe.throughput);
  if (lobe.throughput.mueller) json["degree_of_polarization"] = polarizance(*lobe.throughput.mueller);
  return json;
}

Json json_of(const SurfaceRay& ray) {
  Json json{{"position", ray.position}};
  json.update(way_of(ray));
  json["reflectance"] = ray.reflectance.unpolarized;
  json["direction"] = json_of(ray.direction);
  add_mueller(json, ray.reflectance);
  return json;
}

/// The Mueller matrix of BRDF × cosine, as `brdf_cos` and `by_bounces`.
Reflected times(Reflected light, double factor) {
  light.unpolarized *= factor;
  if (light.mueller) light.mueller = factor * *light.mueller;
  return light;
}

Json json_of(const Result& result) {
  Json json = question(result);
  json.update(totals(result));
  add_mueller(json, result.brdf ? times(result.brdf->value, result.cos_toward) : result.reflectance);
  for (const auto& [bounces, part] : result.by_bounces) json["by_bounces"][std::to_string(bounces)] = part;
  if (!result.brdf) json["lobes"] = Json::array();
  for (const SurfaceLobe& lobe : result.lobes) json["lobes"].push_back(json_of(lobe));
  if (result.ray) json["ray"] = json_of(*result.ray);
  return json;
}

/// A cell of the tables with a number, of which Markdown shows eight digits.
void add_number(ReportRow& row, const std::string& column, double value) {
  row.add_to_tables(column, exact(value), with_digits(value, 8));
}

template <class Way>
void add_way(ReportRow& row, const std::string& light, const Way& way, std::optional<double> weight,
             const Reflected& throughput) {
  row.add_to_tables("light", light);
  row.add_to_tables("first_panel", way.first_panel ? std::to_string(static_cast<int>(*way.first_panel)) : "");
  if (!way.facets.empty()) row.add_to_tables("facets", way.facets);
  row.add_to_tables("bounces", std::to_string(way.bounces));
  if (weight)
    add_number(row, "weight", *weight);
  else
    row.add_to_tables("weight", "");
  add_number(row, "throughput", throughput.unpolarized);
  add_number(row, "x", way.direction.x);
  add_number(row, "y", way.direction.y);
  add_number(row, "z", way.direction.z);
}

std::string in_words(const Result& result) {
  std::string words = in_words(result.at.surface);
  words.append(", theta ").append(exact(result.theta_deg)).append("°");
  words.append(", phi ").append(exact(result.phi_deg)).append("°");
  return words.append(", polarization ").append(name_of(result.polarization));
}

/// Names and numbers of a JSON object, such as "reflectance 0.1, absorptance 0.9".
/// @param text writes a number
std::string listed(const Json& numbers, std::string (*text)(double)) {
  std::string words;
  for (const auto& [name, value] : numbers.items()) {
    const std::string number = value.is_number() ? text(value.get<double>()) : value.dump();
    words.append(words.empty() ? "" : ", ").append(name).append(" ").append(number);
  }
  return words;
}

std::string index_in_words(const std::optional<RefractiveIndex>& index) {
  return index ? ", n = " + exact(index->n) + ", k = " + exact(index->k) : "";
}

/// The rows of the tables for one direction.
/// @param leading whether they say first which direction that is
void add_rows(Report& report, const Result& result, bool leading) {
  // Where there are no ways to list, the direction itself is the row.
  const bool alone = result.lobes.empty() && !result.ray && result.by_bounces.empty();
  const auto new_row = [&]() -> ReportRow& {
    ReportRow& row = report.add_row();
    if (!leading && !alone) return row;
    for (const Json& fields : {question(result), totals(result)})
      for (const auto& [name, value] : fields.items()) {
        if (value.is_number_float())
          add_number(row, name, value.get<double>());
        else
          row.add_to_tables(name, text_of(value));
      }
    return row;
  };
  for (const SurfaceLobe& lobe : result.lobes) add_way(new_row(), "lobe", lobe, lobe.weight, lobe.throughput);
  if (result.ray)
    add_way(new_row(), "ray at " + exact(result.ray->position), *result.ray, std::nullopt,
            result.ray->reflectance);
  for (const auto& [bounces, part] : result.by_bounces) {
    ReportRow& row = new_row();
    row.add_to_tables("light", result.brdf ? "brdf_cos" : "reflectance");
    row.add_to_tables("bounces", std::to_string(bounces));
    add_number(row, "value", part);
  }
  if (alone) new_row();
}

/// Draws the way of the light of one direction.
void plot_direction(const Result& result, const std::vector<Material>& materials, AtomicFile& file) {
  const std::string title = grooves_in_words(result.at.surface) + ", light from theta " +
                            exact(result.theta_deg) + "°, phi " + exact(result.phi_deg) + "°";
  std::string footnote = in_words(result) + ", wavelength " + exact(result.at.wavelength_nm) +
                         " nm; directional " +
                         listed(totals(result), [](double x) { return with_digits(x, 6); }) + ". ";
  for (const Material& material : materials) footnote += in_one_line(material) + "; ";
  write_direction_plot(file, {result.at.surface, direction_at(result.theta_deg, result.phi_deg), result.lobes,
                              title, footnote + software() + ", " + command_line()});
}

void run_direction(const DirectionOptions& options) {
  std::optional<AtomicFile> picture;
  if (!options.plot.empty()) picture.emplace(options.plot);
  const std::vector<Result> results = results_of(options);
  if (picture && results.size() > 1)
    throw UsageError("--plot: shows one direction on one surface, expected no list or range");
  std::vector<Material> materials;
  for (const Result& result : results)
    for (const Material& material : materials_of(result.at.surface)) materials.push_back(material);

  if (picture) plot_direction(results.front(), materials, *picture);

  Report report;
  report.rows_name.clear();
  tell_origin(report, materials);
  for (const Result& result : results) report.tell(albedo_in_words(result.at.surface));
  if (results.size() == 1) {
    const Result& result = results.front();
    report.head.update(json_of(result));
    report.title = "Light from one direction: " + joined(report.notes, "; ") + index_in_words(result.index) +
                   ", " + in_words(result) + "\n\nDirectional " +
                   listed(totals(result), [](double x) { return with_digits(x, 8); });
    report.notes.clear();
    report.provenance.push_back(in_words(result) + ", wavelength " + exact(result.at.wavelength_nm) + " nm" +
                                index_in_words(result.index));
    report.provenance.push_back(listed(totals(result), exact));
  } else {
    report.title = "Light from several directions";
    report.head["rows"] = Json::array();
    for (const Result& result : results) report.head["rows"].push_back(json_of(result));
  }
  for (const Result& result : results) add_rows(report, result, results.size() > 1);
  std::cout << report.in(options.format);
  if (picture) picture->commit();
}

}  // namespace

void add_direction_command(CLI::App& program) {
  auto options = std::make_shared<DirectionOptions>();
  CLI::App* command = program.add_subcommand(
      "direction", "reflectance, lobes and, on request, a single ray of one direction or of several");
  add_surface_options(*command, options->surfaces);
  add_numbers(*command, "--theta", options->thetas_deg, theta_range_deg,
              "polar angles of the direction towards the light in degrees, 0 to 90")
      ->type_name("DEG[,DEG...]")
      ->required();
  add_numbers(*command, "--phi", options->phis_deg, azimuth_range_deg,
              "its azimuths in degrees, -360 to 360; 0 across the groove, 90 along it")
      ->type_name("DEG[,DEG...]")
      ->required();
  add_wavelengths(*command, options->wavelengths_nm);
  add_numbers(*command, "--position", options->positions, {-1, 1},
              "also follow the rays through these points of the opening, -1 to 1 across it")
      ->type_name("Y[,Y...]");
  add_direction(*command, "--toward", options->toward_deg,
                "also the BRDF towards a viewer in this direction, where the surface has one");
  add_picture(*command, "--plot", options->plot,
              "also draw the cross-section to scale with the way of the light, bounces numbered, and the "
              "lobes with their "
              "weights");
  add_polarization(*command, options->polarization);
  add_format(*command, options->format);
  command->callback([options] { run_direction(*options); });
}

}  // namespace vcavity::tools
