// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Agreement ray by ray: no statistics, every single ray has to come out the same.

#include <cstdint>
#include <limits>
#include <string>

#include "closed_form.hpp"

namespace agreement {

/// Rays that pass an edge within this distance, in panel widths across the ray, may take another way: both
/// programs round.
inline constexpr double edge_margin = 1e-12;

/// Largest distance between the two exit directions, both unit vectors. Only double precision is at work
/// here: ninety rotations in the theory, ninety reflections in the tracer.
inline constexpr double direction_tolerance = 1e-12;

/// Largest relative difference between the two products of Fresnel reflectances, of up to ninety factors
/// whose cosines are as uncertain as the direction.
inline constexpr double product_tolerance = 1e-10;

/// An upper bound of the probability that a ray of this direction comes within the margin of an edge. Of the
/// rays that enter side by side, one passes through each of at most seven edges: two rims on the way in, the
/// apex, and on the way out, after meeting either panel first, the two rims beside which the number of
/// bounces changes.
double expected_inside_margin(const LightRay& ray);

/// Counts of one comparison.
struct RayAgreement {
  std::int64_t rays = 0;
  std::int64_t inside_margin = 0;       ///< rays within the margin of an edge
  std::int64_t mismatches_inside = 0;   ///< those of them for which the two programs differ
  std::int64_t mismatches = 0;          ///< rays outside the margin for which they differ: none are allowed
  std::int64_t refined = 0;             ///< rays with a panel chosen in double precision
  std::int64_t met_another_groove = 0;  ///< rays that left one groove and met another: the model says never
  double expected_inside = 0;           ///< sum of expected_inside_margin()
  double largest_direction_error = 0;   ///< outside the margin, where path and theory have the same bounces
  double largest_product_error = 0;     ///< the same, relative
  std::string first_mismatch;           ///< description of the first ray outside the margin that differs

  /// Compares what was traced with what the theory says, and counts the outcome.
  void add(const LightRay& ray, const Material& material, const tracer::Path& path, const RayAnswer& answer);

  /// Adds the counts of another comparison.
  RayAgreement& operator+=(const RayAgreement& other);

  /// Theory and tracer agree: there were rays, none outside the margin differs, and none has met a second
  /// groove.
  bool holds() const { return rays > 0 && mismatches == 0 && met_another_groove == 0; }

  /// The margin has hidden no more rays than its width explains, up to five standard deviations of chance.
  bool margin_is_narrow() const;

  double fraction_refined() const { return static_cast<double>(refined) / static_cast<double>(rays); }
  double fraction_inside() const { return static_cast<double>(inside_margin) / static_cast<double>(rays); }
};

}  // namespace agreement
