// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tables of one's own: comma-separated values with a heading, for instance
///
///     wavelength_nm,n,k
///     400,1.470,1.95
///     500,1.122,2.60
///
/// The heading of the wavelengths ends in their unit: `wavelength_nm`, `wavelength_um`, `Wavelength (nm)`,
/// `lambda [µm]`; `wl` alone is micrometres, as in the tables that refractiveindex.info exports. The other
/// columns are `n` and `k` in either order, in any letter case; without k the material is transparent. '#'
/// starts a comment. Rows may stand in any order, those of the same wavelength are replaced by their mean.

#include <filesystem>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Reads one file; the material is called like the file, without extension. Throws std::runtime_error
/// "FILE:LINE: reason" if it is malformed, "FILE: cannot read: reason" if it cannot be read.
Material read_nk_csv(const std::filesystem::path& file);

}  // namespace vcavity::tools
