// SPDX-License-Identifier: BSD-3-Clause
#include "relief.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tracer {

double Relief::top() const {
  return std::ranges::max_element(profile, {}, &glm::dvec2::y)->y;
}

Relief groove_array(double aperture, int grooves, double length) {
  if (!(aperture > 0 && aperture <= std::numbers::pi))
    throw std::invalid_argument("aperture " + std::to_string(aperture) +
                                " rad: expected more than 0, at most pi");
  if (grooves < 1 || grooves % 2 == 0)
    throw std::invalid_argument(std::to_string(grooves) + " grooves: expected an odd number");
  if (!(length > 0))
    throw std::invalid_argument("groove length " + std::to_string(length) + ": expected more than 0");

  const double half_width = std::sin(aperture / 2);
  const double depth = std::cos(aperture / 2);
  Relief relief{{}, length};
  for (int edge = -grooves; edge <= grooves; ++edge) {
    const bool is_apex = (edge + grooves) % 2 == 1;
    relief.profile.emplace_back(edge * half_width, is_apex ? 0 : depth);
  }
  return relief;
}

Relief profile_array(const std::vector<glm::dvec2>& period, int grooves, double length) {
  if (period.size() < 2) throw std::invalid_argument("a cross-section of less than two points");
  if (grooves < 1 || grooves % 2 == 0)
    throw std::invalid_argument(std::to_string(grooves) + " grooves: expected an odd number");
  if (!(length > 0))
    throw std::invalid_argument("groove length " + std::to_string(length) + ": expected more than 0");
  const double width = period.back().x - period.front().x;
  if (!(width > 0) || period.back().y != period.front().y)
    throw std::invalid_argument("a cross-section that does not lead on to the next groove");

  Relief relief{
      {period.front() - glm::dvec2(width * (grooves / 2), 0)}, length, static_cast<int>(period.size()) - 1};
  for (int groove = -(grooves / 2); groove <= grooves / 2; ++groove)
    for (std::size_t i = 1; i < period.size(); ++i)
      relief.profile.emplace_back(period[i] + glm::dvec2(width * groove, 0));
  return relief;
}

}  // namespace tracer
