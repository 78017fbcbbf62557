// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/provenance.hpp"

namespace vcavity::tools {
namespace {

enum class Document { man, bash };

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) commands.push_back(command);  // no hidden ones
  return commands;
}

/// "--long" names of an option and, if wished, its "-s" names.
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : separator).append(word);
  return text;
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

void print_options(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string> names = names_of(*option);
    std::cout << ".TP\n";
    if (names.empty()) {
      std::cout << "\\fI" << troff(option->get_name(true)) << "\\fR\n";
    } else {
      std::cout << "\\fB" << troff(joined(names, ", ")) << "\\fR";
      if (option->get_expected_max() > 0) std::cout << " \\fI" << troff(option->get_type_name()) << "\\fR";
      std::cout << '\n';
    }
    std::cout << troff(option->get_description()) << (option->get_required() ? " (required)" : "") << '\n';
  }
}

void print_man(const CLI::App& program) {
  std::cout << ".TH VCAVITY_MAPS 1 \"\" \"" << software() << "\"\n.SH NAME\nvcavity_maps \\- "
            << troff(program.get_description())
            << "\n.SH SYNOPSIS\n.B vcavity_maps\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n"
            << ".SH OPTIONS\n";
  print_options(program);
  std::cout << ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(program)) {
    std::cout << ".SS " << command->get_name() << '\n' << troff(command->get_description()) << '\n';
    print_options(*command);
  }
  std::cout << ".SH EXIT STATUS\n0 done, 1 failed, 2 wrong usage.\n";
}

void print_bash(const CLI::App& program) {
  std::vector<std::string> names;
  std::cout << "# bash completion for vcavity_maps, written by 'vcavity_maps generate bash'\n"
               "_vcavity_maps() {\n"
               "  local words\n"
               "  case ${COMP_WORDS[1]} in\n";
  for (const CLI::App* command : commands_of(program)) {
    names.push_back(command->get_name());
    std::vector<std::string> options;
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    std::cout << "    " << command->get_name() << ") words=\"" << joined(options, " ") << "\" ;;\n";
  }
  std::cout << "    *) words=\"" << joined(names, " ") << " --help --version\" ;;\n"
            << "  esac\n"
               "  [ \"$COMP_CWORD\" -eq 1 ] && words=\""
            << joined(names, " ") << " --help --version\"\n"
            << "  COMPREPLY=($(compgen -W \"$words\" -- \"${COMP_WORDS[COMP_CWORD]}\"))\n"
               "}\n"
               "complete -o default -F _vcavity_maps vcavity_maps\n";
}

}  // namespace

void add_generate_command(CLI::App& program) {
  auto document = std::make_shared<Document>();
  CLI::App* command = program.add_subcommand("generate", "a man page, or completion for bash, on stdout");
  command->group("");  // for packagers; not in the help
  add_choice(*command, "DOCUMENT", *document, {{"man", Document::man}, {"bash", Document::bash}},
             "man or bash")
      ->required();
  command->callback([document, &program] {
    if (*document == Document::man) {
      print_man(program);
    } else {
      print_bash(program);
    }
  });
}

}  // namespace vcavity::tools
