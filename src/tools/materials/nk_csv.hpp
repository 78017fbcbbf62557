// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tables of one's own, of a spreadsheet or an instrument, and the exports of refractiveindex.info: columns with a
/// heading, for instance
///
///     wavelength_nm,n,k
///     400,1.470,1.95
///     500,1.122,2.60
///
/// The heading of the wavelengths names their unit as a word: `wavelength_nm`, `Wavelength (nm)`, `lambda [µm]`,
/// `wavelength in Angstrom`; `wl` alone is micrometres, as in the exports. The other columns are `n` and `k` in either
/// order, also in words ("Refractive index", "Extinction coefficient"); without k the material is transparent. A second
/// heading may start a second block, as the exports have for k. Cells are separated as read_spreadsheet() says, '#'
/// starts a comment, and where there is no other heading that may be one. Decimals may stand behind a comma where cells
/// are not separated by commas. Rows may stand in any order, those of the same wavelength are replaced by their mean.
/// What could be read in two ways is refused.

#include <filesystem>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Reads one file; the material is called like the file, without extension.
/// @param missing what k is where the file has n but no k
/// @throws std::runtime_error "FILE:LINE: reason" if it is malformed, "FILE: cannot read: reason" if it cannot be read
Material read_nk_csv(const std::filesystem::path& file,
                     MissingExtinction missing = MissingExtinction::refused);

}  // namespace vcavity::tools
