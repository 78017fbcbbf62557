// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a surface is made of and how it is shaped, before a wavelength is chosen; and the surface itself.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/materials/facet.hpp"
#include "tools/materials/material.hpp"
#include "tools/surfaces/albedo.hpp"
#include "tools/surfaces/films.hpp"
#include "tools/surfaces/profile_description.hpp"
#include "tools/surfaces/rough_surface.hpp"
#include "tools/surfaces/surface.hpp"

namespace vcavity::tools {

/// How panels reflect: like mirrors, or into all directions alike (Lambert).
enum class Finish { mirror, matte };

/// "mirror" or "matte", as on the command line.
const char* name_of(Finish finish);

/// A surface in the words of the command line. Members are those of one shape and finish; what an option that was not
/// given would set stays at its default.
struct SurfaceDescription {
  Material material;                  ///< of all faces that have none of their own
  double aperture_deg;                ///< angle between the panels in degrees, [0, 180]; 0 over a floor alone
  std::vector<FilmLayer> films = {};  ///< on every facet, the top one first
  ProfileDescription profile = {};    ///< where the groove is not symmetric and of one material
  std::optional<Roughness> roughness = std::nullopt;  ///< a distribution of grooves, in place of one aperture
  Finish finish = Finish::mirror;
  std::optional<PanelAlbedos> albedos = std::nullopt;  ///< of the panels, in place of the material
  std::optional<Albedo> specular = std::nullopt;       ///< what matte panels reflect like mirrors besides
};

/// How light is followed.
struct LightModel {
  Polarization polarization;
  int max_bounces;  ///< light that needs more bounces is left out
};

/// What distinguishes a surface from others, as a JSON object in the order of the columns of a table: `material`,
/// `aperture_deg`, and only where they were asked for the rest.
nlohmann::ordered_json fields_of(const SurfaceDescription& surface);

/// What a surface is made of, for people: "Cu-Johnson".
std::string material_of(const SurfaceDescription& surface);

/// Material and kind for the title of a page: "Cu-Johnson grooves", "grooves of index 1.5".
std::string grooves_in_words(const SurfaceDescription& surface);

/// The shape and finish for people, without the material: "aperture 45°".
std::string in_words(const SurfaceDescription& surface);

/// Material, shape and finish as part of a file name: "Cu-Johnson_45deg".
std::string file_stem(const SurfaceDescription& surface);

/// The materials that a surface is made of, for provenance; none where albedos are given.
std::vector<Material> materials_of(const SurfaceDescription& surface);

/// Finish and albedo of the panels and where it is from, for provenance; empty where a material is given.
std::string albedo_in_words(const SurfaceDescription& surface);

/// Whether a surface is a symmetric groove of one material, bare or under films: its own mirror image.
bool is_symmetric_groove(const SurfaceDescription& surface);

/// Whether a surface is a bare symmetric groove, for which maps have a fast kernel.
bool is_bare_symmetric_groove(const SurfaceDescription& surface);

/// The surface at a wavelength. Here the shape, the facet and the model of polarisation are chosen.
/// @param wavelength_nm vacuum wavelength
/// @throws UsageError where a material has no data at the wavelength, or a shape cannot be made
std::unique_ptr<const Surface> make_surface(const SurfaceDescription& surface, double wavelength_nm,
                                            const LightModel& light);

}  // namespace vcavity::tools
