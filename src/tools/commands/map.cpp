// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <optional>
#include <utility>
#include <vcavity/lobes.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/disc_map.hpp"
#include "tools/error.hpp"
#include "tools/map_plan.hpp"
#include "tools/materials/catalogue.hpp"

namespace vcavity::tools {
namespace {

// An error, or a colour difference.
constexpr Interval tolerance_range{0, 100, Interval::Ends::open_low};

struct MapOptions {
  std::string material;
  double aperture_deg = 0;
  int size = 512;
  std::optional<double> wavelength_nm;
  std::vector<double> wavelengths_nm;
  Quantity quantity = Quantity::reflectance;
  Polarization polarization = Polarization::none;
  EffectsOptions effects;
  double tolerance = 1e-3;
  std::string environment;
  int most_bounces = all_bounces;
  std::string out;
};

void run_map(const MapOptions& options) {
  if ((options.quantity == Quantity::bounces || options.quantity == Quantity::absorptance) &&
      options.most_bounces != all_bounces)
    throw UsageError("--max-bounces: limits the reflectance, not --quantity bounces or absorptance");
  std::vector<double> wavelengths_nm = options.wavelengths_nm;
  if (wavelengths_nm.empty()) wavelengths_nm.push_back(options.wavelength_nm.value_or(default_wavelength_nm));

  MapRequest request{load_material(options.material),
                     options.aperture_deg,
                     wavelengths_nm,
                     options.size,
                     options.most_bounces,
                     options.quantity,
                     Spectrum::written,
                     options.polarization};
  if (!options.environment.empty()) {
    if (options.quantity != Quantity::reflectance)
      throw UsageError("--environment: shows the light it casts, not --quantity");
    if (!options.wavelength_nm) request.wavelengths_nm = {610, 550, 465};
    request.environment = std::make_shared<const Environment>(options.environment);
  }
  if (options.effects.automatic) {
    MapPlan plan = plan_map(std::move(request), options.tolerance);
    std::cout << plan.explanation << '\n';
    if (options.effects.explain) return;
    request = std::move(plan.request);
  }
  const DiscMapper mapper(std::move(request));
  AtomicFile file(options.out);
  Progress progress(static_cast<std::uint64_t>(options.size));
  write_map(file, mapper, progress);
  file.commit();
}

}  // namespace

void add_map_command(CLI::App& program) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command = program.add_subcommand(
      "map", "OpenEXR image of a quantity for every direction, on the disc of the equal-area projection");
  add_material(*command, options->material);
  add_number(*command, "--aperture", options->aperture_deg, aperture_range_deg,
             "angle between the panels in degrees, above 0 to 180")
      ->type_name("DEG")
      ->required();
  add_count(*command, "--size", options->size, 1, largest_map, "pixels along one side (default 512)")
      ->type_name("N");
  CLI::Option* single = add_number(*command, "--wavelength", options->wavelength_nm, wavelength_range_nm,
                                   "one vacuum wavelength in nanometres (default 550); channel Y");
  single->type_name("NM");
  command
      ->add_option_function<std::string>(
          "--wavelengths",
          [options](const std::string& words) {
            options->wavelengths_nm = checked_range(words, "--wavelengths", wavelength_range_nm);
            if (options->wavelengths_nm.size() < 2)
              throw UsageError("--wavelengths: '" + words +
                               "' is a single wavelength, for which there is --wavelength");
          },
          "a grid of vacuum wavelengths in nanometres; channels R, G, B and one for each wavelength")
      ->type_name("LO:HI:STEP")
      ->excludes(single);
  add_choice(*command, "--quantity", options->quantity,
             {{"reflectance", Quantity::reflectance},
              {"bounces", Quantity::bounces},
              {"dop", Quantity::degree_of_polarization},
              {"absorptance", Quantity::absorptance}},
             "reflectance, bounces, dop (degree of polarisation) or absorptance (default reflectance)")
      ->type_name("QUANTITY");
  add_polarization(*command, options->polarization);
  add_max_bounces(*command, options->most_bounces);
  add_effects(*command, options->effects);
  add_number(
      *command, "--tolerance", options->tolerance, tolerance_range,
      "largest error of --effects auto (default 0.001): absolute in the reflectance, CIEDE2000 for a grid "
      "of wavelengths")
      ->type_name("T")
      ->needs("--effects");
  command
      ->add_option(
          "--environment", options->environment,
          "show how the groove reflects this latitude-longitude OpenEXR image: zenith at the top, +y "
          "(across the groove) in the middle, +x to the right of it; unless --wavelength is given, R, "
          "G and B are taken at 610, 550 and 465 nm")
      ->type_name("SKY.exr")
      ->excludes("--wavelengths")
      ->excludes("--effects");
  command->add_option("--out", options->out, "the OpenEXR file to write")->type_name("FILE.exr")->required();
  command->callback([options] { run_map(*options); });
}

}  // namespace vcavity::tools
