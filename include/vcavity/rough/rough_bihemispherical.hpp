// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bi-hemispherical reflectance of a rough surface: diffuse light in, all reflected light out.
///
/// Diffuse light has no azimuth. So that of the grooves plays no part, and what is left is one integral over their
/// apertures,
///
///     R = ∫ p(α) R_V(α) dα,
///
/// with the bi-hemispherical reflectance R_V of equal grooves. Method: R_V is smooth between the apertures π/k. It
/// is asked for at Gauss–Legendre nodes of such intervals, of halves of the last one below π/16, and the Legendre
/// series through these values is integrated over the distribution, which costs next to nothing; its last terms
/// tell the error. The narrowest grooves, of less area or reflectance than the tolerance lets matter, are bounded:
/// since narrower grooves reflect less, R_V there lies between 0 and that at the end.

#include <array>
#include <cstddef>
#include <limits>

#include "vcavity/hemisphere/bihemispherical.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/rough/rough_albedo.hpp"

namespace vcavity {

namespace detail {

/// A Legendre series of as many terms as the rule has nodes.
template <class Real>
using LegendreTerms = Pack<Real, GaussWithSeries<Real>::order>;

/// The values of the Legendre polynomials at x.
template <class Real>
LegendreTerms<Real> legendre_polynomials(const Real& x) {
  LegendreTerms<Real> result;
  Real before(0), polynomial(1);
  for (std::size_t degree = 0; degree < GaussWithSeries<Real>::order; ++degree) {
    result[degree] = polynomial;
    const Real n = static_cast<Real>(degree);
    const Real next = ((Real(2) * n + Real(1)) * x * polynomial - n * before) / (n + Real(1));
    before = polynomial;
    polynomial = next;
  }
  return result;
}

/// The Legendre polynomials averaged over the grooves of an interval of apertures, which has the ends −1 and 1; the
/// first one gives the share of the area that they have.
template <SlopeDistribution Distribution>
Quadrature<LegendreTerms<scalar_t<Distribution>>> aperture_moments(const Distribution& distribution,
                                                                   const scalar_t<Distribution>& low,
                                                                   const scalar_t<Distribution>& high,
                                                                   const scalar_t<Distribution>& tolerance) {
  using Real = scalar_t<Distribution>;
  using Terms = LegendreTerms<Real>;
  using std::cos;
  using std::sin;
  return mean_over_azimuths<Terms>(
      distribution, tolerance, [&](const auto& part, const Real& u_azimuth, const Real& inner_tolerance) {
        const GroovesOfAzimuth grooves(part, u_azimuth);
        const Real end = pi<Real>() / Real(2);
        const Real from = high < pi<Real>() ? grooves.chi(high, Real(0), end) : Real(0);
        const Real to = low > Real(0) ? grooves.chi(low, from, end) : end;
        const auto polynomials = [&](const Real& chi) {
          const Real x = (Real(2) * grooves.aperture(chi) - (low + high)) / (high - low);
          const Real weight = Real(2) * Real(sin(chi)) * Real(cos(chi));
          return Quadrature<Terms>{weight * legendre_polynomials(x), Real(0), 1};
        };
        constexpr int halvings = 12;
        return integrate<Terms>(polynomials, from, to, inner_tolerance, halvings);
      });
}

/// The part of the bi-hemispherical reflectance that belongs to the grooves of an interval of apertures.
/// @param tolerance absolute error to aim at
/// @param halvings how often the interval may be halved
template <SlopeDistribution Distribution, class Facet>
Quadrature<unpolarized_t<Facet, scalar_t<Distribution>>> reflectance_of_apertures(
    const Distribution& distribution, const scalar_t<Distribution>& low, const scalar_t<Distribution>& high,
    const Facet& facet, const scalar_t<unpolarized_t<Facet, scalar_t<Distribution>>>& tolerance,
    int max_bounces, int halvings) {
  using Real = scalar_t<Distribution>;
  using Value = unpolarized_t<Facet, Real>;
  using Scalar = scalar_t<Value>;
  using Rule = GaussWithSeries<Real>;
  const auto moments = aperture_moments(distribution, low, high, Real(tolerance / Scalar(4)));
  const Scalar share = static_cast<Scalar>(moments.value[0]);
  Quadrature<Value> result{Value(0), static_cast<Scalar>(moments.error), 0};
  if (share <= tolerance / Scalar(2)) {
    result.error += share;
    return result;
  }
  std::array<Value, Rule::order> series;
  series.fill(Value(0));
  for (const auto& node : Rule::get().nodes()) {
    const Cavity<Real> groove((low + high) / Real(2) + (high - low) / Real(2) * node.x);
    const auto at =
        vcavity::bihemispherical_reflectance(groove, facet, tolerance / (Scalar(4) * share), max_bounces);
    result.evaluations += at.evaluations;
    result.error += share * at.error * static_cast<Scalar>(node.weight / Real(2));
    const auto polynomials = legendre_polynomials(node.x);
    for (std::size_t degree = 0; degree < Rule::order; ++degree) {
      const Real norm = (Real(static_cast<int>(degree)) + Real(0.5)) * node.weight;
      series[degree] = series[degree] + scaled(Real(norm * polynomials[degree]), at.value);
    }
  }
  for (std::size_t degree = 0; degree < Rule::order; ++degree)
    result.value = result.value + scaled(moments.value[degree], series[degree]);
  const Scalar truncation = share * (largest(series[Rule::order - 2]) + largest(series[Rule::order - 1]));
  if (truncation <= tolerance / Scalar(2) || halvings == 0) {
    result.error += truncation;
    return result;
  }
  const Real middle = (low + high) / Real(2);
  const auto halves = reflectance_of_apertures(distribution, low, middle, facet,
                                               Scalar(tolerance / Scalar(2)), max_bounces, halvings - 1) +
                      reflectance_of_apertures(distribution, middle, high, facet,
                                               Scalar(tolerance / Scalar(2)), max_bounces, halvings - 1);
  return {halves.value, halves.error, halves.evaluations + result.evaluations};
}

}  // namespace detail

/// Bi-hemispherical reflectance of a distribution of grooves, with an estimate of its error and its cost.
///
/// @param distribution of the grooves
/// @param facet facet reflectance
/// @param tolerance absolute error to aim at, > 0
/// @param max_bounces light that needs more bounces is lost
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the reflectance of unpolarised light
template <SlopeDistribution Distribution, FacetReflectance<scalar_t<Distribution>> Facet>
Integral<unpolarized_t<Facet, scalar_t<Distribution>>> bihemispherical_reflectance(
    const Distribution& distribution, const Facet& facet,
    const scalar_t<unpolarized_t<Facet, scalar_t<Distribution>>>& tolerance, int max_bounces = all_bounces) {
  using Real = scalar_t<Distribution>;
  using Value = unpolarized_t<Facet, Real>;
  using Scalar = scalar_t<Value>;
  detail::require_tolerance(tolerance, "bi-hemispherical reflectance");
  constexpr int last_count = 16;  // down to π/16 there is a kink that matters at every π/k
  constexpr int halvings = 6;
  const Real narrowest = static_cast<Real>(2e-4);  // narrower ones are 1e-8 of the area of GGX 1
  const Scalar part = tolerance / Scalar(4);
  detail::Quadrature<Value> sum{Value(0), Scalar(0), 0};
  Real high = pi<Real>();
  for (int k = 1;; ++k) {
    const Real low = k < last_count ? Real(pi<Real>() / Real(k + 1)) : Real(high / Real(2));
    sum = sum + detail::reflectance_of_apertures(distribution, low, high, facet,
                                                 Scalar(part / Scalar(k < 4 ? 4 : last_count)), max_bounces,
                                                 halvings);
    high = low;
    const auto rest = detail::aperture_moments(distribution, Real(0), high, Real(part / Scalar(4)));
    const Scalar share = static_cast<Scalar>(rest.value[0]);
    if (share > part && k < last_count) continue;
    // What is left reflects at most as much as the widest of these grooves.
    Value half = Value(0);
    Scalar error = share;
    if (share > part) {
      const auto widest =
          bihemispherical_reflectance(Cavity<Real>(high), facet, part / (Scalar(4) * share), max_bounces);
      half = Scalar(0.5) * (share * widest.value);
      error = largest(half) + share * widest.error;
      sum.evaluations += widest.evaluations;
    }
    if (error <= part || high < narrowest)
      return {sum.value + half, detail::at_most_all_light(Scalar(sum.error + error)), sum.evaluations};
  }
}

}  // namespace vcavity
