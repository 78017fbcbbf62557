// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Optical constants given by the rows of a table.

#include <cstddef>
#include <filesystem>
#include <vector>

#include "tools/materials/material.hpp"
#include "tools/support/text_file.hpp"

namespace vcavity::tools {

/// How many of a unit of length make a micrometre.
enum class WavelengthUnit { um = 1, nm = 1000 };

/// n or k as the function that is linear between the rows of a table. Rows may stand in any order; those of
/// the same wavelength are replaced by their mean. \param rows     wavelength first, at least one row \param
/// column   the column of values; 0 is the wavelength \param unit     of the wavelengths \param file where
/// the rows are from, and \param line     where the table starts, for errors Throws malformed() where a
/// wavelength is not above 0.
OpticalConstant tabulated(const std::vector<NumberRow>& rows, std::size_t column, WavelengthUnit unit,
                          const std::filesystem::path& file, int line);

}  // namespace vcavity::tools
