// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bounces of a single ray: which panel it meets first, how often it is reflected, and at which angles.
///
/// Method. Unfolding: instead of reflecting the ray, reflect the groove. The ray is then a straight line that
/// crosses the images of the panels, which stand around the apex at the angles α/2 + (j − 1)α, j = 1, 2, …
/// The number of images it crosses inside the unit circle is the number of bounces.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <utility>

#include "cavity.hpp"
#include "value.hpp"

namespace vcavity {

/// The way of a ray through the groove, as far as geometry goes.
struct RayPath {
  Panel first_panel;  ///< the panel met first
  int bounces;        ///< the number of reflections, at least 1, at most `Cavity::max_bounces()`
};

/// The successive images of the panels as a straight ray meets them (Eqs. 14–16). One rotation by the
/// aperture leads from each bounce to the next; no trigonometric function is evaluated.
template <class Real>
class PanelImages {
 public:
  /// @param e direction towards the light
  /// @param first the panel met first
  PanelImages(const Cavity<Real>& cavity, const Vec3<Real>& e, Panel first)
      : sine_(cavity.sin_aperture()),
        versine_(cavity.versine_aperture()),
        along_(e.x),
        panel_(first) {
    const Real across = first == Panel::one ? e.y : Real(-e.y);
    normal_ = across * cavity.cos_half() + e.z * cavity.sin_half();
    tangent_ = e.z * cavity.cos_half() - across * cavity.sin_half();
  }

  /// Number j of the bounce, starting at 1.
  int bounce() const { return bounce_; }

  /// The real panel on which bounce j takes place.
  Panel panel() const { return panel_; }

  /// e · N^(j), before any clamping of its rounding error.
  const Real& normal_component() const { return normal_; }

  /// The component of e in the image, across the groove and away from the apex.
  const Real& tangent_component() const { return tangent_; }

  /// The component of e along the groove, the same at every bounce.
  const Real& along_component() const { return along_; }

  /// Cosine of the angle of incidence, c_j = e · N^(j), not negative.
  Real cos_theta_i() const { return at_least(normal_, Real(0)); }

  /// Steps to the next image. The rotation is written with 1 − cos α so that many small steps do not drift.
  void advance() {
    const Real normal = normal_;
    normal_ = normal - (versine_ * normal - sine_ * tangent_);
    tangent_ = tangent_ - (versine_ * tangent_ + sine_ * normal);
    panel_ = opposite(panel_);
    ++bounce_;
  }

  /// The direction in which the light travels after bounce j: the normal component is reversed, the others
  /// stay.
  Vec3<Real> exit_direction(const Cavity<Real>& cavity, const Vec3<Real>& e) const {
    const Real across = normal_ * cavity.cos_half() + tangent_ * cavity.sin_half();
    return {-e.x, panel_ == Panel::one ? across : Real(-across),
            normal_ * cavity.sin_half() - tangent_ * cavity.cos_half()};
  }

 private:
  Real sine_;
  Real versine_;
  Real along_;
  Real normal_;
  Real tangent_;
  Panel panel_;
  int bounce_ = 1;
};

/// The value of a facet for one bounce: called with the cosine of the angle of incidence if it can be, else
/// with the bounce itself.
template <class Real, FacetReflectance<Real> Facet>
value_t<Facet, Real> reflect(const Facet& facet, const PanelImages<Real>& bounce) {
  if constexpr (std::invocable<const Facet&, const Real&>) {
    return facet(bounce.cos_theta_i());
  } else {
    return facet(bounce);
  }
}

/// First panel and number of bounces of the ray through a point of the opening (Eqs. 7–13).
///
/// With θ' the angle of the ray across the groove, δ = y cos θ' − cos(α/2) sin θ' its signed distance from
/// the apex and s = sign δ: panel one is met first if δ < 0, and m = ⌊(π + s θ' − arcsin|δ|)/α − 1/2⌋ + 1.
/// (The paper's Eqs. 11 and 12 are merged here.) A ray through the apex counts as meeting panel two first,
/// one through the edge of a panel's image as meeting that image. Rounding never gives less than 1 bounce nor
/// more than `max_bounces`.
///
/// @param e direction towards the light, e.z ≥ 0
/// @param position where the ray crosses the opening, a fraction of its half width in [−1, 1]
template <class Real>
RayPath ray_path(const Cavity<Real>& cavity, const Vec3<Real>& e, const Real& position) {
  using std::asin;
  using std::atan2;
  using std::floor;
  using std::sqrt;
  assert(e.z >= Real(0) && position >= Real(-1) && position <= Real(1));

  const Real across = sqrt(e.y * e.y + e.z * e.z);
  if (!(across > Real(0)))
    return {position < Real(0) ? Panel::one : Panel::two, 1};  // grazing along the groove

  const Real distance =
      (position * cavity.sin_half() * e.z - cavity.cos_half() * e.y) / across;  // δ, from the apex
  const Panel first = distance < Real(0) ? Panel::one : Panel::two;
  const Real theta = atan2(e.y, e.z);
  const Real leaving = pi<Real>() + (first == Panel::one ? Real(-theta) : theta) -
                       asin(at_most(largest(distance), Real(1)));  // γ_H
  const Real count = floor(leaving / cavity.aperture() - Real(0.5)) + Real(1);
  const int most = cavity.max_bounces();
  if (!(count < Real(most))) return {first, most};
  return {first, std::max(1, static_cast<int>(count))};
}

/// The direction in which the light of a ray leaves the groove.
template <class Real>
Vec3<Real> ray_exit_direction(const Cavity<Real>& cavity, const Vec3<Real>& e, const RayPath& path) {
  PanelImages<Real> images(cavity, e, path.first_panel);
  while (images.bounce() < path.bounces) images.advance();
  return images.exit_direction(cavity, e);
}

/// Reflectance of a single ray, the product of the facet reflectances along its way (Eq. 17).
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
template <class Real, FacetReflectance<Real> Facet>
power_t<Facet, Real> ray_reflectance(const Cavity<Real>& cavity, const Vec3<Real>& e, const RayPath& path,
                                     const Facet& facet) {
  PanelImages<Real> images(cavity, e, path.first_panel);
  auto throughput = reflect(facet, images);
  while (images.bounce() < path.bounces) {
    images.advance();
    throughput = throughput * reflect(facet, images);
  }
  return power(throughput);
}

/// Reflectance R(θ, φ, y) of the ray through a point of the opening (Eq. 17).
/// @param e direction towards the light, e.z ≥ 0
/// @param position where the ray crosses the opening, a fraction of its half width in [−1, 1]
template <class Real, FacetReflectance<Real> Facet>
power_t<Facet, Real> ray_reflectance(const Cavity<Real>& cavity, const Vec3<Real>& e, const Real& position,
                                     const Facet& facet) {
  return ray_reflectance(cavity, e, ray_path(cavity, e, position), facet);
}

}  // namespace vcavity
