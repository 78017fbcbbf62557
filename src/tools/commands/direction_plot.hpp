// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The cross-section of a surface and the way of the light of one direction over it.

#include <string>
#include <vcavity/conventions.hpp>
#include <vector>

#include "tools/images/atomic_file.hpp"
#include "tools/surfaces/surface.hpp"
#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// What is drawn.
struct DirectionPlot {
  const SurfaceDescription& surface;
  Vec3<double> e;                         ///< towards the light, e.z > 0
  const std::vector<SurfaceLobe>& lobes;  ///< of the direction, in the order in which the surface tells them
  std::string title;
  std::string footnote;
};

/// Draws grooves to scale, the light that enters one as a beam for every lobe, as wide as its weight, the way of the ray
/// in its middle with bounces numbered, and where it goes. Everything is seen along the grooves.
/// @param file .png or .svg
/// @throws UsageError where there are no lobes, or light does not come from above
void write_direction_plot(AtomicFile& file, const DirectionPlot& plot);

}  // namespace vcavity::tools
