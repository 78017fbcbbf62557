// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The man page, from the definitions of commands and options.

#include <CLI/CLI.hpp>
#include <string>

namespace vcavity::tools {

/// The page in troff, as `man -l` shows it.
std::string man_page(const CLI::App& program);

}  // namespace vcavity::tools
