// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace agreement {

/// How many rays a comparison ray by ray traces, over all shapes; VCAVITY_TRACER_RAYS=1e8 asks for more.
inline std::int64_t number_of_rays() {
  const char* wish = std::getenv("VCAVITY_TRACER_RAYS");
  const double rays = wish ? std::stod(wish) : 1.1e6;
  if (!(rays >= 1 && rays <= 1e12))
    throw std::invalid_argument("VCAVITY_TRACER_RAYS=" + std::string(wish) +
                                ": expected a number from 1 to 1e12");
  return std::llround(rays);
}

}  // namespace agreement
