// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/srgb_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "tools/colour/spectral_weights.hpp"

using namespace vcavity::tools;

TEST_CASE("the spectrum of a colour has that colour under D65 and reflects between nothing and all") {
  std::vector<double> wavelengths_nm;
  for (int nm = 360; nm <= 780; nm += 5) wavelengths_nm.push_back(nm);
  const SpectralWeights weights(wavelengths_nm);
  const LinearRgb white = to_linear_srgb(weights.white());
  for (int r = 0; r <= 255; r += 85)
    for (int g = 0; g <= 255; g += 85)
      for (int b = 0; b <= 255; b += 85) {
        CAPTURE(r, g, b);
        const LinearRgb colour{decode_srgb(r / 255.0), decode_srgb(g / 255.0), decode_srgb(b / 255.0)};
        const SrgbSpectrum spectrum(colour);
        std::vector<double> reflectance;
        for (const double nm : wavelengths_nm) reflectance.push_back(spectrum.at(nm));
        CHECK(*std::min_element(reflectance.begin(), reflectance.end()) >= 0);
        CHECK(*std::max_element(reflectance.begin(), reflectance.end()) <= 1);
        const LinearRgb found = to_linear_srgb(weights.colour(reflectance));
        CHECK(std::abs(found.r / white.r - colour.r) < 1e-8);
        CHECK(std::abs(found.g / white.g - colour.g) < 1e-8);
        CHECK(std::abs(found.b / white.b - colour.b) < 1e-8);
        CHECK(spectrum.error() < 1e-8);
      }
}

TEST_CASE("greys are the same at every wavelength, copper is not") {
  const SrgbSpectrum grey({0.3, 0.3, 0.3});
  CHECK(grey.at(400) == 0.3);
  CHECK(grey.at(700) == 0.3);
  const SrgbSpectrum copper(
      {decode_srgb(0xb8 / 255.0), decode_srgb(0x73 / 255.0), decode_srgb(0x33 / 255.0)});
  CHECK(copper.at(650) > 2 * copper.at(550));
  CHECK(copper.at(550) > 2 * copper.at(450));
}

TEST_CASE("decoding undoes the encoding of sRGB on both of its pieces") {
  for (const double linear : {0.0, 0.001, 0.0031308, 0.0032, 0.2, 0.9, 1.0})
    CHECK(decode_srgb(encode_srgb(linear)) == Approx(linear).margin(1e-7));
  CHECK(decode_srgb(0.5) == Approx(0.21404114));
}
