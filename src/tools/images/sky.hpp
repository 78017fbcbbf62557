// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Latitude–longitude images of the light from all around, as other programs write them into OpenEXR files.
///
/// What the header of a file says about the meaning of its pixels is honoured or refused by name:
/// - pixels stand where data and display window say: outside the data window it is dark, outside the display window
///   nothing counts;
/// - `chromaticities`: converted to linear Rec. 709, without adaptation to another white;
/// - `envmap`: a cube is refused;
/// - several parts, several views, deep pixels, whole numbers, luminance with chroma (RY, BY) and subsampled channels
///   are refused; of tiled images with levels the finest is read; `whiteLuminance` only sets the unit of the radiance.
/// Pixels that are infinite or not a number are refused with their count.
/// When not to use it: for images that this program wrote and means to read back exactly, there is read_exr().

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

namespace vcavity::tools {

/// The largest sky, in pixels of its data window and of its display window: 16384 × 8192. Each takes 12 bytes of memory.
inline constexpr std::int64_t largest_sky = std::int64_t{1} << 27;

/// Radiances in linear Rec. 709, row by row from the top.
struct SkyImage {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;
};

/// Reads an image with the channels R, G and B, or Y for grey light.
/// @throws std::runtime_error "cannot read 'PATH': REASON"
SkyImage read_sky(const std::filesystem::path& path);

}  // namespace vcavity::tools
