// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/definitions.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace vcavity::tools {

std::vector<const CLI::App*> visible_commands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

bool takes_value(const CLI::Option& option) {
  return option.get_expected_max() > 0;
}

std::vector<std::string> choices_of(const CLI::Option& option) {
  const auto is_capital = [](unsigned char letter) { return std::isupper(letter) != 0; };
  std::vector<std::string> choices;
  std::istringstream alternatives(option.get_type_name());
  for (std::string word; std::getline(alternatives, word, '|');)
    if (std::none_of(word.begin(), word.end(), is_capital)) choices.push_back(word);
  return choices;
}

}  // namespace vcavity::tools
