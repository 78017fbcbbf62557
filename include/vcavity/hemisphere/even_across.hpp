// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Quadrature across a narrow groove by two or three nodes.
///
/// Method. Where rays of all numbers of bounces that count reach every angle u in [0, α/2], the integrand is
/// sin(α/2 − u) h(u²), with an h that in narrow grooves is almost constant: u moves every bounce by less than half an
/// aperture. The Gauss rule of n nodes in u² for that weight is exact for h up to u^(4n − 2); its nodes are the zeros of the
/// orthogonal polynomial (Stieltjes' procedure; Gautschi, "Orthogonal Polynomials", 2004, section 2.2.3). The error is
/// that of the term of u^(4n), estimated from the slope of h, from the distance of the next singularity, and from the
/// number of factors that change with u, some 1/α, each by the square of it.
///
/// When not to use it: for facets with a critical angle, and for grooves of few bounces.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"

namespace vcavity::detail {

/// The rule for one aperture, in t = (u/(α/2))².
template <class Real, std::size_t count>
class EvenAcross {
 public:
  struct Node {
    Real u;
    Real weight;  ///< of the integrand itself
    Real hat;     ///< sin(α/2 − u)
  };

  /// @param aperture α
  explicit EvenAcross(const Real& aperture) : aperture_(aperture) {
    using std::sin;
    using std::sqrt;
    const Real half = aperture / Real(2);
    constexpr std::size_t enough_nodes = 12;
    struct Weighted {
      Real t, weight;
    };
    std::array<Weighted, enough_nodes> measure;
    const auto legendre = gauss_legendre<Real>(enough_nodes);
    for (std::size_t i = 0; i < enough_nodes; ++i) {
      const Real s = (Real(1) + legendre[i].x) / Real(2);
      measure[i] = {s * s, half * legendre[i].weight / Real(2) * sin(half * (Real(1) - s))};
    }
    for (std::size_t k = 0; k <= count; ++k) {
      Real moment(0);
      for (const Weighted& at : measure) {
        const Real value = polynomials(at.t, k).value[k];
        norm_[k] += at.weight * value * value;
        moment += at.weight * value * value * at.t;
      }
      if (k < count) centre_[k] = moment / norm_[k];
    }
    // The zeros, divided out one by one; each is approached from below.
    for (std::size_t i = 0; i < count; ++i) {
      Real t(0);
      constexpr int enough_steps = 60;
      for (int step = 0; step < enough_steps; ++step) {
        const Polynomials p = polynomials(t, count);
        Real divided(0);
        for (std::size_t j = 0; j < i; ++j) divided += Real(1) / (t - squares_[j]);
        const Real move = p.value[count] / (p.slope[count] - p.value[count] * divided);
        t -= move;
        if (magnitude(move) < std::numeric_limits<Real>::epsilon()) break;
      }
      squares_[i] = t;
      Real sum(0);
      const Polynomials p = polynomials(t, count);
      for (std::size_t k = 0; k < count; ++k) sum += p.value[k] * p.value[k] / norm_[k];
      const Real s = sqrt(t), hat = sin(half * (Real(1) - s));
      nodes_[i] = {half * s, Real(1) / (sum * hat), hat};
    }
  }

  const std::array<Node, count>& nodes() const { return nodes_; }

  /// Estimate of the error of the rule.
  /// @param difference, size of h at the first nodes: the largest part of the difference, and of h
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
    // The norm of the polynomial of the nodes is what the rule makes of t^(2n), wrongly.
    return safety * largest * std::pow(fall, 2 * static_cast<double>(count)) *
           static_cast<double>(norm_[count]);
  }

 private:
  struct Polynomials {
    std::array<Real, count + 1> value, slope;
  };

  /// p_(k + 1) = (t − a_k) p_k − b_k p_(k − 1) up to a degree, b_k being the ratio of the norms of p_k and p_(k − 1).
  Polynomials polynomials(const Real& t, std::size_t degree) const {
    Polynomials p{{Real(1)}, {Real(0)}};
    for (std::size_t k = 0; k < degree; ++k) {
      p.value[k + 1] = (t - centre_[k]) * p.value[k];
      p.slope[k + 1] = p.value[k] + (t - centre_[k]) * p.slope[k];
      if (k == 0) continue;
      const Real ratio = norm_[k] / norm_[k - 1];
      p.value[k + 1] -= ratio * p.value[k - 1];
      p.slope[k + 1] -= ratio * p.slope[k - 1];
    }
    return p;
  }

  Real aperture_;
  std::array<Real, count> centre_{}, squares_{};
  std::array<Real, count + 1> norm_{};  ///< ∫ of the square of a polynomial with the weight
  std::array<Node, count> nodes_;
};

}  // namespace vcavity::detail
