// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// At which wavelengths a surface must be looked at for its colour.
///
/// Method: between the wavelengths of a grid the reflectance is taken to be linear. Where it is not, as with thin films
/// or a table of n and k finer than the grid, wavelengths are added until straight lines show it within 0.01 at every
/// nanometre, for normal and for slanting light.
/// When not to use it: for structure finer than 1 nm, which may be missed.

#include <functional>
#include <utility>
#include <vector>

namespace vcavity::tools {

/// Whether the colour-matching functions of the CIE are given at a wavelength in nm.
constexpr bool is_visible(double nm) {
  return nm >= 360 && nm <= 780;
}

/// A grid and what its colour needs in between.
/// @param grid_nm ascending wavelengths
/// @param reflectance gives two reflectances at a wavelength in nm; called between visible ones of the grid only
std::vector<double> refined(const std::vector<double>& grid_nm,
                            const std::function<std::pair<double, double>(double)>& reflectance);

}  // namespace vcavity::tools
