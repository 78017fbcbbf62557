// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/man_page.hpp"

#include "tools/commands/definitions.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

/// "--long" names of an option and, if it has any, its "-s" names.
std::string names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return joined(names, ", ");
}

/// Text as troff shows it unchanged.
std::string troff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  if (result.starts_with('.') || result.starts_with('\'')) result.insert(0, "\\&");
  return result;
}

std::string options_of(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    text += ".TP\n";
    if (option->get_positional()) {
      text += "\\fI" + troff(option->get_name(true)) + "\\fR\n";
    } else {
      text += "\\fB" + troff(names_of(*option)) + "\\fR";
      if (takes_value(*option)) text += " \\fI" + troff(option->get_type_name()) + "\\fR";
      text += '\n';
    }
    text += troff(option->get_description()) + (option->get_required() ? " (required)" : "") + '\n';
  }
  return text;
}

}  // namespace

std::string man_page(const CLI::App& program) {
  std::string page = ".TH VCAVITY_MAPS 1 \"\" \"" + software() + "\"\n.SH NAME\nvcavity_maps \\- " +
                     troff(program.get_description()) +
                     "\n.SH SYNOPSIS\n.B vcavity_maps\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH OPTIONS\n" +
                     options_of(program) + ".SH COMMANDS\n";
  for (const CLI::App* command : visible_commands(program))
    page +=
        ".SS " + command->get_name() + '\n' + troff(command->get_description()) + '\n' + options_of(*command);
  return page + ".SH EXIT STATUS\n0 done, 1 failed, 2 wrong usage.\n";
}

}  // namespace vcavity::tools
