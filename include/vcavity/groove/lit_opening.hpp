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

#include <cassert>
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
    assert(Number<Real> || !any_of(e_.y < Scalar(0)));
    const Real other_normal = cavity.sin_half() * e_.z - cavity.cos_half() * magnitude(e_.y);
    const Real share = other_normal * inverse_width_;
    both_ = share > negligible_fraction<Scalar>();
    other_share_ = select(both_, share, Real(0));
  }

  /// The direction towards the light.
  const Vec3<Real>& direction() const { return e_; }

  /// How many panels there are that some rays meet first.
  int first_panels() const { return any_of(both_) ? 2 : 1; }

  /// A panel that some rays meet first.
  /// @param which of them, below `first_panels()`; 0 is the one that faces the light more, panel one if both do alike
  Panel first_panel(int which) const {
    bool faces_two = false;
    if constexpr (Number<Real>) faces_two = e_.y < Real(0);
    return faces_two == (which == 0) ? Panel::two : Panel::one;
  }

  /// f_1: the fraction of the opening whose rays meet a panel first.
  /// @param panel one of the first panels
  Real first_met(Panel panel) const {
    return panel == first_panel(0) ? Real(Real(1) - other_share_) : other_share_;
  }

  /// f_j, where j is the bounce at which the ray is, at least 2.
  /// @param ray the ray at its present bounce
  /// @param before f_{j−1}, which f_j never exceeds
  VCAVITY_INLINE Real reached(const UnfoldedRay<Real>& ray, const Real& before) const {
    Real share = all_of(both_) ? Real(0) : beyond_aperture(ray.number());
    if (any_of(both_)) share = select(both_, Real(ray.normal_component() * inverse_width_), share);
    return at_least(at_most(share, before), Scalar(0));
  }

 private:
  /// f_j beyond the aperture, before it is limited.
  VCAVITY_INLINE Real beyond_aperture(int j) const {
    const auto turn = cavity_.multiple(j - 1);
    const Real slope = turn.cosine * e_.z - turn.sine * magnitude(e_.y);
    const Scalar fan = cavity_.multiple(j).sine * cavity_.inverse_sin_half();
    return fan * (slope * inverse_e_z_);
  }

  const Cavity<Scalar>& cavity_;
  Vec3<Real> e_;
  Real inverse_e_z_;
  Real inverse_width_;  // of the opening as the light sees it, 1/(2 e_z sin(α/2))
  mask_t<Real> both_;   // set where light reaches both panels directly
  Real other_share_;  // fraction of the opening whose rays meet the panel first that does not face the light
};

}  // namespace vcavity
