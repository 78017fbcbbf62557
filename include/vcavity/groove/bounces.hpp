// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bounces of a single ray: which panel it meets first, how often it is reflected, and at which angles.
///
/// Method. Unfolding: instead of reflecting the ray, reflect the groove. The ray is then a straight line that
/// crosses the images of the panels, which stand around the apex at the angles α/2 + (j − 1)α, j = 1, 2, …
/// The number of images it crosses inside the unit circle is the number of bounces.

#include <cassert>
#include <cmath>
#include <concepts>
#include <cstdint>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/fan.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/inline.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The way of a ray through the groove, as far as geometry goes.
struct RayPath {
  Panel first_panel;  ///< the panel met first
  int bounces;        ///< the number of reflections, at least 1, at most `Cavity::max_bounces()`
};

/// The panel that faces a direction; panel one for light along the groove.
template <Number Real>
Panel facing_panel(const Vec3<Real>& e) {
  return e.y < Real(0) ? Panel::two : Panel::one;
}

/// The same for a pack of directions, all with e.y ≥ 0; mirror the others.
template <class Real>
Panel facing_panel([[maybe_unused]] const Vec3<Real>& e) {
  assert(!any_positive(-e.y));
  return Panel::one;
}

/// The successive images of the panels as a straight ray meets them (Eqs. 14–16). One rotation by the
/// aperture leads from each bounce to the next; no trigonometric function is evaluated.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
class PanelImages {
 public:
  using Groove = Cavity<scalar_t<Real>>;

  /// @param cavity must outlive the images
  /// @param e direction towards the light
  /// @param first the panel met first
  PanelImages(const Groove& cavity, const Vec3<Real>& e, Panel first)
      : PanelImages(cavity, e.x, first == Panel::one ? e.y : Real(-e.y), e.z, first) {}
  PanelImages(const Groove&&, const Vec3<Real>&, Panel) = delete;

  /// Number j of the bounce, starting at 1.
  int bounce() const { return bounce_; }

  /// The real panel on which bounce j takes place.
  Panel panel() const { return panel_; }

  /// e · N^(j), before any clamping of its rounding error.
  Real normal_component() const { return e_.y(); }

  /// The component of e in the image, across the groove and away from the apex.
  Real tangent_component() const { return e_.x(); }

  /// The component of e along the groove, the same at every bounce.
  const Real& along_component() const { return along_; }

  /// Cosine of the angle of incidence, c_j = e · N^(j), not negative.
  Real cos_theta_i() const { return at_least(normal_component(), scalar_t<Real>(0)); }

  /// Steps to the next image.
  void advance() {
    e_.turn(2);
    panel_ = opposite(panel_);
    ++bounce_;
  }

  /// Steps over several images at once.
  void advance(int images) {
    e_.turn(std::int64_t{2} * images);
    if (images % 2 != 0) panel_ = opposite(panel_);
    bounce_ += images;
  }

  /// The direction in which the light travels after bounce j: the normal component is reversed, the others
  /// stay.
  Vec3<Real> exit_direction(const Groove& cavity, const Vec3<Real>& e) const {
    const Real across = e_.y() * cavity.cos_half() + e_.x() * cavity.sin_half();
    return {-e.x, panel_ == Panel::one ? across : Real(-across),
            e_.y() * cavity.sin_half() - e_.x() * cavity.cos_half()};
  }

 private:
  /// @param along component of the direction along the groove
  /// @param across its component from the first panel to the other
  /// @param up its component along the mean normal
  PanelImages(const Groove& cavity, const Real& along, const Real& across, const Real& up, Panel first)
      : e_(cavity, up, across), along_(along), panel_(first) {
    e_.turn(1);
  }

  FanVector<Real> e_;  // the direction, in components along and normal to the image
  Real along_;
  Panel panel_;
  int bounce_ = 1;
};

/// The value of a facet for one bounce: called with the cosine of the angle of incidence if it can be, else
/// with the bounce itself.
template <class Real, FacetReflectance<Real> Facet>
VCAVITY_INLINE value_t<Facet, Real> reflect(const Facet& facet, const PanelImages<Real>& bounce) {
  if constexpr (std::invocable<const Facet&, const Real&>) {
    return facet(bounce.cos_theta_i());
  } else {
    return facet(bounce);
  }
}

/// First panel and number of bounces of the ray through a point of the opening (Eqs. 7–13).
///
/// With θ' the angle of the ray across the groove, δ = y cos θ' − cos(α/2) sin θ' its signed distance from
/// the apex and s = sign δ: panel one is met first if δ < 0, and m = ⌊γ/α − 1/2⌋ + 1, where
/// γ = π + s θ' − arcsin|δ| merges the paper's Eqs. 11 and 12. Here γ = (π/2 + s θ') + arccos|δ|, two angles
/// that are small together in a narrow groove under grazing light, and keep their digits.
///
/// A ray through the apex counts as meeting panel two first, one through the edge of a panel's image as
/// meeting that image. The answer is at least 1 and at most `max_bounces`, whatever the rounding.
///
/// @param e direction towards the light, e.z ≥ 0
/// @param position where the ray crosses the opening, a fraction of its half width in [−1, 1]
template <class Real>
RayPath ray_path(const Cavity<Real>& cavity, const Vec3<Real>& e, const Real& position) {
  using std::atan2;
  using std::floor;
  using std::sqrt;
  assert(e.z >= Real(0) && position >= Real(-1) && position <= Real(1));

  const Real size = at_least(largest(e.y), e.z);
  if (!(size > Real(0)))
    return {position < Real(0) ? Panel::one : Panel::two, 1};  // grazing along the groove
  // Only the ratio of y and z counts. Almost along the groove their squares would vanish.
  const Real y = e.y / size;
  const Real z = e.z / size;
  const Real across = sqrt(y * y + z * z);

  const Real aside = position * cavity.sin_half() * z;
  const Panel first = aside < cavity.cos_half() * y ? Panel::one : Panel::two;  // δ < 0
  const Real facing = first == Panel::one ? y : Real(-y);
  // 1 − |δ|, without forming |δ| = (cos(α/2) facing ∓ aside)/across
  const Real beyond = facing > Real(0) ? Real(z * (z / (across + facing))) : Real(across - facing);
  const Real rest = at_least(
      Real((beyond + cavity.versine_half() * facing + (first == Panel::one ? aside : Real(-aside))) / across),
      Real(0));
  const Real leaving = atan2(z, facing) + atan2(sqrt(rest * (Real(2) - rest)), Real(1) - rest);  // γ
  const Real count = floor(leaving / cavity.aperture() - Real(0.5)) + Real(1);
  if (count <= Real(1)) return {first, 1};
  const int most = cavity.max_bounces();
  return {first, count < Real(most) ? static_cast<int>(count) : most};
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
