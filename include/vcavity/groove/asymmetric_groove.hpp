// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A groove whose panels are not equally steep: sawtooth, blazed grating, Fresnel lens.
///
/// Method. Panels one (y < 0) and two (y > 0) stand at the angles β1 and β2 to the mean plane, with their rims at equal
/// height. Let α = π − β1 − β2 be the aperture and τ = (β1 − β2)/2 the tilt of the bisector, from z towards +y. In the
/// frame of the bisector the light meets the images of a symmetric groove, so the bounces are those of `UnfoldedRay`.
/// Only the weights are new: with the groove of depth 1, L the length of a panel, 1/cos(α/2 ∓ τ), and W = L1 L2 sin α
/// the opening, image j reflects alone the fraction
///
///     g_j = L_j c_j / (W e_z)                                               where light reaches both panels, and else
///     g_j = 2 L_q sin(jα/2) D((j−1)α/2) / (W e_z)          for even j,
///     g_j = 1 + 2 L_p sin((j−1)α/2) D(jα/2) / (W e_z)      for odd j,
///
/// where p is met first, q the other one, and D(a) the component of e at the angle a from the bisector, away from p.
/// Images of unequal length do not fall off one after the other, so f_j is the running minimum of g_1, …, g_j.
///
/// Validity: β1, β2 > 0 and β1 + β2 < π; vertical and overhanging walls are nothing special. Light that leaves meets no
/// other groove, for nothing rises above the plane of the rims. A direction has at most five lobes, six where a wall
/// overhangs (found by trial over 8·10⁷ directions); three, or four, of the same first panel are proved.
///
/// When not to use it: `Cavity` is faster where the panels are equal. And where α is known, pass it: two
/// rounded slopes of a narrow groove have lost some of its digits.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/lit_opening.hpp"
#include "vcavity/groove/ray.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A V-groove with panels of different slope, infinitely long.
template <class Real>
class AsymmetricGroove {
 public:
  using value_type = Real;

  /// The largest number of lobes of any direction: four for either first panel.
  static constexpr std::size_t max_lobes = 8;

  /// @param aperture the angle between the panels, in (0, π)
  /// @param tilt of the bisector from z towards +y; its magnitude below (π − aperture)/2
  /// @throws std::invalid_argument when one is out of range or is not a number
  AsymmetricGroove(const Real& aperture, const Real& tilt) : bisected_(checked(aperture, tilt)), tilt_(tilt) {
    using std::cos;
    using std::sin;
    cos_tilt_ = cos(tilt);
    sin_tilt_ = sin(tilt);
    lengths_[0] = Real(1) / cos(aperture / Real(2) - tilt);
    lengths_[1] = Real(1) / cos(aperture / Real(2) + tilt);
    opening_ = lengths_[0] * lengths_[1] * sin(aperture);
  }

  /// The same around a symmetric groove that is made already, for a renderer that makes one for every point it shades:
  /// the tilt is added to half the aperture by the addition theorem. Packs of grooves are not checked.
  /// @param bisected of this aperture, below π
  /// @param tilt as above
  /// @throws std::invalid_argument when one is out of range or is not a number
  AsymmetricGroove(const Cavity<Real>& bisected, const Real& tilt) : bisected_(bisected), tilt_(tilt) {
    using std::cos;
    using std::sin;
    cos_tilt_ = cos(tilt);
    sin_tilt_ = sin(tilt);
    const Real up = bisected.cos_half() * cos_tilt_, turned = bisected.sin_half() * sin_tilt_;
    if constexpr (Number<Real>)
      if (!(up - magnitude(turned) > rounding() && magnitude(tilt) < pi<Real>()))
        refuse_tilt(bisected.aperture(), tilt);
    lengths_[0] = Real(1) / Real(up + turned);
    lengths_[1] = Real(1) / Real(up - turned);
    opening_ = Real(2) * bisected.sin_half() * bisected.cos_half() * (lengths_[0] * lengths_[1]);
  }

