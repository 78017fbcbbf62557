// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A line on the terminal with the share done and the time left.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>

namespace vcavity::tools {

/// Shows progress on stderr, but only where a person is likely to look for it: on a terminal, and in a job
/// that has lasted longer than `patience`. The line removes itself when the object goes.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// A job of `total` equal steps.
  explicit Progress(std::uint64_t total, Clock::duration patience = std::chrono::seconds(1));
  ~Progress();

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Counts `steps` as done. May be called from any thread.
  void advance(std::uint64_t steps = 1);

 private:
  void show(Clock::time_point now);

  const std::uint64_t total_;
  const bool on_terminal_;
  const Clock::time_point start_;
  std::atomic<std::uint64_t> done_{0};
  std::mutex mutex_;  // guards the terminal and what follows
  Clock::time_point next_show_;
  bool shown_ = false;
};

}  // namespace vcavity::tools
