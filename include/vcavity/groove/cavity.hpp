// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The cavity: a groove between two plane mirrors of unit width, known by its aperture alone.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "vcavity/conventions.hpp"
#include "vcavity/groove/multiples.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A symmetric V-shaped groove, infinitely long. The width of the panels plays no part in geometrical optics.
template <class Real>
class Cavity {
 public:
  using value_type = Real;
  using Rotation = vcavity::Rotation<Real>;

  /// The largest number of lobes of any direction.
  static constexpr std::size_t max_lobes = 4;

  /// The smallest aperture, 2e-9 rad: bounces, of which there are up to π/α, have numbers of type int.
  static Real smallest_aperture() { return Real(2e-9); }

  /// @param aperture the angle between the panels in [`smallest_aperture`, π]; π is a flat surface, and so is what
  ///          rounding (4 ε) has lifted above it
  /// @throws std::invalid_argument when the aperture lies outside that range or is not a number
  explicit Cavity(const Real& aperture) : Cavity(checked(aperture), FromAperture()) {}

  /// The same groove for a renderer that makes one for every point it shades, in less time: multiples of α/2 follow
  /// from the addition theorem, each wrong by less than one ε more than the one before (cavity_test.cpp).
  /// @param aperture as above, and with the same exceptions
  static Cavity by_addition(const Real& aperture) { return Cavity(checked(aperture), ByAddition()); }

  /// The groove of given facets, in the same way: no trigonometric function is evaluated, unless the aperture is less
  /// than 26° or asked for. The error of a multiple is also that of the normal times its number.
  /// @param across,up components of the normal of a panel across the groove and along the mean normal, both ≥ 0
  ///          (the sign of the first does not matter); of any length within the range of squares
  /// @throws std::invalid_argument when the panels are vertical, closer than `smallest_aperture`, or a component
  ///          is not a number
  static Cavity from_normal(const Real& across, const Real& up) {
    using std::sqrt;
    const Real length = sqrt(across * across + up * up);
    return Cavity(checked(Rotation{magnitude(across) / length, up / length}));
  }

  /// The same from the slope of the facets, the tangent of their angle to the mean surface.
  /// @param slope ≥ 0, and not larger than the square root of the largest number
  /// @throws std::invalid_argument as for `from_normal`
  static Cavity from_slope(const Real& slope) { return from_normal(slope, Real(1)); }

  /// The angle α between the panels.
  Real aperture() const { return multiples_.aperture(); }

  /// sin(α/2), half the width of the opening.
  Real sin_half() const { return multiples_[1].sine; }

  /// cos(α/2), the depth of the groove.
  Real cos_half() const { return multiples_[1].cosine; }

  /// 1/sin(α/2)
  Real inverse_sin_half() const { return inverse_sin_half_; }

  /// The area of the panels per area of the opening; under diffuse light the mean number of bounces.
  Real developed_area() const { return inverse_sin_half_; }

  /// 1 − cos(α/2), with all its digits when α is small
  Real versine_half() const { return versine_half_; }

  /// The least e.z of a direction, so small that it changes no result, and so large that inverses are finite.
  /// Smaller ones count as this one; so light along the groove, e.y = e.z = 0, comes from straight above as far
  /// as the plane across the groove is concerned (θ' = 0).
  Real least_up() const { return smallest_divisor<Real>() * inverse_sin_half_; }

  /// Cosine and sine of kα/2, for any k ≥ 0.
  VCAVITY_INLINE Rotation multiple(std::int64_t k) const { return multiples_.at(k); }

  /// Those of the multiples that the bounces need.
  const HalfApertureMultiples<Real>& multiples() const { return multiples_; }

  /// The normal of a panel, pointing into the groove (Eq. 5).
  Vec3<Real> normal(Panel panel) const {
    return {Real(0), panel == Panel::one ? cos_half() : Real(-cos_half()), sin_half()};
  }

  /// The unit vector along a panel, from the apex to the rim.
  Vec3<Real> tangent(Panel panel) const {
    return {Real(0), panel == Panel::one ? Real(-sin_half()) : sin_half(), cos_half()};
  }

  /// The largest number of bounces of any ray, ⌈π/α⌉. An aperture within rounding (4 ε) of π/k counts as π/k:
  /// moving the aperture by so little moves the weights as much as leaving out the rays that would bounce
  /// once more. At most one less than the largest int, so that the image behind the last bounce has a number.
  int max_bounces() const { return max_bounces_; }

 private:
  struct FromAperture {};
  struct ByAddition {};

  Cavity(const Real& aperture, FromAperture)
      : max_bounces_(bounces_at(aperture)), multiples_(aperture, half_rotation(aperture), max_bounces_) {
    inverse_sin_half_ = Real(1) / sin_half();
    const Real sin_quarter = half_rotation(Real(aperture / Real(2))).sine;
    versine_half_ = Real(2) * sin_quarter * sin_quarter;
  }

  Cavity(const Real& aperture, ByAddition)
      : max_bounces_(bounces_at(aperture)),
        multiples_(
            HalfApertureMultiples<Real>::by_addition(aperture, half_rotation(aperture), max_bounces_)) {
    inverse_sin_half_ = Real(1) / sin_half();
    versine_half_ = sin_half() * sin_half() / (Real(1) + cos_half());
  }

  explicit Cavity(const Rotation& half)
      : inverse_sin_half_(Real(1) / half.sine),
        versine_half_(half.sine * half.sine / (Real(1) + half.cosine)),
        multiples_(half) {
    max_bounces_ = multiples_.max_bounces();
    if (max_bounces_ > 0) return;
    // Too narrow for sums of angles.
    const Real aperture = multiples_.aperture();
    max_bounces_ = bounces_at(aperture);
    multiples_ = {aperture, half, max_bounces_};
  }

  static Real checked(const Real& aperture) {
    const Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
    if (!(aperture >= smallest_aperture() && aperture <= pi<Real>() * (Real(1) + rounding))) {
      throw_invalid_argument("the aperture of a groove must lie in [", smallest_aperture(),
                             ", π] radians, not ", aperture);
    }
    return at_most(aperture, pi<Real>());
  }

  static const Rotation& checked(const Rotation& half) {
    if (!(half.sine > smallest_aperture() / Real(2) && half.cosine >= Real(0))) {
      throw_invalid_argument("the facets of a groove must be less steep than vertical, not of a normal (",
                             half.cosine, " across, ", half.sine, " up)");
    }
    return half;
  }

  static int bounces_at(const Real& aperture) {
    using std::ceil;
    const Real count =
        ceil(pi<Real>() / aperture * (Real(1) - Real(4) * std::numeric_limits<Real>::epsilon()));
    constexpr int most = std::numeric_limits<int>::max() - 1;
    if (!(count < Real(most))) return most;
    return count < Real(1) ? 1 : static_cast<int>(count);
  }

  Real inverse_sin_half_;
  Real versine_half_;
  int max_bounces_;
  HalfApertureMultiples<Real> multiples_;
};

}  // namespace vcavity
