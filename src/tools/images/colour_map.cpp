// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/colour/colour.hpp"

namespace vcavity::tools {
namespace {

// Every fifth of the 256 colours of "viridis" by Stéfan van der Walt and Nathaniel Smith (2015), data in the
// public domain (CC0). Linear interpolation between them stays within 1 of 255 of the full table.
constexpr std::array<std::uint32_t, 52> viridis{
    0x440154, 0x46085c, 0x471063, 0x481769, 0x481d6f, 0x482475, 0x472a7a, 0x46307e, 0x453781,
    0x433d84, 0x414287, 0x3f4889, 0x3d4e8a, 0x3a538b, 0x38598c, 0x355e8d, 0x33638d, 0x31688e,
    0x2e6d8e, 0x2c718e, 0x2a768e, 0x297b8e, 0x27808e, 0x25848e, 0x23898e, 0x218e8d, 0x20928c,
    0x1f978b, 0x1e9c89, 0x1fa188, 0x21a585, 0x24aa83, 0x28ae80, 0x2eb37c, 0x35b779, 0x3dbc74,
    0x46c06f, 0x50c46a, 0x5ac864, 0x65cb5e, 0x70cf57, 0x7cd250, 0x89d548, 0x95d840, 0xa2da37,
    0xb0dd2f, 0xbddf26, 0xcae11f, 0xd8e219, 0xe5e419, 0xf1e51d, 0xfde725,
};

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

double component(std::uint32_t colour, int shift) {
  return (colour >> shift & 0xff) / 255.0;
}

Rgba8 viridis_colour(double value) {
  const double position = value * (viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(position), viridis.size() - 2);
  const auto mix = [&](int shift) {
    return to_byte(std::lerp(component(viridis[below], shift), component(viridis[below + 1], shift),
                             position - static_cast<double>(below)));
  };
  return {mix(16), mix(8), mix(0), 255};
}

}  // namespace

Rgba8 map_colour(ColourMap map, double value) {
  if (std::isnan(value)) return {};
  value = std::clamp(value, 0.0, 1.0);
  return map == ColourMap::viridis ? viridis_colour(value) : srgb_pixel(value, value, value);
}

Rgba8 srgb_pixel(double r, double g, double b) {
  return {to_byte(encode_srgb(r)), to_byte(encode_srgb(g)), to_byte(encode_srgb(b)), 255};
}

}  // namespace vcavity::tools
