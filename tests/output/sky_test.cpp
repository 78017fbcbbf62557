// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/sky.hpp"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfEnvmap.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <algorithm>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "scratch_folder.hpp"
#include "support/catch.hpp"

using namespace vcavity::tools;

namespace {

/// A number that tells where in its display window a pixel stands, and in which channel.
float value_at(int x, int y, int channel) {
  return static_cast<float>(1 + x + 16 * y + 256 * channel);
}

/// Writes an image with value_at() in every pixel, without the help of the code under test.
/// @param names of its channels
void write(const std::filesystem::path& path, Imf::Header header, const std::vector<std::string>& names,
           Imf::PixelType type = Imf::FLOAT) {
  const Imath::Box2i window = header.dataWindow();
  const int width = window.size().x + 1;
  const int height = window.size().y + 1;
  std::vector<std::vector<float>> floats(names.size());
  std::vector<std::vector<std::uint32_t>> whole(names.size());
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(type));
    for (int y = window.min.y; y <= window.max.y; ++y)
      for (int x = window.min.x; x <= window.max.x; ++x) {
        floats[c].push_back(value_at(x, y, static_cast<int>(c)));
        whole[c].push_back(static_cast<std::uint32_t>(std::max(floats[c].back(), 0.0f)));
      }
    const void* values = type == Imf::UINT ? static_cast<const void*>(whole[c].data()) : floats[c].data();
    buffer.insert(names[c], Imf::Slice::Make(type, values, window.min, width, height));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(height);
}

/// What is wrong with an image, without "cannot read 'PATH': ".
std::string refusal(const std::filesystem::path& path) {
  const std::string text = error_of([&] { read_sky(path); });
  const std::string beginning = "cannot read '" + path.string() + "': ";
  return text.starts_with(beginning) ? text.substr(beginning.size()) : "without path: " + text;
}

const Imath::Box2i display({0, 0}, {7, 3});
const std::vector<std::string> rgb{"R", "G", "B"};

Imf::Header cropped(const Imath::Box2i& data) {
  return {display, data};
}

}  // namespace

TEST_CASE("pixels stand where the display window says, and it is dark outside the data window") {
  const ScratchFolder folder;
  for (const Imath::Box2i& data : {display, Imath::Box2i({2, 1}, {4, 2}), Imath::Box2i({0, 0}, {7, 1}),
                                   Imath::Box2i({-2, -1}, {9, 5}), Imath::Box2i({-3, 2}, {1, 9})}) {
    write(folder / "a.exr", cropped(data), rgb);
    const SkyImage sky = read_sky(folder / "a.exr");
    REQUIRE(sky.width == 8);
    REQUIRE(sky.height == 4);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 8; ++x) {
        const bool inside = data.intersects(Imath::V2i(x, y));
        const glm::vec3& pixel = sky.pixels[static_cast<std::size_t>(8 * y + x)];
        CHECK(pixel.x == (inside ? value_at(x, y, 0) : 0));
        CHECK(pixel.z == (inside ? value_at(x, y, 2) : 0));
      }
  }
}

TEST_CASE("a display window that starts elsewhere is the whole sky too") {
  const ScratchFolder folder;
  const Imath::Box2i elsewhere({10, 20}, {17, 23});
  write(folder / "a.exr", Imf::Header(elsewhere, Imath::Box2i({12, 21}, {12, 21})), rgb);
  const SkyImage sky = read_sky(folder / "a.exr");
  CHECK(sky.pixels[8 + 2].x == value_at(12, 21, 0));
  CHECK(sky.pixels[0].x == 0);
}

TEST_CASE("grey light is the same in red, green and blue, and other channels do not count") {
  const ScratchFolder folder;
  write(folder / "grey.exr", cropped(display), {"Y", "Z"});
  CHECK(read_sky(folder / "grey.exr").pixels[9] == glm::vec3(value_at(1, 1, 0)));
  write(folder / "layers.exr", cropped(display), {"R", "G", "B", "A", "sun.R"});
  CHECK(read_sky(folder / "layers.exr").pixels[9].y == value_at(1, 1, 1));
}

