// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/colour.hpp"

#include <cmath>

#include "support/catch.hpp"

namespace vcavity::tools::testing {
namespace {

constexpr Xyz d65{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};

TEST_CASE("white is L* 100, middle grey of 18 % is L* 49.5, black is L* 0") {
  const Lab white = to_lab(d65, d65);
  CHECK(white.lightness == Catch::Approx(100).epsilon(1e-14));
  CHECK(std::abs(white.a) < 1e-12);
  CHECK(std::abs(white.b) < 1e-12);
  const Lab grey = to_lab({0.18 * d65.x, 0.18, 0.18 * d65.z}, d65);
  CHECK(grey.lightness == Catch::Approx(116 * std::cbrt(0.18) - 16).epsilon(1e-14));
  CHECK(to_lab({0, 0, 0}, d65).lightness == Catch::Approx(0).margin(1e-14));
}

TEST_CASE("lightness is linear near black, without a step at the knee") {
  CHECK(to_lab({0, 0.004, 0}, {1, 1, 1}).lightness == Catch::Approx(0.004 * 24389 / 27).epsilon(1e-12));
  CHECK(to_lab({0, 0.015, 0}, {1, 1, 1}).lightness ==
        Catch::Approx(116 * std::cbrt(0.015) - 16).epsilon(1e-12));
  const double knee = 216.0 / 24389;
  CHECK(to_lab({0, knee, 0}, {1, 1, 1}).lightness == Catch::Approx(8).epsilon(1e-12));
  CHECK(to_lab({0, std::nextafter(knee, 1.0), 0}, {1, 1, 1}).lightness == Catch::Approx(8).epsilon(1e-12));
}

TEST_CASE("a* runs from green to red and b* from blue to yellow") {
  const Lab lab = to_lab({0.4, 0.2, 0.05}, {1, 1, 1});
  CHECK(lab.a == Catch::Approx(500 * (std::cbrt(0.4) - std::cbrt(0.2))).epsilon(1e-13));
  CHECK(lab.b == Catch::Approx(200 * (std::cbrt(0.2) - std::cbrt(0.05))).epsilon(1e-13));
}

TEST_CASE("the colours of sRGB components are those that have these components") {
  // The two matrices of the standard have four decimals.
  for (const LinearRgb& rgb :
       {LinearRgb{1, 0, 0}, LinearRgb{0, 1, 0}, LinearRgb{0, 0, 1}, LinearRgb{0.7, 0.2, 0.4}}) {
    const LinearRgb back = to_linear_srgb(from_linear_srgb(rgb));
    CHECK(std::abs(back.r - rgb.r) < 3e-4);
    CHECK(std::abs(back.g - rgb.g) < 3e-4);
    CHECK(std::abs(back.b - rgb.b) < 3e-4);
  }
}

TEST_CASE("the white of sRGB and of BT.2020 is D65") {
  const LinearRgb srgb = to_linear_srgb(d65);
  // The matrix of the standard has four decimals.
  CHECK(std::abs(srgb.r - 1) < 2e-4);
  CHECK(std::abs(srgb.g - 1) < 2e-4);
  CHECK(std::abs(srgb.b - 1) < 2e-4);
  const LinearRgb wide = to_linear_rec2020(d65);
  CHECK(wide.r == Catch::Approx(1).epsilon(1e-9));
  CHECK(wide.g == Catch::Approx(1).epsilon(1e-9));
  CHECK(wide.b == Catch::Approx(1).epsilon(1e-9));
}

TEST_CASE("the primaries of sRGB and of BT.2020 have one component") {
  const auto xyz = [](double x, double y) { return Xyz{x / y, 1, (1 - x - y) / y}; };
  const LinearRgb red = to_linear_srgb(xyz(0.64, 0.33));
  CHECK(red.r > 4);
  CHECK(std::abs(red.g) < 1e-3);
  CHECK(std::abs(red.b) < 1e-3);
  const LinearRgb green = to_linear_rec2020(xyz(0.170, 0.797));
  CHECK(std::abs(green.r) < 1e-9);
  CHECK(green.g == Catch::Approx(1 / 0.6779980715).epsilon(1e-9));  // BT.2020: Y = ... + 0.6780 G + ...
  CHECK(std::abs(green.b) < 1e-9);
}

TEST_CASE("the transfer function of sRGB has its published values") {
  CHECK(encode_srgb(0) == 0);
  CHECK(encode_srgb(1) == Catch::Approx(1).epsilon(1e-15));
  CHECK(encode_srgb(0.002) == Catch::Approx(0.02584).epsilon(1e-12));
  CHECK(encode_srgb(0.01) == Catch::Approx(1.055 * std::pow(0.01, 1 / 2.4) - 0.055).epsilon(1e-12));
  CHECK(encode_srgb(0.18) == Catch::Approx(1.055 * std::pow(0.18, 1 / 2.4) - 0.055).epsilon(1e-12));
  CHECK(std::lround(255 * encode_srgb(0.2158605)) == 128);
  CHECK(encode_srgb(-1) == 0);
  CHECK(encode_srgb(7) == Catch::Approx(1).epsilon(1e-15));
  CHECK(encode_srgb(std::nextafter(0.0031308, 1.0)) == Catch::Approx(encode_srgb(0.0031308)).margin(1e-7));
}

}  // namespace
}  // namespace vcavity::tools::testing
