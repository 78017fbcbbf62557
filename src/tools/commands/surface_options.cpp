// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/surface_options.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vcavity/conventions.hpp>
#include <vcavity/groove/cavity.hpp>
#include <vcavity/rough/slope_distribution.hpp>

#include "tools/commands/options.hpp"
#include "tools/commands/vary.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

/// Where the material of `M:NM` ends. Names of files may have colons of their own: what is a file is one.
std::size_t end_of_material(const std::string& words) {
  const auto first = words.find(':');
  for (auto colon = words.rfind(':'); colon != words.npos && colon > first;
       colon = words.rfind(':', colon - 1))
    if (std::error_code ignored; std::filesystem::is_regular_file(words.substr(0, colon), ignored))
      return colon;
  return first;
}

/// A film of each thickness that `M:NM` names, where NM may be a list or a range.
std::vector<FilmLayer> films_of(const std::string& words, MissingExtinction missing) {
  const auto colon = end_of_material(words);
  if (colon == words.npos || colon == 0)
    throw unexpected("--film", words, "a material and a thickness in nm, M:NM or M:LO:HI:STEP");
  const Material material = load_material(words.substr(0, colon), missing);
  std::vector<FilmLayer> films;
  for (const double thickness_nm : checked_numbers(words.substr(colon + 1), "--film", film_range_nm))
    films.push_back({material, thickness_nm});
  return films;
}

constexpr Interval roughness_range{smallest_roughness, largest_roughness};
constexpr Interval concentration_range{0, 1e6};

/// Of brushed grooves, unless the user says otherwise: a standard deviation of 9 degrees.
constexpr double default_concentration = 10;

/// Roughnesses A, pairs AX:AY and ranges LOW:HIGH:STEP, separated by commas.
std::vector<Roughness> roughnesses_of(std::string_view words) {
  std::vector<Roughness> result;
  for (;;) {
    const auto end = words.find(',');
    const std::string_view part = words.substr(0, end);
    const auto colon = part.find(':');
    if (std::count(part.begin(), part.end(), ':') == 1) {
      result.push_back({{},
                        checked_number(part.substr(0, colon), "--roughness", roughness_range),
                        checked_number(part.substr(colon + 1), "--roughness", roughness_range)});
    } else {
      for (const double roughness : checked_numbers(part, "--roughness", roughness_range))
        result.push_back({{}, roughness, roughness});
    }
    if (end == words.npos) return result;
    words.remove_prefix(end + 1);
  }
}

void check_distribution(const SurfaceOptions& options) {
  const bool is_brushed = options.distribution == Roughness::Distribution::brushed;
  if (!options.distribution) {
    if (!options.roughnesses.empty())
      throw UsageError("--roughness: of what is not said, expected --distribution as well");
    if (!options.concentrations.empty())
      throw UsageError("--concentration: only brushed grooves have one, expected --distribution brushed");
    return;
  }
  if (!options.apertures_deg.empty())
    throw UsageError("--aperture: a distribution has grooves of all apertures, expected --roughness alone");
  if (options.roughnesses.empty()) throw UsageError("--roughness is required with --distribution");
  if (!options.concentrations.empty() && !is_brushed)
    throw UsageError("--concentration: only brushed grooves have one, expected --distribution brushed");
  for (const Roughness& roughness : options.roughnesses)
    if (is_brushed && roughness.along_x != roughness.along_y)
      throw UsageError("--roughness: slopes of brushed grooves have one roughness, expected a number");
}

void check_albedos(const SurfaceOptions& options) {
  const bool matte =
      std::find(options.finishes.begin(), options.finishes.end(), Finish::matte) != options.finishes.end();
  if (matte && !options.materials.empty())
    throw UsageError("--finish matte: is of panels with an --albedo, expected no --material");
  if (matte && options.albedos.empty()) throw UsageError("--albedo is required with --finish matte");
  if (options.albedos.empty() && options.specular)
    throw UsageError("--specular: is a part of matte panels, expected --finish matte and an --albedo");
  if (options.albedos.empty()) return;
  if (!options.materials.empty() || !options.profiles.panels.empty())
    throw UsageError("--albedo: stands in place of --material and --panels, expected one of them");
  if (!options.films.empty()) throw UsageError("--film: lies on facets of a --material, not on an --albedo");
  if (options.finishes.empty()) throw UsageError("--finish is required with --albedo: matte or mirror");
}

