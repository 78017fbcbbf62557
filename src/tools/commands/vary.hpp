// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Lists of options multiplied out: every surface with every value.

#include <utility>
#include <vector>

#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// Each of the surfaces with each of the values of an option, all values of the first surface first.
/// @param values empty if the option was not given: the surfaces stay as they are then
/// @param set writes a value into a description
template <class Value, class Set>
void vary(std::vector<SurfaceDescription>& surfaces, const std::vector<Value>& values, const Set& set) {
  if (values.empty()) return;
  std::vector<SurfaceDescription> varied;
  for (const SurfaceDescription& surface : surfaces)
    for (const Value& value : values) {
      varied.push_back(surface);
      set(varied.back(), value);
    }
  surfaces = std::move(varied);
}

}  // namespace vcavity::tools
