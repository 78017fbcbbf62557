// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The bi-hemispherical reflectance as a ray tracer estimates it: Embree follows random rays of diffuse light
/// from panel to panel across an array of real grooves. It shares no formula with the library.

#include <complex>
#include <cstdint>
#include <functional>

namespace vcavity::tools {

/// What came of some rays.
struct TracedReflectance {
  double mean;            ///< reflectance
  long long reflections;  ///< all together
};

/// Traces as many rays as it is asked for; equal seeds give equal rays.
using DiffuseTracer = std::function<TracedReflectance(int rays, std::uint64_t seed)>;

/// A tracer for grooves of one material, in the paper's model of polarisation.
/// @param aperture angle between the panels in radians, in (0, π]
/// @param index n + ik
/// Throws std::runtime_error if Embree reports an error.
DiffuseTracer diffuse_tracer(double aperture, std::complex<double> index);

}  // namespace vcavity::tools