/// Words separated by commas.
std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list)
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

/// The albedos of a list, in which `LOW:HIGH:STEP` stands for all of a range.
std::vector<std::string> albedos_of(const std::string& list) {
  std::vector<std::string> albedos;
  for (std::string& word : split_list(list, "--albedo")) {
    if (std::error_code ignored; word.find_first_not_of("0123456789.eE+-:") != word.npos ||
                                 word.find(':') == word.npos || std::filesystem::exists(word, ignored)) {
      albedos.push_back(std::move(word));
      continue;
    }
    for (const double albedo : checked_numbers(word, "--albedo", {0, 1})) albedos.push_back(exact(albedo));
  }
  return albedos;
}

std::vector<Finish> finishes_of(const std::string& list) {
  std::vector<Finish> finishes;
  for (const std::string& word : words_of(list)) {
    const auto known = {Finish::mirror, Finish::matte};
    const auto found =
        std::find_if(known.begin(), known.end(), [&](Finish finish) { return word == name_of(finish); });
    if (found == known.end()) throw unexpected("--finish", word, "mirror or matte");
    finishes.push_back(*found);
  }
  return finishes;
}

void add_albedo_options(CLI::App& command, SurfaceOptions& options) {
  command
      .add_option_function<std::string>(
          "--finish", [&options](const std::string& list) { options.finishes = finishes_of(list); },
          "how panels reflect: like mirrors (default) or matte, into all directions alike (Lambert), with an "
          "--albedo in place of --material; a list")
      ->type_name("mirror|matte");
  command
      .add_option_function<std::string>(
          "--albedo", [&options](const std::string& list) { options.albedos = albedos_of(list); },
          "what panels reflect at any angle: a number from 0 to 1, a range LOW:HIGH:STEP, an sRGB colour "
          "such as "
          "'#b87333', a CSV file with wavelength_nm,reflectance, or ONE/TWO for the two panels; a list")
      ->type_name("A[,A...]");
  command
      .add_option("--specular", options.specular,
                  "what matte panels of one --albedo reflect like mirrors besides, the same at any angle: a "
                  "number, a "
                  "colour or a CSV file; for diffuse light alone (table)")
      ->type_name("S");
}

void check(const SurfaceOptions& options) {
  check_albedos(options);
  if (options.materials.empty() && options.profiles.panels.empty() && options.albedos.empty())
    throw UsageError("--material is required");
  if (!options.materials.empty() && !options.profiles.panels.empty())
    throw UsageError("--panels: stands in place of --material, expected one of them");
  check_distribution(options);
  if (options.apertures_deg.empty() && options.profiles.slopes_deg.empty() && !options.distribution)
    throw UsageError("--aperture is required");
  const double narrowest_deg = degrees(Cavity<double>::smallest_aperture());
  for (const double aperture_deg : options.apertures_deg)
    if (aperture_deg < narrowest_deg)
      throw UsageError("--aperture: '" + exact(aperture_deg) + "' is too narrow, expected at least " +
                       with_digits(narrowest_deg, 3) + " degrees");
  if (!options.apertures_deg.empty() && !options.profiles.slopes_deg.empty())
    throw UsageError("--slopes: stand in place of --aperture, expected one of them");
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceOptions& options) {
  add_materials(command, options.materials);
  add_missing_k(command, options.missing_k);
  add_apertures(command, options.apertures_deg);
  add_profile_options(command, options.profiles);
  command
      .add_option(
          "--film", options.films,
          "a thin film on every facet: a material as for --material and a thickness in nanometres, 0 to "
          "1e6; a list M:A,B,C or a range M:LO:HI:STEP; repeat it for more films, the top one first")
      ->type_name("M:NM")
      ->allow_extra_args(false);
  add_choice<std::optional<Roughness::Distribution>>(
      command, "--distribution", options.distribution,
      {{"ggx", Roughness::Distribution::ggx},
       {"beckmann", Roughness::Distribution::beckmann},
       {"brushed", Roughness::Distribution::brushed}},
      "a rough surface in place of grooves of one aperture; brushed grooves run along x");
  command
      .add_option_function<std::string>(
          "--roughness",
          [&options](const std::string& words) { options.roughnesses = roughnesses_of(words); },
          "of a distribution, 1e-6 to 1000; AX:AY along x and along y; a list A,B,C or a range LOW:HIGH:STEP")
      ->type_name("A|AX:AY[,...]");
  add_numbers(command, "--concentration", options.concentrations, concentration_range,
              "of the azimuth of brushed grooves about x, 0 (none) to 1e6 (default " +
                  exact(default_concentration) + ")")
      ->type_name("K[,K...]");
  add_albedo_options(command, options);
}

