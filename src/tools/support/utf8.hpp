// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Texts of unknown origin, such as names of files, where UTF-8 is needed: JSON, PNG, SVG.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vcavity::tools {

/// Where a text stops being UTF-8 (RFC 3629); nothing if it is all UTF-8.
/// @return the position of the first byte that belongs to no character
std::optional<std::size_t> first_not_utf8(std::string_view text);

/// The text with U+FFFD, the replacement character, for every byte that belongs to no character.
std::string valid_utf8(std::string_view text);

/// A text in Latin-1 as UTF-8; every byte is a character there.
std::string utf8_of_latin1(std::string_view text);

}  // namespace vcavity::tools
