// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/data_path.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

namespace fs = std::filesystem;

/// The program's path, from its bin folder to its data; empty where the system does not tell.
fs::path installed_data() {
  std::error_code no_such_link;
  const fs::path program = fs::read_symlink("/proc/self/exe", no_such_link);
  return no_such_link ? fs::path() : program.parent_path() / VCAVITY_DATA_FROM_BIN;
}

}  // namespace

fs::path data_directory() {
  if (const char* chosen = std::getenv("VCAVITY_DATA")) {
    if (!fs::is_directory(chosen)) {
      throw UsageError("VCAVITY_DATA is '" + std::string(chosen) +
                       "', expected a folder that holds nk and cie");
    }
    return chosen;
  }
  for (const fs::path& candidate : {installed_data(), fs::path(VCAVITY_SOURCE_DATA)}) {
    if (fs::is_directory(candidate / "nk")) return candidate.lexically_normal();
  }
  throw std::runtime_error(
      "the data folder was not found; set VCAVITY_DATA to the folder that holds nk and cie");
}

}  // namespace vcavity::tools
