// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Unfolding: instead of reflecting a ray, reflect the groove. The ray is then a straight line.
///
/// Method. The images of the panels stand around the apex at the angles α/2 + (j − 1)α, j = 1, 2, …, and the
/// ray meets one after the other (Eqs. 14–16). In the frame of the image its direction is turned by α from
/// bounce to bounce. Turns are looked up in the table of the cavity and cost two products and a sum for a
/// component. Where the table ends, in narrow grooves, the direction is turned from its beginning to there,
/// and the table serves again: so no rounding adds up, however many bounces there are.

#include <cassert>
#include <cstdint>

#include "vcavity/conventions.hpp"
#include "vcavity/facet/bounce.hpp"
#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The panel that faces a direction; panel one for light along the groove.
/// @param e direction towards the light
template <Number Real>
Panel facing_panel(const Vec3<Real>& e) {
  return e.y < Real(0) ? Panel::two : Panel::one;
}

/// The same for a pack of directions, all with e.y ≥ 0; mirror the others.
template <class Real>
Panel facing_panel([[maybe_unused]] const Vec3<Real>& e) {
  assert(!any_of(e.y < scalar_t<Real>(0)));
  return Panel::one;
}

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
      : groove_(&groove),
        up_(e.z),
        across_(first == Panel::one ? e.y : Real(-e.y)),
        table_up_(up_),
        table_across_(across_),
        along_(e.x),
        panel_(first) {
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
  Real tangent_component() const {
    const auto& turn = groove_->tabulated(in_table_);
    return turn.cosine * table_up_ - turn.sine * table_across_;
  }

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
    in_table_ += multiple;
    if (in_table_ > Groove::most_multiples) start_table_again();
    const auto& turn = groove_->tabulated(in_table_);
    normal_ = turn.sine * table_up_ + turn.cosine * table_across_;
  }

  void start_table_again() {
    constexpr std::int64_t length = Groove::most_multiples + 1;
    before_table_ += in_table_ / length * length;
    in_table_ %= length;
    const auto turn = groove_->multiple(before_table_);
    table_up_ = turn.cosine * up_ - turn.sine * across_;
    table_across_ = turn.sine * up_ + turn.cosine * across_;
  }

  const Groove* groove_;
  Real up_, across_;               // of e before any turn; across from the first panel to the other
  std::int64_t before_table_ = 0;  // multiples turned before the table started again
  Real table_up_, table_across_;   // of e after these
  std::int64_t in_table_ = 0;
  Real normal_;  // after all turns
  Real along_;
  Panel panel_;
  int number_ = 1;
};

/// The value of a facet for the bounce at which a ray is.
/// @param facet facet reflectance
/// @param ray the ray at its present bounce
template <class Real, FacetReflectance<Real> Facet>
VCAVITY_INLINE value_t<Facet, Real> reflect(const Facet& facet, const UnfoldedRay<Real>& ray) {
  if constexpr (std::invocable<const Facet&, const Real&>) {
    return facet(ray.cosine());
  } else {
    return facet(ray.bounce());
  }
}

/// The ray of a direction that meets a given panel first, unfolded. Grooves of other shapes overload this.
/// @param groove must outlive the ray
/// @param e direction towards the light
/// @param first the panel met first
template <class Scalar, class Real>
UnfoldedRay<Real> unfold(const Cavity<Scalar>& groove, const Vec3<Real>& e, Panel first) {
  return UnfoldedRay<Real>(groove, e, first);
}
template <class Scalar, class Real>
UnfoldedRay<Real> unfold(const Cavity<Scalar>&&, const Vec3<Real>&, Panel) = delete;

/// The direction in which light travels that leaves after the bounce at which a ray is. Grooves of other
/// shapes overload this.
/// @param ray unfolded in this groove
template <class Scalar, class Real>
Vec3<Real> exit_direction(const Cavity<Scalar>&, const UnfoldedRay<Real>& ray) {
  return ray.exit_direction();
}

}  // namespace vcavity
