// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sampling with a known error, and the verdict on many comparisons at once.
///
/// Each mean is the average over independent replicates. Within a replicate the points form a lattice, which
/// fills the domain more evenly than chance does; a random shift makes every replicate unbiased, and their
/// spread gives an honest standard error (Cranley and Patterson, SIAM J. Numer. Anal. 13, 1976, p. 904).

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace agreement {

/// Random numbers in [0, 1), the same on every system.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : bits_(seed) {}
  double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 bits_;
};

/// The replicates of every mean: so many that their average is normally distributed for all that matters
/// here.
inline constexpr int replicates = 1024;

/// Points in the unit cube: fractional parts of the multiples of the roots of 2, 3 and 5 (Weyl), with a
/// random shift.
class ShiftedLattice {
 public:
  /// @param seed, replicate  determine the shift
  ShiftedLattice(std::uint64_t seed, int replicate);
  /// Point number i, each coordinate in [0, 1).
  std::array<double, 3> operator[](int i) const;

 private:
  std::array<double, 3> shift_;
};

/// A mean over replicates.
class ReplicatedMean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  /// Ends a replicate of at least one value.
  void end_replicate();
  double mean() const { return mean_; }
  /// Standard error of mean(), from the spread of the replicates.
  double standard_error() const;

 private:
  double sum_ = 0;
  int count_ = 0;
  int replicates_ = 0;
  double mean_ = 0;
  double squares_ = 0;  // sum of squared deviations of the replicates from their mean
};

/// A mean that the theory predicts and the tracer has estimated.
struct MeanComparison {
  std::string what;
  double theory;
  double traced;
  double standard_error;

  double difference() const { return theory - traced; }
  double sigmas() const { return difference() / standard_error; }
};

/// The probability that any of the comparisons of a correct theory fails with another seed.
inline constexpr double false_alarm_rate = 1e-3;

/// Largest difference between theory and tracer in any mean, whatever its standard error.
inline constexpr double mean_tolerance = 5e-4;

/// The number of standard errors that each of `cases` comparisons may differ by, so that all of them together
/// raise a false alarm with the rate above (Sidak's correction; conservative where the cases share their
/// rays).
double allowed_sigmas(int cases);

/// The comparisons that fail: outside the confidence interval, or beyond the tolerance.
std::vector<MeanComparison> failures(const std::vector<MeanComparison>& comparisons);

}  // namespace agreement
