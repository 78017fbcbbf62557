// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Pixels of a PNG file, to check what a figure shows.

#include <cairo.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <vector>

#include "support/catch.hpp"
#include "tools/images/colour_map.hpp"

/// Where on the page pixels of one colour lie; the bounds are inclusive.
struct Patch {
  int count = 0;
  double x = 0, y = 0;  // centroid
  int left = 1 << 30, right = -1, top = 1 << 30, bottom = -1;
};

class Page {
 public:
  explicit Page(const std::filesystem::path& png) {
    cairo_surface_t* surface = cairo_image_surface_create_from_png(png.c_str());
    REQUIRE(cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS);
    width = cairo_image_surface_get_width(surface);
    height = cairo_image_surface_get_height(surface);
    const unsigned char* data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        std::uint32_t word;
        std::memcpy(&word, data + y * stride + 4 * x, sizeof word);
        const auto byte = [&](int shift) { return static_cast<std::uint8_t>(word >> shift); };
        pixels_.push_back({byte(16), byte(8), byte(0), 255});
      }
    cairo_surface_destroy(surface);
  }

  vcavity::tools::Rgba8 at(int x, int y) const { return pixels_[static_cast<std::size_t>(y * width + x)]; }

  Patch find(vcavity::tools::Rgba8 colour) const {
    Patch patch;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (at(x, y) == colour) {
          ++patch.count;
          patch.x += x;
          patch.y += y;
          patch.left = std::min(patch.left, x);
          patch.right = std::max(patch.right, x);
          patch.top = std::min(patch.top, y);
          patch.bottom = std::max(patch.bottom, y);
        }
    patch.x /= std::max(patch.count, 1);
    patch.y /= std::max(patch.count, 1);
    return patch;
  }

  int width, height;

 private:
  std::vector<vcavity::tools::Rgba8> pixels_;
};
