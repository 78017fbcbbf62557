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

// Embree's choice is doubted within this distance of an edge, in panel widths. The coordinates of a path, at
// most about 1, are rounded by half an epsilon in the ray, in the edge and in their difference; four leave no
// room for luck.
constexpr double doubtful = 4 * std::numeric_limits<float>::epsilon();

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

int bounces_in_other_grooves(const Path& path) {
  return static_cast<int>(std::ranges::count_if(
      path.bounces, [&](const Bounce& bounce) { return bounce.groove != path.bounces.front().groove; }));
}

Tracer::Tracer(Relief relief)
    : relief_(std::move(relief)), normals_(panel_normals(relief_)), scene_(relief_) {}

double Tracer::distance_to(int panel, glm::dvec3 origin, glm::dvec3 direction) const {
  const auto p = static_cast<std::size_t>(panel);
  const glm::dvec3 corner{origin.x, relief_.profile[p]};
  return glm::dot(corner - origin, normals_[p]) / glm::dot(direction, normals_[p]);
}

std::optional<int> Tracer::search_all_panels(glm::dvec3 origin, glm::dvec3 direction) const {
  std::optional<int> first;
  double nearest = infinity;
  for (int panel = 0; panel < relief_.panels(); ++panel) {
    const auto p = static_cast<std::size_t>(panel);
    if (glm::dot(direction, normals_[p]) >= 0) continue;
    const double distance = distance_to(panel, origin, direction);
    const glm::dvec3 point = origin + distance * direction;
    const glm::dvec2 along = relief_.profile[p + 1] - relief_.profile[p];
    const double reached = glm::dot(glm::dvec2(point.y, point.z) - relief_.profile[p], along);
    const bool is_on_panel =
        0 <= reached && reached <= glm::dot(along, along) && std::abs(point.x) <= relief_.length / 2;
    if (is_on_panel && distance > 0 && distance < nearest) {
      first = panel;
      nearest = distance;
    }
  }
  return first;
}

Tracer::Segment Tracer::segment_to(std::optional<int> panel, glm::dvec3 origin, glm::dvec3 direction) const {
  Segment segment{panel, panel ? distance_to(*panel, origin, direction) : infinity, infinity};
  const glm::dvec2 start{origin.y, origin.z};
  const glm::dvec2 along{direction.y, direction.z};
  const double speed = glm::length(along);
  for (int edge = 0; edge <= relief_.panels(); ++edge) {
    const glm::dvec2 to_edge = relief_.profile[static_cast<std::size_t>(edge)] - start;
    const double foot = glm::dot(to_edge, along) / (speed * speed);
    const bool is_passed = foot > 0 && foot < segment.distance;
    const bool bounds_the_stop = edge == panel || edge - 1 == panel;
    if (is_passed || bounds_the_stop)
      segment.clearance =
          std::min(segment.clearance, std::abs(to_edge.x * along.y - to_edge.y * along.x) / speed);
  }
  return segment;
}

Tracer::Segment Tracer::next_segment(glm::dvec3 origin, glm::dvec3 direction) const {
  const Segment segment = segment_to(scene_.first_panel(origin, direction), origin, direction);
  if (segment.clearance > doubtful) return segment;
  Segment refined = segment_to(search_all_panels(origin, direction), origin, direction);
  refined.refined = true;
  return refined;
}

Path Tracer::trace(glm::dvec3 origin, glm::dvec3 direction) const {
  Path path{{}, direction, origin, Ending::missed, infinity};
  for (;;) {
    const Segment segment = next_segment(origin, direction);
    path.clearance = std::min(path.clearance, segment.clearance);
    path.refined = path.refined || segment.refined;
    if (!segment.panel || path.bounces.size() == trapped_after) break;
    const glm::dvec3 normal = normals_[static_cast<std::size_t>(*segment.panel)];
    const double approach = glm::dot(direction, normal);
    path.bounces.push_back({*segment.panel, -approach, *segment.panel / relief_.panels_of_groove});
    origin += segment.distance * direction;
    direction -= 2 * approach * normal;
  }
  path.direction = direction;
  path.top = origin + (relief_.top() - origin.z) / direction.z * direction;
  if (path.bounces.size() == trapped_after)
    path.ending = Ending::trapped;
  else if (!path.bounces.empty())
    path.ending =
        direction.z > 0 && std::abs(path.top.x) < relief_.length / 2 ? Ending::upwards : Ending::past_an_end;
  return path;
}

}  // namespace tracer
