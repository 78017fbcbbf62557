// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Output files that are either complete or untouched.
///
/// Everything is written to a temporary file in the folder of the target, which takes the target's place in
/// one step (rename) only when commit() is called. A failed or interrupted run therefore leaves an earlier
/// file as it was. Signals that end the process remove the temporary (see removal_on_signal.hpp); only
/// SIGKILL or a power cut can leave one behind (".vcavity-PID-NUMBER.tmp"). The next run that writes into the
/// folder removes those of processes that are gone.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tools/images/removal_on_signal.hpp"

namespace vcavity::tools {

/// A file being written, to be put in place by commit(). Not to be shared between threads without a lock.
///
/// - A symbolic link is followed: the file it points to is replaced and the link stays.
/// - A file that already exists keeps its permissions; a new one gets those of the umask.
/// - A target that is not a regular file (/dev/stdout, /dev/full, a named pipe) cannot be renamed over: the
///   temporary lies in the folder for temporary files, commit() appends its content to the target.
///
/// All errors are std::runtime_error with the text "cannot write 'PATH': REASON".
class AtomicFile {
 public:
  /// Opens the temporary. Throws if the target could not be written later (missing folder, no permission, a
  /// folder), so that construction before a long computation tells in time.
  explicit AtomicFile(std::filesystem::path target);

  /// Removes the temporary unless commit() was called.
  ~AtomicFile();

  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// The path as the user gave it; its extension selects a format.
  const std::filesystem::path& target() const { return target_; }

  /// The file that receives the data until commit().
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Writes `size` bytes at the current position.
  void write(const void* data, std::size_t size);

  /// Writes text at the current position.
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// The current position in bytes from the start.
  std::uint64_t position() const { return position_; }

  /// Moves the current position, so that a header can be completed after the data.
  void seek(std::uint64_t position);

  /// Throws if an earlier write failed; for libraries that swallow the exceptions of their callbacks.
  void check() const;

  /// Brings the data to the disk and puts the file in place. Also throws what check() throws.
  void commit();

 private:
  struct Unopened {};
  AtomicFile(std::filesystem::path target, Unopened) : target_(std::move(target)) {}
  void open();
  void deliver_copy();
  [[noreturn]] void fail(int error);

  std::filesystem::path target_;     // as given
  std::filesystem::path file_;       // the target behind all symbolic links, absolute
  std::filesystem::path temporary_;  // absolute
  int descriptor_ = -1;
  int special_ = -1;  // the open target if it is not a regular file
  int error_ = 0;     // errno of the first failure
  std::uint64_t position_ = 0;
  std::optional<RemovalOnSignal> on_signal_;
};

/// Replaces `path` by `text`, completely or not at all.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace vcavity::tools
