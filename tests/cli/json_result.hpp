// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a command that must succeed prints as JSON.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"
#include "support/catch.hpp"

/// Runs the command in `folder`.
inline nlohmann::json result_of(const std::string& line, const std::filesystem::path& folder) {
  const Outcome outcome = run(line + " --format json", folder);
  CAPTURE(line, outcome.err);
  REQUIRE(outcome.status == 0);
  REQUIRE(outcome.err.empty());
  return nlohmann::json::parse(outcome.out);
}

/// Runs the command where it finds no files.
inline nlohmann::json result_of(const std::string& line) {
  const ScratchFolder folder;
  return result_of(line, folder.path());
}
