// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/colour_map.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using namespace vcavity::tools;

namespace {

// Lightness L* (CIE 15:2018) of an sRGB pixel.
double lightness(Rgba8 pixel) {
  const auto linear = [](std::uint8_t byte) {
    const double value = byte / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(pixel.r) + 0.7152 * linear(pixel.g) + 0.0722 * linear(pixel.b);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

}  // namespace

TEST_CASE("grey shows a reflectance as a photograph would") {
  CHECK(map_colour(ColourMap::grey, 0) == Rgba8{0, 0, 0, 255});
  CHECK(map_colour(ColourMap::grey, 0.001) == Rgba8{3, 3, 3, 255});
  CHECK(map_colour(ColourMap::grey, 0.02) == Rgba8{39, 39, 39, 255});
  CHECK(map_colour(ColourMap::grey, 0.2140) ==
        Rgba8{127, 127, 127, 255});  // sRGB 127 is 0.2122, 128 is 0.2159
  CHECK(map_colour(ColourMap::grey, 1) == Rgba8{255, 255, 255, 255});
}

TEST_CASE("viridis runs from its dark violet through its green to its yellow") {
  CHECK(map_colour(ColourMap::viridis, 0) == Rgba8{68, 1, 84, 255});
  CHECK(map_colour(ColourMap::viridis, 120 / 255.0) == Rgba8{35, 137, 142, 255});
  CHECK(map_colour(ColourMap::viridis, 1) == Rgba8{253, 231, 37, 255});
}

// Viridis is uniform in CAM02-UCS, of which L* is an approximation: its own 256 colours keep within 15 % of
// even steps.
TEST_CASE("the lightness of viridis rises in nearly even steps") {
  constexpr int steps = 16;
  const auto at = [](int i) {
    return lightness(map_colour(ColourMap::viridis, static_cast<double>(i) / steps));
  };
  const double even = (at(steps) - at(0)) / steps;
  for (int i = 0; i < steps; ++i) CHECK((at(i + 1) - at(i)) / even == Catch::Approx(1).margin(0.15));
}

TEST_CASE("viridis is smooth: a wrong entry of its table would make a kink") {
  const auto at = [](int entry) { return map_colour(ColourMap::viridis, entry / 51.0); };
  const auto kink = [](int before, int here, int after) { return std::abs(before - 2 * here + after); };
  for (int i = 1; i < 51; ++i) {
    const Rgba8 before = at(i - 1), here = at(i), after = at(i + 1);
    CHECK(kink(before.r, here.r, after.r) <= 2);
    CHECK(kink(before.g, here.g, after.g) <= 2);
    CHECK(kink(before.b, here.b, after.b) <= 6);
  }
}

TEST_CASE("values out of range get the colour at the end, and no number gets none") {
  for (const auto map : {ColourMap::grey, ColourMap::viridis}) {
    CHECK(map_colour(map, -1) == map_colour(map, 0));
    CHECK(map_colour(map, std::numeric_limits<double>::infinity()) == map_colour(map, 1));
    CHECK(map_colour(map, std::numeric_limits<double>::quiet_NaN()).a == 0);
  }
}
