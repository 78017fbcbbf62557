// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A BRDF as files of other programs. All of them are computed on all cores, and show progress.

#include <memory>
#include <string>
#include <vector>

#include "tools/surfaces/surface.hpp"

namespace vcavity::tools {

/// A surface to write, at one or several wavelengths. It has a BRDF.
struct ExportedSurface {
  std::string name;                    ///< material and shape, for people
  bool is_isotropic;                   ///< whether its BRDF depends on no azimuth but their difference
  std::vector<double> wavelengths_nm;  ///< ascending
  std::vector<std::unique_ptr<const Surface>> spectrum;  ///< the surface at each of them
};

/// BSDF XML of Radiance and WINDOW: the mean BRDF from each to each of Klems' 145 patches of the hemisphere, such that
/// hemispherical reflectances are those of the surface.
/// @param surface at one wavelength
/// @throws UsageError for several wavelengths
std::string bsdf_xml(const ExportedSurface& surface);

/// A file of Mitsuba's BSDF `measured`: BRDF × cosine over the angle of incidence, the half vector and the wavelength.
/// @throws UsageError for surfaces that are not isotropic
std::string measured_tensors(const ExportedSurface& surface);

/// A file of the MERL database: the BRDF over half vector and difference vector, in three colours.
/// @param surface at one wavelength, or at those of blue, green and red
/// @throws UsageError for another number of wavelengths, and for surfaces that are not isotropic
std::string merl_binary(const ExportedSurface& surface);

}  // namespace vcavity::tools
