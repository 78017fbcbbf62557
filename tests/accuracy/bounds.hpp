// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The errors that are promised not to be exceeded, in units of max(ε, change/2); see subject.hpp.

namespace vcavity::test {

/// Of reflectance, absorptance and amplitudes of a plane interface.
inline constexpr double fresnel_bound = 8;

/// Of cosines of incidence and directions, after any number of bounces.
inline constexpr double direction_bound = 8;

/// Of the weight of a lobe, as a fraction of the opening.
inline constexpr double weight_bound = 16;

/// Of the sum of the weights.
inline constexpr double sum_bound = 4;

/// Of reflectance and absorptance after `bounces` reflections: one facet after the other adds its own.
inline double product_bound(int bounces) {
  return 16 + 8 * bounces;
}

/// The same of powers that are made from amplitudes, whose relative error counts twice.
inline double squared_product_bound(int bounces) {
  return 16 + 16 * bounces;
}

/// Of the projection of the hemisphere on a disc, and back.
inline constexpr double projection_bound = 4;

}  // namespace vcavity::test
