// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Grooves of two plane panels, of whatever shape: what they tell the loop over their lobes.

#include <concepts>
#include <cstddef>

#include "vcavity/conventions.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/lit_opening.hpp"
#include "vcavity/groove/narrow_groove.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

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

/// The opening of a groove in the light of a direction. Grooves of other shapes overload this.
/// @param groove must outlive the opening
/// @param towards_light direction towards the light, z ≥ 0
template <class Scalar, class Real>
VCAVITY_INLINE LitOpening<Real> lit_opening(const Cavity<Scalar>& groove, const Vec3<Real>& towards_light) {
  return LitOpening<Real>(groove, towards_light);
}

/// The direction in which light travels that leaves after the bounce at which a ray is. Grooves of other
/// shapes overload this.
/// @param ray unfolded in this groove
template <class Scalar, class Real>
Vec3<Real> exit_direction(const Cavity<Scalar>&, const UnfoldedRay<Real>& ray) {
  return ray.exit_direction();
}

/// A groove of two plane panels that can be unfolded. It is made of numbers of type `value_type`, has at most
/// `max_lobes` lobes for any direction and `max_bounces()` bounces for any ray, and these functions, found by
/// argument-dependent look-up, with `Cavity` as the pattern:
///
///  - `unfold(groove, e, first)`, the ray in the fan of the images, in the frame of the bisector of the panels;
///  - `lit_opening(groove, e)`, the first panels, and for each the fractions of the opening whose rays reach a
///    bounce; its members are those of `LitOpening`;
///  - `exit_direction(groove, ray)`, back in the frame of the groove;
///  - `shared_bounces(groove, ray)`, until where all light bounces together, with members as in `SharedBounces`; and, for
///    numbers, `count_shared_bounces(groove, first, normal, tangent, most)`, how often it does.
/// @tparam Real number type of a direction, or a `Pack` of them
template <class Groove, class Real>
concept UnfoldableGroove = requires(const Groove& groove, const Vec3<Real>& e, const UnfoldedRay<Real>& ray) {
  typename Groove::value_type;
  { Groove::max_lobes } -> std::convertible_to<std::size_t>;
  { groove.aperture() } -> std::convertible_to<scalar_t<Groove>>;
  { groove.max_bounces() } -> std::same_as<int>;
  { unfold(groove, e, Panel::one) } -> std::same_as<UnfoldedRay<Real>>;
  { exit_direction(groove, ray) } -> std::same_as<Vec3<Real>>;
  { lit_opening(groove, e).direction() } -> std::convertible_to<Vec3<Real>>;
  { lit_opening(groove, e).first_panels() } -> std::same_as<int>;
  { lit_opening(groove, e).first_panel(0) } -> std::same_as<Panel>;
  { lit_opening(groove, e).first_met(Panel::one) } -> std::convertible_to<Real>;
  { lit_opening(groove, e).reached(ray, e.z) } -> std::same_as<Real>;
  { shared_bounces(groove, ray).include(ray) } -> std::same_as<bool>;
  requires !std::floating_point<Real> || requires(const Real& component) {
    { count_shared_bounces(groove, Panel::one, component, component, 1) } -> std::same_as<int>;
  };
};

}  // namespace vcavity
