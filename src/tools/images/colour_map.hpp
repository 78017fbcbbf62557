// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Colours for numbers: what figures show in place of a scalar.

#include <cstdint>

namespace vcavity::tools {

/// A pixel of a picture: sRGB-encoded, alpha not multiplied in.
struct Rgba8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 0;

  bool operator==(const Rgba8&) const = default;
};

/// How a number in [0, 1] becomes a colour.
enum class ColourMap {
  grey,     ///< a grey of that luminance relative to white: what a photograph of the reflectance would show
  viridis,  ///< perceptually uniform, readable without colour vision (van der Walt & Smith 2015, CC0)
};

/// The opaque colour of `value`, clamped to [0, 1]; transparent if `value` is not a number.
Rgba8 map_colour(ColourMap map, double value);

/// The opaque pixel of a linear RGB colour with Rec. 709 primaries, each component clamped to [0, 1].
Rgba8 srgb_pixel(double r, double g, double b);

}  // namespace vcavity::tools
