// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Temporary files that do not outlive an interrupted process.

#include <filesystem>

namespace vcavity::tools {

/// While it lives, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE and SIGXFSZ remove a file before they end the
/// process.
///
/// The first object installs the handler, except for signals that the process ignores (nohup) or handles
/// already. There is room for 64 files; one beyond that is left behind by a signal.
class RemovalOnSignal {
 public:
  /// `path` is absolute; the file need not exist.
  explicit RemovalOnSignal(const std::filesystem::path& path);
  ~RemovalOnSignal();

  RemovalOnSignal(const RemovalOnSignal&) = delete;
  RemovalOnSignal& operator=(const RemovalOnSignal&) = delete;

 private:
  int slot_ = -1;
};

}  // namespace vcavity::tools
