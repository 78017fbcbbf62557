// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Where the weights of the lobes change slope, and with them the reflectance as a function of the direction.
///
/// All kinks are great half-circles through the ends of the groove: they are known by the angle θ' of a direction,
/// projected on the plane across the groove (Eq. 7), positive towards +y, where the light faces panel one. A groove of
/// another shape that is integrated between its kinks brings a function `kinks` of its own with the same parameters.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/numbers/components.hpp"

namespace vcavity {

/// Puts angles into ascending order, each only once.
/// @param angles in radians; such as differ by rounding (8 ε) count as one
template <class Real>
void sort_angles(std::vector<Real>& angles) {
  std::sort(angles.begin(), angles.end());
  const Real rounding = Real(8) * std::numeric_limits<Real>::epsilon();
  const auto coincide = [&rounding](const Real& a, const Real& b) { return b - a < rounding; };
  angles.erase(std::unique(angles.begin(), angles.end(), coincide), angles.end());
}

/// For light that meets one panel first: the angles θ' between which the weights of its lobes are smooth and no cosine
/// of incidence passes a critical one at ψ = 0.
/// @param cavity the groove
/// @param first the panel met first
/// @param critical_cosine of the facet; 0 if it has none
/// @return ascending, with both ends: −α/2 and π/2 for panel one, mirrored for panel two
template <class Real>
std::vector<Real> kinks(const Cavity<Real>& cavity, Panel first, const Real& critical_cosine = Real(0)) {
  using std::asin;
  const Real half_aperture = cavity.aperture() / Real(2);
  const Real half_pi = pi<Real>() / Real(2);
  const int images = cavity.max_bounces() + 1;
  std::vector<Real> angles{-half_aperture, half_pi};
  const auto add_between = [&angles](const Real& low, const Real& high, const Real& angle) {
    if (angle > low && angle < high) angles.push_back(angle);
  };
  add_between(-half_aperture, half_pi, half_aperture);
  for (int j = 1; j <= images; ++j) {
    // The first panel alone lit: f_j leaves 1, and f_(j+1) reaches 0, at multiples of α/2 from grazing. Both panels
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
  if (first == Panel::two)
    for (Real& angle : angles) angle = -angle;
  sort_angles(angles);
  return angles;
}

/// The same for all light of a symmetric groove.
/// @param cavity the groove
/// @param critical_cosine of the facet; 0 if it has none
/// @return the angles |θ'| in [0, π/2], ascending, with both ends
template <class Real>
std::vector<Real> kinks(const Cavity<Real>& cavity, const Real& critical_cosine = Real(0)) {
  std::vector<Real> angles = kinks(cavity, Panel::one, critical_cosine);
  for (Real& angle : angles) angle = magnitude(angle);
  angles.push_back(Real(0));
  sort_angles(angles);
  return angles;
}

}  // namespace vcavity
