// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Brushed metal: grooves that run along x, more or less, with slopes of any isotropic distribution.
///
/// Azimuth and slope are independent: the azimuth of the grooves about x has an axial von Mises distribution.
///
/// When not to use it: for grooves that are all parallel, or almost (a concentration above 1e6), the BRDF is no
/// function but a fan of light; take `GrooveBsdf` or `SpreadGrooveBsdf` for these.

#include <cmath>
#include <utility>

#include "vcavity/rough/axial_von_mises.hpp"
#include "vcavity/rough/elliptic_slopes.hpp"

namespace vcavity {

/// @tparam Slopes an isotropic distribution
/// @tparam AzimuthReal number type of the azimuth's distribution, which takes no arrays of concentrations
template <SlopeDistribution Slopes, class AzimuthReal = scalar_t<Slopes>>
class BrushedSlopes {
 public:
  using value_type = scalar_t<Slopes>;
  using Real = value_type;

  /// Grooves with the slopes of an isotropic distribution.
  /// @param concentration κ of the azimuth of the grooves about x, in [0, 1e6]; 0 is isotropic
  /// @param slopes distribution of the slopes, isotropic
  /// @throws std::invalid_argument when it is out of range or not a number
  BrushedSlopes(Slopes slopes, const Real& concentration)
      : slopes_(std::move(slopes)), azimuths_(concentration) {}

  /// The same with a distribution of azimuths that exists already.
  /// @param slopes distribution of the slopes, isotropic
  /// @param azimuths of the grooves about x
  BrushedSlopes(Slopes slopes, const AxialVonMises<AzimuthReal>& azimuths)
      : slopes_(std::move(slopes)), azimuths_(azimuths) {}

  /// D(m), per steradian.
  /// @param m unit vector, m.z ≥ 0; of m = z, where there is no azimuth, the mean
  Real density(const Vec3<Real>& m) const {
    const Real x2 = m.x * m.x;
    const Real across2 = x2 + m.y * m.y;
    const auto has_azimuth = across2 > Real(0);
    const Real sine2 = x2 / select(has_azimuth, across2, Real(1));
    return slopes_.density(m) * select(has_azimuth, azimuths_.relative_density(sine2), Real(1));
  }

  /// A normal of the density D(m) cos θ_m.
  /// @param u two random numbers, uniform in [0, 1]: of the slope and of the azimuth
  /// @return unit vector, z ≥ 0
  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Vec3<Real> m = slopes_.sample({u.x, Real(0)});
    const Real across = sqrt(m.x * m.x + m.y * m.y);
    const Real angle = azimuths_.quantile(u.y);
    return {across * sin(angle), across * cos(angle), m.z};
  }

  /// The distribution of the slopes.
  const Slopes& slopes() const { return slopes_; }

  /// The concentration κ of the azimuths.
  AzimuthReal concentration() const { return azimuths_.concentration(); }

 private:
  Slopes slopes_;
  AxialVonMises<AzimuthReal> azimuths_;
};

}  // namespace vcavity
