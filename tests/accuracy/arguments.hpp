// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Random arguments for the functions under measurement, near the hard cases more often than chance would
/// have it.

#include <algorithm>
#include <cmath>
#include <string>
#include <vcavity/conventions.hpp>
#include <vector>

#include "accuracy/subject.hpp"

namespace vcavity::test {

/// The smallest aperture in radians, but for functions that say otherwise; it limits the time that references
/// take.
inline constexpr double smallest_aperture = 0.02;

/// A number whose logarithm is uniform.
inline long double log_uniform(Random& random, double low, double high) {
  std::uniform_real_distribution<double> unit(0, 1);
  return std::exp(static_cast<long double>(std::log(low) + unit(random) * std::log(high / low)));
}

/// A real part n − 1 of the index: any, or close to 1.
inline long double sample_contrast(Random& random) {
  switch (random() % 4) {
    case 0:
      return log_uniform(random, 1e-9, 1) * (random() % 2 ? 1 : -1);
    case 1:
      return log_uniform(random, 1e-3, 1) - 1;
    default:
      return log_uniform(random, 0.03, 100) - 1;
  }
}

inline long double sample_extinction(Random& random) {
  switch (random() % 4) {
    case 0:
      return 0;
    case 1:
      return log_uniform(random, 1e-12, 1);
    default:
      return log_uniform(random, 1e-3, 1000);
  }
}

/// A cosine: any, small, close to 1, close to Brewster's or to the critical angle.
inline long double sample_cosine(Random& random, long double n_minus_1) {
  std::uniform_real_distribution<double> unit(0, 1);
  const long double n = 1 + n_minus_1;
  const long double off = 1 + log_uniform(random, 1e-12, 0.1) * (random() % 2 ? 1 : -1);
  switch (random() % 8) {
    case 0:
      return log_uniform(random, 1e-12, 1);
    case 1:
      return 1 - log_uniform(random, 1e-9, 1);
    case 2:
      return 1 / std::sqrt(1 + n * n) * off;
    case 3:
      return n < 1 ? std::sqrt(1 - n * n) * off : 1;
    default:
      return unit(random);
  }
}

/// An aperture: any, small, or a rounding error beside π/k.
inline long double sample_aperture(Random& random, long double rounding, double smallest) {
  const long double turn = pi<long double>();
  switch (random() % 4) {
    case 0:
      return log_uniform(random, smallest, static_cast<double>(turn));
    case 1:
      return turn / static_cast<long double>(1 + random() % 20) *
             (1 + rounding * (static_cast<long double>(random() % 17) - 8));
    case 2:
      return turn - log_uniform(random, 1e-9, 1);
    default: {
      std::uniform_real_distribution<double> unit(0, 1);
      return std::max(smallest, unit(random)) * turn;
    }
  }
}

/// The angle θ' across the groove: any, grazing, or close to a multiple of a quarter of the aperture, where
/// lobes appear and vanish.
inline long double sample_theta(Random& random, long double aperture) {
  std::uniform_real_distribution<double> unit(0, 1);
  const long double right = pi<long double>() / 2;
  const long double off = log_uniform(random, 1e-15, 0.1) * (random() % 2 ? 1 : -1);
  const long double sign = random() % 2 ? 1 : -1;
  switch (random() % 4) {
    case 0:
      return sign * (right - log_uniform(random, 1e-12, 1));
    case 1:
      return sign * std::min(right, static_cast<long double>(random() % 40) * aperture / 4 + off);
    case 2:
      return sign * std::max(0.0L, right - static_cast<long double>(random() % 40) * aperture / 4 + off);
    default:
      return sign * unit(random) * right;
  }
}

/// Arguments α, e_x, e_y, e_z.
template <class Real>
std::vector<Real> sample_direction(Random& random, double smallest) {
  std::uniform_real_distribution<double> unit(0, 1);
  const long double aperture =
      sample_aperture(random, static_cast<long double>(epsilon<Real>()) / 2, smallest);
  const long double theta = sample_theta(random, aperture);
  long double psi = 0;
  if (random() % 2) psi = unit(random) * pi<long double>() / 2;
  if (random() % 4 == 0) psi = pi<long double>() / 2 - log_uniform(random, 1e-9, 1);
  std::vector<Real> arguments{static_cast<Real>(aperture), static_cast<Real>(std::sin(psi)),
                              static_cast<Real>(std::cos(psi) * std::sin(theta)),
                              static_cast<Real>(std::cos(psi) * std::max(0.0L, std::cos(theta)))};
  // Along the horizon, and straight over the groove.
  const auto choice = random() % 32;
  if (choice < 2) arguments[choice == 0 ? 3 : 2] = Real(0);
  return arguments;
}

template <class Real>
void repair_direction(std::vector<Real>& arguments, double smallest) {
  arguments[0] = std::clamp(arguments[0], static_cast<Real>(smallest), pi<Real>());
  if (arguments[2] == Real(0) && arguments[3] == Real(0)) arguments[3] = Real(1);
  Real length(0);
  for (std::size_t i = 1; i <= 3; ++i) length += arguments[i] * arguments[i];
  length = std::sqrt(length);
  for (std::size_t i = 1; i <= 3; ++i) arguments[i] /= length;
}

/// A subject with arguments α, e_x, e_y, e_z.
template <class Real>
Subject<Real> groove_subject(const std::string& name, double smallest = smallest_aperture) {
  Subject<Real> subject;
  subject.name = name;
  subject.argument_names = {"α", "e_x", "e_y", "e_z"};
  subject.sample = [=](Random& random) { return sample_direction<Real>(random, smallest); };
  subject.repair = [=](std::vector<Real>& arguments) { repair_direction(arguments, smallest); };
  return subject;
}

/// The same with the refractive index n, k of the facets.
template <class Real>
Subject<Real> coated(Subject<Real> subject) {
  const std::size_t n = subject.argument_names.size();
  subject.argument_names.insert(subject.argument_names.end(), {"n", "k"});
  subject.sample = [draw = subject.sample](Random& random) {
    std::vector<Real> arguments = draw(random);
    arguments.push_back(static_cast<Real>(1 + sample_contrast(random)));
    arguments.push_back(static_cast<Real>(sample_extinction(random)));
    return arguments;
  };
  subject.repair = [repair = subject.repair, n](std::vector<Real>& arguments) {
    repair(arguments);
    arguments[n] = std::clamp(arguments[n], Real(1e-3), Real(100));
    arguments[n + 1] = std::clamp(arguments[n + 1], Real(0), Real(1000));
  };
  return subject;
}

/// The direction among the arguments of a `groove_subject`.
template <class Real>
Vec3<Real> direction_of(const std::vector<Real>& arguments) {
  return {arguments[1], arguments[2], arguments[3]};
}

}  // namespace vcavity::test
