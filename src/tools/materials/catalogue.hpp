// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Materials by name: the collection in data/nk, the user's own files, and plain numbers.

#include <string>
#include <string_view>
#include <vector>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// A material of the collection and its short names.
struct CatalogueEntry {
  Material material;
  std::vector<std::string> short_names;  ///< such as "Cu" for Cu-Johnson; mostly none
};

/// All materials in data/nk by name. Throws std::runtime_error if one is malformed or cannot be read.
std::vector<CatalogueEntry> list_materials();

/// The material that a user's words stand for.
/// @param specification one of
///        - a name in data/nk, letter case aside: `Cu-Johnson`, or `Cu` for the default source
///        (data/nk/defaults.yml);
///        - a file, recognised by a slash or its extension: .yml or .yaml of refractiveindex.info, .csv, .tsv or
///          ./NAME.txt (see read_nk_csv()), .spd (see read_spd_pair());
///        - an index: `1.5`, or n + ik as `0.05+4i` or `0.05+4j`.
/// Throws UsageError for an unknown name, with the nearest one, for a file of another kind, and for an index
/// unless n > 0 and k >= 0; std::runtime_error for a file that cannot be read or is malformed.
Material load_material(std::string_view specification,
                       MissingExtinction missing = MissingExtinction::refused);

}  // namespace vcavity::tools
