// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What makes the profile of a surface more than a symmetric groove of one material, in the words of the command line.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Members that were not asked for are empty.
struct ProfileDescription {
  std::optional<double> tilt_deg;                   ///< of the bisector from z towards +y
  std::optional<std::array<double, 2>> slopes_deg;  ///< of panels one and two, in place of aperture and tilt
  std::optional<double> land;                       ///< fraction of the period, [0, 1)
  std::optional<double> floor;                      ///< width over the depth of the groove, ≥ 0
  std::optional<Material> panel_two;                ///< of panel two alone
  std::optional<Material> floor_material;           ///< of the floor, else that of panel one
  std::optional<Material> land_material;            ///< of the land, else that of panel one

  /// Whether nothing was asked for: a symmetric groove of one material.
  bool is_plain() const {
    return !tilt_deg && !slopes_deg && !land && !floor && !panel_two && !floor_material && !land_material;
  }
};

/// Whether options make a surface.
/// @param aperture_deg ignored where slopes are given
/// @throws UsageError that names the value and the domain where they do not
void check_profile(const ProfileDescription& profile, double aperture_deg);

/// The fields of a JSON object that stand behind `aperture_deg`: `tilt_deg`, `land`, `floor` and materials of their own,
/// as far as they were asked for.
nlohmann::ordered_json fields_of(const ProfileDescription& profile);

/// Material of panel one, or of both: "Ag" or "Ag/Au".
std::string panels_in_words(const ProfileDescription& profile, const Material& panel_one);

/// The shape for people, in place of "aperture 45°": "slopes 80° and 40°, floor 0.5, land 0.1".
std::string in_words(const ProfileDescription& profile, double aperture_deg);

/// The shape as part of a file name: "60deg_20tilt".
std::string file_stem(const ProfileDescription& profile, double aperture_deg);

/// The materials besides that of panel one.
std::vector<Material> materials_of(const ProfileDescription& profile);

}  // namespace vcavity::tools
