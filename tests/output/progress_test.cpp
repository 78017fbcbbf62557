// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/progress.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "support/catch.hpp"

using namespace vcavity::tools;
using namespace std::chrono_literals;

namespace {

// Bare containers may have no pseudo-terminals.
bool has_terminals() {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  const bool usable = terminal >= 0 && ::grantpt(terminal) == 0;
  if (terminal >= 0) ::close(terminal);
  if (!usable) WARN("there are no pseudo-terminals here: not tested");
  return usable;
}

// Lets stderr lead elsewhere and collects what is written to it.
class StderrTo {
 public:
  enum class End { terminal, pipe };

  explicit StderrTo(End end) {
    int writer = -1;
    if (end == End::terminal) {
      reader_ = ::posix_openpt(O_RDWR | O_NOCTTY);
      REQUIRE(::grantpt(reader_) == 0);
      REQUIRE(::unlockpt(reader_) == 0);
      writer = ::open(::ptsname(reader_), O_RDWR | O_NOCTTY);
    } else {
      std::array<int, 2> pipe{};
      REQUIRE(::pipe(pipe.data()) == 0);
      reader_ = pipe[0];
      writer = pipe[1];
    }
    REQUIRE(writer >= 0);
    ::fcntl(reader_, F_SETFL, O_NONBLOCK);
    std::fflush(stderr);
    before_ = ::dup(STDERR_FILENO);
    ::dup2(writer, STDERR_FILENO);
    ::close(writer);
  }

  std::string written() {
    std::fflush(stderr);
    std::string text;
    std::array<char, 4096> block;
    for (ssize_t count; (count = ::read(reader_, block.data(), block.size())) > 0;)
      text.append(block.data(), static_cast<std::size_t>(count));
    return text;
  }

  ~StderrTo() {
    ::dup2(before_, STDERR_FILENO);
    ::close(before_);
    ::close(reader_);
  }

 private:
  int reader_ = -1;
  int before_ = -1;
};

}  // namespace

TEST_CASE("progress is silent where stderr is not a terminal") {
  StderrTo pipe(StderrTo::End::pipe);
  {
    Progress progress(2, 0s);
    progress.advance(2);
  }
  CHECK(pipe.written().empty());
}

TEST_CASE("progress is silent in a short job") {
  if (!has_terminals()) return;
  StderrTo terminal(StderrTo::End::terminal);
  {
    Progress progress(2, 1h);
    progress.advance(2);
  }
  CHECK(terminal.written().empty());
}

TEST_CASE("progress shows percent and time left on a terminal and removes its line") {
  if (!has_terminals()) return;
  StderrTo terminal(StderrTo::End::terminal);
  {
    Progress progress(4, 20ms);
    std::this_thread::sleep_for(30ms);
    progress.advance(3);
    const std::string line = terminal.written();
    CHECK(line.find(" 75 %") != std::string::npos);
    CHECK(line.find("0:00:00 left") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
  CHECK(terminal.written() == "\r\x1b[K");
}

TEST_CASE("progress counts the steps of all threads") {
  if (!has_terminals()) return;
  StderrTo terminal(StderrTo::End::terminal);
  Progress progress(4001, 0s);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 1000; ++k) progress.advance();
    });
  for (auto& thread : threads) thread.join();
  std::this_thread::sleep_for(250ms);
  terminal.written();
  progress.advance();
  CHECK(terminal.written().find("100 %") != std::string::npos);
}
