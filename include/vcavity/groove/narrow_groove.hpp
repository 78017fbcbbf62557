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

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
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

/// Where light goes on bounce by bounce.
template <class Real, class Value>
struct Continuation {
  UnfoldedRay<Real> ray;  ///< at the next bounce
  Value throughput;       ///< of the bounces before
};

/// Does many bounces at once, all of which reach every ray of the first panel. Does nothing where that does not
/// pay, or the facet is no function of the cosine with positive numbers for values.
/// @param facet facet reflectance
/// @param ray at its first bounce
/// @param fractions the series of its first panel, see `LitOpening`
/// @param aperture of the groove
/// @param max_bounces none beyond these is done
template <class Value, class Real, class Facet, class Fractions>
VCAVITY_NOINLINE Continuation<Real, Value> reflect_many(const Facet& facet, UnfoldedRay<Real> ray,
                                                        const Fractions& fractions,
                                                        const scalar_t<Real>& aperture, int max_bounces) {
  Value throughput(1);
  if constexpr (std::is_floating_point_v<Real> && std::is_floating_point_v<Value> &&
                std::invocable<const Facet&, const Real&>) {
    constexpr int least_log2 = 7;  // shorter series are done bounce by bounce
    const Real first_angle = std::atan2(ray.normal_component(), ray.tangent_component());
    const Real size = std::hypot(ray.normal_component(), ray.tangent_component());
    int left = std::min(max_bounces, fractions.bounces_of_all(ray, max_bounces)) - 1;
    const auto log_reflectance = [&](const Real& index) {
      const Value reflectance = facet(size * std::sin(first_angle + (index - Real(1)) * aperture));
      return static_cast<Real>(std::log(at_least(reflectance, std::numeric_limits<Value>::min())));
    };
    int log2 = 28;
    while (left >= 1 << least_log2) {
      while (1 << log2 > left) --log2;
      const int count = 1 << log2;
      const auto sum = progression_sum<Real>(log_reflectance, ray.number(), log2,
                                             Real(3 * count) * std::numeric_limits<Real>::epsilon());
      if (!sum) break;
      throughput *= static_cast<Value>(std::exp(*sum));
      ray.advance(count);
      left -= count;
    }
  }
  return {ray, throughput};
}

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

}  // namespace vcavity
