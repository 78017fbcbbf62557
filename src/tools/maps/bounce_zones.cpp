// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/bounce_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vcavity/groove/lobes.hpp>

namespace vcavity::tools {
namespace {

struct BounceRange {
  int least = std::numeric_limits<int>::max();
  int most = 0;

  bool operator==(const BounceRange&) const = default;
};

BounceRange bounces_at(const Cavity<double>& cavity, double theta_across) {
  // A lobe of smaller weight is rounding, such as that of a bounce more at an aperture of 180°/k.
  constexpr double least_weight = 1e-9;
  BounceRange range;
  const Vec3<double> e{0, std::sin(theta_across), std::cos(theta_across)};
  for (const auto& lobe : lobes(cavity, e, [](double) { return 1.0; })) {
    if (lobe.weight < least_weight) continue;
    range.least = std::min(range.least, lobe.bounces);
    range.most = std::max(range.most, lobe.bounces);
  }
  return range;
}

}  // namespace

std::vector<BounceZone> bounce_zones(const Cavity<double>& cavity) {
  constexpr int steps = 4096;
  constexpr double precision = 1e-9;
  const auto angle = [](int step) { return std::numbers::pi / 2 * (step + 0.5) / steps; };

  BounceRange current = bounces_at(cavity, angle(0));
  std::vector<BounceZone> zones{{0, std::numbers::pi / 2, current.least, current.most}};
  for (int step = 1; step < steps; ++step) {
    const BounceRange next = bounces_at(cavity, angle(step));
    if (next == current) continue;
    double before = angle(step - 1);
    double after = angle(step);
    while (after - before > precision) {
      const double middle = std::midpoint(before, after);
      (bounces_at(cavity, middle) == current ? before : after) = middle;
    }
    zones.back().high = after;
    zones.push_back({after, std::numbers::pi / 2, next.least, next.most});
    current = next;
  }
  return zones;
}

}  // namespace vcavity::tools
