// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <vcavity/vcavity.hpp>

#include "cli/program.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"

using namespace vcavity;
using tools::ExrImage;

namespace {

ExrImage map_of(const std::string& options) {
  const ScratchFolder folder;
  const Outcome outcome = run("map --out a.exr " + options, folder.path());
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.empty());
  CHECK(folder.names() == std::vector<std::string>{"a.exr"});
  return tools::read_exr(folder / "a.exr");
}

std::vector<std::string> channels(const ExrImage& image) {
  std::vector<std::string> names;
  for (const auto& channel : image.channels) names.push_back(channel.name);
  return names;
}

std::string text(const ExrImage& image, const char* attribute) {
  return std::get<std::string>(image.attributes.at(attribute));
}

// Calls `check` with every pixel inside the disc and its direction. The pixels outside must be empty.
template <class Check>
void for_each_direction(const ExrImage& image, Check&& check) {
  const int size = image.width;
  REQUIRE(image.height == size);
  const auto& alpha = image.plane("A");
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const auto pixel = static_cast<std::size_t>(row * size + column);
      const double u = std::sqrt(2.0) * ((column + 0.5) * 2 / size - 1);
      const double v = std::sqrt(2.0) * (1 - (row + 0.5) * 2 / size);
      const double theta = 2 * std::asin(std::hypot(u, v) / 2);
      if (std::hypot(u, v) < std::sqrt(2.0)) {
        CHECK(alpha[pixel] == 1);
        check(pixel, direction(theta, std::atan2(v, u)));
      } else {
        for (const auto& channel : image.channels) CHECK(channel.plane[pixel] == 0);
      }
    }
}

}  // namespace

TEST_CASE("a map at one wavelength holds the directional reflectance of every direction") {
  const ExrImage image = map_of("--material 0.1249+3.3391i --aperture 60 --size 24");
  CHECK(channels(image) == std::vector<std::string>{"A", "Y"});
  const Cavity<double> cavity(radians(60.0));
  const Conductor<double> silver(0.1249, 3.3391);
  for_each_direction(image, [&](std::size_t pixel, const Vec3<double>& e) {
    const double expected = directional_reflectance(cavity, e, silver);
    CHECK(image.plane("Y")[pixel] == Catch::Approx(expected).epsilon(1e-6));
  });
}

TEST_CASE("a map of many wavelengths holds each of them beside its colour") {
  const ExrImage image = map_of("--material Cu --aperture 60 --size 8 --wavelengths 400:700:100");
  CHECK(channels(image) == std::vector<std::string>{"A", "B", "G", "R", "T.400,000000nm", "T.500,000000nm",
                                                    "T.600,000000nm", "T.700,000000nm"});
  CHECK(text(image, "spectralLayoutVersion") == "1.0");
  const ExrImage single = map_of("--material Cu --aperture 60 --size 8 --wavelength 600");
  for (std::size_t i = 0; i < 64; ++i)
    CHECK(image.plane("T.600,000000nm")[i] == Catch::Approx(single.plane("Y")[i]).epsilon(1e-6));
}

TEST_CASE("a map of the bounces holds their least, mean and greatest number") {
  const ExrImage image = map_of("--material 1.5 --aperture 45 --size 24 --quantity bounces");
  const Cavity<double> cavity(radians(45.0));
  for_each_direction(image, [&](std::size_t pixel, const Vec3<double>& e) {
    int least = 1000, most = 0;
    double mean = 0;
    for (const auto& lobe : lobes(cavity, e, [](double) { return 1.0; })) {
      least = std::min(least, lobe.bounces);
      most = std::max(most, lobe.bounces);
      mean += lobe.weight * lobe.bounces;
    }
    CHECK(image.plane("bounces.least")[pixel] == static_cast<float>(least));
    CHECK(image.plane("bounces.most")[pixel] == static_cast<float>(most));
    CHECK(image.plane("Y")[pixel] == Catch::Approx(mean).epsilon(1e-6));
  });
}

