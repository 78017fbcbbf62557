// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The two ways in which a command fails.
///
/// UsageError: the user asked for something that does not exist or makes no sense; the program ends with
/// status 2. Any other std::exception: the request was sound but could not be carried out; status 1.

#include <stdexcept>

namespace vcavity::tools {

/// A request that cannot be met as it stands, such as an unknown material or a value out of range.
/// The text is one line that names the value and what was expected.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace vcavity::tools
