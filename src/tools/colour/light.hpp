// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The light in which a colour is seen.

#include <string>
#include <string_view>

#include "tools/support/linear_table.hpp"

namespace vcavity::tools {

/// Illuminants of the CIE. E has equal power at every wavelength.
enum class Illuminant { a, d65, e };

/// A light.
struct Light {
  std::string name;   ///< for people
  LinearTable power;  ///< relative spectral power as a function of the wavelength in nm
};

/// An illuminant of the CIE, from 360 to 780 nm in steps of 5 nm. Throws std::runtime_error if its table in
/// data/cie cannot be read.
Light cie_illuminant(Illuminant illuminant);

/// The light that a user's words stand for.
/// @param specification `D65`, `E` or `A`, letter case aside, or a file with a wavelength in nm and a power
/// in
///                        every line, separated by a comma or white space; '#' starts a comment
/// Throws UsageError for a word that is neither; std::runtime_error "FILE: ..." for a file that cannot be
/// read and "FILE:LINE: ..." where it is malformed: without a row, with a negative power, or without any
/// power at all.
Light load_light(std::string_view specification);

}  // namespace vcavity::tools
