// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The von Mises–Fisher distribution of directions, the normal distribution of the sphere (R. A. Fisher,
/// "Dispersion on a sphere", Proc. R. Soc. Lond. A 217, 1953).
///
/// The density around a mean direction μ is κ/(2π(1 − e^{−2κ})) · exp(−κ(1 − μ·ω)), written here with
/// 1 − μ·ω = |μ − ω|²/2 so that narrow distributions keep their digits in float.

#include <cmath>
#include <limits>

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
      throw_invalid_argument("the width of a lobe must lie in [", smallest_width(), ", 10] radians, not ",
                             width);
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
  /// @tparam Coordinate `Real`, or a value of many of them: as many pairs of directions at once
  template <class Coordinate>
  Coordinate density(const Vec3<Coordinate>& mean, const Vec3<Coordinate>& direction) const {
    using std::exp;
    const Coordinate x = direction.x - mean.x, y = direction.y - mean.y, z = direction.z - mean.z;
    const Coordinate versine = Coordinate(Real(0.5)) * (x * x + y * y + z * z);
    return Coordinate(kappa_ / (Real(2) * pi<Real>() * tail_)) * exp(Coordinate(-kappa_) * versine);
  }

  /// A direction of that density.
  /// @param mean unit vector
  /// @param u two random numbers, uniform in [0, 1]
  /// @tparam Coordinate as for `density`
  template <class Coordinate>
  Vec3<Coordinate> sample(const Vec3<Coordinate>& mean, const Vec2<Coordinate>& u) const {
    using std::cos;
    using std::log1p;
    using std::sin;
    using std::sqrt;
    // Where κ is large, u = 1 stands for the largest number below it: the logarithm is finite, and so is the
    // inverse of the density. Where κ is small, the ratio may exceed 2 by rounding.
    const Real most = Real(1) - std::numeric_limits<Real>::epsilon() / Real(2);
    const Coordinate drawn = at_most(Coordinate(Coordinate(tail_) * u.x), Coordinate(most));
    const Coordinate versine =
        at_most(Coordinate(-log1p(-drawn) * Coordinate(Real(1) / kappa_)), Coordinate(Real(2)));
    const Coordinate radius = sqrt(versine * (Coordinate(Real(2)) - versine));
    const Coordinate azimuth = Coordinate(Real(2) * pi<Real>()) * u.y;
    return around<Coordinate>(mean,
                              {radius * cos(azimuth), radius * sin(azimuth), Coordinate(Real(1)) - versine});
  }

 private:
  /// A vector given relative to a pole, in the basis of Duff et al., "Building an orthonormal basis,
  /// revisited", JCGT 6(1), 2017.
  template <class Coordinate>
  static Vec3<Coordinate> around(const Vec3<Coordinate>& pole, const Vec3<Coordinate>& v) {
    const Coordinate one(Real(1)), minus_one(Real(-1));
    const Coordinate sign = select(pole.z < Coordinate(Real(0)), minus_one, one);
    const Coordinate a = minus_one / (sign + pole.z);
    const Coordinate b = pole.x * pole.y * a;
    return {v.x * (one + sign * pole.x * pole.x * a) + v.y * b + v.z * pole.x,
            v.x * (sign * b) + v.y * (sign + pole.y * pole.y * a) + v.z * pole.y,
            v.z * pole.z - v.x * (sign * pole.x) - v.y * pole.y};
  }

  Real kappa_;
  Real tail_;  // 1 − e^{−2κ}
};

}  // namespace vcavity
