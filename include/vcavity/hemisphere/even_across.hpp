// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Quadrature across a narrow groove by two or three nodes.
///
/// Method. A part of the rays whose overlap is free of kinks (bounce_series.hpp) makes an integrand sin(w − u) h(u²) over u
/// in [0, w], w ≤ α/2, with an h that in narrow grooves is almost constant: u moves every bounce by less than half an
/// aperture. The Gauss rule of n nodes in u² for that weight is exact for h up to u^(4n − 2); its nodes are the zeros of the
/// orthogonal polynomial (Stieltjes' procedure; Gautschi, "Orthogonal Polynomials", 2004, section 2.2.3). The error is
/// that of the term of u^(4n), estimated from the slope of h, from the distance of the next singularity, and from the
/// square of the range: what the bounces of a ray change with u adds up to what it gains at one end and loses at the other,
/// (u²/α) d ln ρ/dx at the last bounce x = mα/2. Where that is more, as in a mirror whose last bounces graze, h shows it.
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

/// The rule for one width w, in t = (u/w)².
template <class Real, std::size_t count>
class EvenAcross {
 public:
  struct Node {
    Real u;
    Real weight;  ///< of the integrand itself
    Real hat;     ///< sin(w − u)
  };

  /// @param width w, at most π/2
  explicit EvenAcross(const Real& width) : width_(width) {
    using std::sin;
    using std::sqrt;
    constexpr std::size_t enough_nodes = 12;
    struct Weighted {
      Real t, weight;
    };
    std::array<Weighted, enough_nodes> measure;
    const auto legendre = gauss_legendre<Real>(enough_nodes);
    for (std::size_t i = 0; i < enough_nodes; ++i) {
      const Real s = (Real(1) + legendre[i].x) / Real(2);
      measure[i] = {s * s, width * legendre[i].weight / Real(2) * sin(width * (Real(1) - s))};
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
      const Real s = sqrt(t), hat = sin(width * (Real(1) - s));
      nodes_[i] = {width * s, Real(1) / (sum * hat), hat};
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
    const double width = static_cast<double>(width_);
    if (!(distance > width)) return largest;  // the singularity is too near to say anything
    const double slope = difference / static_cast<double>(squares_[1] - squares_[0]);
    const double nearness = width / distance;
    const double fall = std::max({slope / largest, nearness * nearness, 4 * width * width});
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

  Real width_;
  std::array<Real, count> centre_{}, squares_{};
  std::array<Real, count + 1> norm_{};  ///< ∫ of the square of a polynomial with the weight
  std::array<Node, count> nodes_;
};

}  // namespace vcavity::detail
