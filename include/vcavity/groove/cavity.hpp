// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The cavity: a groove between two plane mirrors of unit width, known by its aperture alone.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "vcavity/conventions.hpp"
#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/inline.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A symmetric V-shaped groove, infinitely long. The width of the panels plays no part in geometrical optics.
template <class Real>
class Cavity {
 public:
  using value_type = Real;

  /// The largest number of lobes of any direction.
  static constexpr std::size_t max_lobes = 4;

  /// @param aperture the angle between the panels in (0, π]; π is a flat surface, and so is what rounding (4
  /// ε) has lifted above it
  /// @throws std::invalid_argument when the aperture lies outside that range or is not a number
  explicit Cavity(const Real& aperture) : aperture_(at_most(aperture, pi<Real>())) {
    const Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
    if (!(aperture > Real(0) && aperture <= pi<Real>() * (Real(1) + rounding))) {
      std::ostringstream message;
      message << "the aperture of a groove must lie in (0, π] radians, not " << aperture;
      throw std::invalid_argument(message.str());
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

  /// The angle α between the panels.
  const Real& aperture() const { return aperture_; }

  /// sin(α/2), half the width of the opening.
  const Real& sin_half() const { return sin_half_; }

  /// cos(α/2), the depth of the groove.
  const Real& cos_half() const { return cos_half_; }

  /// 1/sin(α/2)
  const Real& inverse_sin_half() const { return inverse_sin_half_; }

  /// 1 − cos(α/2), with all its digits when α is small
  const Real& versine_half() const { return versine_half_; }

  /// Cosine and sine of an angle.
  struct Rotation {
    Real cosine;
    Real sine;
  };

  /// The number of multiples of α/2 whose cosines and sines are kept: enough for apertures of 24° and more.
  static constexpr int tabulated_multiples = 15;

  /// Cosine and sine of kα/2, for k in [0, tabulated_multiples].
  const Rotation& tabulated(std::int64_t k) const { return multiples_[static_cast<std::size_t>(k)]; }

  /// Cosine and sine of kα/2, for any k ≥ 0.
  VCAVITY_INLINE Rotation multiple(std::int64_t k) const {
    if (k <= tabulated_multiples) return tabulated(k);
    using std::cos;
    using std::sin;
    const Real angle = Real(k) * (aperture_ / Real(2));
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
  static int bounces_at(const Real& aperture) {
    using std::ceil;
    const Real count =
        ceil(pi<Real>() / aperture * (Real(1) - Real(4) * std::numeric_limits<Real>::epsilon()));
    constexpr int most = std::numeric_limits<int>::max() - 1;
    if (!(count < Real(most))) return most;
    return count < Real(1) ? 1 : static_cast<int>(count);
  }

  void fill_multiples() {
    using std::cos;
    using std::sin;
    for (int k = 0; k <= tabulated_multiples; ++k) {
      const Real angle = Real(k) * (aperture_ / Real(2));
      multiples_[static_cast<std::size_t>(k)] = {cos(angle), sin(angle)};
    }
    multiples_[1].cosine = cos_half_;
  }

  Real aperture_;
  Real sin_half_;
  Real cos_half_;
  Real inverse_sin_half_;
  Real versine_half_;
  int max_bounces_;
  std::array<Rotation, tabulated_multiples + 1> multiples_;
};

}  // namespace vcavity
