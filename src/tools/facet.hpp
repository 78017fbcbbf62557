// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// From a refractive index to the facet reflectance that suits it.

#include <utility>
#include <vcavity/fresnel.hpp>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Calls `use` with the facet reflectance of an index: `Dielectric` without absorption, else `Conductor`.
/// \return what `use` returns
template <class Use>
auto with_facet(const RefractiveIndex& index, Use&& use) {
  if (index.k == 0) return use(Dielectric<double>(index.n));
  return use(Conductor<double>(index.n, index.k));
}

}  // namespace vcavity::tools
