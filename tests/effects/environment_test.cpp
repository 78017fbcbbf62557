// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/environment.hpp"

#include <unistd.h>
#include <cmath>
#include <filesystem>
#include <memory>
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "tools/maps/disc_map.hpp"

using namespace vcavity;
using namespace vcavity::tools;

namespace {

/// An image in a file of its own, removed at the end of the test.
class SkyFile {
 public:
  template <class Radiance>
  SkyFile(int height, Radiance&& radiance)
      : path_(std::filesystem::temp_directory_path() / ("sky-" + std::to_string(getpid()) + ".exr")) {
    ExrImage image{2 * height, height, {{"R", {}}, {"G", {}}, {"B", {}}}, {}};
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < 2 * height; ++column)
        for (int channel = 0; channel < 3; ++channel)
          image.channels[static_cast<std::size_t>(channel)].plane.push_back(radiance(column, row, channel));
    write_exr(path_, image);
  }
  ~SkyFile() { std::filesystem::remove(path_); }
  SkyFile(const SkyFile&) = delete;
  SkyFile& operator=(const SkyFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

MapRequest request_for(double aperture_deg, const SkyFile& sky) {
  MapRequest request{{Material::from_index({0.2, 3.4}, "0.2+3.4i"), aperture_deg}, {550}, 16, all_bounces};
  request.environment = std::make_shared<const Environment>(sky.path());
  return request;
}

}  // namespace

TEST_CASE("an environment is seen with the zenith at the top, +y in the middle and +x to the right of it") {
  // One bright pixel each: red at the zenith's row, green at +y, blue at +x.
  constexpr int height = 64;
  const SkyFile sky(height, [](int column, int row, int channel) {
    const bool horizon = row == height / 2 || row == height / 2 - 1;
    if (channel == 0) return row == 0 ? 1.0f : 0.0f;
    if (channel == 1) return horizon && (column == height || column == height - 1) ? 1.0f : 0.0f;
    return horizon && (column == 3 * height / 2 || column == 3 * height / 2 - 1) ? 1.0f : 0.0f;
  });
  const Environment environment(sky.path());
  CHECK(environment.radiance({0, 0, 1}).x == Approx(1));
  CHECK(environment.radiance({0, 1, 0}).y == Approx(1));
  CHECK(environment.radiance({1, 0, 0}).z == Approx(1));
  CHECK(environment.radiance({-1, 0, 0}).z == Approx(0).margin(1e-12));
  CHECK(environment.radiance({0, -1, 0}).y == Approx(0).margin(1e-12));
}

TEST_CASE("between pixels the radiance is linear, also across the seam behind") {
  constexpr int height = 8;
  const SkyFile sky(height, [](int column, int, int) { return static_cast<float>(column); });
  const Environment environment(sky.path());
  const auto at_column = [&](double column) {
    const double azimuth = ((column + 0.5) / (2 * height) - 0.5) * 2 * pi<double>();
    return environment.radiance(direction(radians(90.0), azimuth)).x;
  };
  CHECK(at_column(3) == Approx(3));
  CHECK(at_column(3.25) == Approx(3.25));
  CHECK(at_column(15.5) == Approx(7.5));  // halfway from column 15 to column 0
}

TEST_CASE("a uniform sky shows the reflectance") {
  const SkyFile sky(4, [](int, int, int channel) { return static_cast<float>(1 + channel); });
  for (const double aperture_deg : {45.0, 100.0, 180.0}) {
    const MapRequest request = request_for(aperture_deg, sky);
    const DiscMapper mapper(request);
    const auto planes = mapper.rows(0, request.size);
    const Cavity<double> cavity(radians(aperture_deg));
    for (int row = 0; row < request.size; ++row)
      for (int column = 0; column < request.size; ++column)
        if (const auto e = pixel_direction(column, row, request.size)) {
          const double expected = directional_reflectance(cavity, *e, Conductor<double>(0.2, 3.4));
          const auto pixel = static_cast<std::size_t>(row * request.size + column);
          for (std::size_t channel = 0; channel < 3; ++channel)
            CHECK(static_cast<double>(planes[channel][pixel]) ==
                  Approx(expected * static_cast<double>(1 + channel)).epsilon(1e-6));
        }
  }
}

TEST_CASE("a flat mirror shows the sky mirrored in it") {
  const SkyFile sky(64, [](int column, int row, int) { return static_cast<float>(column + 3 * row); });
  const MapRequest request = request_for(180, sky);
  const DiscMapper mapper(request);
  const Environment environment(sky.path());
  const auto planes = mapper.rows(0, request.size);
  for (int row = 0; row < request.size; ++row)
    for (int column = 0; column < request.size; ++column)
      if (const auto e = pixel_direction(column, row, request.size)) {
        const double expected =
            Conductor<double>(0.2, 3.4)(e->z) * environment.radiance({-e->x, -e->y, e->z}).y;
        CHECK(static_cast<double>(planes[1][static_cast<std::size_t>(row * request.size + column)]) ==
              Approx(expected).epsilon(1e-5));
      }
}

TEST_CASE("a right-angled groove shows a viewer himself: light comes back to where it came from") {
  // Bright only behind the viewer at θ = 30° across the groove; two bounces at 90° send light straight back.
  const Vec3<double> viewer = direction(radians(20.0), 0.0);
  const SkyFile sky(256, [&](int column, int row, int) {
    const Vec3<double> from =
        direction(pi<double>() * (row + 0.5) / 256, 2 * pi<double>() * ((column + 0.5) / 512 - 0.5));
    return from.x * viewer.x + from.y * viewer.y + from.z * viewer.z > 0.99 ? 1.0f : 0.0f;
  });
  const Cavity<double> cavity(radians(90.0));
  double expected = 0;
  for (const auto& lobe : lobes(cavity, viewer, Conductor<double>(0.2, 3.4)))
    if (lobe.bounces == 2) expected += lobe.weight * lobe.throughput;
  CHECK(expected > 0.2);
  MapRequest request = request_for(90, sky);
  const DiscMapper mapper(request);
  CHECK(mapper.reflected_radiance(viewer).x == Approx(expected).epsilon(1e-6));
}

TEST_CASE("a picture without colours is no environment") {
  const auto path = std::filesystem::temp_directory_path() / ("depth-" + std::to_string(getpid()) + ".exr");
  write_exr(path, ExrImage{1, 1, {{"Z", {1.0f}}}, {}});
  CHECK_THROWS_AS(Environment(path), std::runtime_error);
  std::filesystem::remove(path);
}
