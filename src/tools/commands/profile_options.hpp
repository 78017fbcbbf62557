// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The options for grooves that are not symmetric and of one material: --tilt, --slopes, --panels, --land, --floor and the
/// materials of land and floor.

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// What the options say. Empty lists stand for options that were not given.
struct ProfileOptions {
  std::vector<std::string> panels;  ///< M1/M2
  std::vector<double> tilts_deg;
  std::vector<std::array<double, 2>> slopes_deg;
  std::vector<double> lands;
  std::vector<double> floors;
  std::string floor_material;
  std::string land_material;
};

/// Adds the options.
void add_profile_options(CLI::App& command, ProfileOptions& options);

/// The two materials of `M1/M2`.
/// @param missing what k is where a file has none
/// @throws UsageError where the words name no two materials
std::pair<Material, Material> panel_materials(const std::string& words, MissingExtinction missing);

/// Every surface in every profile that the options say, all profiles of the first one first.
/// @param missing what k is where the file of a floor's or land's material has none
/// @throws UsageError that names value and domain where a profile cannot be made
std::vector<SurfaceDescription> with_profiles(const std::vector<SurfaceDescription>& surfaces,
                                              const ProfileOptions& options, MissingExtinction missing);

}  // namespace vcavity::tools
