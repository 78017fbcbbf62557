// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What accuracy costs in the BRDF of a rough surface and in its directional albedo, measured on this machine.

#include <vector>

#include "tools/cost/cost_report.hpp"
#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// Two sections: values of the BRDF by the bounce limit; and the albedo of some directions by the bounce limit of its
/// quadrature, by a table, and by random walks in explicit grooves.
/// @param surface with a roughness, without films
/// @param wavelength_nm of the facets' index
std::vector<CostSection> costs_of_brdf(const SurfaceDescription& surface, double wavelength_nm);

}  // namespace vcavity::tools
