// SPDX-License-Identifier: BSD-3-Clause
/// Skies on the command line, their directions computed here and nowhere else.

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "cli/program.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"

using namespace vcavity::tools;

namespace {

constexpr double pi = std::numbers::pi;

struct Way {
  double x, y, z;
};

/// Writes a sky: zenith at the top, +y in the middle, +x to the right of it.
template <class Radiance>
void write_sky(const std::filesystem::path& file, int height, const Radiance& radiance) {
  ExrImage image{2 * height, height, {{"R", {}}, {"G", {}}, {"B", {}}}, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < 2 * height; ++column) {
      const double theta = pi * (row + 0.5) / height, turn = pi * ((column + 0.5) / height - 1);
      const Way way{std::sin(theta) * std::sin(turn), std::sin(theta) * std::cos(turn), std::cos(theta)};
      for (std::size_t channel = 0; channel < 3; ++channel)
        image.channels[channel].plane.push_back(static_cast<float>(radiance(way, channel)));
    }
  write_exr(file, image);
}

ExrImage map_of(const std::string& options, const ScratchFolder& folder) {
  const Outcome outcome = run("map --out a.exr " + options, folder.path());
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  return read_exr(folder / "a.exr");
}

/// The direction of a pixel on the equal-area disc, u to the right along +y, v upwards along +x.
bool way_of(int column, int row, int size, Way& way) {
  const double u = std::sqrt(2.0) * ((2 * column + 1.0) / size - 1),
               v = std::sqrt(2.0) * (1 - (2 * row + 1.0) / size);
  const double square = u * u + v * v;
  if (square >= 2) return false;
  const double stretch = std::sqrt(1 - square / 4);
  way = {v * stretch, u * stretch, 1 - square / 2};
  return true;
}

}  // namespace

TEST_CASE("a flat mirror under a sky shows every direction its own part of it, the right way up") {
  const ScratchFolder folder;
  write_sky(folder / "sky.exr", 64, [](const Way& way, std::size_t channel) {
    return channel == 0 ? 1 + 0.8 * way.x : channel == 1 ? 1 + 0.8 * way.y : 1 + 0.8 * way.z;
  });
  constexpr int size = 24;
  const ExrImage image =
      map_of("--finish mirror --albedo 0.5 --aperture 180 --environment sky.exr --size 24", folder);
  int compared = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      Way way;
      if (!way_of(column, row, size, way) || way.z < 0.1) continue;
      CAPTURE(row, column);
      const auto pixel = static_cast<std::size_t>(row * size + column);
      CHECK(image.plane("R")[pixel] == Approx(0.5 * (1 - 0.8 * way.x)).margin(2e-3));
      CHECK(image.plane("G")[pixel] == Approx(0.5 * (1 - 0.8 * way.y)).margin(2e-3));
      CHECK(image.plane("B")[pixel] == Approx(0.5 * (1 + 0.8 * way.z)).margin(2e-3));
      ++compared;
    }
  CHECK(compared > 300);
}

TEST_CASE("under a white sky copper has in R, G and B its reflectance at 610, 550 and 465 nm") {
  const ScratchFolder folder;
  write_sky(folder / "white.exr", 4, [](const Way&, std::size_t) { return 1.0; });
  const std::string groove = "--material Cu --aperture 60 --size 12";
  const ExrImage coloured = map_of(groove + " --environment white.exr", folder);
  for (const auto& [channel, nm] : {std::pair{"R", "610"}, {"G", "550"}, {"B", "465"}}) {
    const ExrImage single = map_of(groove + " --wavelength " + nm, folder);
    for (std::size_t pixel = 0; pixel < 144; ++pixel)
      CHECK(coloured.plane(channel)[pixel] == Approx(single.plane("Y")[pixel]).margin(1e-5));
  }
  CHECK(coloured.plane("R")[6 * 12 + 6] > 1.2 * coloured.plane("B")[6 * 12 + 6]);
}
