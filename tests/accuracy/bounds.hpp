// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The errors that are promised not to be exceeded, in units of max(ε, change/2); see subject.hpp.

namespace vcavity::test {

/// Of reflectance, absorptance and amplitudes of a plane interface.
inline constexpr double fresnel_bound = 8;

/// Of reflectance and amplitudes of two thin films on a substrate; some 10 but for films of metal that all
/// but carry a surface plasmon below, and for substrates of |n| in the hundreds.
inline constexpr double coated_bound = 512;

/// Of their absorptances, for the same reason.
inline constexpr double coated_absorptance_bound = 8192;

/// Of cosines of incidence and directions, after any number of bounces.
inline constexpr double direction_bound = 8;

/// Of the weight of a lobe, as a fraction of the opening.
inline constexpr double weight_bound = 16;

/// The same between unequal panels, where the opening may be much narrower than a panel is long.
inline constexpr double unequal_weight_bound = 64;

/// The same over a floor. All is measured from where the walls would meet, far below a wide floor between steep walls.
inline constexpr double floor_weight_bound = 1024;

/// Of the sum of the weights.
inline constexpr double sum_bound = 4;

/// Of reflectance and absorptance after `bounces` reflections: one facet after the other adds its own.
/// @param weight bound of the weights
inline double product_bound(int bounces, double weight = weight_bound) {
  return weight + 8 * bounces;
}

/// The same of powers that are made from amplitudes, whose relative error counts twice.
inline double squared_product_bound(int bounces) {
  return 16 + 16 * bounces;
}

/// Of the projection of the hemisphere on a disc, and back.
inline constexpr double projection_bound = 4;

/// Of H, reflectances and BRDF of matte grooves.
inline constexpr double matte_bound = 16;

/// Of the pdf of a rough surface, up to 8 bounces. Rounding of the directions, which are not quite of one length,
/// counts the more the nearer to the mirror direction.
/// @param h length of the horizontal part of the sum of the directions
inline double rough_pdf_bound(double h) {
  return 16 + 8 / h;
}

/// Of its BRDF.
inline double rough_bound(double h) {
  return 32 + 8 / h;
}

}  // namespace vcavity::test