  /// The groove whose panels stand at given angles to the mean plane.
  /// @param one,two positive, together below π; a wall beyond π/2 overhangs
  /// @throws std::invalid_argument when they make no groove
  static AsymmetricGroove from_slopes(const Real& one, const Real& two) {
    if (!(one > Real(0) && two > Real(0) && one + two < pi<Real>())) {
      throw_invalid_argument("the slopes of a groove must be positive and together below π radians, not ",
                             one, " and ", two);
    }
    using std::sin;
    // The sine of π as it is rounded is what it lacks.
    return {(pi<Real>() - one - two) + sin(pi<Real>()), (one - two) / Real(2)};
  }

  /// The angle α between the panels.
  Real aperture() const { return bisected_.aperture(); }

  /// The angle τ of the bisector from z towards +y.
  Real tilt() const { return tilt_; }

  /// The angle of a panel to the mean plane.
  Real slope(Panel panel) const {
    const Real mean = (pi<Real>() - aperture()) / Real(2);
    return panel == Panel::one ? Real(mean + tilt_) : Real(mean - tilt_);
  }

  /// Length of a panel over the depth of the groove.
  const Real& length(Panel panel) const { return lengths_[panel == Panel::one ? 0 : 1]; }

  /// Width of the opening over the depth of the groove.
  Real opening() const { return opening_; }

  /// The area of the panels per area of the opening; under diffuse light the mean number of bounces.
  Real developed_area() const { return (lengths_[0] + lengths_[1]) / opening_; }

  /// The largest number of bounces of any ray, ⌈π/α⌉.
  int max_bounces() const { return bisected_.max_bounces(); }

  /// The symmetric groove of this aperture, in the frame of the bisector.
  const Cavity<Real>& bisected() const { return bisected_; }

  /// A direction in the frame of the bisector.
  /// @tparam Component number, or a `Pack` of them
  template <class Component>
  Vec3<Component> to_bisector(const Vec3<Component>& v) const {
    return {v.x, cos_tilt_ * v.y - sin_tilt_ * v.z, cos_tilt_ * v.z + sin_tilt_ * v.y};
  }

  /// A direction in the frame of the bisector, in the frame of the groove.
  template <class Component>
  Vec3<Component> from_bisector(const Vec3<Component>& v) const {
    return {v.x, cos_tilt_ * v.y + sin_tilt_ * v.z, cos_tilt_ * v.z - sin_tilt_ * v.y};
  }

 private:
  static const Real& checked(const Real& aperture, const Real& tilt) {
    if (!(aperture > Real(0) && aperture < pi<Real>())) {
      throw_invalid_argument("the aperture of an asymmetric groove must lie in (0, π) radians, not ",
                             aperture);
    }
    if (!(magnitude(tilt) < most_tilt(aperture) - rounding())) refuse_tilt(aperture, tilt);
    return aperture;
  }

  static Real most_tilt(const Real& aperture) { return (pi<Real>() - aperture) / Real(2); }

  static Real rounding() { return Real(4) * std::numeric_limits<Real>::epsilon(); }

  static void refuse_tilt(const Real& aperture, const Real& tilt) {
    throw_invalid_argument("the tilt of a groove of aperture ", aperture, " must be less than ",
                           most_tilt(aperture), " radians either way, not ", tilt);
  }

  Cavity<Real> bisected_;
  Real tilt_, cos_tilt_, sin_tilt_;
  Real lengths_[2];
  Real opening_;
};

/// The opening of an asymmetric groove in the light of a direction; members as in `LitOpening`.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
class AsymmetricOpening {
 public:
  using Scalar = scalar_t<Real>;

  /// @param groove must outlive the opening
  /// @param towards_light direction towards the light; raised to where inverses of e.z are finite
  VCAVITY_INLINE AsymmetricOpening(const AsymmetricGroove<Scalar>& groove, const Vec3<Real>& towards_light)
      : groove_(groove),
        e_{towards_light.x, towards_light.y, at_least(towards_light.z, least_up(groove))},
        inverse_width_(Real(1) / Real(groove.opening() * e_.z)) {
    const Cavity<Scalar>& cavity = groove.bisected();
    tilted_ = groove.to_bisector(e_);
    const Real up = cavity.sin_half() * tilted_.z;
    const Real across = cavity.cos_half() * tilted_.y;
    const Real one = groove.length(Panel::one) * (up + across) * inverse_width_;
    const Real two = groove.length(Panel::two) * (up - across) * inverse_width_;
    one_is_larger_ = one > two;
    const Real smaller = select(one_is_larger_, two, one);
    both_ = smaller > negligible_fraction<Scalar>();
    smaller_share_ = select(both_, smaller, Real(0));
  }

