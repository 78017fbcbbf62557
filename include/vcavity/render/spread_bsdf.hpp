// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Grooves whose lobes have a width: slightly wavy facets, or a small lamp seen in perfect ones.
///
/// Each lobe of `GrooveBsdf` is blurred by a von Mises–Fisher distribution. What the blur would carry below
/// the horizon is mirrored back up, so the albedo of every direction ω_o is exactly that of the grooves. The
/// price: the BSDF is reciprocal only as far as the width is small against the distance of a lobe from the
/// horizon. In paths from the light, where the adjoint is needed, it is `evaluate(wi, wo) · wi.z / wo.z`.
///
/// When not to use it: rough facets, with slopes of more than a few degrees, also change how often light
/// bounces.

#include "vcavity/render/bsdf.hpp"
#include "vcavity/render/von_mises_fisher.hpp"

namespace vcavity {

/// BSDF of V-grooves with lobes of a finite width; its interface is that of `GrooveBsdf`.
template <class Real, FacetReflectance<Real> Facet, UnfoldableGroove<Real> Groove = Cavity<Real>>
class SpreadGrooveBsdf {
 public:
  using Value = power_t<Facet, Real>;
  using Throughput = value_t<Facet, Real>;

  /// @param grooves the BSDF of infinitely narrow lobes
  /// @param width of each lobe, in radians; for its range see `VonMisesFisher`
  /// @throws std::invalid_argument when the width is out of range
  SpreadGrooveBsdf(const GrooveBsdf<Real, Facet, Groove>& grooves, const Real& width)
      : grooves_(grooves), spread_(width) {}

  /// Directional albedo, that of the grooves.
  /// @param wo unit vector away from the surface
  Value albedo(const Vec3<Real>& wo) const { return grooves_.albedo(wo); }

  /// BSDF × cosine: what radiance from `wi`, per steradian, counts towards `wo`; 0 if either is below the
  /// horizon.
  /// @param wo,wi unit vectors away from the surface
  /// @param transport which way the light goes; matters for Mueller matrices only
  Value evaluate(const Vec3<Real>& wo, const Vec3<Real>& wi,
                 Transport transport = Transport::radiance) const {
    Value result(0);
    if (!detail::is_above_horizon(wi)) return result;
    for (const auto& lobe : grooves_.lobes(wo))
      result = result + scalar(lobe.weight * density(lobe.direction, wi)) * power(lobe.throughput);
    return detail::transported(result, transport);
  }

  /// Density per steradian with which `sample` draws `wi`; 0 if either direction is below the horizon.
  /// @param wo,wi unit vectors away from the surface
  Real pdf(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
    if (!detail::is_above_horizon(wi)) return Real(0);
    const auto lobes = grooves_.lobes(wo);
    return density(lobes, grooves_.probabilities(lobes), wi);
  }

  /// Draws a direction.
  /// @param wo unit vector away from the surface
  /// @param u_lobe random number, uniform in [0, 1]
  /// @param u_direction two random numbers, uniform in [0, 1]
  /// @param transport which way the light goes; matters for Mueller matrices only
  /// @return nothing below the horizon, or when no light is left
  std::optional<BsdfSample<Real, Value>> sample(const Vec3<Real>& wo, const Real& u_lobe,
                                                const Vec2<Real>& u_direction,
                                                Transport transport = Transport::radiance) const {
    const auto lobes = grooves_.lobes(wo);
    const auto odds = grooves_.probabilities(lobes);
    const std::size_t i = detail::choose(odds, lobes.size(), u_lobe);
    if (i == lobes.size()) return std::nullopt;
    Vec3<Real> wi = spread_.sample(lobes[i].direction, u_direction);
    wi.z = largest(wi.z);
    // Other lobes may reach that direction too: all of them count, in the numerator and in the denominator.
    const Real probability = density(lobes, odds, wi);
    if (!(probability > Real(0))) return std::nullopt;
    Value weight(0);
    for (const auto& lobe : lobes)
      weight =
          weight + scalar(lobe.weight * density(lobe.direction, wi) / probability) * power(lobe.throughput);
    return BsdfSample<Real, Value>{wi, detail::transported(weight, transport), probability,
                                   lobes[i].first_panel, lobes[i].bounces};
  }

 private:
  static auto scalar(const Real& x) { return static_cast<scalar_t<Value>>(x); }

  /// Density of one lobe, with what is mirrored at the horizon.
  Real density(const Vec3<Real>& mean, const Vec3<Real>& wi) const {
    return spread_.density(mean, wi) + spread_.density(mean, {wi.x, wi.y, -wi.z});
  }

  using Grooves = GrooveBsdf<Real, Facet, Groove>;

  Real density(const Lobes<Real, Throughput, Groove::max_lobes>& lobes,
               const typename Grooves::Probabilities& odds, const Vec3<Real>& wi) const {
    Real sum(0);
    for (std::size_t i = 0; i < lobes.size(); ++i) sum += odds[i] * density(lobes[i].direction, wi);
    return sum;
  }

  Grooves grooves_;
  VonMisesFisher<Real> spread_;
};

}  // namespace vcavity
