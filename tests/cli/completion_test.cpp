// SPDX-License-Identifier: BSD-3-Clause
/// Completion as bash itself does it, with the script of the program.

#include <cstdio>
#include <memory>

#include "cli/program.hpp"
#include "support/catch.hpp"

namespace {

class Bash {
 public:
  Bash() { put(folder_ / "completion", run("generate bash").out); }

  /// What bash offers for the last of some words, which may be empty. Bash takes = for a word of its own.
  std::string offers(const std::string& words) const {
    put(folder_ / "ask",
        "source " + (folder_ / "completion").string() + "\nCOMP_WORDS=(vcavity_maps " + words +
            ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_vcavity_maps\necho -n ${COMPREPLY[*]}");
    const std::string command = "bash " + (folder_ / "ask").string() + " 2>&1";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::string reply;
    for (int c; (c = std::fgetc(pipe.get())) != EOF;) reply += static_cast<char>(c);
    return reply;
  }

 private:
  ScratchFolder folder_;
};

}  // namespace

TEST_CASE("bash completes commands and options") {
  const Bash bash;
  CHECK(bash.offers("ma") == "map materials");
  CHECK(bash.offers("map --ap") == "--aperture");
  CHECK(bash.offers("map --explain --toler") == "--tolerance");
  CHECK(bash.offers("table --si").empty());
}

TEST_CASE("bash completes the words that an option chooses from") {
  const Bash bash;
  CHECK(bash.offers("map --polarization ''") == "none separate full");
  CHECK(bash.offers("map --quantity a") == "absorptance");
  CHECK(bash.offers("map --compression z") == "zips zip");
  CHECK(bash.offers("map --illuminant d") == "d65");
  CHECK(bash.offers("table --format = c") == "csv");
  CHECK(bash.offers("table --format =") == "md csv json");
}

TEST_CASE("bash completes materials, also behind a comma where several are taken") {
  const Bash bash;
  CHECK(bash.offers("map --material Cu-Mc") == "Cu-McPeak");
  CHECK(bash.offers("map --material Ag,Cu-Mc") == "Ag,Cu-McPeak");
  CHECK(bash.offers("direction --material Cu-Mc") == "Cu-McPeak");
  CHECK(bash.offers("cost --material Cu-Mc") == "Cu-McPeak");
  CHECK(bash.offers("materials Cu-Mc") == "Cu-McPeak");
  CHECK(bash.offers("materials --wave") == "--wavelength");
}

TEST_CASE("bash completes file names where there is nothing to choose from") {
  const Bash bash;
  for (const char* line : {"map --out ''", "map --environment ''", "map --size ''", "cost --plot ''"})
    CHECK(bash.offers(line).empty());
}

TEST_CASE("what completion offers is accepted, and it offers all that is") {
  const Bash bash;
  const std::string map = "map --material Cu --aperture 60 --wavelengths 400:700:100 --size 8 --out a.exr ";
  const std::string polarized_map =
      "map --material Cu --aperture 60 --size 8 --out a.exr --polarization full ";
  for (const auto& [line, option] :
       {std::pair(map, "--polarization"), std::pair(map, "--compression"), std::pair(map, "--precision"),
        std::pair(map, "--observer"), std::pair(map, "--rgb"), std::pair(map, "--illuminant"),
        std::pair(polarized_map, "--quantity"), std::pair(std::string("materials Cu "), "--format")}) {
    const std::vector<std::string> offered = words(bash.offers(words(line).front() + " " + option + " ''"));
    CHECK(offered.size() >= 2);
    for (const std::string& word : offered) {
      const ScratchFolder folder;
      const Outcome outcome = run(line + option + " " + word, folder.path());
      CAPTURE(option, word, outcome.err);
      CHECK(outcome.status == 0);
    }
  }
}
