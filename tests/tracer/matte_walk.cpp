// SPDX-License-Identifier: BSD-3-Clause
#include "matte_walk.hpp"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>

namespace tracer {

MatteWalker::MatteWalker(Relief relief) : relief_(std::move(relief)), scene_(relief_) {}

MatteWalk MatteWalker::walk(glm::dvec3 origin, glm::dvec3 direction, agreement::Uniform& uniform) const {
  constexpr int lost_after = 10000;
  MatteWalk walk;
  while (walk.on_left + walk.on_right < lost_after) {
    const std::optional<int> panel = scene_.first_panel(origin, direction);
    if (!panel) break;
    ++(*panel % 2 == 0 ? walk.on_left : walk.on_right);
    const auto p = static_cast<std::size_t>(*panel);
    const glm::dvec2 along = glm::normalize(relief_.profile[p + 1] - relief_.profile[p]);
    const glm::dvec3 normal{0, -along.y, along.x}, tangent{0, along.x, along.y};
    const glm::dvec3 corner{origin.x, relief_.profile[p]};
    origin += glm::dot(corner - origin, normal) / glm::dot(direction, normal) * direction;
    const double sine = std::sqrt(uniform());
    const double azimuth = 2 * std::numbers::pi * uniform();
    direction = std::sqrt(1 - sine * sine) * normal + sine * std::cos(azimuth) * tangent +
                glm::dvec3(sine * std::sin(azimuth), 0, 0);
  }
  walk.direction = direction;
  walk.escaped = walk.on_left + walk.on_right > 0 && direction.z > 0;
  return walk;
}

}  // namespace tracer
