// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A function given by samples, linear in between.

#include <vector>

namespace vcavity::tools {

/// Piecewise linear interpolation; never beyond the outermost samples.
class LinearTable {
 public:
  /// A sample of the function.
  struct Sample {
    double x;
    double y;
  };

  /// @param samples at least one, in any order; those at the same x are replaced by their mean
  explicit LinearTable(std::vector<Sample> samples);

  double min_x() const { return samples_.front().x; }
  double max_x() const { return samples_.back().x; }

  /// Where the samples are, in ascending order.
  std::vector<double> nodes() const;

  /// The function's value at min_x() <= x <= max_x().
  double at(double x) const;

 private:
  std::vector<Sample> samples_;  // ascending in x, no x twice
};

}  // namespace vcavity::tools
