// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/provenance.hpp"

#include <filesystem>
#include <set>
#include <vcavity/version.hpp>

#include "tools/support/utf8.hpp"

namespace vcavity::tools {
namespace {

std::string& stored_command_line() {
  static std::string line;
  return line;
}

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == word.npos) return word;
  std::string quoted = "'";
  for (const char c : word)
    if (c == '\'') {
      quoted.append("'\\''");
    } else {
      quoted.push_back(c);
    }
  quoted.push_back('\'');
  return quoted;
}

}  // namespace

void remember_command_line(int argc, const char* const* argv) {
  std::string& line = stored_command_line();
  line = "vcavity_maps";
  for (int i = 1; i < argc; ++i) line.append(" ").append(shell_word(valid_utf8(argv[i])));
}

const std::string& command_line() {
  return stored_command_line();
}

std::string software() {
  return "vcavity " VCAVITY_VERSION;
}

std::string in_one_line(const Material& material) {
  if (material.constant()) return "index " + material.name();
  return material.name() + ": " + material.reference();
}

void tell_origin(Report& report, const std::vector<Material>& materials) {
  report.provenance = {software(), "command: " + command_line()};
  nlohmann::ordered_json names, sources;
  std::set<std::string> known;
  for (const Material& material : materials) {
    if (!known.insert(material.name() + material.file().string()).second) continue;
    names.push_back(material.name());
    sources.push_back(material.reference());
    report.provenance.push_back("material: " + in_one_line(material));
    report.notes.push_back(in_one_line(material));
  }
  if (names.size() == 1) {
    names = names.front();
    sources = sources.front();
  }
  if (!names.is_null()) report.head.update({{"material", names}, {"source", sources}});
  report.head.update({{"software", software()}, {"command", command_line()}});
}

std::vector<std::string> provenance_lines(const Material& material) {
  return {software(), "command: " + command_line(), "material: " + in_one_line(material)};
}

}  // namespace vcavity::tools