TEST_CASE("colours of other primaries become those of Rec. 709") {
  const ScratchFolder folder;
  Imf::Header header(display, display);
  // ACES AP0, SMPTE ST 2065-1.
  Imf::addChromaticities(header, {{0.7347f, 0.2653f}, {0, 1}, {0.0001f, -0.077f}, {0.32168f, 0.33767f}});
  write(folder / "ap0.exr", header, {"R", "G", "B"});
  const glm::vec3 found = read_sky(folder / "ap0.exr").pixels[0];
  // XYZ of AP0 (ST 2065-1, 1, 257, 513), then the matrix of IEC 61966-2-1, computed by hand.
  const double r = 1, g = 257, b = 513;
  const double x = 0.9525523959 * r + 0.0000936786 * b;
  const double y = 0.3439664498 * r + 0.7281660966 * g - 0.0721325464 * b;
  const double z = 1.0088251844 * b;
  CHECK(found.x == Approx(3.2406 * x - 1.5372 * y - 0.4986 * z).epsilon(2e-3));
  CHECK(found.y == Approx(-0.9689 * x + 1.8758 * y + 0.0415 * z).epsilon(2e-3));
  CHECK(found.z == Approx(0.0557 * x - 0.2040 * y + 1.0570 * z).epsilon(2e-3));

  Imf::Header same(display, display);
  Imf::addChromaticities(same, {});
  write(folder / "rec709.exr", same, rgb);
  CHECK(read_sky(folder / "rec709.exr").pixels[0] == glm::vec3(1, 257, 513));
}

TEST_CASE("images of another meaning are refused by name") {
  const ScratchFolder folder;
  Imf::Header cube(display, display);
  Imf::addEnvmap(cube, Imf::ENVMAP_CUBE);
  write(folder / "a.exr", cube, rgb);
  CHECK(refusal(folder / "a.exr") ==
        "it is a cube map (envmap), expected latitude and longitude; 'exrenvmap -l' converts it");
  Imf::Header views(display, display);
  Imf::addMultiView(views, {"left", "right"});
  write(folder / "a.exr", views, {"R", "G", "B", "right.R", "right.G", "right.B"});
  CHECK(refusal(folder / "a.exr") == "it holds several views (multiView), expected one image");
  write(folder / "a.exr", cropped(display), {"Y", "RY", "BY"});
  CHECK(refusal(folder / "a.exr") ==
        "it holds luminance and chroma (Y, RY, BY), expected channels R, G and B, or Y alone");
  write(folder / "a.exr", cropped(display), {"R", "G"});
  CHECK(refusal(folder / "a.exr") == "an environment has channels R, G and B, or Y");
  write(folder / "a.exr", cropped(display), rgb, Imf::UINT);
  CHECK(refusal(folder / "a.exr") == "channel 'R' holds whole numbers, expected half or float");

  Imf::Header latlong(display, display);
  Imf::addEnvmap(latlong, Imf::ENVMAP_LATLONG);
  write(folder / "a.exr", latlong, rgb);
  CHECK(read_sky(folder / "a.exr").width == 8);
}

TEST_CASE("a file of several images is refused") {
  const ScratchFolder folder;
  std::vector<Imf::Header> headers(2, Imf::Header(display, display));
  for (std::size_t i = 0; i < 2; ++i) {
    headers[i].setName(std::to_string(i));
    headers[i].setType(Imf::SCANLINEIMAGE);
    headers[i].channels().insert("Y", Imf::Channel(Imf::FLOAT));
  }
  {
    Imf::MultiPartOutputFile file((folder / "a.exr").c_str(), headers.data(), 2);
  }
  CHECK(refusal(folder / "a.exr") == "it has 2 parts, expected one image");
}

TEST_CASE("images too large to be meant are refused before any memory is taken for them") {
  const ScratchFolder folder;
  const Imath::Box2i large({0, 0}, {19999, 19999});
  for (const auto& [data, shown, name] :
       {std::tuple(large, large, "data"), std::tuple(large, display, "data"),
        std::tuple(display, large, "display")}) {
    Imf::Header header(shown, data);
    for (const std::string& channel : rgb) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    {
      Imf::OutputFile without_pixels((folder / "a.exr").c_str(), header);
    }
    CHECK(refusal(folder / "a.exr") ==
          std::string("its ") + name + " window has 400000000 pixels, at most 134217728 are read");
  }
}

TEST_CASE("pixels that are infinite or no number are counted") {
  const ScratchFolder folder;
  Imf::Header header(display, display);
  std::vector<float> plane(32, 1.0f);
  plane[3] = std::numeric_limits<float>::infinity();
  plane[4] = std::numeric_limits<float>::quiet_NaN();
  plane[5] = -std::numeric_limits<float>::infinity();
  Imf::FrameBuffer buffer;
  for (const std::string& name : rgb) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, plane.data(), {0, 0}, 8, 4));
  }
  {
    Imf::OutputFile file((folder / "a.exr").c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(4);
  }
  CHECK(refusal(folder / "a.exr") == "3 of its 32 pixels are infinite or not a number");
}
