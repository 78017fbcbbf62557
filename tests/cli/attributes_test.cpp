// SPDX-License-Identifier: BSD-3-Clause
/// Everything that a map says of itself, and light at the horizon.

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vcavity/vcavity.hpp>

#include "cli/program.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"

using namespace vcavity;
using nlohmann::json;
using tools::ExrImage;

namespace {

ExrImage map_of(const std::string& options, const ScratchFolder& folder) {
  const Outcome outcome = run("map --out a.exr --size 4 " + options, folder.path());
  CAPTURE(options, outcome.err);
  REQUIRE(outcome.status == 0);
  return tools::read_exr(folder / "a.exr");
}

ExrImage map_of(const std::string& options) {
  const ScratchFolder folder;
  return map_of(options, folder);
}

std::string text(const ExrImage& image, const char* name) {
  return std::get<std::string>(image.attributes.at(name));
}

double number(const ExrImage& image, const char* name) {
  return std::get<double>(image.attributes.at(name));
}

json direction_of(const std::string& options) {
  const Outcome outcome = run("direction --format json " + options);
  CAPTURE(options, outcome.err);
  REQUIRE(outcome.status == 0);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("a map at one wavelength tells n and k, aperture, quantity, model and arithmetic") {
  const ExrImage image = map_of("--material Cu --aperture 45.5 --wavelength 600 --polarization full");
  const json direction = direction_of("--material Cu --aperture 45.5 --wavelength 600 --theta 0 --phi 0");
  CHECK(number(image, "refractiveIndexN") == direction["n"].get<double>());
  CHECK(number(image, "extinctionK") == direction["k"].get<double>());
  CHECK(number(image, "extinctionK") > 2);
  CHECK(number(image, "refractiveIndexN") < 1);
  CHECK(number(image, "apertureDeg") == 45.5);
  CHECK(number(image, "wavelengthNm") == 600);
  CHECK(text(image, "polarization") == "full");
  CHECK(text(image, "arithmetic") == "double");
  CHECK(text(image, "maxBounces") == "all");
  CHECK(text(image, "quantity").find("reflectance") != std::string::npos);
  CHECK_FALSE(image.attributes.contains("environment"));
  CHECK_FALSE(image.attributes.contains("colour"));
}

TEST_CASE(
    "a map of many wavelengths lists them with n and k, and says whose eye sees the colour in which light") {
  const std::string grid = "--material Cu --aperture 60 --wavelengths 500:600:50 ";
  const ExrImage image = map_of(grid + "--observer 10 --illuminant a");
  CHECK(text(image, "wavelengthsNm") == "500 550 600");
  std::string n, k;
  for (const char* nm : {"500", "550", "600"}) {
    const json at =
        direction_of(std::string("--material Cu --aperture 60 --theta 0 --phi 0 --wavelength ") + nm);
    n += (n.empty() ? "" : " ") + at["n"].dump();
    k += (k.empty() ? "" : " ") + at["k"].dump();
  }
  CHECK(text(image, "refractiveIndicesN") == n);
  CHECK(text(image, "extinctionsK") == k);
  CHECK(text(image, "colour").find("1964 10") != std::string::npos);
  CHECK(text(image, "colour").find("under A,") != std::string::npos);
  const ExrImage other = map_of(grid + "--rgb rec2020");
  CHECK(text(other, "colour").find("1931 2 ") != std::string::npos);
  CHECK(text(other, "colour").find("Rec. 2020") != std::string::npos);
}

TEST_CASE("a map under a sky names it") {
  const ScratchFolder folder;
  write_exr(folder / "sky.exr", ExrImage{2, 1, {{"R", {1, 1}}, {"G", {1, 1}}, {"B", {1, 1}}}, {}});
  const ExrImage image = map_of("--material Cu --aperture 60 --environment sky.exr", folder);
  CHECK(text(image, "environment").find("sky.exr") != std::string::npos);
  CHECK(text(image, "quantity").find("environment") != std::string::npos);
  CHECK(text(image, "units") == "those of the environment");
}

TEST_CASE("theta of 90 degrees is the horizon itself") {
  const Cavity<double> cavity(radians(45.0));
  const Conductor<double> silver(0.1249, 3.3391);
  for (const auto& [phi, e] : {std::pair{"0", Vec3<double>{0, 1, 0}},
                               {"30", Vec3<double>{std::sin(radians(30.0)), std::cos(radians(30.0)), 0}}}) {
    const json result =
        direction_of(std::string("--material 0.1249+3.3391i --aperture 45 --theta 90 --phi ") + phi);
    CHECK(result["reflectance"].get<double>() ==
          Approx(directional_reflectance(cavity, e, silver)).epsilon(1e-15));
    // No light is left for more than one bounce, and the light leaves along the horizon of its panel alone.
    REQUIRE(result["lobes"].size() == 1);
    CHECK(result["lobes"][0]["weight"] == 1);
    CHECK(result["lobes"][0]["bounces"] == 1);
  }
  // A flat surface absorbs in proportion to the height of the light, here that by which π is not a number.
  const json flat = direction_of("--material 1.5 --aperture 180 --theta 90 --phi 0");
  CHECK(flat["absorptance"].get<double>() ==
        Approx(directional_absorptance(Cavity<double>(pi<double>()), {0, 1, 0}, Dielectric<double>(1.5)))
            .epsilon(1e-9)
            .margin(0));
}
