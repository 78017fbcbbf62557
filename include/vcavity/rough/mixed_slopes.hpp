// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Two distributions of grooves on one surface, side by side: a polish with a few deep scratches, say.

#include <utility>

#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/rough/slope_distribution.hpp"

namespace vcavity {

/// For more than two, mix a mixture.
template <SlopeDistribution First, SlopeDistribution Second>
class MixedSlopes {
 public:
  using value_type = scalar_t<First>;
  using Real = value_type;

  /// @param share of the mean area that has grooves of the first distribution, in [0, 1]
  /// @param first the one distribution
  /// @param second the other one
  /// @throws std::invalid_argument when it is out of range or not a number
  MixedSlopes(First first, Second second, const Real& share)
      : first_(std::move(first)), second_(std::move(second)), share_(share) {
    if (!(share >= Real(0) && share <= Real(1))) {
      throw_invalid_argument("the share of a distribution in a mixture must lie in [0, 1], not be ", share);
    }
  }

  /// D(m), per steradian.
  /// @param m unit vector, m.z ≥ 0
  Real density(const Vec3<Real>& m) const {
    return share_ * first_.density(m) + (Real(1) - share_) * second_.density(m);
  }

  /// A normal of the density D(m) cos θ_m.
  /// @param u two random numbers, uniform in [0, 1]: of the slope, and of the distribution and its azimuth
  /// @return unit vector, z ≥ 0
  Vec3<Real> sample(const Vec2<Real>& u) const {
    if (u.y < share_) return first_.sample({u.x, u.y / share_});
    if (!(share_ < Real(1))) return first_.sample(u);
    return second_.sample({u.x, at_most(Real((u.y - share_) / (Real(1) - share_)), Real(1))});
  }

  /// The two distributions.
  const First& first() const { return first_; }
  const Second& second() const { return second_; }

  /// The share of the mean area that has grooves of the first one.
  Real share() const { return share_; }

 private:
  First first_;
  Second second_;
  Real share_;
};

}  // namespace vcavity
