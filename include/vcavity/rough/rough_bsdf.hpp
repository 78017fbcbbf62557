// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Rough and brushed metal as a renderer sees it: a distribution of V-grooves with all their bounces, in closed form.
///
/// The surface is the one of Torrance and Sparrow, "Theory for off-specular reflection from roughened surfaces",
/// JOSA 57 (1967), and of every microfacet model with V-cavities; but where these stop at the first bounce and lose
/// the light of all others, here it goes on:
///
///     f(e, o) cos θ_o = cos η/(2|h| e_z) · Σ D(m) cos(α/2) T B/j
///
/// over the grooves that lead light from e to o (connecting_grooves.hpp), T being the product of the facet
/// reflectances along the way. The term j = 1 is D G F/(4 cos θ_e cos θ_o) cos θ_o. The sum is reciprocal for every
/// number of bounces, and white facets reflect all light at every direction and azimuth. Both are proved; no
/// factor is fitted.
///
/// Sampling draws a groove, then a ray in it. BSDF × cosine/probability is then an average of reflectances T and
/// never exceeds 1. `evaluate_with_pdf` has both for the price of one.
///
/// With `Polarized` facets values are Mueller matrices in the axes of the mean surface, see mean_axes.hpp: those of
/// grooves would turn with the directions.
///
/// Range: roughness of 1e-3 and more in float. Next to the mirror direction, h → 0, the terms of two and more
/// bounces grow like 1/|h|: they are a focus with finite energy. Sample the BSDF there, alone or combined with
/// lights, but not small lights alone.
/// When not to use it: for grooves of one azimuth or of one aperture, whose light is a fan or a few directions and
/// no function; `GrooveBsdf` and `SpreadGrooveBsdf` have these. Patches of grooves are large against the grooves:
/// light that leaves a patch meets no other.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "vcavity/facet/bounce.hpp"
#include "vcavity/groove/lobes.hpp"
#include "vcavity/groove/narrow_groove.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/render/bsdf.hpp"
#include "vcavity/rough/bounce_lanes.hpp"
#include "vcavity/rough/connecting_grooves.hpp"
#include "vcavity/rough/drawn_ray.hpp"
#include "vcavity/rough/mean_axes.hpp"
#include "vcavity/rough/slope_distribution.hpp"

namespace vcavity {

/// What becomes of light that bounces more often than the limit of a `RoughGrooveBsdf`.
enum class LongWays {
  lost,          ///< it is absorbed
  without_loss,  ///< it leaves as if all its bounces reflected everything: right for white facets
};

/// BSDF of a distribution of V-grooves; its interface is that of `SpreadGrooveBsdf`. The frame is that of the mean
/// surface, in which brushed grooves run along x.
template <SlopeDistribution Distribution, FacetReflectance<scalar_t<Distribution>> Facet>
class RoughGrooveBsdf {
 public:
  using Real = scalar_t<Distribution>;
  using Value = power_t<Facet, Real>;
  using Throughput = value_t<Facet, Real>;

  /// With J bounces GGX of roughness a loses (πa/2J)² of white light at normal incidence: 2e-4 for a = 0.3.
  static constexpr int default_max_bounces = 32;

  /// Near θ_o = θ_e there is a groove for every number of bounces; no more than so many are followed.
  static constexpr int highest_limit = 4096;

  /// @param distribution of the grooves
  /// @param facet facet reflectance
  /// @param max_bounces light that needs more bounces goes the way of `long_ways`; in [1, highest_limit]
  /// @param long_ways what becomes of light beyond the bounce limit
  /// @throws std::invalid_argument when the limit is out of range
  RoughGrooveBsdf(Distribution distribution, Facet facet, int max_bounces = default_max_bounces,
                  LongWays long_ways = LongWays::lost)
      : distribution_(std::move(distribution)),
        facet_(std::move(facet)),
        max_bounces_(max_bounces),
        long_ways_(long_ways) {
    if (max_bounces < 1 || max_bounces > highest_limit) {
      throw_invalid_argument("the bounce limit of a rough surface must lie in [1, ", highest_limit,
                             "], not be ", max_bounces);
    }
  }

  /// The distribution of the grooves.
  const Distribution& distribution() const { return distribution_; }

  /// The facet reflectance.
  const Facet& facet() const { return facet_; }

  /// The bounce limit.
  int max_bounces() const { return max_bounces_; }

