// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The answer to an argument out of range, the same for the whole library: `std::invalid_argument`, whose message
/// names the value and what was expected. Where exceptions are switched off (-fno-exceptions) the message goes to
/// the standard error output and the program is aborted: go on it cannot, and a silent answer would be wrong.

#include <string>

#if defined(__cpp_exceptions)
#include <stdexcept>
#else
#include <cstdio>
#include <cstdlib>
#endif

namespace vcavity {

/// Throws, or aborts where there are no exceptions.
/// @param message one line
/// @throws std::invalid_argument always
[[noreturn]] inline void throw_invalid_argument(const std::string& message) {
#if defined(__cpp_exceptions)
  throw std::invalid_argument(message);
#else
  std::fprintf(stderr, "vcavity: %s\n", message.c_str());
  std::abort();
#endif
}

}  // namespace vcavity
