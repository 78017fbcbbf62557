// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/surface_options.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "tools/commands/options.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

/// Each of the surfaces with each of the values of an option, all values of the first surface first.
/// @param values empty if the option was not given: the surfaces stay as they are then
/// @param set writes a value into a description
template <class Value, class Set>
void vary(std::vector<SurfaceDescription>& surfaces, const std::vector<Value>& values, const Set& set) {
  if (values.empty()) return;
  std::vector<SurfaceDescription> varied;
  for (const SurfaceDescription& surface : surfaces)
    for (const Value& value : values) {
      varied.push_back(surface);
      set(varied.back(), value);
    }
  surfaces = std::move(varied);
}

/// A film of each thickness that `M:NM` names, where NM may be a list or a range.
std::vector<FilmLayer> films_of(const std::string& words) {
  const auto colon = words.find(':');
  if (colon == words.npos || colon == 0)
    throw unexpected("--film", words, "a material and a thickness in nm, M:NM or M:LO:HI:STEP");
  const Material material = load_material(words.substr(0, colon));
  std::vector<FilmLayer> films;
  for (const double thickness_nm : checked_numbers(words.substr(colon + 1), "--film", film_range_nm))
    films.push_back({material, thickness_nm});
  return films;
}

void check(const SurfaceOptions& options) {
  if (options.materials.empty() && options.profiles.panels.empty())
    throw UsageError("--material is required");
  if (!options.materials.empty() && !options.profiles.panels.empty())
    throw UsageError("--panels: stands in place of --material, expected one of them");
  if (options.apertures_deg.empty() && options.profiles.slopes_deg.empty())
    throw UsageError("--aperture is required");
  if (!options.apertures_deg.empty() && !options.profiles.slopes_deg.empty())
    throw UsageError("--slopes: stand in place of --aperture, expected one of them");
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceOptions& options) {
  add_materials(command, options.materials);
  add_apertures(command, options.apertures_deg);
  add_profile_options(command, options.profiles);
  command
      .add_option(
          "--film", options.films,
          "a thin film on every facet: a material as for --material and a thickness in nanometres, 0 to "
          "1e6; a list M:A,B,C or a range M:LO:HI:STEP; repeat it for more films, the top one first")
      ->type_name("M:NM")
      ->allow_extra_args(false);
}

std::vector<SurfaceDescription> surfaces_of(const SurfaceOptions& options) {
  check(options);
  std::vector<SurfaceDescription> surfaces;
  for (const std::string& name : options.materials) surfaces.push_back({load_material(name), 180});
  for (const std::string& words : options.profiles.panels) {
    const auto [one, two] = panel_materials(words);
    surfaces.push_back({one, 180});
    surfaces.back().profile.panel_two = two;
  }
  vary(surfaces, options.apertures_deg,
       [](SurfaceDescription& surface, double aperture_deg) { surface.aperture_deg = aperture_deg; });
  surfaces = with_profiles(surfaces, options.profiles);
  for (const std::string& film : options.films)
    vary(surfaces, films_of(film),
         [](SurfaceDescription& surface, const FilmLayer& layer) { surface.films.push_back(layer); });
  return surfaces;
}

std::vector<SurfaceAtWavelength> surfaces_at(const SurfaceOptions& options,
                                             const std::vector<double>& wavelengths_nm) {
  const std::vector<SurfaceDescription> surfaces = surfaces_of(options);
  const std::size_t materials = options.materials.size() + options.profiles.panels.size();
  const std::size_t shapes = surfaces.size() / std::max<std::size_t>(1, materials);
  std::vector<SurfaceAtWavelength> result;
  for (auto first = surfaces.begin(); first != surfaces.end(); first += static_cast<std::ptrdiff_t>(shapes))
    for (const double wavelength_nm : wavelengths_nm)
      for (auto shape = first; shape != first + static_cast<std::ptrdiff_t>(shapes); ++shape)
        result.push_back({*shape, wavelength_nm});
  return result;
}

}  // namespace vcavity::tools
