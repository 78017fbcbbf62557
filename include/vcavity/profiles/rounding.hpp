// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// How much rounded rims or apexes can matter: bounds of the change of the reflectance of a symmetric groove.
///
/// Method. A fillet of radius r, tangent to both panels, replaces t = r / tan(α/2) of each of them, panels being of unit
/// width. Light whose path in the sharp groove never touches a replaced part keeps it. So the fraction of light that does
/// touch one bounds the change, whatever the facets. Under diffuse light every strip of a mirrored groove receives the
/// flux of its width, so of the light at most 2t/W, with W = 2 sin(α/2) the opening, meets replaced rims; and exactly t
/// enters the part of the groove that a rounded apex replaces. For one direction the fractions follow from the unfolded
/// groove: around the rims the union of the shadows of the replaced strips, at the apex the light that would meet a floor
/// of width t W.
///
/// Actual changes are much smaller: by trial under diffuse light, for silver and for glass, less than 0.03 of the bound
/// for rims and 0.06 of it for apexes.
///
/// When not to use it: to correct a reflectance. The sign of the change is not known, and a curved facet spreads lobes.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/profiles/truncated_groove.hpp"

namespace vcavity {

/// Bounds of the absolute change of a reflectance, in [0, 1].
template <class Real>
struct RoundingBound {
  Real rims;  ///< if all rims are rounded
  Real apex;  ///< if all apexes are rounded

  /// If both are.
  Real both() const { return at_most(Real(rims + apex), Real(1)); }
};

namespace detail {

/// The part of a panel that a fillet replaces.
template <class Real>
Real replaced_part(const Cavity<Real>& cavity, const Real& radius) {
  const Real part = radius * cavity.cos_half() * cavity.inverse_sin_half();
  if (!(radius >= Real(0) && part <= Real(1))) {
    throw_invalid_argument("the radius of a fillet must lie in [0, tan(α/2)] panel widths, here ",
                           cavity.sin_half() / cavity.cos_half(), ", not ", radius);
  }
  return part;
}

/// The length that intervals cover together.
template <class Real>
Real covered(std::vector<std::pair<Real, Real>>& intervals) {
  std::sort(intervals.begin(), intervals.end());
  Real length(0), end(0);
  bool is_first = true;
  for (const auto& [low, high] : intervals) {
    const Real start = is_first || low > end ? low : end;
    if (high > start) length += high - start;
    end = is_first || high > end ? high : end;
    is_first = false;
  }
  return length;
}

}  // namespace detail

/// Bounds for the bi-hemispherical reflectance.
/// @param cavity the groove
/// @param radius of the fillets in panel widths, in [0, tan(α/2)]
/// @throws std::invalid_argument when it is out of range or is not a number
template <class Real>
RoundingBound<Real> rounding_bound(const Cavity<Real>& cavity, const Real& radius) {
  const Real part = detail::replaced_part(cavity, radius);
  return {at_most(Real(part * cavity.inverse_sin_half()), Real(1)), part};
}

/// Bounds for the directional reflectance.
/// @param cavity the groove
/// @param e direction towards the light, e.z > 0; for grazing light the bounds lose digits like ε/e.z
/// @param radius of the fillets in panel widths, in [0, tan(α/2)]
/// @throws std::invalid_argument when it is out of range or is not a number
template <class Real>
RoundingBound<Real> rounding_bound(const Cavity<Real>& cavity, const Vec3<Real>& e, const Real& radius) {
  const Real part = detail::replaced_part(cavity, radius);
  RoundingBound<Real> bound{Real(0), Real(0)};
  if (!(part > Real(0))) return bound;

  // Distances from the apex; the rim of image j lies at its cosine.
  for (const Panel first : {Panel::one, Panel::two}) {
    std::vector<std::pair<Real, Real>> touched;
    const Real shadow = at_least(Real(-unfold(cavity, e, opposite(first)).normal_component()), Real(0));
    UnfoldedRay<Real> ray = unfold(cavity, e, first);
    Real reached = ray.normal_component();
    while (reached > shadow) {
      const Real low = std::max(shadow, Real((Real(1) - part) * ray.normal_component()));
      if (low < reached) touched.emplace_back(low, reached);
      ray.advance();
      reached = std::min(reached, ray.normal_component());
    }
    bound.rims += detail::covered(touched) / (Real(2) * cavity.sin_half() * e.z);
  }
  bound.rims = at_most(bound.rims, Real(1));

  if (!(part < Real(1))) return {bound.rims, Real(1)};
  const Real slope = (pi<Real>() - cavity.aperture()) / Real(2);
  const Real depth = (Real(1) - part) * cavity.cos_half();
  const TruncatedGroove<Real> chord(slope, slope, Real(2) * part * cavity.sin_half() / depth);
  chord.follow(
      e, [](const Real&) { return Real(1); },
      [&](const FacePencil<Real>& light, const Real&) {
        if (light.path.meets_floor) bound.apex += light.weight;
      });
  bound.apex = at_most(bound.apex, Real(1));
  return bound;
}

}  // namespace vcavity
