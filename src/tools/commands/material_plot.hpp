// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The curves of a material: n, k and what a flat surface of it reflects.

#include <vector>

#include "tools/images/plot.hpp"
#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Two plots over all wavelengths of the data, to be drawn below each other: n and k, and the reflectance at
/// normal incidence. The lines have gaps where Material::at() refuses the data.
/// Throws UsageError for a material of constant index.
std::vector<Plot> material_plots(const Material& material);

}  // namespace vcavity::tools
