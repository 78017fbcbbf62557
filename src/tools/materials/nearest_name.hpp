// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// "Did you mean ...?"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vcavity::tools {

/// How many letters must be inserted, removed or replaced to turn one word into the other (Levenshtein
/// distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that takes the fewest edits, letter case aside, and the first of several; nothing if even
/// that one takes more edits than half the letters of the word.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates);

}  // namespace vcavity::tools
