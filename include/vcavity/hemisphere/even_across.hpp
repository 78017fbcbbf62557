// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Quadrature across a narrow groove by two nodes.
///
/// Method. Where rays of all numbers of bounces that count reach every angle u in [0, α/2], the integrand is
/// sin(α/2 − u) h(u²), with an h that in narrow grooves is almost constant: u moves every bounce by less than half an
/// aperture. The Gauss rule of two nodes in u² for that weight is exact for h up to u⁶. The error is that of the term of
/// u⁸, estimated from the slope of h, from the distance of the next singularity, and from the number of factors that
/// change with u, some 1/α, each by the square of it.
///
/// When not to use it: for facets with a critical angle, and for grooves of few bounces.

#include <algorithm>
#include <array>
#include <cmath>

#include "vcavity/numbers/gauss_legendre.hpp"

namespace vcavity::detail {

/// The rule for one aperture, in s = u/(α/2).
template <class Real>
class EvenAcross {
 public:
  struct Node {
    Real u;
    Real weight;  ///< of the integrand itself
  };

  /// @param aperture α
  explicit EvenAcross(const Real& aperture) : aperture_(aperture) {
    using std::sin;
    using std::sqrt;
    const Real half = aperture / Real(2);
    const auto hat = [&](const Real& s) { return sin(half * (Real(1) - s)); };
    std::array<Real, 5> moments{};  // ∫ hat s^(2k) ds
    constexpr std::size_t enough_nodes = 12;
    for (const auto& node : gauss_legendre<Real>(enough_nodes)) {
      const Real s = (Real(1) + node.x) / Real(2);
      Real term = node.weight / Real(2) * hat(s);
      for (Real& moment : moments) {
        moment += term;
        term *= s * s;
      }
    }
    // The polynomial s⁴ + b s² + c that is orthogonal to 1 and s².
    const Real determinant = moments[1] * moments[1] - moments[0] * moments[2];
    const Real b = (moments[0] * moments[3] - moments[1] * moments[2]) / determinant;
    const Real c = (moments[2] * moments[2] - moments[1] * moments[3]) / determinant;
    missed_ = half * (moments[4] + b * moments[3] + c * moments[2]);
    const Real root = sqrt(b * b / Real(4) - c);
    squares_ = {-b / Real(2) - root, -b / Real(2) + root};
    for (std::size_t i = 0; i < 2; ++i) {
      const Real other = squares_[1 - i], s = sqrt(squares_[i]);
      const Real weight = (moments[1] - other * moments[0]) / (squares_[i] - other);
      nodes_[i] = {half * s, half * weight / hat(s)};
      hats_[i] = hat(s);
    }
  }

  const std::array<Node, 2>& nodes() const { return nodes_; }

  /// Estimate of the error of the rule.
  /// @param difference, size of h at the nodes: the largest part of the difference, and of h
  /// @param distance in u of the next singularity
  double error(double difference, double size, double distance) const {
    constexpr double safety = 25;  // as for series (legendre_series.hpp)
    const double largest = std::max(difference, size);
    if (!(largest > 0)) return 0;  // there is no light
    const double half = static_cast<double>(aperture_) / 2;
    if (!(distance > half)) return largest;  // the singularity is too near to say anything
    const double slope = difference / static_cast<double>(squares_[1] - squares_[0]);
    const double nearness = half / distance;
    const double fall = std::max({slope / largest, nearness * nearness, static_cast<double>(aperture_)});
    return safety * largest * std::pow(fall, 4) * static_cast<double>(missed_);
  }

  /// The weight of the integrand at a node.
  const Real& hat(std::size_t node) const { return hats_[node]; }

 private:
  Real aperture_;
  Real missed_;  ///< ∫ of the square of the polynomial of the nodes: what the rule makes of s⁸, wrongly
  std::array<Real, 2> squares_, hats_;
  std::array<Node, 2> nodes_;
};

}  // namespace vcavity::detail
