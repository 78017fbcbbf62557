// SPDX-License-Identifier: BSD-3-Clause
#include "cli/program.hpp"
#include "support/catch.hpp"

namespace {

// The command lines of vcavity_maps in the shell examples of a Markdown file, without the program's name.
std::vector<std::string> examples(const std::filesystem::path& document) {
  const std::string program = "vcavity_maps ";
  std::istringstream text(content(document));
  std::vector<std::string> result;
  bool in_shell = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) in_shell = line == "```sh";
    if (in_shell && line.starts_with(program)) result.push_back(line.substr(program.size()));
  }
  return result;
}

}  // namespace

TEST_CASE("the examples of the documents work") {
  const std::filesystem::path root = VCAVITY_ROOT;
  for (const auto& document : {root / "README.md", root / "docs/tool.md"}) {
    const std::vector<std::string> lines = examples(document);
    CHECK(lines.size() >= 4);
    const ScratchFolder folder;
    for (const std::string& line : lines) {
      const Outcome outcome = run(line, folder.path());
      CAPTURE(document, line, outcome.err);
      CHECK(outcome.status == 0);
      CHECK(outcome.err.empty());
    }
  }
}
