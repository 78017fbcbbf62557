// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Elliptic distributions of slopes, GGX and Beckmann: those of renderers, isotropic or with a roughness along
/// either axis.
///
/// Both are functions of one stretched slope, q = (s_x/a_x)² + (s_y/a_y)²:
///
///     GGX        D(m) = 1/(π a_x a_y cos⁴θ_m (1 + q)²)      (Walter et al. 2007, Eq. 33)
///     Beckmann   D(m) = exp(−q)/(π a_x a_y cos⁴θ_m)         (Walter et al. 2007, Eq. 25)
///
/// stretched along the axes as in Heitz 2014, so that a normal is drawn by drawing q, whose distribution is q/(1 + q) or 1 − exp(−q), and a stretched azimuth.
///
/// References: Walter, Marschner, Li and Torrance, "Microfacet models for refraction through rough surfaces", EGSR
/// 2007; Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 2014.

#include <cmath>
#include <limits>

#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/rough/slope_distribution.hpp"

namespace vcavity {

namespace detail {

/// Throws std::invalid_argument unless a roughness is in range. Arrays of which nobody knows the entries yet are taken
/// as they are.
template <class Real>
void require_roughness([[maybe_unused]] const Real& roughness) {
  if constexpr (Number<Real>) {
    if (!(roughness >= Real(smallest_roughness) && roughness <= Real(largest_roughness))) {
      throw_invalid_argument("a roughness must lie in [", smallest_roughness, ", ", largest_roughness,
                             "], not be ", roughness);
    }
  }
}

/// The unit vector along (x, y, z), of any length but 0.
template <class Real>
Vec3<Real> unit_vector(const Real& x, const Real& y, const Real& z) {
  using std::sqrt;
  const Real inverse = Real(1) / Real(sqrt(x * x + y * y + z * z));
  return {x * inverse, y * inverse, z * inverse};
}

/// What GGX and Beckmann have in common: two roughnesses.
template <class Real>
class EllipticSlopes {
 public:
  using value_type = Real;

  /// The roughness along x, that is, of the slopes ∂z/∂x.
  Real roughness_x() const { return roughness_x_; }

  /// The roughness along y.
  Real roughness_y() const { return roughness_y_; }

 protected:
  EllipticSlopes(const Real& roughness_x, const Real& roughness_y)
      : roughness_x_(roughness_x), roughness_y_(roughness_y) {
    require_roughness(roughness_x);
    require_roughness(roughness_y);
    inverse_x2_ = Real(1) / (roughness_x * roughness_x);
    inverse_y2_ = Real(1) / (roughness_y * roughness_y);
    peak_ = Real(1) / (pi<Real>() * roughness_x * roughness_y);
  }

  /// D(z) = 1/(π a_x a_y)
  Real peak() const { return peak_; }

  /// q cos²θ_m of a normal; of a horizontal unit vector q cos²θ_m/sin²θ_m for all normals that lean its way.
  template <class Horizontal>
  Real stretched(const Horizontal& m) const {
    return inverse_x2_ * (m.x * m.x) + inverse_y2_ * (m.y * m.y);
  }

  /// The unit vector of the slope `size`·(a_x cos φ, a_y sin φ)/`up`.
  Vec3<Real> normal(const Real& size, const Real& up, const Real& u_azimuth) const {
    const PlaneDirection<Real> azimuth = direction_of_turns(u_azimuth);
    return unit_vector(Real(roughness_x_ * size * azimuth.cosine), Real(roughness_y_ * size * azimuth.sine),
                       up);
  }

 private:
  Real roughness_x_, roughness_y_;
  Real inverse_x2_, inverse_y2_;
  Real peak_;
};

}  // namespace detail

/// GGX, also known as Trowbridge–Reitz: few steep facets, but more than any other.
template <class Real>
class GgxSlopes : public detail::EllipticSlopes<Real> {
 public:
  /// @param roughness the same in all directions, in [1e-6, 1e3]; renderers call it α
  /// @throws std::invalid_argument when it is out of range or not a number
  explicit GgxSlopes(const Real& roughness) : GgxSlopes(roughness, roughness) {}

