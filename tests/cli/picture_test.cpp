// SPDX-License-Identifier: BSD-3-Clause
#include "cli/program.hpp"
#include "output/page.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"

using vcavity::tools::ColourMap;
using vcavity::tools::map_colour;
using vcavity::tools::Rgba8;
using vcavity::tools::write_exr;

namespace {

Page page_of(const std::string& options) {
  const ScratchFolder folder;
  const Outcome outcome = run("map --png a.png " + options, folder.path());
  CAPTURE(options, outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(folder.names() == std::vector<std::string>{"a.png"});
  return Page(folder / "a.png");
}

// The colour in the middle of the right quarter of a single disc, away from its grid lines.
Rgba8 colour_on_disc(const Page& page) {
  return page.at(page.width / 2 + 40, page.height / 2 + 30);
}

bool is_grey(Rgba8 pixel) {
  return pixel.r == pixel.g && pixel.g == pixel.b;
}

}  // namespace

TEST_CASE("a page at one wavelength is grey unless false colours are asked for") {
  CHECK(is_grey(colour_on_disc(page_of("--material Cu --aperture 60"))));
  CHECK_FALSE(is_grey(colour_on_disc(page_of("--material Cu --aperture 60 --false-color"))));
}

TEST_CASE("grey is a reflectance as a photograph shows it, black at 0, however narrow its range") {
  // Silver at 150 degrees reflects between 0.9 and 0.98 everywhere.
  const Rgba8 silver = colour_on_disc(page_of("--material Ag --aperture 150"));
  CHECK(is_grey(silver));
  CHECK(silver.r > 235);
  CHECK(silver.r < 255);
}

TEST_CASE("the luminance of red is that of red, not of blue") {
  const Page page = page_of(
      "--finish matte --albedo #ff0000,#0000ff --aperture 180 --wavelengths 400:700:10 --false-color");
  // Two discs of even brightness, the first at the upper end of the bar and the second at the lower.
  const auto lightness = [](Rgba8 pixel) { return pixel.r + pixel.g + pixel.b; };
  const Rgba8 red = page.at(page.width / 4, page.height / 2 + 15);
  const Rgba8 blue = page.at(page.width / 4 * 5 / 2, page.height / 2 + 15);
  CAPTURE(lightness(red), lightness(blue));
  CHECK(lightness(red) > lightness(blue) + 60);
}

TEST_CASE("copper is reddish on a page of the visible spectrum") {
  const Rgba8 copper = colour_on_disc(page_of("--material Cu --aperture 60 --wavelengths 400:700:20"));
  CHECK(copper.r > copper.g + 20);
  CHECK(copper.g > copper.b);
}

TEST_CASE("a flat surface bounces once everywhere, the first colour of its bar") {
  const Page page = page_of("--material Cu --aperture 180 --quantity bounces");
  const Rgba8 first = map_colour(ColourMap::viridis, 0);
  CHECK(page.find(first).count > 100'000);
}

TEST_CASE("contours are drawn in white") {
  const std::string map = "--material Cu --aperture 45 --false-color";
  const Rgba8 white{255, 255, 255, 255};
  const Page plain = page_of(map);
  const Page lined = page_of(map + " --contours");
  // Where the disc is widest the page has more white with the lines than without.
  const auto white_in_disc = [&](const Page& page) {
    int count = 0;
    for (int y = page.height / 2 - 20; y < page.height / 2 + 20; ++y)
      for (int x = 100; x < page.width / 2; ++x) count += page.at(x, y) == white ? 1 : 0;
    return count;
  };
  CHECK(white_in_disc(lined) > white_in_disc(plain) + 20);
}

TEST_CASE("an environment is exposed for its brightness, whatever the unit of its radiance") {
  for (const float unit : {1e-4f, 1.0f, 1e4f}) {
    const ScratchFolder folder;
    // Dark at the zenith, bright at the horizon, and reddish.
    write_exr(folder / "sky.exr", {1,
                                   4,
                                   {{"R", {unit, 4 * unit, unit, unit}},
                                    {"G", {unit / 2, 2 * unit, unit, unit}},
                                    {"B", {unit / 2, 2 * unit, unit, unit}}},
                                   {}});
    const Outcome outcome =
        run("map --material Ag --aperture 150 --environment sky.exr --png a.png", folder.path());
    CAPTURE(unit, outcome.err);
    REQUIRE(outcome.status == 0);
    const Rgba8 middle = colour_on_disc(Page(folder / "a.png"));
    CHECK(middle.r > 60);
    CHECK(middle.r < 250);
    CHECK(middle.r > middle.g + 20);
  }
}

TEST_CASE("a page needs something to show") {
  const Outcome outcome = run("map --material Ag --aperture 45 --wavelengths 900:1000:10 --png a.png");
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "vcavity_maps: a picture needs the reflectance at visible wavelengths, or a single --wavelength\n");
}
