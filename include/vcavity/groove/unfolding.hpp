// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Unfolding: instead of reflecting a ray, reflect the groove. The ray is then a straight line.
///
/// Method. The images of the panels stand around the apex at the angles α/2 + (j − 1)α, j = 1, 2, …, and the
/// ray meets one after the other (Eqs. 14–16). In the frame of the image its direction is turned by α from
/// bounce to bounce, which takes two products and a sum for a component (multiples.hpp).

#include <cstdint>

#include "vcavity/conventions.hpp"
#include "vcavity/facet/bounce.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/multiples.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A ray in the unfolded groove: a cursor over its bounces. No trigonometric function is evaluated on the way.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
class UnfoldedRay {
 public:
  using Groove = Cavity<scalar_t<Real>>;

  /// The ray at its first bounce.
  /// @param groove symmetric groove; must outlive the ray
  /// @param e direction towards the light
  /// @param first the panel met first
  UnfoldedRay(const Groove& groove, const Vec3<Real>& e, Panel first)
      : groove_(&groove), turned_(e.z, first == Panel::one ? e.y : Real(-e.y)), along_(e.x), panel_(first) {
    turn(1);
  }
  UnfoldedRay(const Groove&&, const Vec3<Real>&, Panel) = delete;

  /// Number j of the bounce, 1 for the first.
  int number() const { return number_; }

  /// The real panel on which bounce j takes place.
  Panel panel() const { return panel_; }

  /// The panel of the first bounce.
  Panel first_panel() const { return number_ % 2 == 1 ? panel_ : opposite(panel_); }

  /// e · N^(j), before any clamping of its rounding error.
  Real normal_component() const { return normal_; }

  /// The component of e in the image, across the groove and away from the apex.
  Real tangent_component() const { return turned_.up(groove_->multiples()); }

  /// Cosine of the angle of incidence, c_j = e · N^(j), not negative.
  Real cosine() const { return at_least(normal_component(), scalar_t<Real>(0)); }

  /// All that a facet may want to know of this bounce.
  Bounce<Real> bounce() const { return {cosine(), tangent_component(), along_, panel_, number_}; }

  /// Steps to the next bounce, or to the image behind the last one, of number `max_bounces() + 1`, but no
  /// further: one more has the cosine 0.
  void advance() {
    turn(2);
    panel_ = opposite(panel_);
    ++number_;
  }

  /// Steps over several bounces at once, no further than that either.
  /// @param bounces ≥ 0
  void advance(int bounces) {
    turn(std::int64_t{2} * bounces);
    if (bounces % 2 != 0) panel_ = opposite(panel_);
    number_ += bounces;
  }

  /// The direction in which the light travels after this bounce, in the frame of the groove: the normal
  /// component is reversed, the others stay.
  Vec3<Real> exit_direction() const {
    const Real tangent = tangent_component();
    const Real across = groove_->cos_half() * normal_ + groove_->sin_half() * tangent;
    return {-along_, panel_ == Panel::one ? across : Real(-across),
            groove_->sin_half() * normal_ - groove_->cos_half() * tangent};
  }

 private:
  /// Turns the direction by a multiple of α/2, from the tangent towards the normal.
  VCAVITY_INLINE void turn(std::int64_t multiple) {
    turned_.turn(groove_->multiples(), multiple);
    normal_ = turned_.across(groove_->multiples());
  }

  const Groove* groove_;
  TurnedDirection<Real> turned_;  // e in the image
  Real normal_;
  Real along_;
  Panel panel_;
  int number_ = 1;
};

}  // namespace vcavity
