// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The matte groove as a renderer sees it.
///
/// Method. Where light or viewer is within the aperture the BRDF is that of `LambertianCavity`, without loss. Where both
/// are beyond it, what has crossed the groove at most once is still exact; the rest, a smooth function of the two
/// directions, is interpolated by cubics in a table made at construction. Directions are drawn with the cosine, as from
/// a flat matte surface: the BRDF of a groove is never far from that.
///
/// Directions are in the frame of the groove and point away from the surface, as in `GrooveBsdf`, whose interface this
/// is. Nothing here allocates or throws once the object is built.
/// When not to use it: under a smooth interface, see lambertian_cavity.hpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "vcavity/matte/lambertian_cavity.hpp"
#include "vcavity/render/bsdf.hpp"

namespace vcavity {

/// A direction drawn from a BSDF without lobes.
template <class Real, class Value>
struct DiffuseSample {
  Vec3<Real> direction;  ///< unit vector away from the surface, z ≥ 0
  Value weight;          ///< BSDF × cosine / probability: what the radiance from `direction` counts
  Real probability;      ///< density per steradian, > 0
};

/// BSDF of V-grooves with matte panels.
template <class Real, class Reflectance = Real>
class LambertianGrooveBsdf {
 public:
  using Value = Reflectance;

  /// @param cavity with its albedos
  explicit LambertianGrooveBsdf(const LambertianCavity<Real, Value>& cavity) : cavity_(cavity) {
    std::vector<Real> lengths;
    for (int i = 0; i <= intervals; ++i) lengths.push_back(length_at(Real(i) / Real(intervals)));
    table_ = cavity.exchange_strips(lengths);
  }

  /// Directional albedo; 0 below the horizon.
  /// @param wo unit vector away from the surface
  Value albedo(const Vec3<Real>& wo) const {
    if (!detail::is_above_horizon(wo)) return Value(0);
    return cavity_.directional_reflectance(wo);
  }

  /// BSDF × cosine: what radiance from `wi`, per steradian, counts towards `wo`; 0 if either is below the horizon or
  /// grazes it. The BRDF is symmetric: light goes either way alike.
  /// @param wo,wi unit vectors away from the surface
  Value evaluate(const Vec3<Real>& wo, const Vec3<Real>& wi, Transport = Transport::radiance) const {
    if (!is_seen(wo) || !is_seen(wi)) return Value(0);
    return static_cast<scalar_t<Value>>(wi.z) * brdf(wo, wi);
  }

  /// Density per steradian with which `sample` draws `wi`; 0 if either direction is below the horizon or grazes it.
  /// @param wo,wi unit vectors away from the surface
  Real pdf(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
    return is_seen(wo) && is_seen(wi) ? wi.z / pi<Real>() : Real(0);
  }

  /// Draws a direction.
  /// @param wo unit vector away from the surface
  /// @param u two random numbers, uniform in [0, 1]
  /// @return nothing below the horizon, or when that is where rounding has put the direction
  std::optional<DiffuseSample<Real, Value>> sample(const Vec3<Real>& wo, const Vec2<Real>& u,
                                                   Transport = Transport::radiance) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    if (!is_seen(wo)) return std::nullopt;
    const Real cosine = sqrt(u.x);
    const Real sine = sqrt(at_least(Real(Real(1) - u.x), Real(0)));
    const Real azimuth = Real(2) * pi<Real>() * u.y;
    const Vec3<Real> wi{sine * sin(azimuth), sine * cos(azimuth), cosine};
    if (!(wi.z > Real(0))) return std::nullopt;
    return DiffuseSample<Real, Value>{wi, static_cast<scalar_t<Value>>(pi<Real>()) * brdf(wo, wi),
                                      wi.z / pi<Real>()};
  }

 private:
  static constexpr int intervals = 32;

  static bool is_seen(const Vec3<Real>& w) { return detail::is_above_horizon(w) && w.z > Real(0); }

  // A variable in [0, 1] of the length 1 − s₀ of a strip, in which the table is smooth: near the apex radiosity is a
  // power of s₀, and the lengths of narrow grooves are mostly small.
  Real place_of(const Real& length) const {
    using std::cbrt;
    const Real sine = cavity_.cavity().sin_half();
    const Real depth = Real(1) - cbrt(at_least(Real(Real(1) - length), Real(0)));
    return depth * (Real(1) + sine) / (depth + sine);
  }
  /// The inverse of `place_of`.
  Real length_at(const Real& place) const {
    const Real sine = cavity_.cavity().sin_half();
    const Real root = Real(1) - place * sine / (Real(1) + sine - place);
    return Real(1) - root * root * root;
  }

  Value brdf(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
    const Cavity<Real>& cavity = cavity_.cavity();
    const detail::Footprint<Real> in(cavity, wi), out(cavity, wo);
    if (in.on_all || out.on_all) return cavity_.brdf(wi, wo);
    const bool same_panel = in.on_one == out.on_one;
    const Value& seen = cavity_.albedo(out.on_one > Real(0) ? Panel::one : Panel::two);
    const Value& lit = cavity_.albedo(in.on_one > Real(0) ? Panel::one : Panel::two);
    using Scalar = scalar_t<Value>;
    const Real scale = Real(2) * cavity.sin_half() / pi<Real>();
    const Real first = same_panel ? Real(1) / std::max(in.length, out.length)
                                  : cavity_.geometry()->exchange.mean_kernel_of_strips(in.start, out.start);
    const Value sum =
        Value(static_cast<Scalar>(first)) +
        interpolated(same_panel ? table_.even : table_.odd, place_of(in.length), place_of(out.length));
    const Value reflected = static_cast<Scalar>(scale) * (seen * sum);
    return same_panel ? reflected : reflected * lit;
  }

  /// The four nodes around a place, and their weights.
  struct Stencil {
    std::size_t first;
    std::array<Real, 4> weights;

    explicit Stencil(const Real& place) {
      const Real x = place * Real(intervals);
      first = static_cast<std::size_t>(std::clamp(static_cast<int>(x) - 1, 0, intervals - 3));
      const Real t = x - Real(static_cast<int>(first));
      const Real a = t - Real(1), b = t - Real(2), c = t - Real(3);
      weights = {-a * b * c / Real(6), t * b * c / Real(2), -t * a * c / Real(2), t * a * b / Real(6)};
    }
  };

  static Value interpolated(const std::vector<Value>& table, const Real& row, const Real& column) {
    const Stencil rows(row), columns(column);
    Value sum(0);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        const Real weight = rows.weights[i] * columns.weights[j];
        sum = sum + static_cast<scalar_t<Value>>(weight) *
                        table[(rows.first + i) * (intervals + 1) + columns.first + j];
      }
    return sum;
  }

  LambertianCavity<Real, Value> cavity_;
  typename LambertianCavity<Real, Value>::StripExchange table_;
};

}  // namespace vcavity
