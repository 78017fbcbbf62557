// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which effects a rough surface calls for: the answer of planner.hpp for a distribution of grooves.
///
/// Method. The light that a rough surface reflects is the mean of what its grooves reflect, and so are the bounds of
/// planner.hpp on what leaving out polarisation or long ways costs. They are averaged over the distribution by a
/// plain rule in the two random numbers that draw a groove, and searched on a grid for the worst direction. Both are
/// enlarged by a margin, half of them, which covers the error of the rule and the directions between: it is measured,
/// not proved (tests/rough tries directions and distributions at random).
///
/// Of the light beyond J bounces there is a bound that is proved, and it is taken where it is the smaller one: unfolded, a
/// ray is straight and sweeps half a turn at most, so that it meets no more than ⌈π/α⌉ panels. Light that bounces more
/// than J times is in grooves of α < π/J, and facets reflect no more than all of it: no more is lost than the share of
/// these grooves in the mean area, of GGX a²/(a² + cot²(π/2J)). Where facets are nearly white it is lost indeed.
///
/// The bounds hold for the light that leaves a surface under illumination of radiance 1 from everywhere or from
/// parts of the sky; not for the value of the BRDF at a pair of directions, which has no bound.
///
/// When not to use it: for roughnesses above 2, whose grooves are narrower than the rule resolves.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/reflectance.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/plan/planner.hpp"
#include "vcavity/rough/rough_albedo.hpp"
#include "vcavity/rough/rough_bsdf.hpp"
#include "vcavity/rough/slope_distribution.hpp"

namespace vcavity {

namespace detail {

/// The share of the mean area that grooves narrower than an aperture have, at the worst of some azimuths of a quarter
/// turn. The distributions of this library have it on one of their axes, which are among them.
template <SlopeDistribution Distribution>
double share_of_narrower_grooves(const Distribution& distribution, double aperture) {
  double sum = 0;
  for_each_part(distribution, 1.0, [&](const auto& part, double share) {
    const auto share_at = [&](double u_azimuth) {
      // The larger the random number of the slope, the steeper the facets.
      double wider = 0, narrower = 1;
      for (int digit = 0; digit < std::numeric_limits<double>::digits; ++digit) {
        const double middle = (wider + narrower) / 2;
        const Vec3<double> m = part.sample({middle, u_azimuth});
        (2 * std::atan2(m.z, std::hypot(m.x, m.y)) < aperture ? narrower : wider) = middle;
      }
      return 1 - wider;
    };
    constexpr int azimuths = 16;
    double largest_share = 0;
    for (int i = 0; i <= azimuths; ++i)
      largest_share = at_least(largest_share, share_at(0.25 * i / azimuths));
    sum += share * largest_share;
  });
  return sum;
}

/// The errors of leaving out effects, averaged over the grooves of a distribution, in the worst of some directions.
template <SlopeDistribution Distribution, class Facet>
Omissions worst_rough_omissions(const Distribution& distribution, const Facet& facet) {
  constexpr int slopes = 48;
  constexpr int azimuths = 8;  // of a half-circle: the other half has the same grooves
  constexpr double margin = 1.5;
  constexpr std::array angles_deg{0.0, 20.0, 40.0, 55.0, 67.0, 76.0, 83.0, 87.0, 89.5};
  constexpr std::size_t directions = 3;  // of the light over the grooves, in a quarter turn
  const TriedFacet<Facet> tried(facet);
  std::array<std::array<Omissions, directions>, angles_deg.size()> sums;
  for (auto& row : sums) row.fill(Omissions(0.0));
  for (int i = 0; i < slopes; ++i) {
    // u = 1 − t⁴: long ways are those of the few steepest grooves, at the end u = 1.
    const double t = (i + 0.5) / slopes;
    const double density = 4 * t * t * t;
    for (int j = 0; j < azimuths; ++j) {
      const Vec3<double> m = distribution.sample({1 - t * t * t * t, 0.5 * (j + 0.5) / azimuths});
      const double across = std::hypot(m.x, m.y);
      const Cavity<double> cavity(2 * std::atan2(m.z, across));
      const Vec2<double> y_axis{m.x / across, m.y / across};
      for (std::size_t row = 0; row < angles_deg.size(); ++row) {
        for (std::size_t column = 0; column < directions; ++column) {
          const double theta = radians(angles_deg[row]);
          const double phi = static_cast<double>(column) * pi<double>() / (2 * (directions - 1));
          const Vec3<double> e{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta)};
          const Vec3<double> in_groove{e.x * y_axis.y - e.y * y_axis.x, e.x * y_axis.x + e.y * y_axis.y, e.z};
          sums[row][column] = sums[row][column] + density * directional_reflectance(cavity, in_groove, tried);
        }
      }
    }
  }
  Omissions worst(0.0);
  for (const auto& row : sums)
    for (const Omissions& sum : row)
      for (std::size_t i = 0; i <= longest_cutoff; ++i) worst[i] = at_least(worst[i], sum[i]);
  Omissions bounds = (margin / (slopes * azimuths)) * worst;
  for (std::size_t most = 1; most <= longest_cutoff; ++most)
    bounds[most - 1] = at_most(
        bounds[most - 1], share_of_narrower_grooves(distribution, pi<double>() / static_cast<double>(most)));
  return bounds;
}

}  // namespace detail

/// The cheapest plan for a rough surface of one facet material.
///
/// The tolerance is shared equally among polarisation and bounces; what polarisation leaves of its share, once it is not
/// followed, the bounces get too. So a looser tolerance never asks for more. Rounding is not planned: the relative error of
/// a BRDF in float is some 1e-6, and weights of samples carry no more.
///
/// @param distribution of the slopes
/// @param facet facet with amplitudes, such as `Conductor` or `Dielectric`
/// @param tolerance largest absolute error of the directional albedo, > 0
/// @throws std::invalid_argument when the tolerance is not a positive number
template <SlopeDistribution Distribution, FieldReflector<double> Facet>
EffectsPlan plan_rough_effects(const Distribution& distribution, const Facet& facet, double tolerance) {
  if (!(tolerance > 0)) {
    throw_invalid_argument("the tolerance of a plan must be positive, not ", tolerance);
  }
  const double share = tolerance / 2;
  const detail::Omissions errors = detail::worst_rough_omissions(distribution, facet);
  EffectsPlan plan{true, all_bounces, true, {0, 0, 0, 0}};
  if (const double error = errors[detail::longest_cutoff]; error <= share) {
    plan.polarization = false;
    plan.bounds.polarization = error;
  }
  const double rest = plan.polarization ? share : tolerance - plan.bounds.polarization;
  for (std::size_t most = 1; most <= detail::longest_cutoff; ++most) {
    if (errors[most - 1] > rest) continue;
    plan.max_bounces = static_cast<int>(most);
    plan.bounds.bounces = errors[most - 1];
    break;
  }
  return plan;
}

}  // namespace vcavity
