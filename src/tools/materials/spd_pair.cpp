// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/spd_pair.hpp"

#include <string>

#include "tools/materials/tabulated.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

OpticalConstant read_spd(const std::filesystem::path& file) {
  const auto rows = parse_rows(read_text(file), 2, file);
  if (rows.empty()) throw malformed(file, 1, "the table is empty");
  return tabulated(rows, 1, nm_per_um, file, rows.front().line);
}

}  // namespace

Material read_spd_pair(const std::filesystem::path& either, MissingExtinction missing) {
  const std::filesystem::path without_spd = either.stem();
  const std::string name = without_spd.stem().string();
  if (without_spd.extension() != ".eta" && without_spd.extension() != ".k") {
    throw UsageError("'" + either.string() +
                     "' is not half of a pair: expected a name such as Cu.eta.spd or Cu.k.spd");
  }
  const auto eta_file = either.parent_path() / (name + ".eta.spd");
  const auto k_file = either.parent_path() / (name + ".k.spd");
  return Material({.name = name,
                   .file = eta_file,
                   .reference = eta_file.filename().string() + " and " + k_file.filename().string(),
                   .comments = {},
                   .n = read_spd(eta_file),
                   .k = read_spd(k_file)},
                  missing);
}

}  // namespace vcavity::tools
