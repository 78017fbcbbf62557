// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The search for the arguments at which a function errs most: random ones, many of them near the hard
/// cases, then climbing from the worst by ever smaller random steps.

#include <algorithm>
#include <cmath>
#include <vector>

#include "accuracy/subject.hpp"

namespace vcavity::test {

/// The worst that a search has found.
template <class Real>
struct WorstCase {
  Error error;
  std::vector<Real> arguments;
};

/// Arguments near the given ones: some of them moved by a relative amount between ε and 0.3.
template <class Real>
std::vector<Real> neighbour(const Subject<Real>& subject, std::vector<Real> arguments, Random& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double smallest = std::log(static_cast<double>(epsilon<Real>()) / 2);
  for (Real& argument : arguments) {
    if (unit(random) < 0.5) continue;
    const Real step = static_cast<Real>(std::exp(smallest + unit(random) * (std::log(0.3) - smallest)));
    argument *= unit(random) < 0.5 ? Real(1) + step : Real(1) - step;
  }
  subject.repair(arguments);
  return arguments;
}

/// @param samples number of random arguments
/// @param steps number of steps of climbing; one restart from the next worst for every tenth of them
template <class Real>
WorstCase<Real> find_worst_case(const Subject<Real>& subject, int samples, int steps, Random& random) {
  constexpr std::size_t climbers = 10;
  samples = std::max(10, static_cast<int>(samples * subject.share_of_samples));
  steps = std::max(10, static_cast<int>(steps * subject.share_of_samples));
  std::vector<WorstCase<Real>> worst;
  const auto keep = [&](WorstCase<Real> found) {
    worst.push_back(std::move(found));
    std::sort(worst.begin(), worst.end(),
              [](const auto& a, const auto& b) { return a.error.share() > b.error.share(); });
    if (worst.size() > climbers) worst.pop_back();
  };
  for (int i = 0; i < samples; ++i) {
    std::vector<Real> arguments = subject.sample(random);
    subject.repair(arguments);
    const double of_interest = worst.size() < climbers ? 0 : worst.back().error.share();
    const Error error = error_of(subject, arguments, of_interest);
    if (worst.size() < climbers || error.share() > of_interest) keep({error, arguments});
  }
  for (WorstCase<Real>& climber : worst)
    for (int i = 0; i < steps / static_cast<int>(climbers); ++i) {
      const std::vector<Real> arguments = neighbour(subject, climber.arguments, random);
      const Error error = error_of(subject, arguments, climber.error.share());
      if (error.share() > climber.error.share()) climber = {error, arguments};
    }
  return *std::max_element(worst.begin(), worst.end(),
                           [](const auto& a, const auto& b) { return a.error.share() < b.error.share(); });
}

}  // namespace vcavity::test
