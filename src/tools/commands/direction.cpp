// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <vcavity/groove/reflectance.hpp>
#include <vcavity/polarization/absorbed_fields.hpp>
#include <vcavity/polarization/polarization.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/materials/facet.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

struct DirectionOptions {
  std::string material;
  double aperture_deg = 0;
  double theta_deg = 0;
  double phi_deg = 0;
  double wavelength_nm = default_wavelength_nm;
  std::optional<double> position;
  Polarization polarization = Polarization::none;
  Format format = Format::md;
};

/// What becomes of light: the part of unpolarised light that is reflected and, if it was asked for, the rest.
struct Reflected {
  double unpolarized;
  std::optional<Mueller<double>> mueller;
};

template <class Power>
Reflected reflected(const Power& reflectance) {
  if constexpr (std::is_same_v<Power, Mueller<double>>) {
    return {unpolarized(reflectance), reflectance};
  } else {
    return {unpolarized(reflectance), std::nullopt};
  }
}

struct Ray {
  double position;
  RayPath path;
  Reflected reflectance;
  Vec3<double> direction;
};

struct Result {
  RefractiveIndex index;
  Reflected reflectance;
  double absorptance;
  Lobes<double, Reflected> lobes;
  std::optional<Ray> ray;
};

template <class Facet>
Result follow(const DirectionOptions& options, const RefractiveIndex& index, const Cavity<double>& cavity,
              const Vec3<double>& e, const Facet& facet) {
  Result result{index,
                reflected(directional_reflectance(cavity, e, facet)),
                unpolarized(directional_absorptance(cavity, e, facet)),
                {},
                std::nullopt};
  for (const auto& lobe : lobes(cavity, e, facet))
    result.lobes.push_back(
        {lobe.first_panel, lobe.bounces, lobe.weight, reflected(power(lobe.throughput)), lobe.direction});
  if (options.position) {
    const RayPath path = ray_path(cavity, e, *options.position);
    result.ray = Ray{*options.position, path, reflected(ray_reflectance(cavity, e, path, facet)),
                     ray_exit_direction(cavity, e, path)};
  }
  return result;
}

Result compute(const DirectionOptions& options, const RefractiveIndex& index) {
  const Cavity<double> cavity(radians(options.aperture_deg));
  Vec3<double> e = direction(radians(options.theta_deg), radians(options.phi_deg));
  if (options.theta_deg == 90) e.z = 0;  // cos(π/2) is not 0 in floating point
  return with_facet(index, [&](const auto& facet) {
    return with_polarization(options.polarization, facet,
                             [&](const auto& model) { return follow(options, index, cavity, e, model); });
  });
}

nlohmann::ordered_json json_of(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}

// The rows of a matrix, if there is one.
void add_mueller(nlohmann::ordered_json& json, const Reflected& light) {
  if (!light.mueller) return;
  json["mueller"] = nlohmann::ordered_json::array();
  for (std::size_t row = 0; row < 4; ++row) {
    const auto element = [&](std::size_t column) { return (*light.mueller)(row, column); };
    json["mueller"].push_back({element(0), element(1), element(2), element(3)});
  }
}

void print_json(const DirectionOptions& options, const Material& material, const Result& result) {
  nlohmann::ordered_json json{{"material", material.name()},
                              {"source", material.reference()},
                              {"software", software()},
                              {"command", command_line()},
                              {"aperture_deg", options.aperture_deg},
                              {"theta_deg", options.theta_deg},
                              {"phi_deg", options.phi_deg},
                              {"wavelength_nm", options.wavelength_nm},
                              {"n", result.index.n},
                              {"k", result.index.k},
                              {"polarization", name_of(options.polarization)},
                              {"reflectance", result.reflectance.unpolarized},
                              {"absorptance", result.absorptance}};
  add_mueller(json, result.reflectance);
  json["lobes"] = nlohmann::ordered_json::array();
  for (const auto& lobe : result.lobes) {
    nlohmann::ordered_json entry{{"first_panel", static_cast<int>(lobe.first_panel)},
                                 {"bounces", lobe.bounces},
                                 {"weight", lobe.weight},
                                 {"throughput", lobe.throughput.unpolarized},
                                 {"direction", json_of(lobe.direction)}};
    add_mueller(entry, lobe.throughput);
    if (lobe.throughput.mueller) entry["degree_of_polarization"] = polarizance(*lobe.throughput.mueller);
    json["lobes"].push_back(entry);
  }
  if (result.ray) {
    json["ray"] = {{"position", result.ray->position},
                   {"first_panel", static_cast<int>(result.ray->path.first_panel)},
                   {"bounces", result.ray->path.bounces},
                   {"reflectance", result.ray->reflectance.unpolarized},
                   {"direction", json_of(result.ray->direction)}};
    add_mueller(json["ray"], result.ray->reflectance);
  }
  std::cout << json.dump(2) << '\n';
}

