// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The grooved surface as a renderer sees it: a BSDF of at most four mirror directions.
///
/// The lobes of a direction ω_o carry all light there is, so the radiance towards the viewer is the finite
/// sum
///
///     L_o(ω_o) = Σ weight · throughput · L_i(direction),
///
/// in which no cosine is missing: by Helmholtz reciprocity weight · cos θ_o = weight' · cos θ_i for the
/// reverse lobe. Read with ω_o towards the light, the same numbers are the fractions of the light's power
/// that leave in each direction. Paths from the camera and paths from the light are therefore sampled alike;
/// only Mueller matrices need to know which way the light goes.
///
/// Directions are in the frame of the groove (x along it, z the normal, see `GrooveFrame`) and point away
/// from the surface. Nothing here allocates, throws or calls a virtual function once the object is built, and
/// no direction that it returns lies below the horizon. For lobes of finite width see `spread_bsdf.hpp`.

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "vcavity/groove/lobes.hpp"
#include "vcavity/groove/ray.hpp"
#include "vcavity/groove/reflectance.hpp"

namespace vcavity {

/// With which probability a lobe is drawn.
enum class LobeChoice {
  by_weight,  ///< in proportion to its weight: evaluates the facet for the drawn lobe only
  by_energy   ///< in proportion to weight × throughput: less noise where bounces absorb much
};

/// Which way light goes along the path that a renderer builds.
enum class Transport {
  radiance,   ///< to `wo`: the path comes from the camera
  importance  ///< from `wo`: the path comes from the light
};

/// A direction drawn from a BSDF.
template <class Real, class Value>
struct BsdfSample {
  Vec3<Real> direction;  ///< unit vector away from the surface, z ≥ 0
  Value weight;          ///< BSDF × cosine / probability: what the radiance from `direction` counts
  Real probability;      ///< > 0; of the lobe, or the density per steradian where lobes have a width
  Panel first_panel;     ///< of the drawn lobe
  int bounces;           ///< of the drawn lobe
};

/// A BSDF and the density with which it is sampled.
template <class Real, class Value>
struct BsdfEvaluation {
  Value value;  ///< BSDF × cosine
  Real pdf;     ///< per steradian
};

namespace detail {

/// Whether a direction can see the grooves; false if any component is not a number or infinite.
template <class Real>
bool is_above_horizon(const Vec3<Real>& direction) {
  return direction.z >= Real(0) && direction.z <= Real(2) &&
         direction.x * direction.x + direction.y * direction.y <= Real(2);
}

/// Moves directions that rounding has put below the horizon back onto it.
template <class Real, class Value, std::size_t capacity>
Lobes<Real, Value, capacity> raised_to_horizon(const Lobes<Real, Value, capacity>& below) {
  Lobes<Real, Value, capacity> raised;
  for (Lobe<Real, Value> lobe : below) {
    lobe.direction.z = at_least(lobe.direction.z, Real(0));
    raised.push_back(lobe);
  }
  return raised;
}

/// The value for light that goes to `wo` or comes from there, given the latter.
template <class Value>
Value transported(const Value& from_wo, Transport transport) {
  if (transport == Transport::radiance) return reversed(from_wo);
  return from_wo;
}

/// The index that u selects. Never one of probability 0, whatever rounding has left of the sum.
/// @param u in [0, 1]
/// @return an index below `size`, or `size` when all probabilities are 0
template <class Real, std::size_t capacity>
std::size_t choose(const std::array<Real, capacity>& probabilities, std::size_t size, Real u) {
  std::size_t chosen = size;
  for (std::size_t i = 0; i < size; ++i) {
    if (!(probabilities[i] > Real(0))) continue;
    chosen = i;
    if (u < probabilities[i]) break;
    u -= probabilities[i];
  }
  return chosen;
}

}  // namespace detail

/// BSDF of specular V-grooves: discrete directions, whose probabilities are exact.
/// @tparam Facet facet reflectance; its value may be a number, RGB, a `Pack` of wavelengths, …; with
///         `Polarized` weights are Mueller matrices in the axes of conventions.hpp
/// @tparam Groove its shape: a `Cavity`, or another groove that can be unfolded
template <class Real, FacetReflectance<Real> Facet, UnfoldableGroove<Real> Groove = Cavity<Real>>
class GrooveBsdf {
 public:
  /// As many numbers as a direction may have lobes.
  using Probabilities = std::array<Real, Groove::max_lobes>;
  using Value = power_t<Facet, Real>;
  using Throughput = value_t<Facet, Real>;

  /// @param groove its shape
  /// @param facet facet reflectance
  /// @param choice with which probability `sample` draws a lobe
  /// @param max_bounces light that needs more bounces is lost
  GrooveBsdf(const Groove& groove, const Facet& facet, LobeChoice choice = LobeChoice::by_energy,
             int max_bounces = all_bounces)
      : groove_(groove), facet_(facet), choice_(choice), max_bounces_(max_bounces) {}

