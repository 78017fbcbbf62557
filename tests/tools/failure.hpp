// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a call fails with.

#include <exception>
#include <string>
#include <typeinfo>

namespace vcavity::tools::testing {

/// The text of the exception that the call throws, if that is an Error and nothing derived from it; else a
/// text that says what happened instead.
template <class Error, class Call>
std::string failure(Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    const bool exact = typeid(error) == typeid(Error);
    return (exact ? "" : std::string(typeid(error).name()) + " instead: ") + error.what();
  }
  return "nothing was thrown";
}

}  // namespace vcavity::tools::testing
