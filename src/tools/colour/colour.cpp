// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/colour.hpp"

#include <algorithm>
#include <cmath>

namespace vcavity::tools {
namespace {

/// The cube root that L*a*b* is built on, with the straight line that continues it near black.
double lightness_root(double ratio) {
  constexpr double knee = 6.0 / 29;
  return ratio > knee * knee * knee ? std::cbrt(ratio) : ratio / (3 * knee * knee) + 4.0 / 29;
}

/// Rows of a matrix that takes XYZ to RGB.
struct RgbMatrix {
  Xyz r;
  Xyz g;
  Xyz b;

  LinearRgb operator*(const Xyz& colour) const {
    const auto dot = [&colour](const Xyz& row) {
      return row.x * colour.x + row.y * colour.y + row.z * colour.z;
    };
    return {dot(r), dot(g), dot(b)};
  }
};

}  // namespace

Lab to_lab(const Xyz& colour, const Xyz& white) {
  const double x = lightness_root(colour.x / white.x);
  const double y = lightness_root(colour.y / white.y);
  const double z = lightness_root(colour.z / white.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

LinearRgb to_linear_srgb(const Xyz& colour) {
  constexpr RgbMatrix srgb{{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
  return srgb * colour;
}

Xyz from_linear_srgb(const LinearRgb& colour) {
  return {0.4124 * colour.r + 0.3576 * colour.g + 0.1805 * colour.b,
          0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b,
          0.0193 * colour.r + 0.1192 * colour.g + 0.9505 * colour.b};
}

LinearRgb to_linear_rec2020(const Xyz& colour) {
  // Derived from the chromaticities (0.708, 0.292), (0.170, 0.797), (0.131, 0.046) and white (0.3127,
  // 0.3290).
  constexpr RgbMatrix rec2020{{1.7166511880, -0.3556707838, -0.2533662814},
                              {-0.6666843518, 1.6164812366, 0.0157685458},
                              {0.0176398574, -0.0427706133, 0.9421031212}};
  return rec2020 * colour;
}

LinearRgb to_linear_rgb(const Xyz& colour, RgbSpace space) {
  return space == RgbSpace::rec2020 ? to_linear_rec2020(colour) : to_linear_srgb(colour);
}

double encode_srgb(double linear) {
  const double value = std::clamp(linear, 0.0, 1.0);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

double decode_srgb(double encoded) {
  const double value = std::clamp(encoded, 0.0, 1.0);
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace vcavity::tools
