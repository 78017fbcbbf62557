// SPDX-License-Identifier: BSD-3-Clause
/// The parts of `vcavity_maps map` (values, their colour, the file) and whole commands, on as many cores as
/// the process may use.

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vcavity/groove/lobes.hpp>

#include "benchmarks.hpp"
#include "tools/maps/disc_map.hpp"
#include "tools/materials/catalogue.hpp"

namespace vcavity::bench {
namespace {

using namespace tools;

constexpr int size = 1024;

std::vector<double> wavelengths(int count) {
  if (count == 1) return {550};
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(400 + 10 * i);
  return result;
}

DiscMapper copper_map(int wavelength_count, int pixels = size) {
  return DiscMapper(
      MapRequest{{load_material("Cu"), 60}, wavelengths(wavelength_count), pixels, all_bounces});
}

/// Those that this process may use.
int cores() {
  return tbb::this_task_arena::max_concurrency();
}

/// A file that goes away.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name) : path_(std::filesystem::temp_directory_path() / name) {}
  ~ScratchFile() { std::filesystem::remove_all(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

template <class Run>
void add(const std::string& name, const Run& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMillisecond);
}

/// Computes all rows of a map, in blocks as the program does.
void compute_all(const DiscMapper& mapper, Planes& planes) {
  const int block = chunk_rows * cores();
  for (int row = 0; row < mapper.request().size; row += block) {
    planes = mapper.rows(row, std::min(block, mapper.request().size - row), std::move(planes));
    benchmark::DoNotOptimize(planes);
  }
}

/// Values of all pixels, with their colour.
void add_rows(const std::string& name, int count, int pixels) {
  add(name, [=](benchmark::State& state) {
    const DiscMapper mapper = copper_map(count, pixels);
    Planes planes;
    for (auto _ : state) compute_all(mapper, planes);
    count_items(state, static_cast<std::size_t>(count) * static_cast<std::size_t>(pixels) *
                           static_cast<std::size_t>(pixels));
  });
}

/// Linear RGB from the spectra of half a disc; the other half is its mirror image.
void add_colour(int count) {
  add(name_of("map", std::to_string(count), "colour"), [count](benchmark::State& state) {
    const std::vector<double> grid = wavelengths(count);
    const SpectralWeights weights(grid);
    for (auto _ : state)
      tbb::parallel_for(0, size, [&](int row) {
        std::vector<double> spectrum(grid.size(), 0.5);
        for (int column = 0; column < size / 2; ++column) {
          if (!pixel_direction(column, row, size)) continue;
          spectrum[0] = column;
          LinearRgb colour = to_linear_rgb(weights.colour(spectrum), RgbSpace::srgb);
          benchmark::DoNotOptimize(colour);
        }
      });
  });
}

/// The file alone, of a map in memory.
void add_writing(int count, const std::string& name, ExrCompression compression) {
  add(name_of("map", std::to_string(count), name), [=](benchmark::State& state) {
    Progress progress(size);
    const ExrImage image = compute_map(copper_map(count), progress);
    const ScratchFile file("vcavity_bench.exr");
    set_exr_threads(cores());
    for (auto _ : state) write_exr(file.path(), image, ExrNumber::float32, compression);
    set_exr_threads(0);
  });
}

/// A command line of vcavity_maps; `OUT` stands for the file or folder that it writes.
void add_command(const std::string& name, const std::string& arguments) {
  add(name, [arguments](benchmark::State& state) {
    const ScratchFile out("vcavity_bench_out.exr");
    const std::string command =
        VCAVITY_MAPS " " + arguments + " --out " + out.path().string() + " > /dev/null";
    for (auto _ : state)
      if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
  });
}

}  // namespace

void add_map_benchmarks() {
  const std::string map = "map --material Cu --aperture 60 --size 1024";
  for (const int count : {1, 31}) {
    add_rows(name_of("map", std::to_string(count), "values_and_colour"), count, size);
    add_writing(count, "writing_uncompressed", ExrCompression::none);
    add_writing(count, "writing", ExrCompression::piz);
  }
  add_colour(31);
  for (const int pixels : {128, 256, 512, 1024, 2048})
    add_rows(name_of("map_growth/pixels", std::to_string(pixels)), 1, pixels);
  for (const int count : {1, 2, 4, 8, 16, 31})
    add_rows(name_of("map_growth/wavelengths", std::to_string(count)), count, 512);
  add_command("map/1/command", map + " --wavelength 550");
  add_command("map/31/command", map + " --wavelengths 400:700:10");
  add_command("paper/command", "paper --size 256");
}

}  // namespace vcavity::bench
