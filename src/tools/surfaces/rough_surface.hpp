// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Rough and brushed surfaces: distributions of grooves.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tools/surfaces/surface.hpp"

namespace vcavity::tools {

struct SurfaceDescription;
struct LightModel;

/// A distribution of grooves, in the words of the command line.
struct Roughness {
  enum class Distribution { ggx, beckmann, brushed } distribution;
  double along_x;            ///< roughness of the slopes along +x
  double along_y;            ///< along +y; the same for brushed surfaces
  double concentration = 0;  ///< of the azimuth of brushed grooves about x
};

/// Its columns in a table: `distribution` and `roughness`, or `roughness_x` and `roughness_y`; and `concentration`.
nlohmann::ordered_json fields_of(const Roughness& roughness);

/// For people: "ggx, roughness 0.3", "brushed, roughness 0.3, concentration 20".
std::string in_words(const Roughness& roughness);

/// As part of a file name: "ggx-0.3", "beckmann-0.1-0.4", "brushed-0.3-20".
std::string file_stem(const Roughness& roughness);

/// A rough surface at a wavelength; see make_surface().
std::unique_ptr<const Surface> make_rough_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                  const LightModel& light);

}  // namespace vcavity::tools
