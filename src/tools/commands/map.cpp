// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>
#include <vcavity/groove/lobes.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/surface_options.hpp"
#include "tools/maps/disc_map.hpp"
#include "tools/maps/map_picture.hpp"
#include "tools/maps/map_plan.hpp"
#include "tools/maps/sweep.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

// An error, or a colour difference.
constexpr Interval tolerance_range{0, 100, Interval::Ends::open_low};
constexpr double default_tolerance = 1e-3;

struct MapOptions {
  SurfaceOptions surfaces;
  int size = 512;
  std::vector<double> wavelength_nm;   // each a map of its own
  std::vector<double> wavelengths_nm;  // all in one map
  Quantity quantity = Quantity::reflectance;
  Polarization polarization = Polarization::none;
  EffectsOptions effects;
  std::optional<double> tolerance;
  std::string environment;
  int max_bounces = all_bounces;
  std::optional<double> theta_deg, phi_deg;  // of the light, for a map of the BRDF
  Viewing viewing;
  std::string out;
  Storage storage;
  bool skip_existing = false;
  std::string picture;
  PictureStyle style;
};

void check(const MapOptions& options) {
  if ((options.quantity == Quantity::bounces || options.quantity == Quantity::absorptance) &&
      options.max_bounces != all_bounces)
    throw UsageError("--max-bounces: limits the reflectance, not --quantity bounces or absorptance");
  if (!options.environment.empty() && options.quantity != Quantity::reflectance)
    throw UsageError("--environment: shows the light it casts, not --quantity");
  if (options.theta_deg && (options.quantity != Quantity::reflectance || !options.environment.empty()))
    throw UsageError("--theta: maps the BRDF, not --quantity or --environment");
  if (options.out.empty() && options.picture.empty() && !options.effects.explain)
    throw UsageError("--out or --png is required");
}

/// The wavelengths of each map.
std::vector<std::vector<double>> wavelengths_of_maps(const MapOptions& options) {
  if (!options.wavelengths_nm.empty()) return {options.wavelengths_nm};
  std::vector<std::vector<double>> result;
  for (const double wavelength_nm : options.wavelength_nm) result.push_back({wavelength_nm});
  if (!result.empty()) return result;
  if (!options.environment.empty()) return {{610, 550, 465}};  // of R, G and B
  return {{default_wavelength_nm}};
}

/// Every surface at every wavelength. All of them can be computed.
std::vector<MapRequest> combinations(const MapOptions& options) {
  const std::vector<SurfaceDescription> surfaces = surfaces_of(options.surfaces);
  MapRequest request{
      surfaces.front(),    {}, options.size, options.max_bounces, options.quantity, Spectrum::written,
      options.polarization};
  request.viewing = options.viewing;
  if (!options.environment.empty())
    request.environment = std::make_shared<const Environment>(options.environment);
  if (options.theta_deg) request.light = DirectionDeg{*options.theta_deg, *options.phi_deg};
  std::vector<MapRequest> requests;
  for (const SurfaceDescription& surface : surfaces)
    for (const std::vector<double>& wavelengths_nm : wavelengths_of_maps(options)) {
      request.surface = surface;
      request.wavelengths_nm = wavelengths_nm;
      DiscMapper{request};  // throws what is wrong before the long work
      requests.push_back(request);
    }
  return requests;
}

/// Replaces each map by the cheapest one within the tolerance and says why.
void plan(std::vector<MapRequest>& requests, const MapOptions& options) {
  for (MapRequest& request : requests) {
    MapPlan planned = options.effects.automatic
                          ? plan_map(std::move(request), options.tolerance.value_or(default_tolerance))
                          : plan_precision(std::move(request), *options.tolerance, options.storage.number);
    std::cout << planned.explanation << '\n';
    request = std::move(planned.request);
  }
}

void run_map(const MapOptions& options) {
  check(options);
  std::vector<MapRequest> requests = combinations(options);
  if (options.effects.automatic || options.tolerance) plan(requests, options);
  if (options.effects.explain) return;
  const bool with_picture = !options.picture.empty();
  if (with_picture && requests.size() > most_discs)
    throw UsageError("--png: " + std::to_string(requests.size()) + " maps do not fit on a page, at most " +
                     std::to_string(most_discs) + " do");
  std::vector<MapFile> maps;
  if (!options.out.empty()) maps = name_map_files(requests, options.out);
  if (options.skip_existing) leave_out_finished(maps, options.storage);

  Progress progress(static_cast<std::uint64_t>(options.size) * maps.size() +
                    static_cast<std::uint64_t>(picture_size) * (with_picture ? requests.size() : 0));
  std::optional<AtomicFile> picture;
  if (with_picture) picture.emplace(options.picture);  // tells in time if it cannot be written
  write_maps(maps, options.storage, progress);
  if (!picture) return;
  write_sheet(*picture, map_sheet(requests, options.style, progress));
  picture->commit();
}

