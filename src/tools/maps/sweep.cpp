// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/sweep.hpp"

#include <tbb/info.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <system_error>

#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

std::string suffix(Quantity quantity) {
  switch (quantity) {
    case Quantity::bounces:
      return "_bounces";
    case Quantity::degree_of_polarization:
      return "_dop";
    case Quantity::absorptance:
      return "_absorptance";
    case Quantity::reflectance:
      break;
  }
  return "";
}

std::string wavelengths_of(const MapRequest& request) {
  const std::string first = exact(request.wavelengths_nm.front());
  return request.wavelengths_nm.size() == 1 ? first : first + "-" + exact(request.wavelengths_nm.back());
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot write '" + folder.string() + "': " + error.message());
}

/// Bytes that a row of a map takes: in its planes, those of the block computed meanwhile, OpenEXR's two
/// buffers, and their compressed copies of half the size.
std::uint64_t row_memory(const MapRequest& request) {
  constexpr std::uint64_t copies = 5;
  constexpr std::uint64_t channels_beside_wavelengths = 4;
  return copies * static_cast<std::uint64_t>(request.size) *
         (request.wavelengths_nm.size() + channels_beside_wavelengths) * sizeof(float);
}

/// Whether a file holds the image of this header, but for the command line. It may have more attributes.
bool holds(const std::filesystem::path& path, ExrHeader expected) try {
  const ExrHeader found = read_exr_header(path);
  std::sort(expected.channels.begin(), expected.channels.end());
  expected.attributes.erase("command");
  return found.width == expected.width && found.height == expected.height &&
         found.channels == expected.channels && found.number == expected.number &&
         found.compression == expected.compression && found.primaries == expected.primaries &&
         std::all_of(expected.attributes.begin(), expected.attributes.end(), [&](const auto& attribute) {
           const auto at = found.attributes.find(attribute.first);
           return at != found.attributes.end() && at->second == attribute.second;
         });
} catch (const std::runtime_error&) {  // no such file, or another kind of file
  return false;
}

}  // namespace

std::string map_file_name(const MapRequest& request) {
  const std::string what = request.light ? "_brdf" : suffix(request.quantity);
  return file_stem(request.surface) + "_" + wavelengths_of(request) + "nm" + what + ".exr";
}

std::vector<MapFile> name_map_files(const std::vector<MapRequest>& requests, const std::string& out) {
  const bool exists = std::filesystem::is_directory(out);
  if (requests.size() == 1 && !exists && !out.ends_with('/')) return {{requests.front(), out}};
  if (out.ends_with(".exr") && !exists)
    throw UsageError("--out: '" + out + "' is one file for " + std::to_string(requests.size()) +
                     " maps, expected a folder");
  std::vector<MapFile> maps;
  std::set<std::filesystem::path> paths;
  for (const MapRequest& request : requests) {
    maps.push_back({request, std::filesystem::path(out) / map_file_name(request)});
    if (!paths.insert(maps.back().path).second)
      throw UsageError("two maps would go into '" + maps.back().path.string() + "'");
  }
  make_folder(out);
  return maps;
}

void leave_out_finished(std::vector<MapFile>& maps, const Storage& storage) {
  std::erase_if(maps, [&storage](const MapFile& map) {
    return holds(map.path, map_header(DiscMapper(map.request), storage));
  });
}

void write_maps(const std::vector<MapFile>& maps, const Storage& storage, Progress& progress) {
  if (maps.empty()) return;
  const auto write = [&](const MapFile& map, int block_rows) {
    AtomicFile file(map.path);
    write_map(file, DiscMapper(map.request), storage, block_rows, progress);
    file.commit();
  };
  constexpr std::uint64_t most_memory = std::uint64_t{1} << 30;
  const std::uint64_t most_rows = most_memory / row_memory(maps.front().request);
  const int cores = tbb::info::default_concurrency();
  if (most_rows >= static_cast<std::uint64_t>(cores * chunk_rows) && maps.size() > 1) {
    set_exr_threads(0);
    tbb::parallel_for_each(maps.begin(), maps.end(), [&](const MapFile& map) { write(map, chunk_rows); });
  } else {
    // Several chunks for each core: some take longer than others.
    const int chunk = rows_per_chunk(storage.compression);
    const int most_chunks = static_cast<int>(std::min<std::uint64_t>(
                                most_rows, 4 * static_cast<std::uint64_t>(cores * chunk_rows))) /
                            chunk;
    set_exr_threads(std::clamp(most_chunks, 1, cores));
    for (const MapFile& map : maps) write(map, std::max(most_chunks, 1) * chunk);
  }
}

}  // namespace vcavity::tools