  /// BSDF × cosine: what radiance from `wi`, per steradian, counts towards `wo`; 0 if either is below the horizon.
  /// @param wo, wi unit vectors away from the surface
  /// @param transport which way the light goes; matters for Mueller matrices only
  Value evaluate(const Vec3<Real>& wo, const Vec3<Real>& wi,
                 Transport transport = Transport::radiance) const {
    return evaluate_with_pdf(wo, wi, transport).value;
  }

  /// Of this the part that has bounced a given number of times.
  /// @param bounces at least 1; beyond the limit nothing is left
  /// @param wo unit vector away from the surface
  /// @param wi unit vector away from the surface
  /// @param transport which way the light goes; matters for Mueller matrices only
  Value evaluate_bounces(const Vec3<Real>& wo, const Vec3<Real>& wi, int bounces,
                         Transport transport = Transport::radiance) const {
    Value result(0);
    for_each_term(wo, wi, std::min(bounces, max_bounces_),
                  [&](const ConnectingGrooves<Real>& grooves, const ConnectingGroove<Real>& groove) {
                    if (groove.bounces == bounces)
                      result = result + transported(term(grooves, groove, density(grooves, groove)), grooves,
                                                    transport);
                  });
    return result;
  }

  /// All parts of this by the number of bounces, in one pass.
  /// @param visit called with a number of bounces and a part, in ascending order; for a number twice where either
  ///        panel may be met first. What `LongWays::without_loss` adds is in none of them.
  /// @param wo unit vector away from the surface
  /// @param wi unit vector away from the surface
  /// @param transport which way the light goes; matters for Mueller matrices only
  template <class Visit>
  void for_each_part(const Vec3<Real>& wo, const Vec3<Real>& wi, Transport transport, Visit&& visit) const {
    for_each_term(wo, wi, max_bounces_,
                  [&](const ConnectingGrooves<Real>& grooves, const ConnectingGroove<Real>& groove) {
                    const Real white = density(grooves, groove);
                    if (white > Real(0))
                      visit(groove.bounces, transported(term(grooves, groove, white), grooves, transport));
                  });
  }

  /// Density per steradian with which `sample` draws `wi`: BSDF × cosine for facets that reflect all light. 0 if
  /// either direction is below the horizon.
  /// @param wo, wi unit vectors away from the surface
  Real pdf(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
    Real sum(0);
    if (!are_above_horizon(wo, wi)) return sum;
    const ConnectingGrooves<Real> grooves(wo, wi);
    if (max_bounces_ == 1) return density(grooves, grooves.first()) + density_of_long_ways(grooves);
    const GrooveBatches<Real> batches(grooves, max_bounces_);
    sum = lane_sum(densities(grooves, batches.first(), sum));
    for (int least = batches.second; batches.reach(least); least += GrooveBatch<Real>::bounce_counts)
      sum += lane_sum(densities(grooves, batches.from(least), sum));
    return sum + density_of_long_ways(grooves);
  }

  /// Both in one pass.
  /// @param wo, wi unit vectors away from the surface
  /// @param transport which way the light goes; matters for Mueller matrices only
  BsdfEvaluation<Real, Value> evaluate_with_pdf(const Vec3<Real>& wo, const Vec3<Real>& wi,
                                                Transport transport = Transport::radiance) const {
    BsdfEvaluation<Real, Value> result{Value(0), Real(0)};
    if (!are_above_horizon(wo, wi)) return result;
    const ConnectingGrooves<Real> grooves(wo, wi);
    if (max_bounces_ == 1) {
      const ConnectingGroove<Real> first = grooves.first();
      result.pdf = density(grooves, first);
      if (result.pdf > Real(0)) result.value = term(grooves, first, result.pdf);
    } else {
      const GrooveBatches<Real> batches(grooves, max_bounces_);
      if constexpr (ComponentsOverDirections<Facet, Real>)
        result = all_ways(grooves, batches);
      else
        result = one_by_one(grooves, batches);
    }
    const Real long_ways = density_of_long_ways(grooves);
    if (long_ways > Real(0)) {
      result.pdf += long_ways;
      result.value = result.value + scaled(long_ways, Value(1));
    }
    result.value = transported(result.value, grooves, transport);
    return result;
  }

