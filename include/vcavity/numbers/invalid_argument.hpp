// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The answer to an argument out of range, the same for the whole library: `std::invalid_argument`, whose message
/// names the value and what was expected. Where exceptions are switched off (-fno-exceptions) the message goes to
/// the standard error output and the program is aborted: go on it cannot, and a silent answer would be wrong. On a GPU,
/// which has neither, the kernel is aborted.

#include <sstream>

#include "vcavity/numbers/compiler.hpp"

#if defined(__cpp_exceptions)
#include <stdexcept>
#else
#include <cstdio>
#include <cstdlib>
#endif

namespace vcavity {

/// Throws, or aborts where there are no exceptions.
/// @param parts of the message, one line together; copies, for numbers whose address is taken leave their registers
/// @throws std::invalid_argument always
template <class... Parts>
[[noreturn]] VCAVITY_NOINLINE void throw_invalid_argument([[maybe_unused]] Parts... parts) {
#if defined(VCAVITY_ON_GPU)
  __builtin_trap();
#else
  std::ostringstream message;
  (message << ... << parts);
#if defined(__cpp_exceptions)
  throw std::invalid_argument(message.str());
#else
  std::fprintf(stderr, "vcavity: %s\n", message.str().c_str());
  std::abort();
#endif
#endif
}

}  // namespace vcavity