  /// @param roughness_x, roughness_y along x and along y, in [1e-6, 1e3]
  /// @throws std::invalid_argument when one is out of range or not a number
  GgxSlopes(const Real& roughness_x, const Real& roughness_y)
      : detail::EllipticSlopes<Real>(roughness_x, roughness_y) {}

  /// D(m), per steradian.
  /// @param m unit vector, m.z ≥ 0
  Real density(const Vec3<Real>& m) const { return of(this->stretched(m), m.z); }

  /// The same of several normals that lean one way.
  /// @param across horizontal unit vector
  /// @param cos_half, sin_half components of the normals along it and along z, packs, sin_half ≥ 0
  template <class Value>
  VCAVITY_INLINE Value densities(const Vec2<Real>& across, const Value& cos_half,
                                 const Value& sin_half) const {
    return of(Value(this->stretched(across) * (cos_half * cos_half)), sin_half);
  }

  /// A normal of the density D(m) cos θ_m.
  /// @param u two random numbers, uniform in [0, 1]: of the slope and of the azimuth
  /// @return unit vector, z ≥ 0
  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::sqrt;
    return this->normal(sqrt(u.x), sqrt(Real(1) - u.x), u.y);
  }

 private:
  /// @param stretched q cos²θ_m
  /// @param up cos θ_m
  template <class Value>
  VCAVITY_INLINE Value of(const Value& stretched, const Value& up) const {
    const Value spread = stretched + up * up;
    return Value(this->peak()) / (spread * spread);
  }
};

/// Beckmann: normally distributed slopes, hardly any much steeper than the roughness.
template <class Real>
class BeckmannSlopes : public detail::EllipticSlopes<Real> {
 public:
  /// @param roughness the same in all directions, in [1e-6, 1e3]: √2 times the standard deviation of a slope
  /// @throws std::invalid_argument when it is out of range or not a number
  explicit BeckmannSlopes(const Real& roughness) : BeckmannSlopes(roughness, roughness) {}

  /// @param roughness_x, roughness_y along x and along y, in [1e-6, 1e3]
  /// @throws std::invalid_argument when one is out of range or not a number
  BeckmannSlopes(const Real& roughness_x, const Real& roughness_y)
      : detail::EllipticSlopes<Real>(roughness_x, roughness_y) {}

  /// D(m), per steradian.
  /// @param m unit vector, m.z ≥ 0
  Real density(const Vec3<Real>& m) const { return of(this->stretched(m), m.z); }

  /// The same of several normals that lean one way.
  /// @param across horizontal unit vector
  /// @param cos_half, sin_half components of the normals along it and along z, packs, sin_half ≥ 0
  template <class Value>
  VCAVITY_INLINE Value densities(const Vec2<Real>& across, const Value& cos_half,
                                 const Value& sin_half) const {
    return of(Value(this->stretched(across) * (cos_half * cos_half)), sin_half);
  }

  /// A normal of the density D(m) cos θ_m.
  /// @param u two random numbers, uniform in [0, 1]: of the slope and of the azimuth
  /// @return unit vector, z > 0
  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::log;
    using std::sqrt;
    const Real rest = at_least(Real(Real(1) - u.x), std::numeric_limits<Real>::min());
    return this->normal(sqrt(-log(rest)), Real(1), u.y);
  }

 private:
  /// @param stretched q cos²θ_m
  /// @param up cos θ_m
  template <class Value>
  VCAVITY_INLINE Value of(const Value& stretched, const Value& up) const {
    // Multiplied twice, because the fourth power of a small cosine vanishes.
    // Far below where it does, the exponential is 0 for every roughness, and nothing overflows.
    const Value cosine2 = at_least(Value(up * up), Real(Real(1e13) * std::numeric_limits<Real>::min()));
    const Value inverse = Value(Real(1)) / cosine2;
    return this->peak() * detail::exponential(Value(-(stretched * inverse))) * inverse * inverse;
  }
};

}  // namespace vcavity
