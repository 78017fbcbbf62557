// SPDX-License-Identifier: BSD-3-Clause
#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace agreement {

ShiftedLattice::ShiftedLattice(std::uint64_t seed, int replicate) {
  Uniform uniform(seed * replicates + static_cast<std::uint64_t>(replicate));
  for (double& coordinate : shift_) coordinate = uniform();
}

std::array<double, 3> ShiftedLattice::operator[](int i) const {
  constexpr std::array step{std::numbers::sqrt2, std::numbers::sqrt3,
                            2 * std::numbers::phi};  // 2 phi = 1 + sqrt 5
  std::array<double, 3> point;
  for (std::size_t k = 0; k < point.size(); ++k) {
    const double x = shift_[k] + i * step[k];
    point[k] = x - std::floor(x);
  }
  return point;
}

void ReplicatedMean::end_replicate() {
  const double value = sum_ / count_;
  ++replicates_;
  const double deviation = value - mean_;
  mean_ += deviation / replicates_;
  squares_ += deviation * (value - mean_);
  sum_ = 0;
  count_ = 0;
}

double ReplicatedMean::standard_error() const {
  return std::sqrt(squares_ / (static_cast<double>(replicates_) * (replicates_ - 1)));
}

double allowed_sigmas(int cases) {
  const double rate_per_case = -std::expm1(std::log1p(-false_alarm_rate) / cases);
  double low = 0, high = 40;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::sqrt(2.0)) > rate_per_case ? low : high) = middle;
  }
  return high;
}

std::vector<MeanComparison> failures(const std::vector<MeanComparison>& comparisons) {
  const double sigmas = allowed_sigmas(static_cast<int>(comparisons.size()));
  std::vector<MeanComparison> failed;
  std::ranges::copy_if(comparisons, std::back_inserter(failed), [&](const MeanComparison& comparison) {
    // Where all rays have one reflectance only rounding is left of the spread.
    const double rounding = 1e-11 * comparison.traced;
    const double allowed = std::min(sigmas * comparison.standard_error + rounding, mean_tolerance);
    return !(std::abs(comparison.difference()) <= allowed);
  });
  return failed;
}

}  // namespace agreement