TEST_CASE("reflectance and absorptance of a direction add up to one in each model of polarisation") {
  for (const char* model : {"none", "separate", "full"}) {
    const std::string map =
        std::string("--material Cu --aperture 50 --size 16 --wavelengths 400:700:100 --polarization ") +
        model;
    const ExrImage reflectance = map_of(map);
    const ExrImage absorptance = map_of(map + " --quantity absorptance");
    for_each_direction(absorptance, [&](std::size_t pixel, const Vec3<double>&) {
      const auto sum =
          reflectance.plane("T.500,000000nm")[pixel] + absorptance.plane("T.500,000000nm")[pixel];
      CHECK(sum == Catch::Approx(1).epsilon(1e-6));
    });
  }
}

TEST_CASE(
    "a map of a BRDF shows the light of one bounce in the mirror direction, where all of it is infinite") {
  const std::string rough_metal = "--material 0.2+3i --distribution ggx --roughness 0.3 --theta 0 --phi 0 ";
  const ExrImage image = map_of(rough_metal + "--size 9");
  const ExrImage one_bounce = map_of(rough_metal + "--size 9 --max-bounces 1");
  const float middle = one_bounce.plane("Y")[4 * 9 + 4];
  CHECK(middle > 0);
  CHECK(image.plane("Y")[4 * 9 + 4] == middle);
  CHECK(image.plane("Y")[4 * 9 + 5] > one_bounce.plane("Y")[4 * 9 + 5]);
}

TEST_CASE("a map says where it comes from") {
  const ExrImage image = map_of("--material Cu --aperture 45.5 --size 8 --wavelength 600 --max-bounces 2");
  CHECK(text(image, "command") ==
        "vcavity_maps map --out a.exr --material Cu --aperture 45.5 --size 8 --wavelength 600 "
        "--max-bounces 2");
  CHECK(text(image, "software").starts_with("vcavity "));
  CHECK(text(image, "material") == "Cu-Johnson");
  CHECK(text(image, "materialSource").find("Johnson") != std::string::npos);
  CHECK(text(image, "maxBounces") == "2");
  CHECK(text(image, "units") == "1");
  CHECK(std::get<double>(image.attributes.at("apertureDeg")) == 45.5);
  CHECK(std::get<double>(image.attributes.at("wavelengthNm")) == 600);
}

TEST_CASE("half numbers and other compressions change the file but not its meaning") {
  const std::string map = "--material Cu --aperture 60 --size 16 --wavelengths 400:700:100";
  const ExrImage exact = map_of(map);
  for (const char* method : {"none", "rle", "zips", "zip", "piz"})
    CHECK(map_of(map + " --compression " + method).plane("R") == exact.plane("R"));
  const ExrImage rounded = map_of(map + " --precision half");
  for (const auto& channel : exact.channels)
    for (std::size_t i = 0; i < channel.plane.size(); ++i)
      CHECK(rounded.plane(channel.name)[i] == Catch::Approx(channel.plane[i]).epsilon(std::ldexp(1, -11)));
}

TEST_CASE("light, observer and primaries change the colour but not the spectrum") {
  const std::string map = "--material Cu --aperture 60 --size 16 --wavelengths 400:700:20";
  const ExrImage usual = map_of(map);
  for (const char* option : {" --illuminant A", " --observer 10", " --rgb rec2020"}) {
    const ExrImage other = map_of(map + option);
    CHECK(other.plane("R") != usual.plane("R"));
    CHECK(other.plane("T.600,000000nm") == usual.plane("T.600,000000nm"));
    CHECK(text(other, "colour") != text(usual, "colour"));
  }
}

TEST_CASE("the light of a file is as good as the same light by name") {
  const ScratchFolder folder;
  std::string rows = "# wavelength_nm, power\n";
  for (int nm = 400; nm <= 700; nm += 20) rows += std::to_string(nm) + ", 3.5\n";
  put(folder / "flat.csv", rows);
  const std::string map = "map --material Cu --aperture 60 --size 16 --wavelengths 400:700:20 --illuminant ";
  REQUIRE(run(map + "flat.csv --out own.exr", folder.path()).status == 0);
  REQUIRE(run(map + "e --out named.exr", folder.path()).status == 0);
  const auto own = tools::read_exr(folder / "own.exr").plane("G");
  const auto named = tools::read_exr(folder / "named.exr").plane("G");
  for (std::size_t i = 0; i < own.size(); ++i) CHECK(own[i] == Catch::Approx(named[i]).epsilon(1e-6));
}

