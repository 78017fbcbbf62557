// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Files of the refractiveindex.info database (YAML), the present layout and the older ones.
///
/// Source of the format: https://github.com/polyanskiy/refractiveindex.info-database, Sci. Data 11, 94
/// (2024). Keys may stand in any order; only REFERENCES, COMMENTS and DATA are read. DATA has one entry for n
/// and k together, or one for each, of type `tabulated nk`, `tabulated n`, `tabulated k` (rows: wavelength in
/// um, values) or `formula 1` to `formula 9` (`coefficients` and `wavelength_range`, formerly `range`). What
/// is not evident:
/// - rows may stand in any order; rows of the same wavelength are replaced by their mean;
/// - data for n alone are those of a transparent material, k = 0;
/// - where n is given by a formula and by a table, the table counts, for that is what was measured, and the comments say
///   so; n or k given by two entries otherwise is an error, and so are data for k alone or for the nonlinear index n2
///   alone;
/// - negative values of k are an error where they are asked for, see Material::at().

#include <filesystem>
#include <string>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Reads one file.
/// @param name what to call the material
/// @param missing what k is where the file has n but no k
/// @throws std::runtime_error "FILE:LINE: reason" if it is malformed, "FILE: cannot read: reason" if it cannot be read
Material read_refractiveindex_info(const std::filesystem::path& file, std::string name,
                                   MissingExtinction missing = MissingExtinction::refused);

}  // namespace vcavity::tools