  /// The same of a groove that is made in its place, for renderers that make one for every point: copying one that has
  /// just been made takes as long as making it.
  /// @param make_groove called once, without arguments
  template <class MakeGroove>
    requires std::same_as<std::invoke_result_t<const MakeGroove&>, Groove>
  GrooveBsdf(const MakeGroove& make_groove, const Facet& facet, LobeChoice choice = LobeChoice::by_energy,
             int max_bounces = all_bounces)
      : groove_(make_groove()), facet_(facet), choice_(choice), max_bounces_(max_bounces) {}

  /// The complete BSDF of a direction: at most `max_lobes` of the groove; none below the horizon.
  /// @param wo unit vector away from the surface, where the light of the throughputs comes from
  Lobes<Real, Throughput, Groove::max_lobes> lobes(const Vec3<Real>& wo) const {
    return lobes_of(wo, facet_);
  }

  /// Directional albedo, the reflectance for light from `wo` or, `reversed`, seen from `wo` in diffuse light;
  /// 0 below the horizon.
  /// @param wo unit vector away from the surface
  Value albedo(const Vec3<Real>& wo) const {
    if (!detail::is_above_horizon(wo)) return Value(0);
    return directional_reflectance(groove_, wo, facet_, max_bounces_);
  }

  /// The probabilities with which `sample` draws these lobes, in their order.
  /// @return as many numbers as there are lobes, which add up to 1; all 0 if no light is left
  template <class AnyValue>
  Probabilities probabilities(const Lobes<Real, AnyValue, Groove::max_lobes>& lobes) const {
    Probabilities result{};
    Real sum(0);
    for (std::size_t i = 0; i < lobes.size(); ++i) {
      result[i] = lobes[i].weight;
      if (choice_ == LobeChoice::by_energy)
        result[i] *= Real(largest(unpolarized(power(lobes[i].throughput))));
      sum += result[i];
    }
    if (!(sum > Real(0))) return {};
    for (Real& probability : result) probability /= sum;
    return result;
  }

  /// Draws a lobe.
  /// @param wo unit vector away from the surface
  /// @param u random number, uniform in [0, 1]
  /// @param transport which way the light goes; matters for Mueller matrices only
  /// @return nothing below the horizon, or when no light is left
  std::optional<BsdfSample<Real, Value>> sample(const Vec3<Real>& wo, const Real& u,
                                                Transport transport = Transport::radiance) const {
    if (choice_ == LobeChoice::by_energy) {
      return drawn(lobes(wo), u, transport,
                   [](const Lobe<Real, Throughput>& lobe) { return power(lobe.throughput); });
    }
    const auto candidates = lobes_of(wo, [](const Real&) { return Real(1); });
    return drawn(candidates, u, transport, [&](const Lobe<Real, Real>& lobe) {
      return ray_reflectance(groove_, wo, RayPath{lobe.first_panel, lobe.bounces}, facet_);
    });
  }

  /// 0: light from a direction given beforehand meets no mirror direction. Here so that generic code
  /// compiles.
  static Value evaluate(const Vec3<Real>&, const Vec3<Real>&) { return Value(0); }

  /// 0, the density of discrete directions; their probabilities are in `probabilities`.
  static Real pdf(const Vec3<Real>&, const Vec3<Real>&) { return Real(0); }

 private:
  template <class AnyFacet>
  Lobes<Real, value_t<AnyFacet, Real>, Groove::max_lobes> lobes_of(const Vec3<Real>& wo,
                                                                   const AnyFacet& facet) const {
    if (!detail::is_above_horizon(wo)) return {};
    return detail::raised_to_horizon(vcavity::lobes(groove_, wo, facet, max_bounces_));
  }

  /// @param reflectance_of gives the reflectance along the lobe that was drawn
  template <class AnyValue, class ReflectanceOf>
  std::optional<BsdfSample<Real, Value>> drawn(const Lobes<Real, AnyValue, Groove::max_lobes>& candidates,
                                               const Real& u, Transport transport,
                                               ReflectanceOf&& reflectance_of) const {
    const Probabilities odds = probabilities(candidates);
    const std::size_t i = detail::choose(odds, candidates.size(), u);
    if (i == candidates.size()) return std::nullopt;
    const Lobe<Real, AnyValue>& lobe = candidates[i];
    const auto scale = static_cast<scalar_t<Value>>(lobe.weight / odds[i]);
    return BsdfSample<Real, Value>{lobe.direction,
                                   scale * detail::transported<Value>(reflectance_of(lobe), transport),
                                   odds[i], lobe.first_panel, lobe.bounces};
  }

  Groove groove_;
  Facet facet_;
  LobeChoice choice_;
  int max_bounces_;
};

template <class Groove, class Facet>
GrooveBsdf(const Groove&, const Facet&, LobeChoice = LobeChoice::by_energy, int = all_bounces)
    -> GrooveBsdf<scalar_t<Groove>, Facet, Groove>;
template <std::invocable MakeGroove, class Facet>
GrooveBsdf(const MakeGroove&, const Facet&, LobeChoice = LobeChoice::by_energy, int = all_bounces)
    -> GrooveBsdf<scalar_t<std::invoke_result_t<MakeGroove>>, Facet, std::invoke_result_t<MakeGroove>>;

}  // namespace vcavity