std::vector<SurfaceDescription> surfaces_of(const SurfaceOptions& options) {
  check(options);
  std::vector<SurfaceDescription> surfaces;
  for (const std::string& name : options.materials)
    surfaces.push_back({load_material(name, options.missing_k), 180});
  for (const std::string& words : options.profiles.panels) {
    const auto [one, two] = panel_materials(words, options.missing_k);
    surfaces.push_back({one, 180});
    surfaces.back().profile.panel_two = two;
  }
  for (const std::string& words : options.albedos)
    for (const Finish finish : options.finishes) {
      SurfaceDescription surface{Material::from_index({1, 0}, "1"), 180};
      surface.finish = finish;
      surface.albedos = load_albedos(words);
      if (options.specular) surface.specular = Albedo(*options.specular, "--specular");
      surfaces.push_back(surface);
    }
  vary(surfaces, options.apertures_deg,
       [](SurfaceDescription& surface, double aperture_deg) { surface.aperture_deg = aperture_deg; });
  surfaces = with_profiles(surfaces, options.profiles, options.missing_k);
  for (const std::string& film : options.films)
    vary(surfaces, films_of(film, options.missing_k),
         [](SurfaceDescription& surface, const FilmLayer& layer) { surface.films.push_back(layer); });
  vary(surfaces, options.roughnesses, [&options](SurfaceDescription& surface, const Roughness& roughness) {
    if (!surface.profile.is_plain())
      throw UsageError(
          "--distribution: has symmetric grooves of one material, expected no profile of its own");
    surface.roughness = roughness;
    surface.roughness->distribution = *options.distribution;
    if (options.distribution == Roughness::Distribution::brushed)
      surface.roughness->concentration = default_concentration;
  });
  vary(surfaces, options.concentrations, [](SurfaceDescription& surface, double concentration) {
    surface.roughness->concentration = concentration;
  });
  return surfaces;
}

std::vector<SurfaceAtWavelength> surfaces_at(const SurfaceOptions& options,
                                             const std::vector<double>& wavelengths_nm) {
  const std::vector<SurfaceDescription> surfaces = surfaces_of(options);
  const std::size_t materials = options.materials.size() + options.profiles.panels.size() +
                                options.albedos.size() * options.finishes.size();
  const std::size_t shapes = surfaces.size() / std::max<std::size_t>(1, materials);
  std::vector<SurfaceAtWavelength> result;
  for (auto first = surfaces.begin(); first != surfaces.end(); first += static_cast<std::ptrdiff_t>(shapes))
    for (const double wavelength_nm : wavelengths_nm)
      for (auto shape = first; shape != first + static_cast<std::ptrdiff_t>(shapes); ++shape)
        result.push_back({*shape, wavelength_nm});
  return result;
}

}  // namespace vcavity::tools
