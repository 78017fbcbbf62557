// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <regex>
#include <set>

#include "cli/program.hpp"
#include "support/catch.hpp"
#include "tools/images/exr.hpp"

using vcavity::tools::write_exr;

namespace {

// The command lines of vcavity_maps in the shell examples of a Markdown file, without the program's name. Files that they
// write from here-documents are put into the folder.
std::vector<std::string> examples(const std::filesystem::path& document,
                                  const std::filesystem::path& folder) {
  const std::string program = "vcavity_maps ";
  const std::regex here_document("cat > ([^ /]+) <<'END'");
  std::istringstream text(content(document));
  std::vector<std::string> result;
  bool in_shell = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) in_shell = line == "```sh";
    if (!in_shell) continue;
    if (line.starts_with(program)) result.push_back(line.substr(program.size()));
    if (std::smatch file; std::regex_match(line, file, here_document)) {
      std::ofstream written(folder / file[1].str());
      while (std::getline(text, line) && line != "END") written << line << '\n';
    }
  }
  return result;
}

}  // namespace

TEST_CASE("the examples of the documents work") {
  const std::filesystem::path root = VCAVITY_ROOT;
  std::set<std::string> done;
  for (const auto& document :
       {root / "README.md", root / "docs/tool.md", root / "docs/effects.md", root / "docs/profiles.md",
        root / "docs/films.md", root / "docs/rough.md", root / "docs/matte.md"}) {
    const ScratchFolder folder;
    const std::vector<std::string> lines = examples(document, folder.path());
    CHECK(lines.size() >= 4);
    write_exr(folder / "sky.exr", {2, 1, {{"Y", {1, 1}}}, {}});  // that an example shows reflected
    for (const std::string& line : lines) {
      if (!done.insert(line).second) continue;
      const Outcome outcome = run(line, folder.path());
      CAPTURE(document, line, outcome.err);
      CHECK(outcome.status == 0);
      CHECK(outcome.err.empty());
    }
  }
}

TEST_CASE("commands are named only in examples, so that none goes untested") {
  // In running text a command stands without options.
  for (const char* document : {"README.md", "docs/tool.md", "docs/effects.md", "docs/profiles.md",
                               "docs/films.md", "docs/rough.md", "docs/matte.md"}) {
    const std::string text = content(std::filesystem::path(VCAVITY_ROOT) / document);
    CAPTURE(document);
    const std::regex with_options("`vcavity_maps [a-z]+ -[^`]*`");
    for (std::sregex_iterator at(text.begin(), text.end(), with_options); at != std::sregex_iterator(); ++at)
      FAIL_CHECK(at->str());
  }
}
