// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/exr.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>

#include "scratch_folder.hpp"
#include "small_disk.hpp"
#include "support/catch.hpp"

using namespace vcavity::tools;

namespace {

// Noise does not compress, so that the size of the file is known roughly.
std::vector<float> noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform;
  std::vector<float> plane(static_cast<std::size_t>(width * height));
  for (float& value : plane) value = uniform(random);
  return plane;
}

ExrImage rgb_image(int width, int height) {
  return {width,
          height,
          {{"R", noise(width, height, 1)}, {"G", noise(width, height, 2)}, {"B", noise(width, height, 3)}},
          {{"material", "Ag"},
           {"aperture", 45.0},
           {"wavelength", 550.0f},
           {"command", "vcavity_maps \"a b\" 45°"}}};
}

}  // namespace

TEST_CASE("an EXR image comes back with every bit and its attributes") {
  const auto compression = GENERATE(ExrCompression::none, ExrCompression::rle, ExrCompression::zips,
                                    ExrCompression::zip, ExrCompression::piz);
  const ScratchFolder folder;
  ExrImage image = rgb_image(37, 41);
  image.plane("G");
  image.channels[0].plane[5] = -0.0f;
  image.channels[0].plane[6] = 1e-42f;
  write_exr(folder / "a.exr", image, ExrNumber::float32, compression);

  const ExrImage back = read_exr(folder / "a.exr");
  CHECK(back.width == 37);
  CHECK(back.height == 41);
  REQUIRE(back.channels.size() == 3);
  for (const auto& channel : image.channels) CHECK(back.plane(channel.name) == channel.plane);
  CHECK(std::signbit(back.plane("R")[5]));
  for (const auto& [name, value] : image.attributes) {
    CAPTURE(name);
    REQUIRE(back.attributes.count(name) == 1);
    CHECK(back.attributes.at(name) == value);
  }
}

TEST_CASE("half numbers lose no more than their eleven bits") {
  const ScratchFolder folder;
  const ExrImage image = rgb_image(16, 16);
  write_exr(folder / "a.exr", image, ExrNumber::float16);
  const ExrImage back = read_exr(folder / "a.exr");
  for (const auto& channel : image.channels)
    for (std::size_t i = 0; i < channel.plane.size(); ++i) {
      const float exact = channel.plane[i], rounded = back.plane(channel.name)[i];
      CHECK(std::abs(rounded - exact) <= std::max(std::ldexp(exact, -11), std::ldexp(1.0f, -25)));
    }
  CHECK(back.plane("R") != image.plane("R"));
}

TEST_CASE("what a number of the file cannot hold is refused, and never becomes infinity") {
  const ScratchFolder folder;
  ExrImage image = rgb_image(4, 4);
  const auto refusal = [&](float value, ExrNumber number) {
    image.channels[1].plane[7] = value;
    return error_of([&] { write_exr(folder / "a.exr", image, number); });
  };
  const std::string beginning =
      "cannot write '" + (folder / "a.exr").string() + "': channel 'G' has the value ";
  CHECK(refusal(65504, ExrNumber::float16).empty());
  CHECK(refusal(65505, ExrNumber::float16) == beginning + "65505, --precision half holds none beyond 65504");
  CHECK(refusal(-3e6f, ExrNumber::float16) == beginning + "-3e+06, --precision half holds none beyond 65504");
  CHECK(refusal(-3e6f, ExrNumber::float32).empty());
  CHECK(refusal(std::numeric_limits<float>::infinity(), ExrNumber::float32).starts_with(beginning + "inf"));
  CHECK(refusal(std::numeric_limits<float>::quiet_NaN(), ExrNumber::float32).starts_with(beginning + "nan"));
}

TEST_CASE("writing in blocks of rows gives the same file as writing at once") {
  const int rows_per_block = GENERATE(1, 7, 16, 32);
  const auto number = GENERATE(ExrNumber::float32, ExrNumber::float16);
  const ScratchFolder folder;
  const ExrImage image = rgb_image(20, 45);
  write_exr(folder / "at_once.exr", image, number);

  AtomicFile file(folder / "blocks.exr");
  ExrWriter writer(file, {20, 45, {"R", "G", "B"}, image.attributes, number});
  for (std::size_t y = 0; writer.rows_left() > 0;) {
    const int rows = std::min(rows_per_block, writer.rows_left());
    std::vector<std::span<const float>> planes;
    for (const auto& channel : image.channels)
      planes.push_back(std::span(channel.plane).subspan(20 * y, 20 * static_cast<std::size_t>(rows)));
    writer.write_rows(rows, planes);
    y += static_cast<std::size_t>(rows);
  }
  writer.finish();
  file.commit();
  CHECK(content(folder / "blocks.exr") == content(folder / "at_once.exr"));
}

