// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/surface_description.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/support/text_table.hpp"
#include "tools/surfaces/groove_surface.hpp"
#include "tools/surfaces/matte_surface.hpp"
#include "tools/surfaces/profile_surface.hpp"

namespace vcavity::tools {

const char* name_of(Finish finish) {
  return finish == Finish::matte ? "matte" : "mirror";
}

namespace {

/// "0.5", "0.5 and specular 0.1"
std::string albedo_of(const SurfaceDescription& surface) {
  return surface.albedos->name() + (surface.specular ? " and specular " + surface.specular->name() : "");
}

}  // namespace

nlohmann::ordered_json fields_of(const SurfaceDescription& surface) {
  if (surface.albedos) {
    nlohmann::ordered_json fields{{"finish", name_of(surface.finish)}, {"albedo", surface.albedos->name()}};
    if (surface.specular) fields["specular"] = surface.specular->name();
    fields["aperture_deg"] = surface.aperture_deg;
    fields.update(fields_of(surface.profile));
    return fields;
  }
  nlohmann::ordered_json fields{{"material", material_of(surface)}};
  if (surface.roughness) {
    fields.update(fields_of(*surface.roughness));
  } else {
    fields["aperture_deg"] = surface.aperture_deg;
    fields.update(fields_of(surface.profile));
  }
  if (!surface.films.empty()) fields["films"] = fields_of(surface.films);
  return fields;
}

std::string material_of(const SurfaceDescription& surface) {
  if (surface.albedos) return std::string(name_of(surface.finish)) + " " + albedo_of(surface);
  return panels_in_words(surface.profile, surface.material);
}

std::string grooves_in_words(const SurfaceDescription& surface) {
  if (surface.albedos)
    return std::string(name_of(surface.finish)) + " grooves of albedo " + albedo_of(surface);
  return surface.material.constant() ? "grooves of index " + material_of(surface)
                                     : material_of(surface) + " grooves";
}

std::string in_words(const SurfaceDescription& surface) {
  std::string words =
      surface.roughness ? in_words(*surface.roughness) : in_words(surface.profile, surface.aperture_deg);
  if (!surface.films.empty()) words.append(", under ").append(in_words(surface.films));
  return words;
}

std::string file_stem(const SurfaceDescription& surface) {
  std::string material = material_of(surface);
  std::replace_if(
      material.begin(), material.end(), [](char c) { return c == '/' || c == ' ' || c == '#'; }, '-');
  const std::string shape =
      surface.roughness ? file_stem(*surface.roughness) : file_stem(surface.profile, surface.aperture_deg);
  return material + "_" + shape + file_stem(surface.films);
}

std::string albedo_in_words(const SurfaceDescription& surface) {
  if (!surface.albedos) return "";
  const PanelAlbedos& albedos = *surface.albedos;
  std::string words = std::string(name_of(surface.finish)) + " panels, " + albedos.one.source();
  if (albedos.differ) words += " on panel one, " + albedos.two.source() + " on panel two";
  if (surface.specular) words += ", specular part: " + surface.specular->source();
  return words;
}

std::vector<Material> materials_of(const SurfaceDescription& surface) {
  if (surface.albedos) return {};
  std::vector<Material> materials{surface.material};
  for (const Material& material : materials_of(surface.profile)) materials.push_back(material);
  for (const FilmLayer& film : surface.films) materials.push_back(film.material);
  return materials;
}

bool is_symmetric_groove(const SurfaceDescription& surface) {
  return !surface.albedos && surface.profile.is_plain() && !surface.roughness;
}

bool is_bare_symmetric_groove(const SurfaceDescription& surface) {
  return is_symmetric_groove(surface) && !has_films(surface.films);
}

std::unique_ptr<const Surface> make_surface(const SurfaceDescription& surface, double wavelength_nm,
                                            const LightModel& light) {
  if (surface.albedos) return make_albedo_surface(surface, wavelength_nm, light);
  if (!surface.profile.is_plain()) return make_profile_surface(surface, wavelength_nm, light);
  if (surface.roughness) return make_rough_surface(surface, wavelength_nm, light);
  return make_groove_surface(surface, wavelength_nm, light);
}

}  // namespace vcavity::tools
