// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Many maps in one go: what they are, which file each goes into, and writing them on all cores.

#include <filesystem>
#include <string>
#include <vector>

#include "tools/maps/disc_map.hpp"

namespace vcavity::tools {

/// A map and the file it goes into.
struct MapFile {
  MapRequest request;
  std::filesystem::path path;
};

/// The name of the file of a map among others: `MATERIAL_APERTUREdeg_WAVELENGTHnm.exr`, numbers as short as
/// they are exact; `LOW-HIGHnm` for a grid of wavelengths, and `_QUANTITY` before the dot unless it is the
/// reflectance. For instance `Cu-Johnson_45deg_400-700nm.exr`.
std::string map_file_name(const MapRequest& request);

/// Says which file each map goes into.
/// @param out a folder, made if missing, where each map gets the file map_file_name(); or, if there is only
///              one map and no folder of that name, its file
/// Throws UsageError if two maps would go into the same file, or if there are several and `out` ends in .exr;
/// std::runtime_error if the folder cannot be made.
std::vector<MapFile> name_map_files(const std::vector<MapRequest>& requests, const std::string& out);

/// Leaves out maps whose file holds them already: with the same size, channels and storage, and with all
/// attributes that the map would get, the command line aside. Light and environment count as the same if they
/// have the same name.
void leave_out_finished(std::vector<MapFile>& maps, const Storage& storage);

/// Computes maps and writes them, several small ones at a time, large ones one after the other. Takes about 1 GB of
/// memory; or more, where the rows that OpenEXR compresses together need it: 20 bytes for every pixel and channel of
/// rows_per_chunk() rows. A failure leaves every file either as it was or complete.
/// @param progress advanced by the number of rows
void write_maps(const std::vector<MapFile>& maps, const Storage& storage, Progress& progress);

}  // namespace vcavity::tools
