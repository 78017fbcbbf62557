// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Error and time of a computation.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vcavity/hemisphere/bihemispherical.hpp>
#include <vector>

namespace vcavity::tools {

/// One way to compute something, at one setting.
struct Measurement {
  std::string method;
  std::string setting;
  double error;           ///< the largest absolute error, or colour difference
  double seconds;         ///< median of the repeats
  long long evaluations;  ///< of the facet reflectance; 0 if not counted
};

/// Median wall-clock time of `compute()`, in seconds: of at least five calls, or fewer if they take seconds.
template <class Compute>
double median_seconds(Compute&& compute) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t most_calls = 101;
  constexpr double enough = 0.05;
  constexpr double too_long = 2;
  std::vector<double> times;
  double total = 0;
  while (times.size() < most_calls && total < too_long && (times.size() < 5 || total < enough)) {
    const auto start = Clock::now();
    compute();
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    total += times.back();
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// The largest difference between the values and those they should have.
inline double largest_error(const std::vector<double>& values, const std::vector<double>& expected) {
  double error = 0;
  for (std::size_t i = 0; i < values.size(); ++i) error = std::max(error, std::abs(values[i] - expected[i]));
  return error;
}

/// Counts, times and compares one computation.
/// @param compute called with the facet, returns as many values as `expected` has
template <class Facet, class Compute>
Measurement measure(std::string method, std::string setting, const Facet& facet,
                    const std::vector<double>& expected, Compute&& compute) {
  long long evaluations = 0;
  const double error = largest_error(compute(CountedFacet<Facet>(facet, evaluations)), expected);
  std::vector<double> values;
  const double seconds = median_seconds([&] { values = compute(facet); });
  return {std::move(method), std::move(setting), error, seconds, evaluations};
}

}  // namespace vcavity::tools
