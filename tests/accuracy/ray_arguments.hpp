// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Single rays as arguments: α, e_x, e_y, e_z, and the position on the opening.

#include <algorithm>
#include <string>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/arguments.hpp"
#include "accuracy/groove_reference.hpp"

namespace vcavity::test {

/// A position on the opening: any, near a rim, near the middle.
inline long double sample_position(Random& random) {
  const int sign = random() % 2 ? 1 : -1;
  switch (random() % 4) {
    case 0:
      return sign * (1 - log_uniform(random, 1e-12, 1));
    case 1:
      return sign * log_uniform(random, 1e-12, 1);
    default:
      return sign * std::uniform_real_distribution<double>(0, 1)(random);
  }
}

/// A subject with arguments α, e_x, e_y, e_z, y.
template <class Real>
Subject<Real> ray_subject(const std::string& name) {
  Subject<Real> subject = groove_subject<Real>(name);
  subject.argument_names.push_back("y");
  subject.sample = [draw = subject.sample](Random& random) {
    std::vector<Real> arguments = draw(random);
    arguments.push_back(static_cast<Real>(sample_position(random)));
    return arguments;
  };
  subject.repair = [repair = subject.repair](std::vector<Real>& arguments) {
    repair(arguments);
    arguments[4] = std::clamp(arguments[4], Real(-1), Real(1));
  };
  return subject;
}

/// The way of the ray according to the library, the errors of which are a subject of their own.
template <class Real, class Wide>
RayPath path_of(const std::vector<Wide>& arguments) {
  const auto rounded = [&](std::size_t i) { return static_cast<Real>(arguments[i]); };
  return ray_path(rounded_cavity<Real>(arguments), Vec3<Real>{rounded(1), rounded(2), rounded(3)},
                  std::clamp(rounded(4), Real(-1), Real(1)));
}

}  // namespace vcavity::test