  /// The direction towards the light.
  const Vec3<Real>& direction() const { return e_; }

  /// How many panels there are that some rays may meet first.
  int first_panels() const { return any_of(both_) || !Number<Real> ? 2 : 1; }

  /// A panel that some rays may meet first.
  /// @param which of them, below `first_panels()`
  Panel first_panel(int which) const {
    const Panel larger = any_of(one_is_larger_) ? Panel::one : Panel::two;
    return which == 0 ? larger : opposite(larger);
  }

  /// f_1: the fraction of the opening whose rays meet a panel first.
  /// @param panel one of the first panels
  Real first_met(Panel panel) const {
    const Real rest = Real(1) - smaller_share_;
    return panel == Panel::one ? select(one_is_larger_, rest, smaller_share_)
                               : select(one_is_larger_, smaller_share_, rest);
  }

  /// f_j, where j is the bounce at which the ray is, at least 2.
  /// @param ray the ray at its present bounce
  /// @param before f_{j−1}, which f_j never exceeds
  VCAVITY_INLINE Real reached(const UnfoldedRay<Real>& ray, const Real& before) const {
    const Real share =
        select(both_, Real(length(ray) * ray.normal_component() * inverse_width_), beyond_shadow(ray));
    return select(ray.normal_component() > Scalar(0), at_least(at_most(share, before), Scalar(0)), Real(0));
  }

 private:
  const Scalar& length(const UnfoldedRay<Real>& ray) const { return groove_.length(ray.panel()); }

  /// g_j where the other panel lies in the shadow of its rim.
  Real beyond_shadow(const UnfoldedRay<Real>& ray) const {
    const Cavity<Scalar>& cavity = groove_.bisected();
    const int j = ray.number();
    const bool is_even = j % 2 == 0;
    const auto turn = cavity.multiple(is_even ? j - 1 : j);
    const Scalar fan = Scalar(2) * length(ray) * cavity.multiple(is_even ? j : j - 1).sine;
    const Scalar sine = ray.first_panel() == Panel::one ? turn.sine : Scalar(-turn.sine);
    const Real away = turn.cosine * tilted_.z - sine * tilted_.y;
    const Real beyond = fan * away * inverse_width_;
    return is_even ? beyond : Real(Real(1) + beyond);
  }

  /// The least e.z: smaller ones count as this one.
  static Scalar least_up(const AsymmetricGroove<Scalar>& groove) {
    return smallest_divisor<Scalar>() / at_most(groove.opening(), Scalar(1));
  }

  const AsymmetricGroove<Scalar>& groove_;
  Vec3<Real> e_;
  Vec3<Real> tilted_;           // in the frame of the bisector
  Real inverse_width_;          // of the opening as the light sees it, 1/(W e_z)
  mask_t<Real> one_is_larger_;  // set where more rays meet panel one first
  mask_t<Real> both_;           // set where light reaches both panels directly
  Real smaller_share_;          // fraction of the opening whose rays meet the less lit panel first
};

/// Until where all rays that meet the same panel first bounce together; members as in `SharedBounces`.
/// @tparam Real number type of a component, or a `Pack` of them
template <class Real>
class AsymmetricSharedBounces {
 public:
  using Scalar = scalar_t<Real>;

  /// @param groove must outlive this
  /// @param first the ray at its first bounce
  VCAVITY_INLINE AsymmetricSharedBounces(const AsymmetricGroove<Scalar>& groove,
                                         const UnfoldedRay<Real>& first)
      : groove_(groove),
        surely_reached_(
            groove.length(first.panel()) *
            (first.normal_component() + Real(Scalar(16) * std::numeric_limits<Scalar>::epsilon()))) {}

  /// Whether all rays surely bounce at an image too, at the cost of a comparison: its rim lies farther out, by more
  /// than rounding.
  /// @param ray at that image
  bool include(const UnfoldedRay<Real>& ray) const {
    return all_of(Real(groove_.length(ray.panel()) * ray.normal_component()) > surely_reached_);
  }

