// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The groove whose panels have an albedo: matte ones, with or without a specular part, or mirrors that reflect alike at
/// every angle.

#include <memory>

#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// A groove with panels of a given albedo at a wavelength; see make_surface().
/// @param surface with `albedos`
/// @throws UsageError where light is to be followed in a way that such panels do not know
std::unique_ptr<const Surface> make_albedo_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                   const LightModel& light);

}  // namespace vcavity::tools
