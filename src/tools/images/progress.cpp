// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace vcavity::tools {
namespace {

constexpr auto time_between_updates = std::chrono::milliseconds(200);

}  // namespace

Progress::Progress(std::uint64_t total, Clock::duration patience)
    : total_(std::max<std::uint64_t>(total, 1)),
      on_terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      next_show_(start_ + patience) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\x1b[K", stderr);  // back to the first column and erase the line
}

void Progress::advance(std::uint64_t steps) {
  done_ += steps;
  if (!on_terminal_) return;
  const std::unique_lock lock(
      mutex_, std::try_to_lock);  // a thread that finds another one printing goes on computing
  if (!lock.owns_lock()) return;
  if (const auto now = Clock::now(); now >= next_show_) show(now);
}

void Progress::show(Clock::time_point now) {
  const double share = static_cast<double>(std::min(done_.load(), total_)) / static_cast<double>(total_);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const long left = share > 0 ? static_cast<long>(elapsed * (1 - share) / share + 0.5) : 0;
  std::fprintf(stderr, "\r\x1b[K%3.0f %%  %ld:%02ld:%02ld left", 100 * share, left / 3600, left / 60 % 60,
               left % 60);
  shown_ = true;
  next_show_ = now + time_between_updates;
}

}  // namespace vcavity::tools
