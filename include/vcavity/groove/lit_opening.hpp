// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The opening of a groove as the light of a direction finds it: which fraction of its rays meets which panel
/// first, and bounces how often.
///
/// Method. Let f_j be the fraction of the opening whose rays meet a given panel first and bounce at least j
/// times, and t = |e_y|/e_z = |tan θ'|. For directions within the aperture, |θ'| < α/2, light reaches both
/// panels directly and
///
///     f_j = clamp(c_j, 0, c_1) / (2 e_z sin(α/2)),   c_j = e · N^(j);
///
/// beyond, only the panel that faces the light is met first and
///
///     f_j = clamp( sin(jα/2)/sin(α/2) · (cos((j−1)α/2) − t sin((j−1)α/2)), 0, 1 ),
///
/// a product that keeps its digits as e_z → 0.

#include <cmath>
#include <limits>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A fraction of the opening below this is the rounding error of a direction at a change of the bounce count.
template <class Real>
Real negligible_fraction() {
  return Real(4) * std::numeric_limits<Real>::epsilon();
}

/// The opening of a symmetric groove in the light of a direction.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once, all with e.y ≥ 0
template <class Real>
class LitOpening {
 public:
  using Scalar = scalar_t<Real>;

  /// @param cavity must outlive the opening
  /// @param towards_light direction towards the light; raised to `least_up`
  VCAVITY_INLINE LitOpening(const Cavity<Scalar>& cavity, const Vec3<Real>& towards_light)
      : cavity_(cavity),
        e_{towards_light.x, towards_light.y, at_least(towards_light.z, cavity.least_up())},
        inverse_e_z_(Real(1) / e_.z),
        inverse_width_((Scalar(0.5) * cavity.inverse_sin_half()) * inverse_e_z_) {
    const Real other_normal = cavity.sin_half() * e_.z - cavity.cos_half() * magnitude(e_.y);
    const Real share = other_normal * inverse_width_;
    both_ = share > negligible_fraction<Scalar>();
    other_share_ = select(both_, share, Real(0));
    any_both_ = any_of(both_);
    all_both_ = all_of(both_);
  }

  /// The direction towards the light.
  const Vec3<Real>& direction() const { return e_; }

  /// How many panels there are that some rays meet first.
  int first_panels() const { return any_both_ ? 2 : 1; }

  /// A panel that some rays meet first.
  /// @param which of them, below `first_panels()`; 0 is the one that faces the light
  Panel first_panel(int which) const {
    const Panel facing = facing_panel(e_);
    return which == 0 ? facing : opposite(facing);
  }

  /// The series f_j of one first panel.
  class ReachedFractions {
   public:
    /// f_1: the fraction of the opening whose rays meet this panel first.
    Real first() const { return first_; }

    /// f_j, where j is the bounce at which the ray is, at least 2.
    /// @param before f_{j−1}, which f_j never exceeds
    /// @param ray the ray at its present bounce
    VCAVITY_INLINE Real at(const UnfoldedRay<Real>& ray, const Real& before) const {
      Real on_one(0);
      if (!opening_.all_both_) {
        const Cavity<Scalar>& cavity = opening_.cavity_;
        const auto turn = cavity.multiple(ray.number() - 1);
        const Real slope = turn.cosine * opening_.e_.z - turn.sine * magnitude(opening_.e_.y);
        const Scalar fan = cavity.multiple(ray.number()).sine * cavity.inverse_sin_half();
        on_one = at_least(at_most(Real(fan * (slope * opening_.inverse_e_z_)), before), Scalar(0));
        if (!opening_.any_both_) return on_one;
      }
      const Real share = ray.normal_component() * opening_.inverse_width_;
      return select(opening_.both_, at_least(at_most(share, before), Scalar(0)), on_one);
    }

    /// Whether all rays that meet this panel first surely bounce at an image too, at the cost of a comparison:
    /// c_j > c_1, by more than rounding, which is up to 8 ε in each (docs/accuracy.md).
    bool all_reach(const UnfoldedRay<Real>& ray) const {
      return all_of(ray.normal_component() > surely_reached_);
    }

    /// How often all of these rays surely bounce: until the angle has passed a right one and is as far beyond
    /// it as it began before it.
    /// @param first the ray at its first bounce
    /// @param most no more than these matter
    int bounces_of_all(const UnfoldedRay<Real>& first, int most) const {
      const Real first_angle = std::atan2(first.normal_component(), first.tangent_component());
      const Real bounces = (pi<Real>() - Real(2) * first_angle) / opening_.cavity_.aperture() - Real(1);
      return whole_at_most(bounces, most);
    }

   private:
    friend class LitOpening;

    ReachedFractions(const LitOpening& opening, const UnfoldedRay<Real>& first)
        : opening_(opening),
          first_(first.panel() == opening.first_panel(0) ? Real(Real(1) - opening.other_share_)
                                                         : opening.other_share_),
          surely_reached_(first.normal_component() +
                          Real(Scalar(16) * std::numeric_limits<Scalar>::epsilon())) {}

    const LitOpening& opening_;
    Real first_;
    Real surely_reached_;  // a normal component above this
  };

  /// The series of the panel that a ray meets first.
  /// @param first the ray at its first bounce
  ReachedFractions reached(const UnfoldedRay<Real>& first) const { return {*this, first}; }

 private:
  const Cavity<Scalar>& cavity_;
  Vec3<Real> e_;
  Real inverse_e_z_;
  Real inverse_width_;  // of the opening as the light sees it, 1/(2 e_z sin(α/2))
  mask_t<Real> both_;   // set where light reaches both panels directly
  Real other_share_;  // fraction of the opening whose rays meet the panel first that does not face the light
  bool any_both_;
  bool all_both_;
};

/// The opening of a groove in the light of a direction. Grooves of other shapes overload this.
/// @param groove must outlive the opening
/// @param towards_light direction towards the light, z ≥ 0
template <class Scalar, class Real>
VCAVITY_INLINE LitOpening<Real> lit_opening(const Cavity<Scalar>& groove, const Vec3<Real>& towards_light) {
  return LitOpening<Real>(groove, towards_light);
}

}  // namespace vcavity
