// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Pearson's χ² test of counts against probabilities.

#include <boost/math/distributions/chi_squared.hpp>
#include <cstddef>
#include <vector>

namespace vcavity::test {

/// A test that cries wolf once in ten thousand runs; with fixed seeds it does so always or never.
inline constexpr double false_alarm_rate = 1e-4;

/// The probability of a χ² at least as large as that of the counts. Bins with less than 5 expected counts are
/// pooled, as the χ² approximation demands.
inline double p_value(const std::vector<double>& counts, const std::vector<double>& expected) {
  double chi2 = 0, pooled_count = 0, pooled_expected = 0;
  int bins = 0;
  const auto add = [&](double count, double expectation) {
    chi2 += (count - expectation) * (count - expectation) / expectation;
    ++bins;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] >= 5) {
      add(counts[i], expected[i]);
    } else {
      pooled_count += counts[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected >= 5) add(pooled_count, pooled_expected);
  if (pooled_expected <= 0 && pooled_count > 0) return 0;
  if (bins < 2) return 1;
  return boost::math::cdf(complement(boost::math::chi_squared(bins - 1), chi2));
}

}  // namespace vcavity::test
