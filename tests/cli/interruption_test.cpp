// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <thread>

#include "cli/program.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"

using namespace std::chrono_literals;

namespace {

// A map large enough to be interrupted.
const std::string long_job = "map --material Ag --aperture 5 --size 8192 --out a.exr";

// The temporary file of the program at work, once there is something in it.
std::filesystem::path growing_file(const ScratchFolder& folder, RunningProgram& program) {
  for (const auto end = std::chrono::steady_clock::now() + 20s; std::chrono::steady_clock::now() < end;) {
    REQUIRE_FALSE(program.ended());
    for (const std::string& name : folder.names())
      if (name.starts_with(".vcavity-") && std::filesystem::file_size(folder / name) > 100'000)
        return folder / name;
    std::this_thread::sleep_for(2ms);
  }
  FAIL("the program does not start to write");
  return {};
}

// An earlier, complete file; its content.
std::string write_earlier_file(const ScratchFolder& folder) {
  REQUIRE(run("map --material Ag --aperture 45 --size 16 --out a.exr", folder.path()).status == 0);
  return content(folder / "a.exr");
}

}  // namespace

TEST_CASE("an interrupted run leaves the earlier file and nothing else") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const ScratchFolder folder, streams;
  const std::string earlier = write_earlier_file(folder);
  RunningProgram program(words(long_job), folder.path(), streams / "out", streams / "err");
  growing_file(folder, program);
  program.send(signal);
  CHECK(program.status() == 128 + signal);
  CHECK(content(folder / "a.exr") == earlier);
  CHECK(folder.names() == std::vector<std::string>{"a.exr"});
}

TEST_CASE("a killed run leaves the earlier file, and a temporary that is named as such") {
  const ScratchFolder folder, streams;
  const std::string earlier = write_earlier_file(folder);
  RunningProgram program(words(long_job), folder.path(), streams / "out", streams / "err");
  const auto temporary = growing_file(folder, program);
  program.send(SIGKILL);
  CHECK(program.status() == 128 + SIGKILL);
  CHECK(content(folder / "a.exr") == earlier);
  std::vector<std::string> names = folder.names();
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{temporary.filename(), "a.exr"});
}

TEST_CASE("a run that is killed at any moment leaves the old file or the new one") {
  const ScratchFolder folder, streams;
  const std::string line = "map --material Ag --aperture 45 --size 256 --out a.exr";
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(run(line, folder.path()).status == 0);
  const auto whole_run = std::chrono::steady_clock::now() - start;
  const std::string earlier = write_earlier_file(folder);
  constexpr int moments = 40;
  for (int i = 0; i < moments; ++i) {
    RunningProgram program(words(line), folder.path(), streams / "out", streams / "err");
    std::this_thread::sleep_for(1.2 * whole_run * i / moments);
    program.send(SIGKILL);
    program.status();
    if (content(folder / "a.exr") == earlier) continue;
    CHECK(vcavity::tools::read_exr(folder / "a.exr").width == 256);
    write_earlier_file(folder);
  }
}
