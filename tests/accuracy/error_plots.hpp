// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The figures of docs/accuracy.md.

#include <filesystem>

namespace vcavity::test {

/// Draws how errors grow with weak contrast, with thousands of bounces and towards grazing incidence, as
/// accuracy_contrast.svg, accuracy_bounces.svg and accuracy_grazing.svg.
/// Throws std::runtime_error when a file cannot be written.
void write_error_plots(const std::filesystem::path& folder);

}  // namespace vcavity::test
