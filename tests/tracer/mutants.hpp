// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Wrong theories: vcavity with one error in it, of the kinds that people make. A check that lets one pass is
/// no check.

#include <vector>

#include "closed_form.hpp"

namespace agreement {

/// A theory and what is wrong with it.
template <class Theory>
struct Mutant {
  const char* error;
  Theory theory;
};

/// Wrong theories of single rays.
std::vector<Mutant<RayTheory>> ray_mutants();

/// Wrong theories of the reflectance averaged over the opening. Swapped panels are missing: they do not
/// change the mean.
std::vector<Mutant<DirectionalTheory>> directional_mutants();

/// Wrong theories of the reflectance under diffuse light.
std::vector<Mutant<HemisphericalTheory>> hemispherical_mutants();

}  // namespace agreement
