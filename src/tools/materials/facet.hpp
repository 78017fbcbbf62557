// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// From a refractive index to the facet reflectance that suits it, with or without polarisation.

#include <vcavity/facet/fresnel.hpp>
#include <vcavity/polarization/polarization.hpp>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// Calls `use` with the facet reflectance of an index: `Dielectric` without absorption, else `Conductor`.
/// @return what `use` returns
template <class Use>
auto with_facet(const RefractiveIndex& index, Use&& use) {
  if (index.k == 0) return use(Dielectric<double>(index.n));
  return use(Conductor<double>(index.n, index.k));
}

/// How polarisation is followed from bounce to bounce; see vcavity/polarization.hpp.
enum class Polarization { none, separate, full };

/// Calls `use` with the facet reflectance in a model of polarisation.
/// @return what `use` returns, of one type for all models
template <class Facet, class Use>
auto with_polarization(Polarization model, const Facet& facet, Use&& use) {
  switch (model) {
    case Polarization::separate:
      return use(separately_polarized(facet));
    case Polarization::full:
      return use(polarized(facet));
    default:
      return use(facet);
  }
}

/// The name of a model, as on the command line.
constexpr const char* name_of(Polarization model) {
  switch (model) {
    case Polarization::separate:
      return "separate";
    case Polarization::full:
      return "full";
    default:
      return "none";
  }
}

}  // namespace vcavity::tools
