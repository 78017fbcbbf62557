// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/spectral_weights.hpp"

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "tools/failure.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools::testing {
namespace {

std::vector<double> grid(double low_nm, double high_nm, double step_nm) {
  std::vector<double> wavelengths;
  for (int i = 0; low_nm + i * step_nm <= high_nm; ++i) wavelengths.push_back(low_nm + i * step_nm);
  return wavelengths;
}

TEST_CASE("a perfect reflector is white on every grid and in every light") {
  for (const double step : {1.0, 5.0, 7.3, 20.0}) {
    const auto wavelengths = grid(400, 700, step);
    for (const Illuminant light : {Illuminant::a, Illuminant::d65, Illuminant::e}) {
      for (const Observer observer : {Observer::cie_1931_2deg, Observer::cie_1964_10deg}) {
        const SpectralWeights eye(wavelengths, light, observer);
        const Xyz colour = eye.colour(std::vector<double>(wavelengths.size(), 1.0));
        CHECK(colour.y == Catch::Approx(1).epsilon(1e-14));
        const Lab lab = to_lab(colour, eye.white());
        CHECK(lab.lightness == Catch::Approx(100).epsilon(1e-13));
        CHECK(std::abs(lab.a) < 1e-11);
        CHECK(std::abs(lab.b) < 1e-11);
      }
    }
  }
}

TEST_CASE("the white points are those of the illuminants") {
  // As printed in CIE 15 for sums in steps of 5 nm from 380 to 780 nm.
  const auto wavelengths = grid(380, 780, 5);
  const auto check = [&](Illuminant light, Observer observer, double x, double z) {
    const Xyz white = SpectralWeights(wavelengths, light, observer).white();
    CHECK(std::abs(white.x - x) < 1e-4);
    CHECK(std::abs(white.z - z) < 1e-4);
  };
  check(Illuminant::d65, Observer::cie_1931_2deg, 0.9504, 1.0888);
  check(Illuminant::d65, Observer::cie_1964_10deg, 0.9481, 1.0732);
  check(Illuminant::a, Observer::cie_1931_2deg, 1.0985, 0.3558);
  check(Illuminant::a, Observer::cie_1964_10deg, 1.1114, 0.3520);
  check(Illuminant::e, Observer::cie_1931_2deg, 1.0000, 1.0000);
}

TEST_CASE("a perfect reflector in D65 is white on an sRGB display") {
  const LinearRgb white = to_linear_srgb(SpectralWeights(grid(380, 780, 5)).white());
  CHECK(std::abs(white.r - 1) < 5e-4);
  CHECK(std::abs(white.g - 1) < 5e-4);
  CHECK(std::abs(white.b - 1) < 5e-4);
}

TEST_CASE("the colour of a spectrum agrees with another implementation") {
  // Printed by scripts/reference_colours.py.
  struct Expected {
    Illuminant light;
    Observer observer;
    Xyz xyz;
    Lab lab;
  };
  const Expected cases[] = {
      {Illuminant::d65,
       Observer::cie_1931_2deg,
       {0.3470131228, 0.2181560290, 0.6682677590},
       {53.8308072384, 56.3701080070, -49.5688397376}},
      {Illuminant::d65,
       Observer::cie_1964_10deg,
       {0.3377030114, 0.2356715411, 0.6813762934},
       {55.6517886954, 45.5836867497, -48.3561122520}},
      {Illuminant::a,
       Observer::cie_1931_2deg,
       {0.3911539628, 0.2410068944, 0.2027555864},
       {56.1884657050, 43.2375234588, -41.3464309217}},
      {Illuminant::a,
       Observer::cie_1964_10deg,
       {0.3802342413, 0.2472704967, 0.2095435952},
       {56.8085009790, 35.8672156044, -42.7132521800}},
      {Illuminant::e,
       Observer::cie_1931_2deg,
       {0.3692198944, 0.2240686510, 0.6236505000},
       {54.4560604112, 55.0092488393, -49.3979009597}},
      {Illuminant::e,
       Observer::cie_1964_10deg,
       {0.3603085924, 0.2397965465, 0.6457733109},
       {56.0674182168, 45.1691574749, -48.6120914738}},
  };
  const auto wavelengths = grid(380, 780, 5);
  std::vector<double> reflectance;
  for (const double nm : wavelengths) reflectance.push_back(0.5 + 0.4 * std::sin(nm / 50));

  const auto near = [](double value) { return Catch::Approx(value).epsilon(1e-9); };
  for (const auto& [light, observer, xyz, lab] : cases) {
    const SpectralWeights eye(wavelengths, light, observer);
    const Xyz colour = eye.colour(reflectance);
    CHECK(colour.x == near(xyz.x));
    CHECK(colour.y == near(xyz.y));
    CHECK(colour.z == near(xyz.z));
    const Lab seen = to_lab(colour, eye.white());
    CHECK(seen.lightness == near(lab.lightness));
    CHECK(seen.a == near(lab.a));
    CHECK(seen.b == near(lab.b));
  }
}

TEST_CASE("between their points the tables are linear, beyond their ends they are 0") {
  const std::vector<double> wavelengths{550, 552, 554};
  const auto weights = SpectralWeights(wavelengths, Illuminant::e).weights();
  const double y_550 = 0.9949501;
  const double y_555 = 1.0;
  const double y_552 = y_550 + 0.4 * (y_555 - y_550);
  CHECK(weights[1].y / weights[0].y == Catch::Approx(y_552 / y_550).epsilon(1e-12));

  const std::vector<double> beyond{200, 300, 800, 900};
  const auto sparse = SpectralWeights(beyond).weights();
  CHECK(sparse[0].y == 0);
  CHECK(sparse[1].y > 0);
  CHECK(sparse[3].y == 0);
}

// The colour of a smooth reflectance in a lamp, on a grid.
Xyz colour_on(const std::vector<double>& wavelengths, const Light& lamp) {
  std::vector<double> reflectance;
  for (const double nm : wavelengths) reflectance.push_back(0.5 + 0.3 * std::sin(nm / 150));
  return SpectralWeights(wavelengths, lamp, Observer::cie_1931_2deg).colour(reflectance);
}

TEST_CASE("a lamp with lines narrower than the grid has the same colour on every grid") {
  // Lines of 1 nm, where no grid of more than 1 nm has a point; and one that is given at uneven distances.
  const auto lamp_with_lines = [](std::initializer_list<double> lines_nm, double half_width) {
    std::vector<LinearTable::Sample> samples{{360, 1e-4}, {780, 1e-4}};
    for (const double nm : lines_nm)
      for (const auto& [at, power] :
           {std::pair(-half_width, 1e-4), std::pair(0.0, 5.0), std::pair(half_width, 1e-4)})
        samples.push_back({nm + at, power});
    return Light{"lines", LinearTable(std::move(samples))};
  };
  for (const Light& lamp : {lamp_with_lines({452.3, 546.1, 611.7}, 1), lamp_with_lines({589.3}, 0.02)}) {
    const Xyz expected = colour_on(grid(400, 700, 0.5), lamp);
    for (const double step : {1.0, 2.0, 5.0, 7.5, 10.0, 20.0}) {
      CAPTURE(step);
      const Xyz colour = colour_on(grid(400, 700, step), lamp);
      CHECK(colour.x == Catch::Approx(expected.x).epsilon(2e-3));
      CHECK(colour.y == Catch::Approx(expected.y).epsilon(2e-3));
      CHECK(colour.z == Catch::Approx(expected.z).epsilon(2e-3));
    }
  }
}

TEST_CASE("a grid coarser than the colour-matching functions does not leave out their structure") {
  const Light daylight = cie_illuminant(Illuminant::d65);
  const Xyz expected = colour_on(grid(380, 780, 5), daylight);
  for (const double step : {10.0, 20.0, 40.0}) {
    CAPTURE(step);
    const Xyz colour = colour_on(grid(380, 780, step), daylight);
    CHECK(colour.x == Catch::Approx(expected.x).epsilon(4e-3));
    CHECK(colour.y == Catch::Approx(expected.y).epsilon(4e-3));
    CHECK(colour.z == Catch::Approx(expected.z).epsilon(4e-3));
  }
}

TEST_CASE("the wavelengths need not be equally spaced") {
  const Light daylight = cie_illuminant(Illuminant::d65);
  const std::vector<double> uneven{400, 403, 420, 450, 455, 500, 520, 560, 575, 600, 640, 650, 700};
  const Xyz expected = colour_on(grid(400, 700, 5), daylight);
  const Xyz colour = colour_on(uneven, daylight);
  CHECK(colour.y == Catch::Approx(expected.y).epsilon(4e-3));
}

TEST_CASE("a single wavelength has a colour") {
  const std::vector<double> green{546.1};
  CHECK(SpectralWeights(green).white().y == 1);
}

TEST_CASE("a grid that is empty, descending or out of sight is refused") {
  const auto refusal = [](const std::vector<double>& wavelengths) {
    return failure<UsageError>([&] { SpectralWeights{wavelengths}; });
  };
  CHECK(refusal({}) == "a colour needs at least one wavelength");
  const std::string breaks = "nm breaks the grid: a colour needs ascending wavelengths";
  CHECK(refusal({600, 500, 400}) == "wavelength 500 " + breaks);
  CHECK(refusal({500, 500}) == "wavelength 500 " + breaks);
  CHECK(refusal({500, std::nan(""), 600}) == "wavelength nan " + breaks);
  CHECK(refusal({1000, 1100}) ==
        "no wavelength from 1000 to 1100 nm is visible; colours need some within 360 to 780 nm");
}

}  // namespace
}  // namespace vcavity::tools::testing
