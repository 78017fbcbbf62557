// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/sky.hpp"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfEnvmap.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace vcavity::tools {
namespace {

std::int64_t area(const Imath::Box2i& window) {
  return (std::int64_t{window.max.x} - window.min.x + 1) * (std::int64_t{window.max.y} - window.min.y + 1);
}

void check_size(const char* name, const Imath::Box2i& window) {
  if (area(window) > largest_sky)
    throw std::runtime_error(std::string("its ") + name + " has " + std::to_string(area(window)) +
                             " pixels, at most " + std::to_string(largest_sky) + " are read");
}

// What would give the pixels another meaning.
void check_meaning(const Imf::Header& header) {
  if (header.hasType() && header.type() != Imf::SCANLINEIMAGE && header.type() != Imf::TILEDIMAGE)
    throw std::runtime_error("it holds deep pixels, expected a flat image");
  if (Imf::hasMultiView(header))
    throw std::runtime_error("it holds several views (multiView), expected one image");
  if (Imf::hasEnvmap(header) && Imf::envmap(header) != Imf::ENVMAP_LATLONG)
    throw std::runtime_error(
        "it is a cube map (envmap), expected latitude and longitude; 'exrenvmap -l' converts it");
}

/// R, G, B, or three times Y.
std::vector<std::string> channels_of(const Imf::Header& header) {
  const Imf::ChannelList& list = header.channels();
  std::vector<std::string> channels{"Y", "Y", "Y"};
  if (list.findChannel("R") && list.findChannel("G") && list.findChannel("B")) {
    channels = {"R", "G", "B"};
  } else if (!list.findChannel("Y")) {
    throw std::runtime_error("an environment has channels R, G and B, or Y");
  } else if (list.findChannel("RY") || list.findChannel("BY")) {
    throw std::runtime_error(
        "it holds luminance and chroma (Y, RY, BY), expected channels R, G and B, or Y alone");
  }
  for (const std::string& name : channels) {
    const Imf::Channel& channel = *list.findChannel(name);
    if (channel.xSampling != 1 || channel.ySampling != 1)
      throw std::runtime_error("channel '" + name + "' is subsampled");
    if (channel.type == Imf::UINT)
      throw std::runtime_error("channel '" + name + "' holds whole numbers, expected half or float");
  }
  return channels;
}

// From the primaries of the file to those of Rec. 709, through XYZ; row vectors, as Imath multiplies.
Imath::M44f to_rec709(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header) || Imf::chromaticities(header) == Imf::Chromaticities()) return {};
  return Imf::RGBtoXYZ(Imf::chromaticities(header), 1) * Imf::XYZtoRGB(Imf::Chromaticities(), 1);
}

glm::vec3 converted(const glm::vec3& rgb, const Imath::M44f& matrix) {
  const Imath::V3f result = Imath::V3f(rgb.x, rgb.y, rgb.z) * matrix;
  return {result.x, result.y, result.z};
}

bool is_finite(const glm::vec3& rgb) {
  return std::isfinite(rgb.x) && std::isfinite(rgb.y) && std::isfinite(rgb.z);
}

}  // namespace

SkyImage read_sky(const std::filesystem::path& path) try {
  if (const int parts = Imf::MultiPartInputFile(path.c_str()).parts(); parts != 1)
    throw std::runtime_error("it has " + std::to_string(parts) + " parts, expected one image");
  Imf::InputFile input(path.c_str(), 1);
  const Imf::Header& header = input.header();
  check_meaning(header);
  const std::vector<std::string> channels = channels_of(header);
  const bool coloured = channels.front() == "R";
  const Imath::Box2i data = header.dataWindow();
  const Imath::Box2i display = header.displayWindow();
  check_size("data window", data);
  check_size("display window", display);

  SkyImage image{display.size().x + 1, display.size().y + 1, {}};
  image.pixels.resize(static_cast<std::size_t>(area(display)), glm::vec3(0.0f));
  const Imath::M44f matrix = to_rec709(header);
  const int left = std::max(data.min.x, display.min.x);
  const int right = std::min(data.max.x, display.max.x);
  std::vector<glm::vec3> line(static_cast<std::size_t>(data.max.x - data.min.x + 1));
  std::int64_t not_finite = 0;
  for (int y = std::max(data.min.y, display.min.y); y <= std::min(data.max.y, display.max.y); ++y) {
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < (coloured ? 3 : 1); ++c)
      buffer.insert(channels[c],
                    Imf::Slice::Make(Imf::FLOAT, &line.front()[static_cast<int>(c)], {data.min.x, y},
                                     data.max.x - data.min.x + 1, 1, sizeof(glm::vec3)));
    input.setFrameBuffer(buffer);
    input.readPixels(y);
    glm::vec3* const row =
        image.pixels.data() + static_cast<std::ptrdiff_t>(y - display.min.y) * image.width - display.min.x;
    for (int x = left; x <= right; ++x) {
      const glm::vec3& pixel = line[static_cast<std::size_t>(x - data.min.x)];
      row[x] = coloured ? converted(pixel, matrix) : glm::vec3(pixel.x);
      if (!is_finite(row[x])) ++not_finite;
    }
  }
  if (not_finite > 0)
    throw std::runtime_error(std::to_string(not_finite) + " of its " + std::to_string(image.pixels.size()) +
                             " pixels are infinite or not a number");
  return image;
} catch (const std::exception& error) {
  throw std::runtime_error("cannot read '" + path.string() + "': " + error.what());
}

}  // namespace vcavity::tools
