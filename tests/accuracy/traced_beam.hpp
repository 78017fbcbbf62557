// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Rays and parallel beams traced through the groove in real space: reflected at one panel after the other,
/// and clipped at the rims. No unfolding, no formula for fractions or bounce counts; a second road to
/// everything that `lobes.hpp` and `bounces.hpp` compute.

#include <algorithm>
#include <cmath>
#include <vcavity/conventions.hpp>
#include <vector>

namespace vcavity::test {

/// A vector in the plane across the groove.
template <class Wide>
struct Across {
  Wide y, z;
  friend Wide cross(const Across& a, const Across& b) { return a.y * b.z - a.z * b.y; }
  friend Wide dot(const Across& a, const Across& b) { return a.y * b.y + a.z * b.z; }
};

/// The groove as seen along it.
template <class Wide>
struct GrooveSection {
  Wide sine, cosine;  ///< of half the aperture

  /// @param aperture in (0, π], or what rounds to π
  explicit GrooveSection(const Wide& aperture) {
    using std::cos;
    using std::sin;
    const Wide half = std::min(aperture, pi<Wide>()) / 2;
    sine = sin(half);
    cosine = std::max(Wide(cos(half)), Wide(0));
  }

  /// The unit vector from the apex to the rim of a panel.
  Across<Wide> along(Panel panel) const { return {Wide(side(panel) * sine), cosine}; }

  /// The normal of a panel, into the groove.
  Across<Wide> normal(Panel panel) const { return {Wide(-side(panel) * cosine), sine}; }

 private:
  static int side(Panel panel) { return panel == Panel::one ? -1 : 1; }
};

/// What reflections at alternating panels make of the direction of a ray, whether it meets them or not.
template <class Wide>
struct ReflectedRay {
  std::vector<Wide> cosines;  ///< of incidence, bounce by bounce
  Across<Wide> direction;     ///< of travel, after the last bounce

  /// @param e_y, e_z components of the direction towards the light
  /// @param bounces number of reflections
  ReflectedRay(const GrooveSection<Wide>& groove, const Wide& e_y, const Wide& e_z, Panel first, int bounces)
      : direction{Wide(-e_y), Wide(-e_z)} {
    Panel panel = first;
    for (int j = 0; j < bounces; ++j, panel = opposite(panel)) {
      const Across<Wide> normal = groove.normal(panel);
      cosines.push_back(-dot(direction, normal));
      direction = {Wide(direction.y + 2 * cosines.back() * normal.y),
                   Wide(direction.z + 2 * cosines.back() * normal.z)};
    }
  }
};

/// The rays that leave after the same bounces.
template <class Wide>
struct TracedLobe {
  Panel first_panel;
  int bounces;
  Wide weight;                ///< fraction of the opening
  std::vector<Wide> cosines;  ///< of incidence, bounce by bounce
};

namespace detail {

/// Follows the rays that strike `panel` between the distances `near` and `far` from the apex.
/// @param d direction of travel
/// @param weight_per_length fraction of the opening for each unit of that distance
template <class Wide>
void trace_beam(const GrooveSection<Wide>& groove, Panel panel, Across<Wide> d, Wide near, Wide far,
                Wide weight_per_length, std::vector<TracedLobe<Wide>>& result) {
  TracedLobe<Wide> lobe{panel, 0, Wide(0), {}};
  for (lobe.bounces = 1;; ++lobe.bounces) {
    const Across<Wide> along = groove.along(panel);
    const Across<Wide> opposite_along = groove.along(opposite(panel));
    const Across<Wide> normal = groove.normal(panel);
    const Wide incidence = -dot(d, normal);
    lobe.cosines.push_back(incidence);
    d = {Wide(d.y + 2 * incidence * normal.y), Wide(d.z + 2 * incidence * normal.z)};

    // The ray from distance u along this panel meets the other one at distance stretch · u, if at all.
    const Wide crossing = cross(opposite_along, d);
    Wide last_to_stay(0);
    Wide stretch(0);
    if (crossing != 0) {
      stretch = cross(along, d) / crossing;
      const Across<Wide> path{Wide(stretch * opposite_along.y - along.y),
                              Wide(stretch * opposite_along.z - along.z)};
      if (stretch > 0 && dot(path, d) > 0) last_to_stay = 1 / stretch;
    }
    const Wide first_to_leave = std::clamp(last_to_stay, near, far);
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

/// The lobes of a direction.
/// @param e_y, e_z components of the direction towards the light, e_z ≥ 0, not both 0
template <class Wide>
std::vector<TracedLobe<Wide>> traced_lobes(const GrooveSection<Wide>& groove, const Wide& e_y, Wide e_z) {
  using std::abs;
  if (e_z == 0) e_z = abs(e_y) * Wide(1e-25L);  // the limit of grazing light
  const Across<Wide> d{Wide(-e_y), Wide(-e_z)};
  const Wide rim = groove.sine;
  const Wide through_apex = std::clamp(Wide(groove.cosine * e_y / e_z), Wide(-rim), rim);

  std::vector<TracedLobe<Wide>> result;
  for (const Panel panel : {Panel::one, Panel::two}) {
    const Wide low = panel == Panel::one ? Wide(-rim) : through_apex;
    const Wide high = panel == Panel::one ? through_apex : rim;
    if (!(high > low)) continue;
    const Across<Wide> along = groove.along(panel);
    const auto distance = [&](const Wide& y) {
      return Wide(cross(Across<Wide>{y, groove.cosine}, d) / cross(along, d));
    };
    const Wide a = distance(low);
    const Wide b = distance(high);
    const Wide weight_per_length = (high - low) / (2 * rim) / abs(Wide(b - a));
    detail::trace_beam(groove, panel, d, std::min(a, b), std::max(a, b), weight_per_length, result);
  }
  return result;
}

}  // namespace vcavity::test
