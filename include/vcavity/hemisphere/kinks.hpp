// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Where the weights of the lobes change slope, and with them every integrand over directions.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vcavity/groove/cavity.hpp"

namespace vcavity::detail {

/// Puts angles into ascending order, each only once.
template <class Real>
void sort_angles(std::vector<Real>& angles) {
  std::sort(angles.begin(), angles.end());
  const Real rounding = Real(8) * std::numeric_limits<Real>::epsilon();
  const auto coincide = [&rounding](const Real& a, const Real& b) { return b - a < rounding; };
  angles.erase(std::unique(angles.begin(), angles.end(), coincide), angles.end());
}

/// For light that meets panel one first: the angles θ' in [−α/2, π/2], ascending and with both ends, between
/// which the weights of its lobes are smooth and no cosine of incidence passes `critical_cosine` at ψ = 0.
template <class Real>
std::vector<Real> kinks_of_panel(const Cavity<Real>& cavity, const Real& critical_cosine) {
  using std::asin;
  const Real half_aperture = cavity.aperture() / Real(2);
  const Real half_pi = pi<Real>() / Real(2);
  const int images = cavity.max_bounces() + 1;
  std::vector<Real> kinks{-half_aperture, half_pi};
  const auto add_between = [&kinks](const Real& low, const Real& high, const Real& angle) {
    if (angle > low && angle < high) kinks.push_back(angle);
  };
  add_between(-half_aperture, half_pi, half_aperture);
  for (int j = 1; j <= images; ++j) {
    // Panel one alone lit: f_j leaves 1, and f_(j+1) reaches 0, at multiples of α/2 from grazing. Both panels
    // lit: f_j leaves its upper bound where c_j = c_1, which is there too, and its lower one where c_j = 0.
    add_between(j > 1 ? Real(-half_aperture) : half_aperture, half_pi, half_pi - Real(j) * half_aperture);
    add_between(-half_aperture, half_aperture, pi<Real>() - Real(2 * j - 1) * half_aperture);
  }
  if (critical_cosine > Real(0)) {
    const Real turn = asin(critical_cosine);
    for (int j = 1; j <= images; ++j) {
      const Real image = Real(2 * j - 1) * half_aperture;
      add_between(-half_aperture, half_pi, turn - image);
      add_between(-half_aperture, half_pi, pi<Real>() - turn - image);
    }
  }
  sort_angles(kinks);
  return kinks;
}

/// The same for all light: the angles θ' in [0, π/2].
template <class Real>
std::vector<Real> kinks_across(const Cavity<Real>& cavity, const Real& critical_cosine) {
  std::vector<Real> kinks = kinks_of_panel(cavity, critical_cosine);
  for (Real& angle : kinks) angle = magnitude(angle);
  kinks.push_back(Real(0));
  sort_angles(kinks);
  return kinks;
}

}  // namespace vcavity::detail
