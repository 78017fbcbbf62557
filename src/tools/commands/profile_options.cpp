// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/profile_options.hpp"

#include <optional>

#include "tools/commands/options.hpp"
#include "tools/commands/vary.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

constexpr Interval tilt_range_deg{-90, 90, Interval::Ends::open_both};
constexpr Interval slope_range_deg{0, 180, Interval::Ends::open_both};
constexpr Interval land_range{0, 1};
constexpr Interval floor_range{0, 1e6};

/// The pairs of a list of `B1:B2` and `B1/B2`, where in the latter either may be a range.
std::vector<std::array<double, 2>> slopes_of(const std::string& list) {
  std::vector<std::array<double, 2>> slopes;
  for (const std::string& word : split_list(list, "--slopes")) {
    const auto slash = word.find('/');
    const auto separator = slash == std::string::npos ? word.find(':') : slash;
    const bool is_pair =
        separator != std::string::npos && word.find(word[separator], separator + 1) == std::string::npos;
    if (!is_pair)
      throw unexpected("--slopes", word,
                       "the angles of panel one and panel two to the mean plane: B1:B2, or B1/B2 with a "
                       "range LOW:HIGH:STEP for one or both");
    for (const double one : checked_numbers(word.substr(0, separator), "--slopes", slope_range_deg))
      for (const double two : checked_numbers(word.substr(separator + 1), "--slopes", slope_range_deg))
        slopes.push_back({one, two});
  }
  return slopes;
}

std::optional<Material> loaded(const std::string& name, MissingExtinction missing) {
  if (name.empty()) return std::nullopt;
  return load_material(name, missing);
}

}  // namespace

void add_profile_options(CLI::App& command, ProfileOptions& options) {
  add_numbers(command, "--tilt", options.tilts_deg, tilt_range_deg,
              "angles of the bisector of the panels from the normal towards +y in degrees; less than (180 - "
              "aperture)/2 "
              "either way, default 0")
      ->type_name("DEG[,DEG...]");
  command
      .add_option_function<std::string>(
          "--slopes", [&options](const std::string& list) { options.slopes_deg = slopes_of(list); },
          "in place of --aperture and --tilt: the angles of panel one (y < 0) and panel two to the mean "
          "plane in degrees, together less than 180; a list of such pairs. B1/B2 is a pair too, in which "
          "either angle may be a range LOW:HIGH:STEP, as in 60:80:5/40")
      ->type_name("B1:B2[,B1:B2...]");
  command
      .add_option_function<std::string>(
          "--panels", [&options](const std::string& list) { options.panels = split_list(list, "--panels"); },
          "in place of --material: the materials of panel one and panel two; a list of such pairs")
      ->type_name("M1/M2[,M1/M2...]");
  add_numbers(command, "--land", options.lands, land_range,
              "widths of the flat land between two grooves, at the height of their rims, as fractions of the "
              "period, 0 "
              "to less than 1")
      ->type_name("F[,F...]");
  command
      .add_option("--land-material", options.land_material,
                  "what the land is made of, unless it is that of panel one")
      ->type_name(material_placeholder);
  add_numbers(command, "--floor", options.floors, floor_range,
              "widths of the flat bottom over the depth of the groove; with --slopes up to 90")
      ->type_name("F[,F...]");
  command
      .add_option("--floor-material", options.floor_material,
                  "what the flat bottom is made of, unless it is that of panel one")
      ->type_name(material_placeholder);
}

std::pair<Material, Material> panel_materials(const std::string& words, MissingExtinction missing) {
  const auto slash = words.find('/');
  const std::string expected = "the materials of panel one and panel two, M1/M2";
  if (slash == std::string::npos || slash == 0 || slash + 1 == words.size())
    throw unexpected("--panels", words, expected);
  if (words.find('/', slash + 1) == std::string::npos)
    return {load_material(words.substr(0, slash), missing), load_material(words.substr(slash + 1), missing)};
  // Names of files have slashes of their own: the one that leaves two materials it is.
  for (auto at = slash; at != std::string::npos; at = words.find('/', at + 1)) {
    try {
      return {load_material(words.substr(0, at), missing), load_material(words.substr(at + 1), missing)};
    } catch (const std::runtime_error&) {
      continue;
    }
  }
  throw unexpected("--panels", words, expected);
}

std::vector<SurfaceDescription> with_profiles(const std::vector<SurfaceDescription>& surfaces,
                                              const ProfileOptions& options, MissingExtinction missing) {
  if (!options.slopes_deg.empty() && !options.tilts_deg.empty())
    throw UsageError("--tilt: --slopes say how the groove is tilted, expected one of them");
  std::vector<SurfaceDescription> result = surfaces;
  vary(result, options.slopes_deg, [](SurfaceDescription& surface, const std::array<double, 2>& slopes) {
    surface.profile.slopes_deg = slopes;
    surface.aperture_deg = 180 - slopes[0] - slopes[1];
  });
  vary(result, options.tilts_deg,
       [](SurfaceDescription& surface, double tilt_deg) { surface.profile.tilt_deg = tilt_deg; });
  vary(result, options.floors,
       [](SurfaceDescription& surface, double floor) { surface.profile.floor = floor; });
  vary(result, options.lands, [](SurfaceDescription& surface, double land) { surface.profile.land = land; });
  const std::optional<Material> floor_material = loaded(options.floor_material, missing);
  const std::optional<Material> land_material = loaded(options.land_material, missing);
  for (SurfaceDescription& surface : result) {
    surface.profile.floor_material = floor_material;
    surface.profile.land_material = land_material;
    check_profile(surface.profile, surface.aperture_deg);
  }
  return result;
}

}  // namespace vcavity::tools
