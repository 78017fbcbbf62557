// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Where the weights of the lobes change slope, and with them every integrand over directions.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <vector>

#include "cavity.hpp"

namespace vcavity::detail {

/// The angles θ' in [0, π/2], ascending and with both ends, between which the weights of all lobes are smooth
/// and no cosine of incidence passes `critical_cosine` at ψ = 0.
template <class Real>
std::vector<Real> kinks_across(const Cavity<Real>& cavity, const Real& critical_cosine) {
  using std::asin;
  const Real alpha = cavity.aperture();
  const Real half_pi = pi<Real>() / Real(2);
  const int images = cavity.max_bounces() + 1;
  std::vector<Real> kinks{Real(0), half_pi};
  const auto add_between = [&kinks](const Real& low, const Real& high, const Real& angle) {
    if (angle > low && angle < high) kinks.push_back(angle);
  };
  // Both panels lit: f_j leaves its upper bound where c_j = c_1, its lower one where c_j = 0, for either
  // first panel. One panel lit: f_j leaves 1, and reaches 0, at multiples of α/2 from grazing.
  add_between(Real(0), half_pi, alpha / Real(2));
  for (int j = 1; j <= images; ++j) {
    const Real equal = (pi<Real>() - Real(j) * alpha) / Real(2);
    const Real zero = pi<Real>() - (Real(j) - Real(0.5)) * alpha;
    add_between(Real(0), half_pi, equal);
    add_between(Real(0), alpha / Real(2), -equal);
    add_between(Real(0), alpha / Real(2), zero);
    add_between(Real(0), alpha / Real(2), -zero);
  }
  if (critical_cosine > Real(0)) {
    const Real turn = asin(critical_cosine);
    for (int j = 1; j <= images; ++j) {
      const Real image = (Real(j) - Real(0.5)) * alpha;
      for (const Real& angle : {Real(turn - image), Real(pi<Real>() - turn - image)}) {
        add_between(Real(0), half_pi, angle);
        add_between(Real(0), half_pi, -angle);
      }
    }
  }
  std::sort(kinks.begin(), kinks.end());
  const Real rounding = Real(8) * std::numeric_limits<Real>::epsilon();
  const auto coincide = [&rounding](const Real& a, const Real& b) { return b - a < rounding; };
  kinks.erase(std::unique(kinks.begin(), kinks.end(), coincide), kinks.end());
  return kinks;
}

/// The critical cosine of a facet; 0 if it has none or does not tell.
template <class Real, class Facet>
Real critical_cosine_of(const Facet& facet) {
  if constexpr (requires {
                  { facet.critical_cosine() } -> std::convertible_to<Real>;
                }) {
    return facet.critical_cosine();
  } else {
    return Real(0);
  }
}

}  // namespace vcavity::detail
