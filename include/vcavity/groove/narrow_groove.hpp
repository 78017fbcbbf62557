// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What makes long series of bounces fast. Nothing here changes a result by more than rounding; `for_each_lobe`
/// is right without it.
///
/// In narrow grooves all rays of a first panel bounce many times together. Such bounces need no weights; if the
/// facet is a function of the cosine with positive numbers for values, the logarithm of their product is a sum
/// over an arithmetic progression of angles, and few of its terms are enough. And where nothing is left of the
/// light, the Fresnel equations need not be asked any more.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/follow.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/progression_sum.hpp"

namespace vcavity {

/// From this number of bounces on it pays to ask whether all rays bounce once more, before their weights are
/// computed.
inline constexpr int long_series = 16;

/// From this number of bounces on it may pay to do many at once.
inline constexpr int narrow_groove = 200;

/// Whether nothing is left of a throughput. That shows in long series only, and is looked for now and then.
/// @param throughput of the bounces before
/// @param bounce number of the next one
template <class Value>
bool is_dark(const Value& throughput, int bounce) {
  constexpr int seldom = 8;
  return bounce % seldom == 0 && all_of(largest(throughput) < std::numeric_limits<scalar_t<Value>>::min());
}

/// Whether it is faster to multiply a value by 1, or to add 0, than to find out that there is no need.
template <class Value>
inline constexpr bool cheaper_than_branch = Number<Value>;

template <class Real, std::size_t size, std::size_t bytes>
inline constexpr bool cheaper_than_branch<Pack<Real, size, bytes>> = true;

/// Until where all rays of a direction that meet the same panel first bounce together.
/// @tparam Real number type of a component, or a `Pack` of them
template <class Real>
class SharedBounces {
 public:
  /// @param first the ray at its first bounce
  VCAVITY_INLINE explicit SharedBounces(const UnfoldedRay<Real>& first)
      : surely_reached_(first.normal_component() +
                        Real(scalar_t<Real>(16) * std::numeric_limits<scalar_t<Real>>::epsilon())) {}

  /// Whether all rays surely bounce at an image too, at the cost of a comparison: c_j > c_1, by more than
  /// rounding, which is up to 8 ε in each (docs/accuracy.md).
  /// @param ray at that image
  bool include(const UnfoldedRay<Real>& ray) const {
    return all_of(ray.normal_component() > surely_reached_);
  }

 private:
  Real surely_reached_;  // a normal component above this
};

/// Until where all rays bounce together. Grooves of other shapes overload this.
/// @param first the ray at its first bounce
template <class Scalar, class Real>
VCAVITY_INLINE SharedBounces<Real> shared_bounces(const Cavity<Scalar>&, const UnfoldedRay<Real>& first) {
  return SharedBounces<Real>(first);
}

/// How often all rays surely bounce that meet a panel first: until the angle has passed a right one and is as far beyond
/// it as it began before it. Grooves of other shapes overload this.
/// @param groove the groove
/// @param normal,tangent components of the direction towards the light at the first bounce, see `UnfoldedRay`
/// @param most no more than these matter
template <std::floating_point Real>
int count_shared_bounces(const Cavity<Real>& groove, Panel, const Real& normal, const Real& tangent,
                         int most) {
  const Real first_angle = std::atan2(normal, tangent);
  const Real bounces = (pi<Real>() - Real(2) * first_angle) / groove.aperture() - Real(1);
  return whole_at_most(bounces, most);
}

/// Bounces that have been done at once.
template <class Value>
struct ManyBounces {
  int count;
  Value throughput;  ///< of all of them
};

/// Facets of which many bounces can be done at once: functions of the cosine with numbers for values. Not on GPUs, which
/// have no memory for the rules of sums.
template <class Facet, class Real>
concept ManyAtOnce =
#if defined(VCAVITY_ON_GPU)
    false &&
#endif
    std::floating_point<Real> && std::floating_point<value_t<Facet, Real>> &&
    std::invocable<const Facet&, const Real&>;

/// Does many bounces at once, all of which reach every ray of the first panel. Does nothing where that does not pay.
/// Takes numbers, no ray: the address of one that lives in registers would put it into memory.
/// @param facet facet reflectance
/// @param groove the groove
/// @param first the panel met first
/// @param normal,tangent components of the direction towards the light at the first bounce, see `UnfoldedRay`
/// @param max_bounces none beyond these is done
template <std::floating_point Real, ManyAtOnce<Real> Facet, class Groove>
VCAVITY_NOINLINE ManyBounces<value_t<Facet, Real>> reflect_many(const Facet& facet, const Groove& groove,
                                                                Panel first, Real normal, Real tangent,
                                                                int max_bounces) {
  using Value = value_t<Facet, Real>;
  constexpr int least_log2 = 7;  // shorter series are done bounce by bounce
  const Real first_angle = std::atan2(normal, tangent);
  const Real size = std::hypot(normal, tangent);
  const Real aperture = groove.aperture();
  const int shared = count_shared_bounces(groove, first, normal, tangent, max_bounces);
  int left = std::min(max_bounces, shared) - 1;
  const auto log_reflectance = [&](const Real& index) {
    const Value reflectance = facet(size * std::sin(first_angle + (index - Real(1)) * aperture));
    return static_cast<Real>(std::log(at_least(reflectance, std::numeric_limits<Value>::min())));
  };
  ManyBounces<Value> done{0, Value(1)};
  int log2 = 28;
  while (left >= 1 << least_log2) {
    while (1 << log2 > left) --log2;
    const int count = 1 << log2;
    const auto sum = progression_sum<Real>(log_reflectance, 1 + done.count, log2,
                                           Real(3 * count) * std::numeric_limits<Real>::epsilon());
    if (!sum) break;
    done.throughput *= static_cast<Value>(std::exp(*sum));
    done.count += count;
    left -= count;
  }
  return done;
}

/// The value of a facet for the bounce at which a ray is; of which a function of the cosine need not know all.
/// @param facet facet reflectance
/// @param ray the ray at its present bounce
template <class Real, FacetReflectance<Real> Facet>
VCAVITY_INLINE value_t<Facet, Real> reflect(const Facet& facet, const UnfoldedRay<Real>& ray) {
  if constexpr (std::invocable<const Facet&, const Real&>) {
    return facet(ray.cosine());
  } else {
    return facet(ray.bounce());
  }
}

/// What `for_each_lobe` asks about the bounces of one direction and first panel. The ray and its throughput stay with
/// the caller, in registers; as members compilers keep them in memory.
template <class Groove, class Real, class Facet>
class LongSeries {
 public:
  using Value = value_t<Facet, Real>;

