// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Thousands of bounces: rays in a groove of 0.01°, followed with every digit and without.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/groove_reference.hpp"
#include "accuracy/textbook_fresnel.hpp"
#include "accuracy/traced_beam.hpp"
#include "support/reals.hpp"

namespace vcavity::test {

inline constexpr int long_ways = 24;  ///< number of rays

/// Errors in ε up to each bounce, the largest among the rays.
struct LongWayErrors {
  std::vector<double> cosine;      ///< of the cosine of incidence
  std::vector<double> plain_turn;  ///< of the same if a plain recurrence had found it
  std::vector<double> throughput;  ///< relative error of the product of reflectances with n = 0.25 + 100i
};

namespace detail {

/// A turn by plain additions, as a recurrence without care would do it.
template <class Real>
struct PlainTurn {
  Real x, y, sine, versine;
  void turn() {
    const Real step_x = versine * x + sine * y;
    const Real step_y = sine * x - versine * y;
    x -= step_x;
    y += step_y;
  }
};

inline void keep_larger(double& largest, double error) {
  largest = std::max(largest, error);
}

/// Follows one ray to the last image of a panel that faces it.
template <class Real>
void follow(const Vec3<Real>& e, LongWayErrors& errors) {
  const Cavity<Real> cavity(radians(static_cast<Real>(0.01L)));
  const Real n(0.25), k(100);
  const Conductor<Real> mirror(n, k);
  const ReflectedRay<Digits50> exact(GrooveSection<Digits50>{Digits50(cavity.aperture())}, Digits50(e.y),
                                     Digits50(e.z), Panel::one, cavity.max_bounces());
  UnfoldedRay<Real> ray(cavity, e, Panel::one);
  const Real half_sine = cavity.sin_half();
  PlainTurn<Real> plain{ray.tangent_component(), ray.normal_component(),
                        Real(2) * half_sine * cavity.cos_half(), Real(2) * half_sine * half_sine};
  errors.cosine.resize(exact.cosines.size());
  errors.plain_turn.resize(exact.cosines.size());
  errors.throughput.resize(exact.cosines.size());
  Real throughput(1);
  Digits50 exact_throughput(1);
  for (std::size_t j = 0; j < exact.cosines.size() && exact.cosines[j] > 0; ++j) {
    const Digits50& cosine = exact.cosines[j];
    keep_larger(errors.cosine[j], error_in_epsilons(ray.normal_component(), cosine, 1));
    keep_larger(errors.plain_turn[j], error_in_epsilons(plain.y, cosine, 1));
    throughput *= mirror(ray.cosine());
    exact_throughput *=
        TextbookFresnel<Digits50>(Digits50(n - 1), Digits50(k), facet_cosine<Real>(cosine)).reflectance();
    keep_larger(errors.throughput[j], error_in_epsilons(throughput, exact_throughput));
    ray.advance();
    plain.turn();
  }
}

}  // namespace detail

/// The errors along rays in the plane across the groove and beside it.
template <class Real>
LongWayErrors errors_on_long_ways() {
  LongWayErrors errors;
  for (int i = 0; i < long_ways; ++i) {
    const double grazing = i / static_cast<double>(long_ways);
    const double theta = grazing * grazing * pi<double>() / 2;
    const double psi = i % 2 == 0 ? 0 : 0.37 * i / long_ways * pi<double>();
    detail::follow(
        Vec3<Real>{static_cast<Real>(std::sin(psi)), static_cast<Real>(std::cos(psi) * std::sin(theta)),
                   static_cast<Real>(std::cos(psi) * std::cos(theta))},
        errors);
  }
  for (auto* series : {&errors.cosine, &errors.plain_turn, &errors.throughput})
    std::partial_sum(series->begin(), series->end(), series->begin(),
                     [](double a, double b) { return std::max(a, b); });
  return errors;
}

}  // namespace vcavity::test