void add_colour_options(CLI::App& command, Viewing& viewing, CLI::Option* grid) {
  command
      .add_option("--illuminant", viewing.light,
                  "the light for R, G, B: one of the CIE, or a file with a wavelength in nm and a power in "
                  "every line (default d65)")
      ->type_name("d65|e|a|FILE")
      ->needs(grid);
  add_choice(command, "--observer", viewing.observer,
             {{"2", Observer::cie_1931_2deg}, {"10", Observer::cie_1964_10deg}},
             "whose eye sees R, G, B: the CIE observer of 2 (1931) or 10 (1964) degrees (default 2)")
      ->needs(grid);
  add_choice(command, "--rgb", viewing.rgb, {{"srgb", RgbSpace::srgb}, {"rec2020", RgbSpace::rec2020}},
             "primaries of R, G, B, which stay linear (default srgb)")
      ->needs(grid);
}

void add_storage_options(CLI::App& command, Storage& storage) {
  add_choice(command, "--precision", storage.number,
             {{"float", ExrNumber::float32}, {"half", ExrNumber::float16}},
             "numbers of the EXR: float (32 bits) or half (16 bits; 3 digits) (default float)");
  add_choice(command, "--compression", storage.compression,
             {{"none", ExrCompression::none},
              {"rle", ExrCompression::rle},
              {"zips", ExrCompression::zips},
              {"zip", ExrCompression::zip},
              {"piz", ExrCompression::piz}},
             "of the EXR, all without loss (default piz, the fastest)");
}

void add_picture_options(CLI::App& command, std::string& file, PictureStyle& style) {
  CLI::Option* picture = add_picture(command, "--png", file, "also draw all maps on one page for people");
  command
      .add_flag_callback(
          "--false-color", [&style] { style.tone = PictureStyle::Tone::false_colour; },
          "on the page: numbers in a perceptually uniform colour map, not what the eye would see")
      ->needs(picture);
  command
      .add_flag_callback(
          "--contours", [&style] { style.contours = PictureStyle::Contours::shown; },
          "on the page: lines where the number of bounces changes")
      ->needs(picture);
}

}  // namespace

void add_map_command(CLI::App& program) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command = program.add_subcommand(
      "map", "OpenEXR images of a quantity for every direction, on the disc of the equal-area projection");
  add_surface_options(*command, options->surfaces);
  add_count(*command, "--size", options->size, 1, largest_map, "pixels along one side (default 512)")
      ->type_name("N");
  CLI::Option* single = add_wavelengths(*command, options->wavelength_nm);
  CLI::Option* grid = command->add_option_function<std::string>(
      "--wavelengths",
      [options](const std::string& words) {
        options->wavelengths_nm = checked_range(words, "--wavelengths", wavelength_range_nm);
        if (options->wavelengths_nm.size() < 2)
          throw UsageError("--wavelengths: '" + words +
                           "' is a single wavelength, for which there is --wavelength");
      },
      "a grid of vacuum wavelengths in nanometres in one map; channels R, G, B and one for each wavelength");
  grid->type_name("LO:HI:STEP")->excludes(single);
  add_choice(*command, "--quantity", options->quantity,
             {{"reflectance", Quantity::reflectance},
              {"bounces", Quantity::bounces},
              {"dop", Quantity::degree_of_polarization},
              {"absorptance", Quantity::absorptance}},
             "what the map shows; dop is the degree of polarisation (default reflectance)");
  CLI::Option* theta =
      add_number(
          *command, "--theta", options->theta_deg, theta_range_deg,
          "with --phi, map the BRDF of a surface that scatters light, lit from this polar angle in degrees")
          ->type_name("DEG");
  CLI::Option* phi =
      add_number(*command, "--phi", options->phi_deg, azimuth_range_deg, "azimuth of that light in degrees")
          ->type_name("DEG")
          ->needs(theta);
  theta->needs(phi);
  add_polarization(*command, options->polarization);
  add_max_bounces(*command, options->max_bounces);
  add_colour_options(*command, options->viewing, grid);
  command
      ->add_option("--out", options->out,
                   "the OpenEXR file to write; for several maps a folder, where each becomes "
                   "MATERIAL_APERTUREdeg_WAVELENGTHnm.exr")
      ->type_name("FILE.exr|DIR");
  command->add_flag("--skip-existing", options->skip_existing,
                    "leave out maps whose file exists and was made with the same options, data and version, "
                    "to resume an interrupted run; other files are replaced");
  add_storage_options(*command, options->storage);
  add_picture_options(*command, options->picture, options->style);
  add_effects(*command, options->effects);
  add_number(
      *command, "--tolerance", options->tolerance, tolerance_range,
      "largest error: with --effects auto of everything left out (default 0.001), CIEDE2000 for a grid of "
      "wavelengths; alone, of rounding: float where that is enough. Absolute in the reflectance")
      ->type_name("T");
  command
      ->add_option(
          "--environment", options->environment,
          "show how the groove reflects this latitude-longitude OpenEXR image: zenith at the top, +y "
          "(across the groove) in the middle, +x to the right of it; unless --wavelength is given, R, "
          "G and B are taken at 610, 550 and 465 nm")
      ->type_name("SKY.exr")
      ->excludes("--wavelengths")
      ->excludes("--effects")
      ->excludes("--tolerance");
  command->callback([options] { run_map(*options); });
}

}  // namespace vcavity::tools
