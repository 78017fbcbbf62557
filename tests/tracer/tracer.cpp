// SPDX-License-Identifier: BSD-3-Clause
#include "tracer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace tracer {
namespace {

// More bounces than any groove of a tenth of a degree allows.
constexpr std::size_t trapped_after = 2000;

std::vector<glm::dvec3> panel_normals(const Relief& relief) {
  std::vector<glm::dvec3> normals;
  for (std::size_t i = 1; i < relief.profile.size(); ++i) {
    const glm::dvec2 across = glm::normalize(relief.profile[i] - relief.profile[i - 1]);
    normals.emplace_back(0, -across.y, across.x);
  }
  return normals;
}

// The smallest distance, measured across the segment, to the edges that it passes and to the two that bound
// the panel where it stops. `stop` is the panel and the parameter along the segment, or none and infinity.
double clearance_of(const Relief& relief, glm::dvec3 origin, glm::dvec3 direction, std::optional<int> panel,
                    double distance) {
  const glm::dvec2 start{origin.y, origin.z};
  const glm::dvec2 along{direction.y, direction.z};
  const double speed = glm::length(along);
  double nearest = std::numeric_limits<double>::infinity();
  for (int edge = 0; edge <= relief.panels(); ++edge) {
    const glm::dvec2 to_edge = relief.profile[static_cast<std::size_t>(edge)] - start;
    const double foot = glm::dot(to_edge, along) / (speed * speed);
    const bool bounds_the_stop = panel && (edge == *panel || edge == *panel + 1);
    const bool is_passed = foot > 0 && foot < distance;
    if (bounds_the_stop || is_passed)
      nearest = std::min(nearest, std::abs(to_edge.x * along.y - to_edge.y * along.x) / speed);
  }
  return nearest;
}

}  // namespace

int bounces_in_other_grooves(const Path& path) {
  return static_cast<int>(std::ranges::count_if(path.bounces, [&](const Bounce& bounce) {
    return groove_of(bounce.panel) != groove_of(path.bounces.front().panel);
  }));
}

Tracer::Tracer(Relief relief)
    : relief_(std::move(relief)), normals_(panel_normals(relief_)), scene_(relief_) {}

Path Tracer::trace(glm::dvec3 origin, glm::dvec3 direction) const {
  Path path{{}, direction, origin, Ending::missed, std::numeric_limits<double>::infinity()};
  std::optional<int> left;
  while (path.bounces.size() < trapped_after) {
    const std::optional<int> panel = scene_.first_panel(origin, direction, left);
    if (!panel) break;
    const glm::dvec3 normal = normals_[static_cast<std::size_t>(*panel)];
    const glm::dvec2 edge = relief_.profile[static_cast<std::size_t>(*panel)];
    const double approach = glm::dot(direction, normal);
    const double distance = glm::dot(glm::dvec3(origin.x, edge) - origin, normal) / approach;
    path.clearance = std::min(path.clearance, clearance_of(relief_, origin, direction, panel, distance));
    path.bounces.push_back({*panel, -approach});
    origin += distance * direction;
    direction -= 2 * approach * normal;
    left = panel;
  }
  path.direction = direction;
  path.top = origin + (relief_.top() - origin.z) / direction.z * direction;
  path.clearance = std::min(path.clearance, clearance_of(relief_, origin, direction, std::nullopt,
                                                         std::numeric_limits<double>::infinity()));
  if (path.bounces.size() == trapped_after)
    path.ending = Ending::trapped;
  else if (!path.bounces.empty())
    path.ending =
        direction.z > 0 && std::abs(path.top.x) < relief_.length / 2 ? Ending::upwards : Ending::past_an_end;
  return path;
}

}  // namespace tracer