TEST_CASE("a lamp with a line narrower than the grid has the same colour on every grid") {
  const ScratchFolder folder;
  std::string rows = "Wavelength (nm);Power\r\n";
  for (int nm = 380; nm <= 780; ++nm) {
    const double line = std::exp(-std::pow((nm - 451.3) / 0.8, 2));
    const double phosphor = 0.02 * std::exp(-std::pow((nm - 570) / 60.0, 2));
    rows += std::to_string(nm) + ";" + std::to_string(line + phosphor) + "\r\n";
  }
  put(folder / "led.csv", rows);
  const auto colour = [&](int step) {
    const std::string grid = "400:700:" + std::to_string(step);
    REQUIRE(
        run("map --material Cu --aperture 60 --size 1 --illuminant led.csv --out a.exr --wavelengths " + grid,
            folder.path())
            .status == 0);
    const ExrImage image = tools::read_exr(folder / "a.exr");
    return std::array{image.plane("R")[0], image.plane("G")[0], image.plane("B")[0]};
  };
  const auto expected = colour(1);
  for (const int step : {5, 10, 20})
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(step, i);
      CHECK(colour(step)[i] == Catch::Approx(expected[i]).epsilon(3e-3));
    }
}

TEST_CASE(
    "a table of n and k finer than the grid shows in the colour, and the map says where it was looked at") {
  // An absorption line at 545 nm, between two wavelengths of the coarse grid.
  const ScratchFolder folder;
  std::string rows = "wavelength_nm,n,k\n400,1.5,0\n541,1.5,0\n545,1.5,3\n549,1.5,0\n700,1.5,0\n";
  put(folder / "line.csv", rows);
  const auto map = [&](int step) {
    REQUIRE(run("map --material ./line.csv --aperture 60 --size 1 --out a.exr --wavelengths 400:700:" +
                    std::to_string(step),
                folder.path())
                .status == 0);
    return tools::read_exr(folder / "a.exr");
  };
  const ExrImage fine = map(1), coarse = map(20);
  for (const char* channel : {"R", "G", "B"})
    CHECK(coarse.plane(channel)[0] == Catch::Approx(fine.plane(channel)[0]).margin(5e-4));
  CHECK(text(coarse, "colourWavelengthsNm").find(" 545 ") != std::string::npos);
  CHECK(coarse.channels.size() == 4 + 16);
  CHECK(fine.attributes.count("colourWavelengthsNm") == 0);
}

TEST_CASE("a sun too bright for half numbers is refused, not infinite") {
  const ScratchFolder folder;
  ExrImage sky{4, 2, {{"Y", std::vector<float>(8, 3e6f)}}, {}};
  tools::write_exr(folder / "sky.exr", sky);
  const std::string map = "map --material Ag --aperture 60 --size 4 --environment sky.exr --out a.exr";
  const Outcome outcome = run(map + " --precision half", folder.path());
  CHECK(outcome.status == 1);
  CHECK(outcome.err.starts_with("vcavity_maps: cannot write 'a.exr': channel 'R' has the value "));
  CHECK(outcome.err.ends_with("--precision half holds none beyond 65504\n"));
  CHECK_FALSE(std::filesystem::exists(folder / "a.exr"));
  CHECK(run(map, folder.path()).status == 0);
}

TEST_CASE("lights that are no lights are refused") {
  const ScratchFolder folder;
  put(folder / "negative.csv", "400 1\n700 -1\n");
  put(folder / "dark.csv", "# nothing\n");
  put(folder / "short.csv", "400 1\n600 1\n");
  const auto refused = [&](const std::string& light, int status, const std::string& text) {
    const Outcome outcome =
        run("map --material Cu --aperture 60 --size 16 --wavelengths 400:700:20 --out a.exr --illuminant " +
                light,
            folder.path());
    CHECK(outcome.status == status);
    CHECK(outcome.err == "vcavity_maps: " + text + "\n");
  };
  refused("D50", 2, "unknown light 'D50', expected D65, E, A or a file such as ./lamp.csv");
  refused("lamp.csv", 1, "lamp.csv: cannot read: No such file or directory");
  refused("negative.csv", 1, "negative.csv:2: the power of a light must not be negative");
  refused("dark.csv", 1, "dark.csv:1: there is no light: expected lines of wavelength in nm and power");
  refused("short.csv", 2, "light 'short.csv' is given from 400 to 600 nm, which leaves out 605 nm");
}
