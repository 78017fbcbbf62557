// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Catch2 under one name, whether version 2 (Debian 12) or 3 (Debian 13) is installed.

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
namespace Catch {
using Detail::Approx;
namespace Matchers {
inline auto ContainsSubstring(const std::string& part) {
  return Contains(part);
}
}  // namespace Matchers
}  // namespace Catch
#endif
