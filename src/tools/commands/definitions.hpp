// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What the definitions of commands and options tell about themselves, for help in other forms than --help.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace vcavity::tools {

/// The commands of the program, in the order of its help, without hidden ones.
std::vector<const CLI::App*> visible_commands(const CLI::App& program);

/// Whether an option is followed by a value, as flags are not.
bool takes_value(const CLI::Option& option);

/// The words that an option chooses from, taken from the way the help shows its value: in `d65|e|a|FILE`
/// those without capitals stand for themselves, and FILE is to be filled in.
std::vector<std::string> choices_of(const CLI::Option& option);

}  // namespace vcavity::tools
