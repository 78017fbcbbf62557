// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Where the tool's data (nk: refractive indices, cie: colour tables) are.

#include <filesystem>

namespace vcavity::tools {

/// The folder that holds `nk` and `cie`: the environment variable VCAVITY_DATA if set, else share/vcavity
/// beside the program's own bin folder (an installed program), else data in the source tree (a program run
/// where it was built). Throws UsageError if VCAVITY_DATA names no folder, std::runtime_error if there is
/// none at all.
std::filesystem::path data_directory();

}  // namespace vcavity::tools
