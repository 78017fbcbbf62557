// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Completion for bash, from the definitions of commands and options.

#include <CLI/CLI.hpp>
#include <string>

namespace vcavity::tools {

/// A script for bash to source. It completes commands, options, the words that options choose from, and the
/// names of the collection of materials; where there is nothing to choose from bash completes file names.
/// Throws std::runtime_error if the collection cannot be read.
std::string bash_completion(const CLI::App& program);

}  // namespace vcavity::tools
