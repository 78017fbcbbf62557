// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/environment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tools/support/utf8.hpp"

namespace vcavity::tools {

Environment::Environment(const std::filesystem::path& path)
    : name_(valid_utf8(path.string())), sky_(read_sky(path)) {}

glm::dvec3 Environment::pixel(int column, int row) const {
  const int wrapped = (column % sky_.width + sky_.width) % sky_.width;
  const int clamped = std::clamp(row, 0, sky_.height - 1);
  return sky_.pixels[static_cast<std::size_t>(clamped) * static_cast<std::size_t>(sky_.width) +
                     static_cast<std::size_t>(wrapped)];
}

glm::dvec3 Environment::radiance(const Vec3<double>& from) const {
  const double azimuth = std::atan2(from.x, from.y);
  const double polar = std::atan2(std::hypot(from.x, from.y), from.z);
  const double x = (0.5 + azimuth / (2 * pi<double>())) * sky_.width - 0.5;
  const double y = polar / pi<double>() * sky_.height - 0.5;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const double right = x - column;
  const double down = y - row;
  return (1 - down) * ((1 - right) * pixel(column, row) + right * pixel(column + 1, row)) +
         down * ((1 - right) * pixel(column, row + 1) + right * pixel(column + 1, row + 1));
}

}  // namespace vcavity::tools
