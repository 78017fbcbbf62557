// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vcavity/conventions.hpp>
#include <vector>

namespace vcavity::test {

/// Directions that make trouble: along the axes, grazing, along the groove, with tiny components.
template <class T>
std::vector<Vec3<T>> hard_directions() {
  std::vector<Vec3<T>> result;
  for (const T& y : {T(0), std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min(),
                     std::numeric_limits<T>::epsilon(), T(0.6), T(1)})
    for (const T& z : {T(0), std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min(),
                       std::numeric_limits<T>::epsilon(), T(0.6), T(1)}) {
      const T rest = T(1) - y * y - z * z;
      if (rest < T(0)) continue;
      for (const T& sign : {T(-1), T(1)}) result.push_back({std::sqrt(rest), sign * y, z});
    }
  return result;
}

}  // namespace vcavity::test
