// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <vcavity/version.hpp>

#include "cli/program.hpp"
#include "support/catch.hpp"

namespace {

const std::vector<std::string> commands{"paper", "map", "table", "direction", "export", "cost", "materials"};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("without arguments the program explains itself on stderr and ends with 2") {
  const Outcome outcome = run("");
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  for (const std::string& command : commands) CHECK(contains(outcome.err, "\n  " + command + " "));
}

TEST_CASE("help goes to stdout and ends with 0") {
  for (const char* flag : {"--help", "-h"}) {
    const Outcome outcome = run(flag);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    for (const std::string& command : commands) CHECK(contains(outcome.out, "\n  " + command + " "));
  }
}

TEST_CASE("the help of a command names units and defaults") {
  for (const std::string& command : commands) {
    CAPTURE(command);
    const Outcome outcome = run(command + " --help");
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(contains(outcome.out, "default"));
    for (const auto& [option, unit] :
         {std::pair("--aperture", "degrees"), std::pair("--wavelength ", "nanometres")})
      if (const auto at = outcome.out.find(option); at != std::string::npos)
        CHECK(outcome.out.find(unit, at) != std::string::npos);
  }
}

TEST_CASE("the version is that of the library") {
  const Outcome outcome = run("--version");
  CHECK(outcome.status == 0);
  CHECK(outcome.out == "vcavity " VCAVITY_VERSION "\n");
}

TEST_CASE("results that cannot be printed are a failure") {
  const ScratchFolder folder;
  RunningProgram program(words("table --material Ag --aperture 45"), folder.path(), "/dev/full",
                         folder / "err");
  CHECK(program.status() == 1);
  CHECK(content(folder / "err") == "vcavity_maps: cannot write to the standard output\n");
}

TEST_CASE("man page and completion know every command and option") {
  const Outcome man = run("generate man");
  const Outcome bash = run("generate bash");
  CHECK(man.status == 0);
  CHECK(man.out.starts_with(".TH VCAVITY_MAPS 1"));
  for (const std::string& command : commands) {
    CHECK(contains(man.out, "\n.SS " + command + "\n"));
    CHECK(contains(bash.out, "    " + command + ":*) words="));
    std::istringstream help(run(command + " --help").out);
    for (std::string word; help >> word;) {
      if (!word.starts_with("--") || !std::isalpha(static_cast<unsigned char>(word[2]))) continue;
      const std::string option = word.substr(2, word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", 2) - 2);
      CAPTURE(command, option);
      CHECK(contains(bash.out, "--" + option));
    }
  }
}
