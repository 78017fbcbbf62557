// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A parallel beam traced through the groove in real space, in 50 digits: reflected at one panel after the
/// other, and clipped at the rims. No unfolding, no formula for fractions or bounce counts; a second road to
/// everything that `lobes.hpp` and `bounces.hpp` compute.

#include <algorithm>
#include <vcavity/conventions.hpp>
#include <vector>

#include "support/reals.hpp"

namespace vcavity::test {

/// The rays that leave after the same bounces.
struct TracedLobe {
  Panel first_panel;
  int bounces;
  Digits50 weight;                ///< fraction of the opening
  std::vector<Digits50> cosines;  ///< of incidence, bounce by bounce
};

namespace detail {

/// A vector in the plane across the groove.
struct Across {
  Digits50 y, z;
  friend Digits50 cross(const Across& a, const Across& b) { return a.y * b.z - a.z * b.y; }
  friend Digits50 dot(const Across& a, const Across& b) { return a.y * b.y + a.z * b.z; }
};

/// Follows the rays that strike `panel` between the distances `near` and `far` from the apex.
/// @param weight_per_length fraction of the opening for each unit of that distance
inline void trace_beam(const Digits50& sine, const Digits50& cosine, Panel panel, Across d, Digits50 near,
                       Digits50 far, Digits50 weight_per_length, TracedLobe lobe,
                       std::vector<TracedLobe>& result) {
  for (lobe.bounces = 1;; ++lobe.bounces) {
    const Digits50 side = panel == Panel::one ? Digits50(-1) : Digits50(1);
    const Across along{Digits50(side * sine), cosine};
    const Across opposite_along{Digits50(-side * sine), cosine};
    const Across normal{Digits50(-side * cosine), sine};
    const Digits50 incidence = -dot(d, normal);
    lobe.cosines.push_back(incidence);
    d = Across{Digits50(d.y + 2 * incidence * normal.y), Digits50(d.z + 2 * incidence * normal.z)};

    // The ray from distance u along this panel meets the other one at distance stretch · u, if at all.
    const Digits50 crossing = cross(opposite_along, d);
    Digits50 last_to_stay(0);
    Digits50 stretch(0);
    if (crossing != 0) {
      stretch = cross(along, d) / crossing;
      const Across path{Digits50(stretch * opposite_along.y - along.y),
                        Digits50(stretch * opposite_along.z - along.z)};
      if (stretch > 0 && dot(path, d) > 0) last_to_stay = 1 / stretch;
    }
    const Digits50 first_to_leave = std::clamp(last_to_stay, near, far);
    lobe.weight = (far - first_to_leave) * weight_per_length;
    if (lobe.weight > 0) result.push_back(lobe);
    if (!(first_to_leave > near)) return;
    far = first_to_leave * stretch;
    near = near * stretch;
    weight_per_length /= stretch;
    panel = opposite(panel);
  }
}

}  // namespace detail

/// The cosines of incidence of a ray reflected `count` times by alternating panels, whether it meets them or
/// not.
inline std::vector<Digits50> reflected_cosines(const Digits50& aperture, const Digits50& e_y,
                                               const Digits50& e_z, Panel first, int count) {
  const Digits50 half = std::min(aperture, pi<Digits50>()) / 2;
  const Digits50 sine = sin(half);
  const Digits50 cosine = std::max(Digits50(cos(half)), Digits50(0));
  detail::Across d{Digits50(-e_y), Digits50(-e_z)};
  Digits50 side = first == Panel::one ? Digits50(-1) : Digits50(1);
  std::vector<Digits50> cosines;
  for (int j = 0; j < count; ++j, side = -side) {
    const detail::Across normal{Digits50(-side * cosine), sine};
    cosines.push_back(-dot(d, normal));
    d = {Digits50(d.y + 2 * cosines.back() * normal.y), Digits50(d.z + 2 * cosines.back() * normal.z)};
  }
  return cosines;
}

/// The lobes of a direction.
/// @param aperture in (0, π], or what rounds to π
/// @param e_y, e_z components of the direction towards the light, e_z ≥ 0, not both 0
inline std::vector<TracedLobe> traced_lobes(const Digits50& aperture, const Digits50& e_y, Digits50 e_z) {
  if (e_z == 0) e_z = abs(e_y) * Digits50("1e-40");  // the limit of grazing light
  const Digits50 half = std::min(aperture, pi<Digits50>()) / 2;
  const Digits50 sine = sin(half);
  const Digits50 cosine = std::max(Digits50(cos(half)), Digits50(0));
  const detail::Across d{Digits50(-e_y), Digits50(-e_z)};
  const Digits50 through_apex = std::clamp(Digits50(cosine * e_y / e_z), Digits50(-sine), sine);

  std::vector<TracedLobe> result;
  for (const Panel panel : {Panel::one, Panel::two}) {
    const Digits50 side = panel == Panel::one ? Digits50(-1) : Digits50(1);
    const Digits50 low = panel == Panel::one ? Digits50(-sine) : through_apex;
    const Digits50 high = panel == Panel::one ? through_apex : sine;
    if (!(high > low)) continue;
    const detail::Across along{Digits50(side * sine), cosine};
    const auto distance = [&](const Digits50& y) {
      return Digits50(cross(detail::Across{y, cosine}, d) / cross(along, d));
    };
    const Digits50 a = distance(low);
    const Digits50 b = distance(high);
    const Digits50 weight_per_length = (high - low) / (2 * sine) / abs(Digits50(b - a));
    detail::trace_beam(sine, cosine, panel, d, std::min(a, b), std::max(a, b), weight_per_length,
                       {panel, 0, Digits50(0), {}}, result);
  }
  return result;
}

}  // namespace vcavity::test
