// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Pairs of .spd files, as pbrt and Mitsuba have them for metals: X.eta.spd with n and X.k.spd with k beside
/// it.
///
/// Each line is a wavelength in nm and a value; '#' starts a comment. Rows may stand in any order, those of
/// the same wavelength are replaced by their mean. The wavelengths of the two files may differ; the material
/// is known where both are given. Sources of the format: pbrt-v3, file "spds/metals"; Mitsuba, "Scene file
/// format: spectra".

#include <filesystem>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Reads both files of a pair; the material is called X.
/// @param either X.eta.spd or X.k.spd
/// Throws UsageError if the name has neither ending; std::runtime_error "FILE:LINE: reason" if a file is
/// malformed, "FILE: cannot read: reason" if one cannot be read.
Material read_spd_pair(const std::filesystem::path& either,
                       MissingExtinction missing = MissingExtinction::refused);

}  // namespace vcavity::tools
