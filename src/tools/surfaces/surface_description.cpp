// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/surface_description.hpp"

#include <nlohmann/json.hpp>

#include "tools/support/text_table.hpp"
#include "tools/surfaces/groove_surface.hpp"

namespace vcavity::tools {

nlohmann::ordered_json fields_of(const SurfaceDescription& surface) {
  return {{"material", surface.material.name()}, {"aperture_deg", surface.aperture_deg}};
}

std::string material_of(const SurfaceDescription& surface) {
  return surface.material.name();
}

std::string grooves_in_words(const SurfaceDescription& surface) {
  return surface.material.constant() ? "grooves of index " + material_of(surface)
                                     : material_of(surface) + " grooves";
}

std::string in_words(const SurfaceDescription& surface) {
  return "aperture " + exact(surface.aperture_deg) + "°";
}

std::string file_stem(const SurfaceDescription& surface) {
  return surface.material.name() + "_" + exact(surface.aperture_deg) + "deg";
}

std::vector<Material> materials_of(const SurfaceDescription& surface) {
  return {surface.material};
}

bool is_bare_symmetric_groove(const SurfaceDescription&) {
  return true;
}

std::unique_ptr<const Surface> make_surface(const SurfaceDescription& surface, double wavelength_nm,
                                            const LightModel& light) {
  return make_groove_surface(surface, wavelength_nm, light);
}

}  // namespace vcavity::tools
