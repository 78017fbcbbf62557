// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Distributions of grooves: how steep the facets of a rough surface are, and which way they lean.
///
/// The surface is made of flat patches, large against the grooves, each covered by parallel equal grooves; patches
/// neither shadow nor light each other. Of a distribution the model needs two functions:
///
///  - `density(m)`, the density D(m) of facet area with the unit normal m, per mean area and solid angle, as
///    in every microfacet model: ∫ D(m) cos θ_m dω_m = 1. A groove has a facet of normal m and one of its mirror
///    image (−m_x, −m_y, m_z), so D must be the same for both; of any other D it is the mean of the two.
///  - `sample(u)`, a normal m drawn with the density D(m) cos θ_m from two numbers u uniform in [0, 1]. The
///    second number alone decides the azimuth of m (up to half a turn), the first one then the slope; the larger,
///    the steeper.
///
/// A distribution of your own is a struct with these two and a `value_type`, its number type. If it also has
/// `densities(across, cos_half, sin_half)`, the same of the normals (cos_half · across, sin_half), with a horizontal unit
/// vector and two packs, the BRDF is faster. Slopes are tangents: a facet of slope t rises by t on a way of 1, t = tan θ_m,
/// and the groove that it belongs to has the aperture α = 2 arctan(1/t).
///
/// The frame is that of the mean surface: z its normal, x the direction along which brushed grooves run.

#include <concepts>

#include "vcavity/conventions.hpp"

namespace vcavity {

/// A distribution of grooves, see above. Its number type is its `value_type`.
template <class Distribution>
concept SlopeDistribution =
    requires(const Distribution& distribution, const Vec3<typename Distribution::value_type>& m,
             const Vec2<typename Distribution::value_type>& u) {
      { distribution.density(m) } -> std::convertible_to<typename Distribution::value_type>;
      { distribution.sample(u) } -> std::convertible_to<Vec3<typename Distribution::value_type>>;
    };

/// The least and the largest roughness: within, densities neither vanish nor overflow, in float either.
inline constexpr double smallest_roughness = 1e-6;
inline constexpr double largest_roughness = 1e3;

}  // namespace vcavity
