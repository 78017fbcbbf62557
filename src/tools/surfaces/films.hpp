// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Thin films on the facets of a surface, as options name them and as the library takes them at a wavelength.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vcavity/facet/coated.hpp>
#include <vector>

#include "tools/materials/facet.hpp"
#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// A film before a wavelength is chosen.
struct FilmLayer {
  Material material;
  double thickness_nm;  ///< ≥ 0
};

/// Whether any film has a thickness; without, facets are bare.
bool has_films(std::span<const FilmLayer> films);

/// The films for people, the top one first: "TiO2-Siefke 60 nm on SiO2-Malitson 20 nm". Empty without films.
std::string in_words(std::span<const FilmLayer> films);

/// Their materials alone: "TiO2-Siefke on SiO2-Malitson".
std::string materials_in_words(std::span<const FilmLayer> films);

/// Their thicknesses alone: "60 nm on 20 nm".
std::string thicknesses_in_words(std::span<const FilmLayer> films);

/// The films as JSON: an array of objects with `material` and `thickness_nm`.
nlohmann::ordered_json fields_of(std::span<const FilmLayer> films);

/// The films as part of a file name: "_TiO2-Siefke-60nm".
std::string file_stem(std::span<const FilmLayer> films);

/// The films at a wavelength, for `Coated`.
/// @param wavelength_nm vacuum wavelength
/// @throws UsageError where a material has no data at the wavelength, or an index that films cannot have
std::vector<Film<double>> films_at(std::span<const FilmLayer> films, double wavelength_nm);

/// A facet under films.
/// @throws UsageError where the substrate has an index that it cannot have under films
Coated<Conductor<double>> coated_facet(const RefractiveIndex& substrate, std::span<const FilmLayer> films,
                                       double wavelength_nm);

/// Calls `use` with the facet reflectance of a material under films, or bare where there are none.
/// @param substrate its index at the wavelength
/// @return what `use` returns
template <class Use>
auto with_facet(const RefractiveIndex& substrate, std::span<const FilmLayer> films, double wavelength_nm,
                Use&& use) {
  if (!has_films(films)) return with_facet(substrate, use);
  return use(coated_facet(substrate, films, wavelength_nm));
}

}  // namespace vcavity::tools
