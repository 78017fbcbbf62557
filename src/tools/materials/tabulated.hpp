// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Optical constants given by the rows of a table.

#include <cstddef>
#include <filesystem>
#include <vector>

#include "tools/materials/material.hpp"
#include "tools/support/text_file.hpp"

namespace vcavity::tools {

/// How many nanometres make a micrometre.
inline constexpr double nm_per_um = 1000;

/// n or k as the function that is linear between the rows of a table. Rows may stand in any order; those of the same
/// wavelength are replaced by their mean.
/// @param rows wavelength first, at least one row
/// @param column the column of values; 0 is the wavelength
/// @param units_per_um how many of the unit of the wavelengths make a micrometre
/// @param file where the rows are from, for errors
/// @param line where the table starts, for errors
/// @throws malformed() where a wavelength is not above 0
OpticalConstant tabulated(const std::vector<NumberRow>& rows, std::size_t column, double units_per_um,
                          const std::filesystem::path& file, int line);

}  // namespace vcavity::tools