  /// Draws a direction.
  /// @param wo unit vector away from the surface
  /// @param u_ray random number, uniform in [0, 1]: of the ray in the groove
  /// @param u_groove two random numbers, uniform in [0, 1]: of the groove
  /// @param transport which way the light goes; matters for Mueller matrices only
  /// @return nothing below the horizon, or when no light is left. The panel and the bounces are those of the ray
  ///         drawn; weight and probability are those of all grooves that lead to the direction.
  std::optional<BsdfSample<Real, Value>> sample(const Vec3<Real>& wo, const Real& u_ray,
                                                const Vec2<Real>& u_groove,
                                                Transport transport = Transport::radiance) const {
    if (!detail::is_above_horizon(wo)) return std::nullopt;
    const Vec3<Real> m = distribution_.sample(u_groove);
    const DrawnRay<Real> ray(wo, m, u_ray);
    const ConnectingGroove<Real>& drawn = ray.groove();
    if (drawn.bounces > max_bounces_ && long_ways_ == LongWays::lost) return std::nullopt;
    const Vec3<Real> wi = ray.leaving();
    auto [value, probability] = evaluate_with_pdf(wo, wi, transport);
    if (!is_density(probability)) {
      // Rounding of the direction has moved a narrow peak of the distribution away: what was drawn is left.
      const ConnectingGrooves<Real> grooves(wo, wi);
      probability = grooves.density(drawn, distribution_.density(m));
      if (!is_density(probability)) return std::nullopt;
      value = transported(term(grooves, drawn, probability), grooves, transport);
    }
    return BsdfSample<Real, Value>{wi, scalar(Real(1) / probability) * value, probability, drawn.first_panel,
                                   drawn.bounces};
  }

 private:
  template <class Visit>
  void for_each_term(const Vec3<Real>& wo, const Vec3<Real>& wi, int max_bounces, Visit&& visit) const {
    if (!are_above_horizon(wo, wi)) return;
    const ConnectingGrooves<Real> grooves(wo, wi);
    for_each_groove(grooves, max_bounces,
                    [&](const ConnectingGroove<Real>& groove) { visit(grooves, groove); });
  }

  /// Whether a density is finite, and so is its inverse.
  static bool is_density(const Real& x) {
    return x >= smallest_divisor<Real>() && x <= std::numeric_limits<Real>::max();
  }

  static auto scalar(const Real& x) { return static_cast<scalar_t<Value>>(x); }

  static bool are_above_horizon(const Vec3<Real>& wo, const Vec3<Real>& wi) {
    return detail::is_above_horizon(wo) && detail::is_above_horizon(wi);
  }

  static Value transported(const Value& from_wo, const ConnectingGrooves<Real>& grooves,
                           Transport transport) {
    return detail::transported(Value(in_mean_axes(from_wo, grooves)), transport);
  }

  Real density(const ConnectingGrooves<Real>& grooves, const ConnectingGroove<Real>& groove) const {
    return grooves.density(groove, distribution_.density(grooves.normal(groove)));
  }

  using Lanes = typename GrooveBatch<Real>::Lanes;

  /// The densities of a batch; 0 where there is no groove, or so little light that the sum does not change.
  /// @param so_far what they are added to
  VCAVITY_INLINE Lanes densities(const ConnectingGrooves<Real>& grooves, const GrooveBatch<Real>& batch,
                                 const Real& so_far) const {
    // ε² of the sum: even if all else is reflected by black facets and this by white ones, little is lost.
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    const Lanes white = facet_densities(grooves, batch) * batch.weight;
    return select(white > Real(epsilon * epsilon * so_far), white, Lanes(Real(0)));
  }

  VCAVITY_INLINE static Real lane_sum(const Lanes& a) {
    return detail::combined_lanes(detail::plus, std::array{a})[0];
  }

  VCAVITY_INLINE Lanes facet_densities(const ConnectingGrooves<Real>& grooves,
                                       const GrooveBatch<Real>& batch) const {
    const Vec2<Real>& across = grooves.across();
    if constexpr (requires { distribution_.densities(across, batch.cos_half, batch.sin_half); }) {
      return distribution_.densities(across, batch.cos_half, batch.sin_half);
    } else {
      Lanes result(Real(0));
      for (std::size_t lane = 0; lane < batch.capacity; ++lane)
        if (batch.beam[lane] > Real(0)) result[lane] = distribution_.density(grooves.normal(batch[lane]));
      return result;
    }
  }

  /// What goes all ways, several at a time.
  VCAVITY_INLINE BsdfEvaluation<Real, Value> all_ways(const ConnectingGrooves<Real>& grooves,
                                                      const GrooveBatches<Real>& batches) const {
    const GrooveBatch<Real> first = batches.first();
    const Lanes white = densities(grooves, first, Real(0));
    const bool has_long_ways = batches.reach(batches.second);
    const auto sum = light_of_short_ways(facet_, grooves, first, white).template sum<Value>();
    if (!has_long_ways) return sum;
    const auto more = long_ways(grooves, batches, white[0]);
    return {sum.value + more.value, sum.pdf + more.pdf};
  }

