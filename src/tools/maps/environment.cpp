// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/environment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "tools/images/exr.hpp"

namespace vcavity::tools {

Environment::Environment(const std::filesystem::path& path) : name_(path.string()) {
  const ExrImage image = read_exr(path);
  width_ = image.width;
  height_ = image.height;
  const auto has = [&image](const char* name) {
    return std::any_of(image.channels.begin(), image.channels.end(),
                       [name](const ExrChannel& channel) { return channel.name == name; });
  };
  const bool coloured = has("R") && has("G") && has("B");
  if (!coloured && !has("Y"))
    throw std::runtime_error("cannot read '" + path.string() +
                             "': an environment has channels R, G and B, or Y");
  const std::vector<float>& r = image.plane(coloured ? "R" : "Y");
  const std::vector<float>& g = image.plane(coloured ? "G" : "Y");
  const std::vector<float>& b = image.plane(coloured ? "B" : "Y");
  for (std::size_t i = 0; i < r.size(); ++i) pixels_.emplace_back(r[i], g[i], b[i]);
}

const glm::dvec3& Environment::pixel(int column, int row) const {
  const int wrapped = (column % width_ + width_) % width_;
  const int clamped = std::clamp(row, 0, height_ - 1);
  return pixels_[static_cast<std::size_t>(clamped) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(wrapped)];
}

glm::dvec3 Environment::radiance(const Vec3<double>& from) const {
  const double azimuth = std::atan2(from.x, from.y);
  const double polar = std::atan2(std::hypot(from.x, from.y), from.z);
  const double x = (0.5 + azimuth / (2 * pi<double>())) * width_ - 0.5;
  const double y = polar / pi<double>() * height_ - 0.5;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const double right = x - column;
  const double down = y - row;
  return (1 - down) * ((1 - right) * pixel(column, row) + right * pixel(column + 1, row)) +
         down * ((1 - right) * pixel(column, row + 1) + right * pixel(column + 1, row + 1));
}

}  // namespace vcavity::tools
