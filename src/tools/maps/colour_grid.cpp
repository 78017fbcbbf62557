// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/colour_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vcavity::tools {
namespace {

constexpr double most_deviation = 0.0005;  // of a reflectance; a colour is the mean over many
constexpr double finest_nm = 1;

struct Sample {
  double nm;
  std::pair<double, double> reflectance;
};

double deviation(const Sample& sample, const Sample& first, const Sample& last) {
  const double share = (sample.nm - first.nm) / (last.nm - first.nm);
  const auto off = [share](double value, double low, double high) {
    return std::abs(value - std::lerp(low, high, share));
  };
  return std::max(off(sample.reflectance.first, first.reflectance.first, last.reflectance.first),
                  off(sample.reflectance.second, first.reflectance.second, last.reflectance.second));
}

/// Adds, between two samples, the one that is farthest off the straight line, if it is far off, and goes on with what
/// is left and right of it.
void add_between(const std::vector<Sample>& samples, std::size_t first, std::size_t last,
                 std::vector<double>& result) {
  std::size_t worst = first;
  double most = most_deviation;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double off = deviation(samples[i], samples[first], samples[last]); off > most) {
      most = off;
      worst = i;
    }
  if (worst == first) return;
  add_between(samples, first, worst, result);
  result.push_back(samples[worst].nm);
  add_between(samples, worst, last, result);
}

}  // namespace

std::vector<double> refined(const std::vector<double>& grid_nm,
                            const std::function<std::pair<double, double>(double)>& reflectance) {
  std::vector<double> result;
  for (std::size_t i = 0; i < grid_nm.size(); ++i) {
    result.push_back(grid_nm[i]);
    if (i + 1 == grid_nm.size() || !is_visible(grid_nm[i]) || !is_visible(grid_nm[i + 1])) continue;
    const int pieces = static_cast<int>(std::ceil((grid_nm[i + 1] - grid_nm[i]) / finest_nm));
    if (pieces < 2) continue;
    std::vector<Sample> samples;
    for (int piece = 0; piece <= pieces; ++piece) {
      const double nm = std::lerp(grid_nm[i], grid_nm[i + 1], static_cast<double>(piece) / pieces);
      samples.push_back({nm, reflectance(nm)});
    }
    add_between(samples, 0, samples.size() - 1, result);
  }
  return result;
}

}  // namespace vcavity::tools
