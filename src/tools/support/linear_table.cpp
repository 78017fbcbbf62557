// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/linear_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vcavity::tools {

LinearTable::LinearTable(std::vector<Sample> samples) {
  assert(!samples.empty());
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.x < b.x; });
  for (auto group = samples.begin(); group != samples.end();) {
    const double x = group->x;
    double sum = 0;
    double count = 0;
    for (; group != samples.end() && group->x == x; ++group, ++count) sum += group->y;
    samples_.push_back({x, sum / count});
  }
}

std::vector<double> LinearTable::nodes() const {
  std::vector<double> xs;
  for (const Sample& sample : samples_) xs.push_back(sample.x);
  return xs;
}

double LinearTable::at(double x) const {
  assert(min_x() <= x && x <= max_x());
  const auto above = std::lower_bound(samples_.begin(), samples_.end(), x,
                                      [](const Sample& s, double value) { return s.x < value; });
  if (above == samples_.begin()) return above->y;
  const auto below = above - 1;
  return std::lerp(below->y, above->y, (x - below->x) / (above->x - below->x));
}

}  // namespace vcavity::tools