 private:
  const AsymmetricGroove<Scalar>& groove_;
  Real surely_reached_;  // a rim farther out than this
};

/// Until where all rays that meet the same panel first bounce together.
/// @param groove must outlive the result
/// @param first the ray at its first bounce
template <class Scalar, class Real>
VCAVITY_INLINE AsymmetricSharedBounces<Real> shared_bounces(const AsymmetricGroove<Scalar>& groove,
                                                            const UnfoldedRay<Real>& first) {
  return AsymmetricSharedBounces<Real>(groove, first);
}

/// How often all rays surely bounce that meet a panel first, as if all images were as short as the shorter panel.
/// @param groove the groove
/// @param first the panel met first
/// @param normal,tangent components of the direction towards the light at the first bounce, see `UnfoldedRay`
/// @param most no more than these matter
template <std::floating_point Real>
int count_shared_bounces(const AsymmetricGroove<Real>& groove, Panel first, const Real& normal,
                         const Real& tangent, int most) {
  const Real shorter = std::min(groove.length(Panel::one), groove.length(Panel::two));
  const Real least_sine = groove.length(first) / shorter * (normal / std::hypot(normal, tangent));
  if (!(least_sine < Real(1))) return 0;
  const Real first_angle = std::atan2(normal, tangent);
  const Real least_angle = std::asin(least_sine);
  if (first_angle + groove.aperture() < least_angle) return 0;
  const Real bounces = (pi<Real>() - least_angle - first_angle) / groove.aperture() - Real(1);
  return whole_at_most(bounces, most);
}

/// The opening of an asymmetric groove in the light of a direction.
/// @param groove must outlive the opening
/// @param towards_light direction towards the light, z ≥ 0
template <class Scalar, class Real>
VCAVITY_INLINE AsymmetricOpening<Real> lit_opening(const AsymmetricGroove<Scalar>& groove,
                                                   const Vec3<Real>& towards_light) {
  return AsymmetricOpening<Real>(groove, towards_light);
}

/// The ray of a direction that meets a given panel first, unfolded in the frame of the bisector.
/// @param groove must outlive the ray
/// @param e direction towards the light
/// @param first the panel met first
template <class Scalar, class Real>
VCAVITY_INLINE UnfoldedRay<Real> unfold(const AsymmetricGroove<Scalar>& groove, const Vec3<Real>& e,
                                        Panel first) {
  return UnfoldedRay<Real>(groove.bisected(), groove.to_bisector(e), first);
}

/// The direction in which light travels that leaves after the bounce at which a ray is.
/// @param groove the groove
/// @param ray unfolded in this groove
template <class Scalar, class Real>
Vec3<Real> exit_direction(const AsymmetricGroove<Scalar>& groove, const UnfoldedRay<Real>& ray) {
  return groove.from_bisector(ray.exit_direction());
}

/// First panel and number of bounces of the ray through a point of the opening.
///
/// Where the rays of a direction enter they are in the order of their distance from the apex: those that meet panel one
/// first at y below the others, those that bounce most nearest to them.
///
/// @param groove the groove
/// @param e direction towards the light, e.z ≥ 0
/// @param position where the ray crosses the opening, a fraction of its half width in [−1, 1]
template <class Real>
RayPath ray_path(const AsymmetricGroove<Real>& groove, const Vec3<Real>& e, const Real& position) {
  const AsymmetricOpening<Real> opening(groove, e);
  const Real from_one = (Real(1) + position) / Real(2);
  const Real from_two = (Real(1) - position) / Real(2);
  const Real share_one = opening.first_met(Panel::one);
  const Real share_two = opening.first_met(Panel::two);
  const Panel first = from_one < share_one ? Panel::one : Panel::two;
  // The fraction of the opening between the ray and the first one that meets this panel first.
  const Real inside = first == Panel::one ? Real(share_one - from_one) : Real(share_two - from_two);
  UnfoldedRay<Real> ray = unfold(groove, opening.direction(), first);
  Real reached = opening.first_met(first);
  while (ray.number() < groove.max_bounces()) {
    UnfoldedRay<Real> next = ray;
    next.advance();
    reached = opening.reached(next, reached);
    if (!(inside < reached)) break;
    ray = next;
  }
  return {first, ray.number()};
}

}  // namespace vcavity
