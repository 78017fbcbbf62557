// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The cavity: a groove between two plane mirrors of unit width, known by its aperture alone.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>

#include "vcavity/conventions.hpp"
#include "vcavity/facet/facet.hpp"
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

  /// The largest number of lobes of any direction.
  static constexpr std::size_t max_lobes = 4;

  /// The smallest aperture, 2e-9 rad: bounces, of which there are up to π/α, have numbers of type int.
  static Real smallest_aperture() { return Real(2e-9); }

  /// @param aperture the angle between the panels in [`smallest_aperture`, π]; π is a flat surface, and so is what
  ///          rounding (4 ε) has lifted above it
  /// @throws std::invalid_argument when the aperture lies outside that range or is not a number
  explicit Cavity(const Real& aperture) : aperture_(at_most(aperture, pi<Real>())) {
    const Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
    if (!(aperture >= smallest_aperture() && aperture <= pi<Real>() * (Real(1) + rounding))) {
      std::ostringstream message;
      message << "the aperture of a groove must lie in [" << smallest_aperture() << ", π] radians, not "
              << aperture;
      throw_invalid_argument(message.str());
    }
    using std::cos;
    using std::sin;
    sin_half_ = sin(aperture_ / Real(2));
    inverse_sin_half_ = Real(1) / sin_half_;
    const Real sin_quarter = sin(aperture_ / Real(4));
    versine_half_ = Real(2) * sin_quarter * sin_quarter;
    // The nearest float to π lies above π; the panels of a flat surface must not bend the other way.
    cos_half_ = cos(aperture_ / Real(2));
    if (cos_half_ < Real(0)) cos_half_ = Real(0);
    max_bounces_ = bounces_at(aperture_);
    fill_multiples();
  }

  /// The groove of given facets, for a renderer that makes one for every point it shades: no trigonometric
  /// function is evaluated, unless the aperture is less than 26° or asked for. Multiples of α/2 follow from
  /// the addition theorem; their error is that of the normal times their number, and less than one ε more for
  /// each (cavity_test.cpp).
  /// @param across,up components of the normal of a panel across the groove and along the mean normal, both ≥ 0
  ///          (the sign of the first does not matter); of any length within the range of squares
  /// @throws std::invalid_argument when the panels are vertical, closer than `smallest_aperture`, or a component
  ///          is not a number
  static Cavity from_normal(const Real& across, const Real& up) {
    using std::sqrt;
    const Real length = sqrt(across * across + up * up);
    return Cavity(magnitude(across) / length, up / length, FromNormal());
  }

  /// The same from the slope of the facets, the tangent of their angle to the mean surface.
  /// @param slope ≥ 0, and not larger than the square root of the largest number
  /// @throws std::invalid_argument as for `from_normal`
  static Cavity from_slope(const Real& slope) { return from_normal(slope, Real(1)); }

  /// The angle α between the panels.
  Real aperture() const {
    using std::atan2;
    return aperture_ > Real(0) ? aperture_ : Real(Real(2) * atan2(sin_half_, cos_half_));
  }

  /// sin(α/2), half the width of the opening.
  Real sin_half() const { return sin_half_; }

  /// cos(α/2), the depth of the groove.
  Real cos_half() const { return cos_half_; }

  /// 1/sin(α/2)
  Real inverse_sin_half() const { return inverse_sin_half_; }

  /// The area of the panels per area of the opening; under diffuse light the mean number of bounces.
  Real developed_area() const { return inverse_sin_half_; }

  /// The least e.z of a direction, so small that it changes no result, and so large that inverses are finite.
  /// Smaller ones count as this one; so light along the groove, e.y = e.z = 0, comes from straight above as far
  /// as the plane across the groove is concerned (θ' = 0).
  Real least_up() const { return smallest_divisor<Real>() * inverse_sin_half_; }

  /// 1 − cos(α/2), with all its digits when α is small
  Real versine_half() const { return versine_half_; }

  /// Cosine and sine of an angle.
  struct Rotation {
    Real cosine;
    Real sine;
  };

  /// The largest number of multiples of α/2 whose cosines and sines are kept: all that are ever needed for
  /// apertures of 26° and more.
  static constexpr int most_multiples = 15;

  /// The number of those that are kept here: no more than the bounces need.
  int tabulated_multiples() const { return tabulated_; }

  /// Cosine and sine of kα/2, for k in [0, tabulated_multiples()].
  const Rotation& tabulated(std::int64_t k) const { return multiples_[static_cast<std::size_t>(k)]; }

  /// Cosine and sine of kα/2, for any k ≥ 0.
  VCAVITY_INLINE Rotation multiple(std::int64_t k) const {
    if (k <= tabulated_) return tabulated(k);
    using std::cos;
    using std::sin;
    const Real angle = Real(k) * (aperture() / Real(2));
    return {cos(angle), sin(angle)};
  }

  /// The normal of a panel, pointing into the groove (Eq. 5).
  Vec3<Real> normal(Panel panel) const {
    return {Real(0), panel == Panel::one ? cos_half_ : Real(-cos_half_), sin_half_};
  }

  /// The unit vector along a panel, from the apex to the rim.
  Vec3<Real> tangent(Panel panel) const {
    return {Real(0), panel == Panel::one ? Real(-sin_half_) : sin_half_, cos_half_};
  }

  /// The largest number of bounces of any ray, ⌈π/α⌉. An aperture within rounding (4 ε) of π/k counts as π/k:
  /// moving the aperture by so little moves the weights as much as leaving out the rays that would bounce
  /// once more. At most one less than the largest int, so that the image behind the last bounce has a number.
  int max_bounces() const { return max_bounces_; }

 private:
  struct FromNormal {};

  Cavity(const Real& cos_half, const Real& sin_half, FromNormal)
      : aperture_(0), sin_half_(sin_half), cos_half_(cos_half) {
    if (!(sin_half > smallest_aperture() / Real(2) && cos_half >= Real(0))) {
      std::ostringstream message;
      message << "the facets of a groove must be less steep than vertical, not of a normal (" << cos_half
              << " across, " << sin_half << " up)";
      throw_invalid_argument(message.str());
    }
    inverse_sin_half_ = Real(1) / sin_half_;
    versine_half_ = sin_half_ * sin_half_ / (Real(1) + cos_half_);
    if (!add_multiples()) {
      // Too narrow for the table.
      aperture_ = aperture();
      max_bounces_ = bounces_at(aperture_);
      fill_multiples();
    }
  }

  static int bounces_at(const Real& aperture) {
    using std::ceil;
    const Real count =
        ceil(pi<Real>() / aperture * (Real(1) - Real(4) * std::numeric_limits<Real>::epsilon()));
    constexpr int most = std::numeric_limits<int>::max() - 1;
    if (!(count < Real(most))) return most;
    return count < Real(1) ? 1 : static_cast<int>(count);
  }

  /// The ray behind the last bounce is at image max_bounces + 1, at an odd multiple.
  static int needed_multiples(int bounces) {
    return bounces < most_multiples / 2 ? 2 * bounces + 1 : most_multiples;
  }

  void begin_multiples() {
    multiples_[0] = {Real(1), Real(0)};
    multiples_[1] = {cos_half_, sin_half_};
  }

  void fill_multiples() {
    using std::cos;
    using std::sin;
    begin_multiples();
    tabulated_ = needed_multiples(max_bounces_);
    for (int k = 2; k <= tabulated_; ++k) {
      const Real angle = Real(k) * (aperture_ / Real(2));
      multiples_[static_cast<std::size_t>(k)] = {cos(angle), sin(angle)};
    }
  }

  /// The same by the addition theorem, and the largest number of bounces, the first m with mα ≥ π.
  /// @return whether the table has room for all multiples that are needed
  bool add_multiples() {
    begin_multiples();
    const auto add = [this](std::size_t i, std::size_t j) {
      const Rotation &a = multiples_[i], &b = multiples_[j];
      multiples_[i + j] = {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
    };
    constexpr int most = most_multiples / 2;
    for (max_bounces_ = 1; max_bounces_ <= most; ++max_bounces_) {
      const auto m = static_cast<std::size_t>(max_bounces_);
      add(m, m);
      add(m, m + 1);
      // An aperture within rounding of π/m counts as π/m, here as in `bounces_at`.
      const Real rounding = Real(4 * (3 + max_bounces_)) * std::numeric_limits<Real>::epsilon();
      const Rotation& turn = multiples_[2 * m];
      if (turn.sine < Real(0) || (turn.sine <= rounding && turn.cosine < Real(0))) break;
    }
    tabulated_ = 2 * max_bounces_ + 1;
    return max_bounces_ <= most;
  }

  Real aperture_;  // 0 where it has not been asked for
  Real sin_half_;
  Real cos_half_;
  Real inverse_sin_half_;
  Real versine_half_;
  int max_bounces_;
  int tabulated_;
  std::array<Rotation, most_multiples + 1> multiples_{};  // 0 behind those that are needed
};

}  // namespace vcavity
