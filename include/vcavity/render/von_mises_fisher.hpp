// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The von Mises–Fisher distribution of directions, the normal distribution of the sphere (R. A. Fisher,
/// "Dispersion on a sphere", Proc. R. Soc. Lond. A 217, 1953).
///
/// The density around a mean direction μ is κ/(2π(1 − e^{−2κ})) · exp(−κ(1 − μ·ω)), written here with
/// 1 − μ·ω = |μ − ω|²/2 so that narrow distributions keep their digits in float.

#include <cmath>
#include <limits>
#include <sstream>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"

namespace vcavity {

/// Directions spread around a mean direction.
template <class Real>
class VonMisesFisher {
 public:
  /// @param width root-mean-square deviation along each of the two transverse axes while that is small, in
  ///        radians; κ = 1/width². In [`smallest_width`, 10]; wider ones are uniform to a percent.
  /// @throws std::invalid_argument when the width is out of range
  explicit VonMisesFisher(const Real& width) {
    using std::expm1;
    if (!(width >= smallest_width() && width <= Real(10))) {
      std::ostringstream message;
      message << "the width of a lobe must lie in [" << smallest_width() << ", 10] radians, not " << width;
      throw_invalid_argument(message.str());
    }
    kappa_ = Real(1) / (width * width);
    tail_ = -expm1(Real(-2) * kappa_);
  }

  /// The smallest width: in a narrower lobe the rounding of a unit vector would move it to where the density is
  /// next to nothing. 4e-6 for float, 7e-15 for double.
  static Real smallest_width() { return Real(32) * std::numeric_limits<Real>::epsilon(); }

  /// κ, the concentration.
  Real concentration() const { return kappa_; }

  /// Probability density per steradian.
  /// @param mean unit vector
  /// @param direction unit vector
  Real density(const Vec3<Real>& mean, const Vec3<Real>& direction) const {
    using std::exp;
    const Vec3<Real> d = direction - mean;
    const Real versine = (d.x * d.x + d.y * d.y + d.z * d.z) / Real(2);
    return kappa_ / (Real(2) * pi<Real>() * tail_) * exp(-kappa_ * versine);
  }

  /// A direction of that density.
  /// @param mean unit vector
  /// @param u two random numbers, uniform in [0, 1]
  Vec3<Real> sample(const Vec3<Real>& mean, const Vec2<Real>& u) const {
    using std::cos;
    using std::log1p;
    using std::sin;
    using std::sqrt;
    // Where κ is large, u = 1 stands for the largest number below it: the logarithm is finite, and so is the
    // inverse of the density. Where κ is small, the ratio may exceed 2 by rounding.
    const Real most = Real(1) - std::numeric_limits<Real>::epsilon() / Real(2);
    Real versine = -log1p(-at_most(Real(u.x * tail_), most)) / kappa_;
    if (!(versine < Real(2))) versine = Real(2);
    const Real radius = sqrt(versine * (Real(2) - versine));
    const Real azimuth = Real(2) * pi<Real>() * u.y;
    return around(mean, {radius * cos(azimuth), radius * sin(azimuth), Real(1) - versine});
  }

 private:
  /// A vector given relative to a pole, in the basis of Duff et al., "Building an orthonormal basis,
  /// revisited", JCGT 6(1), 2017.
  static Vec3<Real> around(const Vec3<Real>& pole, const Vec3<Real>& v) {
    const Real sign = pole.z < Real(0) ? Real(-1) : Real(1);
    const Real a = Real(-1) / (sign + pole.z);
    const Real b = pole.x * pole.y * a;
    const Vec3<Real> first{Real(1) + sign * pole.x * pole.x * a, sign * b, -sign * pole.x};
    const Vec3<Real> second{b, sign + pole.y * pole.y * a, -pole.y};
    return v.x * first + v.y * second + v.z * pole;
  }

  Real kappa_;
  Real tail_;  // 1 − e^{−2κ}
};

}  // namespace vcavity