  /// @param groove,facet must outlive this
  /// @param first the ray at its first bounce
  /// @param max_bounces after so many it is followed no further
  /// @param dark_light what becomes of light of which nothing is left
  VCAVITY_INLINE LongSeries(const Groove& groove, const Facet& facet, const UnfoldedRay<Real>& first,
                            int max_bounces, DarkLight dark_light)
      : groove_(groove),
        facet_(facet),
        shared_(shared_bounces(groove, first)),
        most_(max_bounces),
        is_long_(groove.max_bounces() >= long_series),
        dark_light_(dark_light) {}

  /// In narrow grooves, does most of the bounces that all of the light makes, at once.
  /// @param ray at its first bounce; at the next one that has not been done afterwards
  /// @param throughput of the bounces before
  VCAVITY_INLINE void begin(UnfoldedRay<Real>& ray, Value& throughput) const {
    if constexpr (ManyAtOnce<Facet, Real>) {
      if (most_ < narrow_groove) return;
      const ManyBounces<Value> done =
          reflect_many(facet_, groove_, ray.panel(), ray.normal_component(), ray.tangent_component(), most_);
      ray.advance(done.count);
      throughput = done.throughput;
    }
  }

  /// Multiplies by the facet's value for one bounce, unless nothing is left of the light.
  /// @param ray at this bounce
  /// @param throughput of the bounces before; and of this one afterwards
  /// @return whether the light is followed any further
  VCAVITY_INLINE bool reflect(const UnfoldedRay<Real>& ray, Value& throughput) const {
    if (!is_dark(throughput, ray.number())) {
      const Value reflected = vcavity::reflect(facet_, ray);
      if (!cheaper_than_branch<Value> && ray.number() == 1)
        throughput = reflected;
      else
        throughput = throughput * reflected;
      return true;
    }
    return dark_light_ == DarkLight::followed;
  }

  /// Whether all of the light surely bounces at an image too, so that none leaves before; asked only where that pays.
  /// @param last the ray at the last bounce
  /// @param ray at the image behind that
  VCAVITY_INLINE bool all_reach(const UnfoldedRay<Real>& last, const UnfoldedRay<Real>& ray) const {
    return last.number() < most_ && is_long_ && shared_.include(ray);
  }

 private:
  const Groove& groove_;
  const Facet& facet_;
  decltype(shared_bounces(std::declval<const Groove&>(), std::declval<const UnfoldedRay<Real>&>())) shared_;
  int most_;
  bool is_long_;
  DarkLight dark_light_;
};

}  // namespace vcavity
