// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Where the weights of the lobes of a profile have kinks, found by trial.
///
/// Method. Between two kinks the weight of every lobe times cos θ' is a distance of two fixed points seen from the
/// direction θ', hence of the form a cos θ' + b sin θ'. So f(m − h) + f(m + h) = 2 cos h f(m) holds exactly on a range
/// without a kink, and a range on which it does not hold is halved, until the kink in it is known well enough. Whether
/// anything narrow was overlooked is known in the end: the number of bounces is of that form too, so its mean over the
/// hemisphere follows from the ends of the ranges, and has to be the area of the faces per area of the opening.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/profiles/profile.hpp"
#include "vcavity/profiles/trench.hpp"

namespace vcavity::detail {

/// Ranges of θ' on which the weights are smooth.
template <class Real>
struct SmoothRanges {
  std::vector<Real> ends;  ///< ascending, from −π/2 to π/2
  Real overlooked;         ///< by how much the mean number of bounces is wrong with them
};

/// Finds the ranges of one profile.
template <class Shape>
class KinkSearch {
 public:
  using Real = typename Shape::value_type;

  /// @param tolerance absolute error of reflectances that kinks may cause
  KinkSearch(const Shape& profile, const Real& tolerance) : profile_(profile), tolerance_(tolerance) {}

  SmoothRanges<Real> operator()() {
    SmoothRanges<Real> best;
    constexpr int coarsest = 64, finest = 4096;
    for (int cells = coarsest; cells <= finest; cells *= 4) {
      best = search(cells);
      if (best.overlooked <= tolerance_ / Real(4) || samples_ >= most_samples) break;
    }
    return best;
  }

 private:
  // Beyond this the rest is left to the quadrature.
  static constexpr long most_samples = 200'000;

  /// The lobes of a direction across the groove.
  struct Sample {
    Real theta;
    std::vector<std::pair<FacePath, Real>> flux;  // weight times cos θ'
    Real bounces;                                 // mean number times cos θ'
  };

  Sample at(const Real& theta) {
    using std::cos;
    using std::sin;
    ++samples_;
    Sample sample{theta, {}, Real(0)};
    const Real cosine = at_least(Real(cos(theta)), Real(0));
    profile_.follow(
        Vec3<Real>{Real(0), sin(theta), cosine}, [](const Real&) { return Real(1); },
        [&](const FacePencil<Real>& light, const Real&) {
          sample.flux.emplace_back(light.path, light.weight * cosine);
          sample.bounces += light.weight * cosine * Real(light.path.bounces());
        });
    return sample;
  }

  SmoothRanges<Real> search(int cells) {
    const Real first = -pi<Real>() / Real(2);
    ends_ = {first};
    mean_bounces_ = Real(0);
    last_half_ = Real(0);
    Sample low = at(first);
    for (int i = 1; i <= cells; ++i) {
      const Sample high = at(pi<Real>() * (Real(i) / Real(cells) - Real(0.5)));
      divide(low, high);
      low = high;
    }
    ends_.push_back(low.theta);
    return {ends_, magnitude(Real(mean_bounces_ - profile_.developed_area()))};
  }

  void divide(const Sample& low, const Sample& high) {
    using std::tan;
    const Real half = (high.theta - low.theta) / Real(2);
    const Sample middle = at(low.theta + half);
    // Much less than what is asked for, as there are many kinks.
    const Real negligible = tolerance_ / Real(10000);
    const bool smooth = !(bend(low, middle, high) > rounding());
    // Angles next to each other have nothing between them.
    const bool divisible = half > Real(4) * std::numeric_limits<Real>::epsilon();
    if (!smooth && divisible && bend(low, middle, high) * half > negligible && samples_ < most_samples) {
      divide(low, middle);
      divide(middle, high);
      return;
    }
    // A range with a kink stands by itself; two smooth ones are joined, unless there is a kink where they meet.
    const Real near = std::min(half, last_half_);
    if (!smooth || (near > Real(0) && bend(at(low.theta - near), low, at(low.theta + near)) > rounding()))
      ends_.push_back(low.theta);
    if (!smooth) ends_.push_back(high.theta);
    last_half_ = smooth ? half : Real(0);
    mean_bounces_ += (low.bounces + high.bounces) * tan(half) / Real(2);
  }

  /// A bend below this is rounding.
  static Real rounding() { return Real(100000) * std::numeric_limits<Real>::epsilon(); }

  /// Σ |f(m − h) + f(m + h) − 2 cos h f(m)| over the lobes.
  static Real bend(const Sample& low, const Sample& middle, const Sample& high) {
    using std::cos;
    std::vector<std::pair<FacePath, Real>> sums;
    const auto add = [&](const Sample& sample, const Real& scale) {
      for (const auto& lobe : sample.flux) {
        const auto same =
            std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == lobe.first; });
        if (same == sums.end())
          sums.emplace_back(lobe.first, scale * lobe.second);
        else
          same->second += scale * lobe.second;
      }
    };
    add(low, Real(1));
    add(high, Real(1));
    add(middle, Real(-2) * cos((high.theta - low.theta) / Real(2)));
    Real result(0);
    for (const auto& [path, sum] : sums) result += magnitude(sum);
    return result;
  }

  const Shape& profile_;
  Real tolerance_;
  std::vector<Real> ends_;
  Real mean_bounces_{};
  Real last_half_{};  // of the last range, if it is smooth
  long samples_ = 0;
};

/// The ranges of a profile.
/// @param tolerance absolute error of reflectances that kinks may cause
template <Profile Shape>
SmoothRanges<typename Shape::value_type> smooth_ranges(const Shape& profile,
                                                       const typename Shape::value_type& tolerance) {
  return KinkSearch<Shape>(profile, tolerance)();
}

/// Those of a trench: kinks lie where light crosses it a whole number of times, N. They have no end towards grazing light.
/// Of light that loses 1 − R at a wall, what is left after N of them, R^N, bends by (1 − R)/N² at a kink; the kinks
/// beyond N, which are left out, so matter less than 0.14/(N² b)² in all, b the width over the depth.
template <class Real>
SmoothRanges<Real> smooth_ranges(const Trench<Real>& trench, const Real& tolerance) {
  using std::atan;
  using std::pow;
  const Real width = trench.floor_over_depth();
  const auto left_out = [&](int crossings) {
    const Real n2 = Real(crossings) * Real(crossings);
    return Real(0.14) / (n2 * width * n2 * width);
  };
  constexpr int most = 4096;
  int crossings = 16;
  while (crossings < most && left_out(crossings) > tolerance / Real(4)) crossings += crossings / 4;
  const Real grazing = pi<Real>() / Real(2);
  SmoothRanges<Real> result{{-grazing}, left_out(crossings)};
  for (int crossing = -crossings; crossing <= crossings; ++crossing)
    result.ends.push_back(atan(Real(crossing) * width / Real(2)));
  result.ends.push_back(grazing);
  return result;
}

}  // namespace vcavity::detail
