// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/bash_completion.hpp"

#include <vector>

#include "tools/commands/definitions.hpp"
#include "tools/commands/options.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

std::string material_names() {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : list_materials()) {
    names.insert(names.end(), entry.short_names.begin(), entry.short_names.end());
    names.push_back(entry.material.name());
  }
  return joined(names, " ");
}

/// What may stand for the value of an option; nothing where bash had better complete the name of a file.
std::string values_of(const CLI::Option& option) {
  const std::string shown = option.get_positional() ? option.get_name(true) : option.get_type_name();
  const bool material = shown == material_placeholder || shown == materials_placeholder;
  return material ? "$materials" : joined(choices_of(option), " ");
}

/// One case of the script: `COMMAND:PREVIOUS_WORD) words="..." ;;`.
std::string offer(const CLI::App& command, const std::string& previous, const std::string& words,
                  const std::string& separator = "") {
  return "    " + command.get_name() + ":" + previous + ") words=\"" + words + "\" separator=" + separator +
         " ;;\n";
}

/// The cases of a command: the values of each option after its name; all options, and what the command takes
/// without naming an option, after any other word.
std::string cases_of(const CLI::App& command) {
  std::string cases, others;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) others += " " + values_of(*option);
    for (const std::string& name : option->get_lnames()) {
      others += " --" + name;
      if (takes_value(*option))
        cases += offer(command, "--" + name, values_of(*option),
                       option->get_type_name() == materials_placeholder ? "," : "");
    }
  }
  return cases + offer(command, "*", others);
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string commands, cases;
  for (const CLI::App* command : visible_commands(program)) {
    commands += command->get_name() + " ";
    cases += cases_of(*command);
  }
  // To bash the = of --option=value is a word of its own, but a comma is not.
  return R"(# bash completion for vcavity_maps, written by 'vcavity_maps generate bash'
_vcavity_maps() {
  local materials=")" +
         material_names() + R"("
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  [ "$previous" = "=" ] && previous=${COMP_WORDS[COMP_CWORD-2]}
  [ "$word" = "=" ] && word=
  local command=${COMP_WORDS[1]} words separator before
  [ "$COMP_CWORD" -eq 1 ] && command=
  case $command:$previous in
)" + cases +
         R"(    *) words=")" + commands + R"(--help --version" ;;
  esac
  [ "$separator" ] && before=${word%"${word##*$separator}"}
  COMPREPLY=($(compgen -P "$before" -W "$words" -- "${word#"$before"}"))
}
complete -o default -F _vcavity_maps vcavity_maps
)";
}

}  // namespace vcavity::tools