void print_table(const DirectionOptions& options, const Material& material, const Result& result) {
  const bool markdown = options.format == Format::md;
  const auto number = [markdown](double x) { return markdown ? with_digits(x, 8) : exact(x); };
  TextTable table{{"light", "first_panel", "bounces", "weight", "throughput", "x", "y", "z"}, {}};
  for (const auto& lobe : result.lobes)
    table.rows.push_back({"lobe", std::to_string(static_cast<int>(lobe.first_panel)),
                          std::to_string(lobe.bounces), number(lobe.weight),
                          number(lobe.throughput.unpolarized), number(lobe.direction.x),
                          number(lobe.direction.y), number(lobe.direction.z)});
  if (result.ray)
    table.rows.push_back({"ray at " + exact(result.ray->position),
                          std::to_string(static_cast<int>(result.ray->path.first_panel)),
                          std::to_string(result.ray->path.bounces), "",
                          number(result.ray->reflectance.unpolarized), number(result.ray->direction.x),
                          number(result.ray->direction.y), number(result.ray->direction.z)});
  const std::string where = "aperture " + exact(options.aperture_deg) + "°, theta " +
                            exact(options.theta_deg) + "°, phi " + exact(options.phi_deg) +
                            "°, polarization " + name_of(options.polarization);
  if (markdown) {
    std::cout << "Light from one direction: " << in_one_line(material) << ", n = " << exact(result.index.n)
              << ", k = " << exact(result.index.k) << ", " << where << "\n\n"
              << "Directional reflectance " << number(result.reflectance.unpolarized) << ", absorptance "
              << number(result.absorptance) << "\n\n"
              << to_markdown(table);
    return;
  }
  std::vector<std::string> provenance = provenance_lines(material);
  provenance.push_back(where + ", wavelength " + exact(options.wavelength_nm) +
                       " nm, n = " + exact(result.index.n) + ", k = " + exact(result.index.k));
  provenance.push_back("reflectance " + number(result.reflectance.unpolarized) + ", absorptance " +
                       number(result.absorptance));
  std::cout << to_csv(table, provenance);
}

void run_direction(const DirectionOptions& options) {
  const Material material = load_material(options.material);
  const Result result = compute(options, material.at(options.wavelength_nm));
  if (options.format == Format::json) {
    print_json(options, material, result);
  } else {
    print_table(options, material, result);
  }
}

}  // namespace

void add_direction_command(CLI::App& program) {
  auto options = std::make_shared<DirectionOptions>();
  CLI::App* command = program.add_subcommand(
      "direction", "reflectance, lobes and, on request, a single ray of one direction");
  add_material(*command, options->material);
  add_aperture(*command, options->aperture_deg);
  add_number(*command, "--theta", options->theta_deg, theta_range_deg,
             "polar angle of the direction towards the light in degrees, 0 to 90")
      ->type_name("DEG")
      ->required();
  add_number(*command, "--phi", options->phi_deg, {-360, 360},
             "its azimuth in degrees, -360 to 360; 0 across the groove, 90 along it")
      ->type_name("DEG")
      ->required();
  add_wavelength(*command, options->wavelength_nm);
  add_number(*command, "--position", options->position, {-1, 1},
             "also follow the ray through this point of the opening, -1 to 1 across it")
      ->type_name("Y");
  add_polarization(*command, options->polarization);
  add_format(*command, options->format);
  command->callback([options] { run_direction(*options); });
}

}  // namespace vcavity::tools