TEST_CASE("the number of threads does not change the file") {
  const ScratchFolder folder;
  const ExrImage image = rgb_image(64, 200);
  write_exr(folder / "one.exr", image);
  set_exr_threads(2);
  write_exr(folder / "two.exr", image);
  set_exr_threads(0);
  CHECK(content(folder / "one.exr") == content(folder / "two.exr"));
}

TEST_CASE("an unfinished image cannot be completed and mismatched planes are refused") {
  const ScratchFolder folder;
  AtomicFile file(folder / "a.exr");
  ExrWriter writer(file, {4, 4, {"Y"}, {}, {}, {}});
  const std::vector<float> row(4), short_row(3);
  const std::vector<std::span<const float>> plane{row}, short_plane{short_row}, two{row, row};
  writer.write_rows(1, plane);
  CHECK(error_of([&] { writer.finish(); }) == "3 rows of the EXR image are missing");
  CHECK(error_of([&] { writer.write_rows(1, short_plane); }) == "channel 'Y' has 3 values, expected 4");
  CHECK(error_of([&] { writer.write_rows(1, two); }) == "write_rows needs one plane for each channel");
  CHECK(error_of([&] { writer.write_rows(4, plane); }) == "4 rows do not fit, 3 are left");
}

TEST_CASE("images without pixels and channels without a name of their own are refused") {
  const ScratchFolder folder;
  const auto refused = [&](ExrImage image) { return error_of([&] { write_exr(folder / "a.exr", image); }); };
  CHECK(refused({0, 4, {{"Y", {}}}, {}}) == "an EXR image needs at least one pixel, not 0 x 4");
  CHECK(refused({1, 1, {}, {}}) == "an EXR image needs a channel");
  CHECK(refused({1, 1, {{"", {1}}}, {}}) == "an EXR channel needs a name of its own, not ''");
  CHECK(refused({1, 1, {{"Y", {1}}, {"Y", {1}}}, {}}) == "an EXR channel needs a name of its own, not 'Y'");
  CHECK(folder.names().empty());
}

TEST_CASE("a disk that fills up while an image is written is reported and keeps the earlier file") {
  const SmallDisk disk;
  if (!disk.mounted()) {
    WARN("not permitted to mount a small disk, test skipped");
    return;
  }
  const int threads = GENERATE(0, 2);
  set_exr_threads(threads);
  const auto target = disk.folder() / "a.exr";
  write_exr(target, rgb_image(8, 8));
  const std::string earlier = content(target);
  CHECK(error_of([&] { write_exr(target, rgb_image(256, 256)); }) ==
        "cannot write '" + target.string() + "': No space left on device");
  set_exr_threads(0);
  CHECK(content(target) == earlier);
  CHECK(disk.folder().names() == std::vector<std::string>{"a.exr"});
}

TEST_CASE("an image sent to a device without space is reported") {
  CHECK(error_of([] { write_exr("/dev/full", rgb_image(8, 8)); }) ==
        "cannot write '/dev/full': No space left on device");
}

TEST_CASE("files that are missing, foreign or cut off are reported by name") {
  const ScratchFolder folder;
  put(folder / "text.exr", "this is no image");
  write_exr(folder / "whole.exr", rgb_image(64, 64));
  put(folder / "cut.exr", content(folder / "whole.exr").substr(0, 5000));
  for (const char* name : {"missing.exr", "text.exr", "cut.exr"}) {
    const std::string error = error_of([&] { read_exr(folder / name); });
    CHECK(error.starts_with("cannot read '" + (folder / name).string() + "': "));
    CHECK(error.find('\n') == std::string::npos);
  }
}

TEST_CASE("spectral channels are named by their wavelength with a decimal comma") {
  CHECK(spectral_channel_name(550) == "T.550,000000nm");
  CHECK(spectral_channel_name(587.5618) == "T.587,561800nm");
}

TEST_CASE("exrheader sees the channels, the attributes and the primaries") {
#ifdef EXRHEADER
  const ScratchFolder folder;
  ExrImage image = rgb_image(8, 4);
  image.channels.push_back({spectral_channel_name(550), noise(8, 4, 4)});
  image.attributes.insert(spectral_layout_version());
  write_exr(folder / "a.exr", image);

  const std::string command = EXRHEADER " " + (folder / "a.exr").string() + " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string report;
  for (int c; (c = std::fgetc(pipe.get())) != EOF;) report += static_cast<char>(c);
  CAPTURE(report);
  for (const char* line :
       {"T.550,000000nm, 32-bit floating-point", "R, 32-bit floating-point",
        "spectralLayoutVersion (type string): \"1.0\"", "aperture (type double): 45",
        "wavelength (type float): 550", "material (type string): \"Ag\"", "red   (0.64 0.33)",
        "white (0.3127 0.329)", "dataWindow (type box2i): (0 0) - (7 3)"})
    CHECK(report.find(line) != std::string::npos);
#else
  WARN("exrheader is not installed, test skipped");
#endif
}
