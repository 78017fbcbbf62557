// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Grooves with unequal panels, several materials, floors or land.

#include <memory>

#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// Such a surface at a wavelength; see make_surface().
std::unique_ptr<const Surface> make_profile_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                    const LightModel& light);

}  // namespace vcavity::tools
