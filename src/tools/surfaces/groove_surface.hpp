// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The symmetric groove of one material.

#include <memory>

#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// A symmetric groove at a wavelength; see make_surface().
std::unique_ptr<const Surface> make_groove_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                   const LightModel& light);

}  // namespace vcavity::tools
