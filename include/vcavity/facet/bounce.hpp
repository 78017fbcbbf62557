// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// One bounce: what the groove tells a facet that needs to know more than the cosine of the angle of incidence.

#include "vcavity/conventions.hpp"

namespace vcavity {

/// A bounce in the frame of the panel on which it takes place. With e the direction towards the light as it
/// arrives there, `cosine`, `tangent` and `along` are its components, and their squares add up to 1.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
struct Bounce {
  Real cosine;   ///< e · N, the cosine of the angle of incidence, in [0, 1]
  Real tangent;  ///< component of e along the panel, across the groove and away from the apex
  Real along;    ///< component of e along the groove; the same at every bounce
  Panel panel;   ///< the panel
  int number;    ///< 1 for the first bounce of a ray
};

}  // namespace vcavity