  /// What goes the ways of more than four bounces. Not inlined: the registers that it takes would not be there for the
  /// others.
  /// @param first what goes the way of one bounce, for facets that reflect all light
  VCAVITY_NOINLINE BsdfEvaluation<Real, Value> long_ways(const ConnectingGrooves<Real>& grooves,
                                                         const GrooveBatches<Real>& batches,
                                                         Real first) const {
    using Batch = GrooveBatch<Real>;
    // Lane by lane: zeros that are written in other pieces than they are read in keep the processor waiting.
    LightInLanes<Real, number_count<Value>> light;
    light.light.fill(Lanes(Real(0)));
    light.white = Lanes(Real(0));
    for (int least = batches.second;; least += Batch::bounce_counts) {
      const std::uint64_t reached = batches.lanes_reached(least);
      if (reached == 0) break;
      const Lanes white = densities(grooves, batches.from(least), first);
      if (!any_of(white > Real(0))) continue;
      constexpr std::size_t half = Batch::bounce_counts;
      for (std::uint64_t left = reached % (1u << half); left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        add_pair(light, facet_, grooves.cos_eta(), batches.pair(least, lane, reached),
                 {white[lane], white[lane + half]});
      }
    }
    return light.template sum<Value>();
  }

  /// The same, one way after the other.
  BsdfEvaluation<Real, Value> one_by_one(const ConnectingGrooves<Real>& grooves,
                                         const GrooveBatches<Real>& batches) const {
    BsdfEvaluation<Real, Value> result{Value(0), Real(0)};
    const auto add = [&](const GrooveBatch<Real>& batch) {
      const Lanes white = densities(grooves, batch, result.pdf);
      for (std::size_t lane = 0; lane < batch.capacity; ++lane)
        if (white[lane] > Real(0)) result.value = result.value + term(grooves, batch[lane], white[lane]);
      result.pdf += lane_sum(white);
    };
    add(batches.first());
    for (int least = batches.second; batches.reach(least); least += GrooveBatch<Real>::bounce_counts)
      add(batches.from(least));
    return result;
  }

  VCAVITY_INLINE Real density_of_long_ways(const ConnectingGrooves<Real>& grooves) const {
    if (long_ways_ == LongWays::lost) return Real(0);
    const Vec3<Real> steepest{grooves.across().x, grooves.across().y, Real(0)};
    return grooves.density_beyond(max_bounces_, distribution_.density(steepest));
  }

  /// The light that goes one way.
  /// @param white the same for white facets
  VCAVITY_INLINE Value term(const ConnectingGrooves<Real>& grooves, const ConnectingGroove<Real>& groove,
                            const Real& white) const {
    return scaled(white, power(throughput(grooves, groove)));
  }

  /// The product of the facet reflectances along a way.
  VCAVITY_INLINE Throughput throughput(const ConnectingGrooves<Real>& grooves,
                                       const ConnectingGroove<Real>& groove) const {
    const Vec3<Real>& e = grooves.to_light();
    const Real over_panel = groove.first_panel == Panel::one ? e.y : Real(-e.y);
    // The direction in components along the normal of the image and along the panel, turned from image to image.
    Real normal = groove.sin_half * e.z + groove.cos_half * over_panel;
    Real tangent = groove.cos_half * e.z - groove.sin_half * over_panel;
    const Real sine = Real(2) * groove.sin_half * groove.cos_half;
    const Real cosine = Real(1) - Real(2) * groove.sin_half * groove.sin_half;
    const auto in_range = [](const Real& x) { return at_most(at_least(x, Real(0)), Real(1)); };
    Bounce<Real> bounce{in_range(normal), tangent, e.x, groove.first_panel, 1};
    Throughput product = reflect(facet_, bounce);
    while (bounce.number < groove.bounces) {
      ++bounce.number;
      if (is_dark(product, bounce.number)) break;
      const Real turned = cosine * normal + sine * tangent;
      tangent = cosine * tangent - sine * normal;
      normal = turned;
      bounce.cosine = in_range(normal);
      bounce.tangent = tangent;
      bounce.panel = opposite(bounce.panel);
      product = product * reflect(facet_, bounce);
    }
    return product;
  }

  Distribution distribution_;
  Facet facet_;
  int max_bounces_;
  LongWays long_ways_;
};

}  // namespace vcavity
