// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bi-hemispherical reflectance of grooves whose panels differ in slope or material.
///
/// Method. As for the symmetric groove the kinks of the weights are known beforehand. Let P_k = L_k (−sin a_k, cos a_k)
/// be the rims of the images of the panels, k ≥ 0, in the frame of the bisector turned so that the first panel lies at
/// y < 0. Weights change slope in directions along P_j, where an image begins to be seen from the apex, and along
/// P_j − P_i, where two rims stand behind each other; i is 0, 1, 2 or j − 1. Between them, and between the angles at which
/// a bounce passes the critical one, the integrand is smooth (adaptive_hemisphere.hpp).
///
/// When not to use it: for symmetric grooves of one material, which need some five times fewer evaluations. Below some 3°
/// rays of all numbers of bounces make more kinks than 5·10⁷ evaluations suffice for: what is known by then is returned,
/// with an estimate that says so.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcavity/facet/panel_facets.hpp"
#include "vcavity/groove/asymmetric_groove.hpp"
#include "vcavity/groove/reflectance.hpp"
#include "vcavity/hemisphere/adaptive_hemisphere.hpp"
#include "vcavity/hemisphere/counted_facet.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/hemisphere/kinks.hpp"
#include "vcavity/numbers/invalid_argument.hpp"

namespace vcavity {

namespace detail {

/// The critical cosine of the facet of a panel.
template <class Real, class Facet>
Real critical_cosine_at(const Facet& facet, Panel) {
  return critical_cosine_of<Real>(facet);
}
template <class Real, class One, class Two>
Real critical_cosine_at(const PanelFacets<One, Two>& facets, Panel panel) {
  return panel == Panel::one ? critical_cosine_of<Real>(facets.one) : critical_cosine_of<Real>(facets.two);
}

/// The angles θ' between which the weights of all lobes are smooth and no cosine of incidence passes the critical one at
/// ψ = 0; ascending, from −π/2 to π/2.
template <class Real, class Facet>
std::vector<Real> kinks(const AsymmetricGroove<Real>& groove, const Facet& facet) {
  using std::acos;
  using std::atan2;
  using std::cos;
  using std::sin;
  const Real half_pi = pi<Real>() / Real(2);
  const int images = groove.max_bounces() + 1;
  std::vector<Real> angles{-half_pi, half_pi};
  const auto add = [&](const Real& angle) {
    Real theta = angle;
    while (theta > half_pi) theta -= pi<Real>();
    while (theta < -half_pi) theta += pi<Real>();
    angles.push_back(theta);
  };
  for (const Panel first : {Panel::one, Panel::two}) {
    const Real side = first == Panel::one ? Real(1) : Real(-1);
    const auto panel = [&](int k) { return k % 2 != 0 ? first : opposite(first); };
    const auto position = [&](int k) { return (Real(k) - Real(0.5)) * groove.aperture(); };
    const auto rim = [&](int k) -> Vec2<Real> {
      const Real length = groove.length(panel(k));
      return {-length * sin(position(k)), length * cos(position(k))};
    };
    const auto add_along = [&](const Vec2<Real>& v) { add(groove.tilt() + side * atan2(v.x, v.y)); };
    for (int j = 0; j <= images; ++j) {
      add_along(rim(j));
      for (int i = 0; i < j; i = i < 2 ? i + 1 : std::max(i + 1, j - 1)) add_along(rim(j) - rim(i));
      const Real critical = j > 0 ? critical_cosine_at<Real>(facet, panel(j)) : Real(0);
      if (!(critical > Real(0))) continue;
      // The cosine at ψ = 0 is that of the angle from the normal of the image.
      const Real turn = acos(critical);
      for (const Real& from_normal : {turn, Real(-turn)}) {
        const Real theta = groove.tilt() + side * (half_pi - position(j) + from_normal);
        if (magnitude(theta) < half_pi) angles.push_back(theta);
      }
    }
  }
  sort_angles(angles);
  // In narrow grooves there are more than it pays to cut at; the quadrature halves the cells that need it.
  constexpr std::size_t most_cells = 512;
  if (angles.size() <= most_cells) return angles;
  const Real least = pi<Real>() / Real(static_cast<int>(most_cells));
  std::vector<Real> spaced{angles.front()};
  for (const Real& angle : angles)
    if (angle - spaced.back() >= least && half_pi - angle >= least) spaced.push_back(angle);
  spaced.push_back(angles.back());
  return spaced;
}

}  // namespace detail

/// Bi-hemispherical reflectance (Eq. 26) of an asymmetric groove, with an estimate of its error and its cost.
///
/// @param groove the groove
/// @param facet facet reflectance, such as a material or `PanelFacets`
/// @param tolerance absolute error to aim at, > 0; what rounding forbids is not attempted
/// @param max_bounces light that needs more bounces is left out
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the reflectance of unpolarised light
template <class Real, FacetReflectance<Real> Facet>
Integral<unpolarized_t<Facet, Real>> bihemispherical_reflectance(
    const AsymmetricGroove<Real>& groove, const Facet& facet,
    const scalar_t<unpolarized_t<Facet, Real>>& tolerance, int max_bounces = all_bounces) {
  using Value = unpolarized_t<Facet, Real>;
  using Scalar = scalar_t<Value>;
  if (!(tolerance > Scalar(0))) {
    throw_invalid_argument("the tolerance of the bi-hemispherical reflectance must be positive, not ",
                           tolerance);
  }
  long long evaluations = 0;
  const CountedFacet<Facet> counted(facet, evaluations);
  const auto reflectance = [&](const Vec3<Real>& e) {
    return unpolarized_reflectance(groove, e, counted, max_bounces);
  };
  const auto cuts = [&](const Vec3<Real>& e, std::vector<Real>& elevations) {
    using std::acos;
    const auto note = [&](const Bounce<Real>& bounce) {
      const Real critical = detail::critical_cosine_at<Real>(facet, bounce.panel);
      if (critical > Real(0) && bounce.cosine > critical)
        elevations.push_back(acos(critical / bounce.cosine));
      return Real(1);
    };
    unpolarized_reflectance(groove, e, note, max_bounces);
  };
  detail::AdaptiveHemisphere<Real, Value, decltype(reflectance), decltype(cuts)> quadrature(reflectance, cuts,
                                                                                            evaluations);
  return quadrature(detail::kinks(groove, facet), tolerance);
}

}  // namespace vcavity
