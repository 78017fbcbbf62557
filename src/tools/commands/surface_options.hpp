// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The options that say what a surface is made of and how it is shaped: in one place for all commands. Each
/// may be a list; every combination of their values is a surface.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/commands/profile_options.hpp"
#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// What the options say. Empty lists stand for options that were not given.
struct SurfaceOptions {
  std::vector<std::string> materials;
  std::vector<double> apertures_deg;
  std::vector<std::string> films;  ///< M:NM each, the top one first
  ProfileOptions profiles;
  std::optional<Roughness::Distribution> distribution;
  std::vector<Roughness> roughnesses;   ///< along x and along y; the rest is in the other two options
  std::vector<double> concentrations;   ///< of brushed grooves
  std::vector<Finish> finishes;         ///< of panels with an albedo
  std::vector<std::string> albedos;     ///< in place of materials, see load_albedos()
  std::optional<std::string> specular;  ///< of matte panels, see `Albedo`
  MissingExtinction missing_k = MissingExtinction::refused;
};

/// Adds --material, --aperture and all others of `SurfaceOptions`.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

/// All surfaces, those of a material together.
/// @throws UsageError where options are missing or contradict each other
std::vector<SurfaceDescription> surfaces_of(const SurfaceOptions& options);

/// A surface and the wavelength to look at it.
struct SurfaceAtWavelength {
  SurfaceDescription surface;
  double wavelength_nm;
};

/// Every material at every wavelength in every shape, in this order.
/// @throws UsageError where options are missing or contradict each other
std::vector<SurfaceAtWavelength> surfaces_at(const SurfaceOptions& options,
                                             const std::vector<double>& wavelengths_nm);

}  // namespace vcavity::tools
