// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/profile_description.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

void check_slopes(const ProfileDescription& profile) {
  const auto [one, two] = *profile.slopes_deg;
  const std::string given = "--slopes: '" + exact(one) + ":" + exact(two) + "'";
  const double floor = profile.floor.value_or(0);
  if (floor > 0) {
    if (one > 90 || two > 90)
      throw UsageError(given +
                       " leans over a floor, to which light may come back without end: expected slopes up to "
                       "90 degrees with --floor");
    if (one == 90 && two == 90 && profile.land.value_or(0) == 0)
      throw UsageError(given + " leaves walls of no thickness, expected --land above 0 with vertical walls");
    return;
  }
  if (one + two >= 180)
    throw UsageError(given + " makes no groove, expected slopes that add up to less than 180 degrees" +
                     (one == 90 && two == 90 ? ", or a --floor above 0" : ""));
}

void check_tilt(double tilt_deg, double aperture_deg) {
  const double most = (180 - aperture_deg) / 2;
  if (tilt_deg != 0 && !(std::abs(tilt_deg) < most))
    throw UsageError("--tilt: '" + exact(tilt_deg) + "' makes no groove of aperture " + exact(aperture_deg) +
                     ", expected more than " + exact(-most) + " and less than " + exact(most) + " degrees");
}

}  // namespace

void check_profile(const ProfileDescription& profile, double aperture_deg) {
  if (profile.land && !(*profile.land < 1))
    throw UsageError("--land: '" + exact(*profile.land) + "' leaves no groove, expected 0 to less than 1");
  if (profile.floor && !profile.slopes_deg)
    throw UsageError("--floor: '" + exact(*profile.floor) + "' needs --slopes, the angles of the walls");
  if (profile.slopes_deg) {
    check_slopes(profile);
  } else {
    check_tilt(profile.tilt_deg.value_or(0), aperture_deg);
    if (aperture_deg == 180 && profile.panel_two)
      throw UsageError("--panels: an aperture of 180 degrees has no panels, expected less");
  }
  if (profile.floor_material && !(profile.floor.value_or(0) > 0))
    throw UsageError("--floor-material: there is no floor, expected --floor above 0");
  if (profile.land_material && !(profile.land.value_or(0) > 0))
    throw UsageError("--land-material: there is no land, expected --land above 0");
}

nlohmann::ordered_json fields_of(const ProfileDescription& profile) {
  nlohmann::ordered_json fields = nlohmann::ordered_json::object();
  if (profile.slopes_deg)
    fields["tilt_deg"] = ((*profile.slopes_deg)[0] - (*profile.slopes_deg)[1]) / 2;
  else if (profile.tilt_deg)
    fields["tilt_deg"] = *profile.tilt_deg;
  if (profile.land) fields["land"] = *profile.land;
  if (profile.floor) fields["floor"] = *profile.floor;
  if (profile.floor_material) fields["floor_material"] = profile.floor_material->name();
  if (profile.land_material) fields["land_material"] = profile.land_material->name();
  return fields;
}

std::string panels_in_words(const ProfileDescription& profile, const Material& panel_one) {
  return profile.panel_two ? panel_one.name() + "/" + profile.panel_two->name() : panel_one.name();
}

std::string in_words(const ProfileDescription& profile, double aperture_deg) {
  std::string words;
  if (profile.slopes_deg)
    words = "slopes " + exact((*profile.slopes_deg)[0]) + "° and " + exact((*profile.slopes_deg)[1]) + "°";
  else
    words = "aperture " + exact(aperture_deg) + "°";
  if (profile.tilt_deg) words += ", tilt " + exact(*profile.tilt_deg) + "°";
  const auto add = [&](const char* name, const std::optional<double>& size,
                       const std::optional<Material>& material) {
    if (!size) return;
    words += std::string(", ") + name + " " + exact(*size);
    if (material) words += " of " + material->name();
  };
  add("floor", profile.floor, profile.floor_material);
  add("land", profile.land, profile.land_material);
  return words;
}

std::string file_stem(const ProfileDescription& profile, double aperture_deg) {
  std::string stem;
  if (profile.slopes_deg)
    stem = exact((*profile.slopes_deg)[0]) + "-" + exact((*profile.slopes_deg)[1]) + "deg";
  else
    stem = exact(aperture_deg) + "deg";
  if (profile.tilt_deg) stem += "_tilt" + exact(*profile.tilt_deg);
  if (profile.floor) stem += "_floor" + exact(*profile.floor);
  if (profile.land) stem += "_land" + exact(*profile.land);
  return stem;
}

std::vector<Material> materials_of(const ProfileDescription& profile) {
  std::vector<Material> materials;
  for (const auto& material : {profile.panel_two, profile.floor_material, profile.land_material})
    if (material) materials.push_back(*material);
  return materials;
}

}  // namespace vcavity::tools
