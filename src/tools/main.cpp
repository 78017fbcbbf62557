// SPDX-License-Identifier: BSD-3-Clause
/// vcavity_maps: reflectance of specular V-grooves as images and tables.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "tools/commands/commands.hpp"
#include "tools/commands/definitions.hpp"
#include "tools/materials/nearest_name.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace {

constexpr int success = 0;
constexpr int failure = 1;
constexpr int usage = 2;

int complain(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "vcavity_maps: " << message << '\n';
  return status;
}

/// CLI11 would only say that a command is missing.
void require_known_command(const CLI::App& program, const std::string& word) {
  const auto has_this_name = [&word](const CLI::App* command) { return command->get_name() == word; };
  if (word.starts_with('-') || !program.get_subcommands(has_this_name).empty()) return;
  std::vector<std::string> names;
  for (const CLI::App* command : vcavity::tools::visible_commands(program))
    names.push_back(command->get_name());
  throw vcavity::tools::UsageError("unknown command '" + word + "', expected one of " +
                                   vcavity::tools::joined(names, ", "));
}

/// What to say about a misspelt option; CLI11 would first ask for the required ones that are missing.
std::optional<std::string> about_unknown_option(const CLI::App& program) {
  std::vector<const CLI::App*> commands{&program};
  for (const CLI::App* command : program.get_subcommands()) commands.push_back(command);
  for (const CLI::App* command : commands)
    for (const std::string& word : command->remaining()) {
      if (!word.starts_with("--")) continue;
      std::vector<std::string> names;
      for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) names.push_back(name);
      const auto nearest = vcavity::tools::nearest_name(word.substr(2), names);
      return "unknown option '" + word + "'" + (nearest ? "; did you mean '--" + *nearest + "'?" : "");
    }
  return std::nullopt;
}

int run(int argc, char** argv) {
  using namespace vcavity::tools;
  remember_command_line(argc, argv);

  CLI::App program{"Reflectance of specular V-grooves: images and tables.", "vcavity_maps"};
  program.set_version_flag("--version", software(), "print the version");
  program.set_help_flag("--help,-h", "print this help");
  program.require_subcommand(1);
  program.footer(
      "Angles are degrees, wavelengths nanometres. 'vcavity_maps COMMAND --help' explains a command.");
  add_paper_command(program);
  add_map_command(program);
  add_table_command(program);
  add_direction_command(program);
  add_export_command(program);
  add_cost_command(program);
  add_materials_command(program);
  add_generate_command(program);

  if (argc == 1) {
    std::cerr << program.help();
    return usage;
  }
  require_known_command(program, argv[1]);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& answer) {  // help or version
    return program.exit(answer);
  } catch (const CLI::ParseError& error) {
    return complain(about_unknown_option(program).value_or(error.what()), usage);
  }
  return success;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int status = run(argc, argv);
    if (!std::cout.flush()) return complain("cannot write to the standard output", failure);
    return status;
  } catch (const vcavity::tools::UsageError& error) {
    return complain(error.what(), usage);
  } catch (const std::exception& error) {
    return complain(error.what(), failure);
  }
}
