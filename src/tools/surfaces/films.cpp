// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/films.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

// What the library refuses is an index that the user chose.
template <class Make>
auto made(const std::string& name, double wavelength_nm, Make&& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw UsageError("--film: " + name + " at " + exact(wavelength_nm) + " nm: " + error.what());
  }
}

/// The words for each film, from the top down.
template <class Words>
std::string listed(std::span<const FilmLayer> films, Words&& words_of) {
  std::string words;
  for (const FilmLayer& film : films) words.append(words.empty() ? "" : " on ").append(words_of(film));
  return words;
}

}  // namespace

bool has_films(std::span<const FilmLayer> films) {
  return std::any_of(films.begin(), films.end(), [](const FilmLayer& film) { return film.thickness_nm > 0; });
}

std::string in_words(std::span<const FilmLayer> films) {
  return listed(films, [](const FilmLayer& film) {
    return film.material.name() + " " + exact(film.thickness_nm) + " nm";
  });
}

std::string materials_in_words(std::span<const FilmLayer> films) {
  return listed(films, [](const FilmLayer& film) { return film.material.name(); });
}

std::string thicknesses_in_words(std::span<const FilmLayer> films) {
  return listed(films, [](const FilmLayer& film) { return exact(film.thickness_nm) + " nm"; });
}

nlohmann::ordered_json fields_of(std::span<const FilmLayer> films) {
  nlohmann::ordered_json fields = nlohmann::ordered_json::array();
  for (const FilmLayer& film : films)
    fields.push_back({{"material", film.material.name()}, {"thickness_nm", film.thickness_nm}});
  return fields;
}

std::string file_stem(std::span<const FilmLayer> films) {
  std::string stem;
  for (const FilmLayer& film : films)
    stem.append("_").append(film.material.name()).append("-").append(exact(film.thickness_nm)).append("nm");
  return stem;
}

std::vector<Film<double>> films_at(std::span<const FilmLayer> films, double wavelength_nm) {
  std::vector<Film<double>> result;
  for (const FilmLayer& film : films) {
    const RefractiveIndex index = film.material.at(wavelength_nm);
    result.push_back(made(film.material.name(), wavelength_nm, [&] {
      return Film<double>::of_thickness_nm(index.n, index.k, film.thickness_nm, wavelength_nm);
    }));
  }
  return result;
}

Coated<Conductor<double>> coated_facet(const RefractiveIndex& substrate, std::span<const FilmLayer> films,
                                       double wavelength_nm) {
  const std::vector<Film<double>> layers = films_at(films, wavelength_nm);
  return made("the substrate", wavelength_nm,
              [&] { return Coated(Conductor<double>(substrate.n, substrate.k), layers); });
}

}  // namespace vcavity::tools
