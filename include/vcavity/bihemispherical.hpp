// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bi-hemispherical reflectance of a grooved surface: diffuse light in, all reflected light out (Eq. 26).
///
/// Method. With e = (sin ψ, cos ψ sin θ', cos ψ cos θ') the reflectance is
///
///     R = (4/π) ∫∫ R(e) cos²ψ cos θ' dψ dθ'   over [0, π/2]²,
///
/// the integrand being even in both angles. It is smooth except at angles θ' that are known beforehand, where
/// a lobe appears or its weight changes slope, and where a cosine of incidence passes the critical angle of
/// the facet, if it has one. The square is cut there, and Gauss–Legendre quadrature on the pieces converges
/// exponentially. Its order rises until two orders agree; a cell on which they never do is halved.
///
/// When not to use it: for a facet reflectance with steps or kinks of its own it still converges, but slowly.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "quadrature.hpp"
#include "reflectance.hpp"

namespace vcavity {

/// An integral, and how it was obtained.
template <class Value>
struct Integral {
  Value value;            ///< the integral
  scalar_t<Value> error;  ///< estimate of the absolute error, from the agreement of two quadrature orders
  long long evaluations;  ///< number of evaluations of the facet reflectance
};

namespace detail {

/// The angles θ' in [0, π/2], ascending and with both ends, between which the weights of all lobes are smooth
/// and no cosine of incidence passes `critical_cosine` at ψ = 0.
template <class Real>
std::vector<Real> kinks_across(const Cavity<Real>& cavity, const Real& critical_cosine) {
  using std::asin;
  const Real alpha = cavity.aperture();
  const Real half_pi = pi<Real>() / Real(2);
  const int images = cavity.max_bounces() + 1;
  std::vector<Real> kinks{Real(0), half_pi};
  const auto add_between = [&kinks](const Real& low, const Real& high, const Real& angle) {
    if (angle > low && angle < high) kinks.push_back(angle);
  };
  // Both panels lit: f_j leaves its upper bound where c_j = c_1, its lower one where c_j = 0, for either
  // first panel. One panel lit: f_j leaves 1, and reaches 0, at multiples of α/2 from grazing.
  add_between(Real(0), half_pi, alpha / Real(2));
  for (int j = 1; j <= images; ++j) {
    const Real equal = (pi<Real>() - Real(j) * alpha) / Real(2);
    const Real zero = pi<Real>() - (Real(j) - Real(0.5)) * alpha;
    add_between(Real(0), half_pi, equal);
    add_between(Real(0), alpha / Real(2), -equal);
    add_between(Real(0), alpha / Real(2), zero);
    add_between(Real(0), alpha / Real(2), -zero);
  }
  if (critical_cosine > Real(0)) {
    const Real turn = asin(critical_cosine);
    for (int j = 1; j <= images; ++j) {
      const Real image = (Real(j) - Real(0.5)) * alpha;
      for (const Real& angle : {Real(turn - image), Real(pi<Real>() - turn - image)}) {
        add_between(Real(0), half_pi, angle);
        add_between(Real(0), half_pi, -angle);
      }
    }
  }
  std::sort(kinks.begin(), kinks.end());
  const Real rounding = Real(8) * std::numeric_limits<Real>::epsilon();
  const auto coincide = [&rounding](const Real& a, const Real& b) { return b - a < rounding; };
  kinks.erase(std::unique(kinks.begin(), kinks.end(), coincide), kinks.end());
  return kinks;
}

/// The critical cosine of a facet; 0 if it has none or does not tell.
template <class Real, class Facet>
Real critical_cosine_of(const Facet& facet) {
  if constexpr (requires {
                  { facet.critical_cosine() } -> std::convertible_to<Real>;
                }) {
    return facet.critical_cosine();
  } else {
    return Real(0);
  }
}

/// A rectangle of the square of directions.
template <class Real>
struct Cell {
  Real theta_low, theta_high;  ///< bounds of θ'
  Real psi_low, psi_high;      ///< bounds of ψ
};

/// The integrand of the bi-hemispherical reflectance and its quadrature over cells.
template <class Real, class Facet>
class HemisphereQuadrature {
 public:
  using Value = unpolarized_t<Facet, Real>;
  using Scalar = scalar_t<Value>;

  HemisphereQuadrature(const Cavity<Real>& cavity, const Facet& facet, int most_bounces)
      : cavity_(cavity),
        facet_(facet),
        most_bounces_(most_bounces),
        critical_(critical_cosine_of<Real>(facet)) {}

  /// The integral of R(e) cos²ψ cos θ' over the quarter of the hemisphere, [0, π/2]².
  Integral<Value> operator()(const Scalar& tolerance) {
    const std::vector<Real> kinks = kinks_across(cavity_, critical_);
    const Scalar share = tolerance / Scalar(static_cast<int>(kinks.size() - 1));
    Integral<Value> total{Value(0), Scalar(0), 0};
    for (std::size_t i = 0; i + 1 < kinks.size(); ++i)
      add(total, {kinks[i], kinks[i + 1], Real(0), pi<Real>() / Real(2)}, share, 0);
    total.evaluations = evaluations_;
    return total;
  }

 private:
  static constexpr std::array<std::size_t, 7> orders_along{6, 9, 13, 19, 28, 42, 64};
  static constexpr std::array<std::size_t, 7> orders_across{2, 3, 5, 8, 12, 18, 27};
  static constexpr std::size_t probes = 3;             // angles θ' at which the order in ψ is chosen
  static Scalar probe_margin() { return Scalar(10); }  // by which other angles θ' may be worse than those
  /// Two low orders agree by chance if the one before was off by more than this many tolerances.
  static Scalar chance_agreement() { return Scalar(1000); }
  static constexpr int most_halvings = 40;  // of one cell
  static constexpr long long most_evaluations = 50'000'000;

  /// Adds the integral over one cell, halved along the angle in which the highest order does not suffice.
  void add(Integral<Value>& total, const Cell<Real>& cell, const Scalar& tolerance, int halvings) {
    const bool may_halve = halvings < most_halvings && evaluations_ < most_evaluations;
    const Scalar along_tolerance = tolerance / (Scalar(2) * probe_margin());
    const Convergence along = converge_along(cell, along_tolerance);
    if (may_halve && !along.converged) {
      const Real middle = (cell.psi_low + cell.psi_high) / Real(2);
      add(total, {cell.theta_low, cell.theta_high, cell.psi_low, middle}, tolerance / Scalar(2),
          halvings + 1);
      add(total, {cell.theta_low, cell.theta_high, middle, cell.psi_high}, tolerance / Scalar(2),
          halvings + 1);
      return;
    }
    Value value(0);
    Scalar difference(0);
    for (const std::size_t order : orders_across) {
      const Value previous = value;
      const Scalar previous_difference = difference;
      value = integrate(cell.theta_low, cell.theta_high, order,
                        [&](const Real& theta) { return integrate_along(cell, theta, along.order); });
      difference = distance(value, previous);
      const Scalar allowed = at_least(Scalar(tolerance / Scalar(2)), rounding(value));
      const bool by_chance = order <= orders_across[2] && previous_difference > chance_agreement() * allowed;
      if (order > orders_across[1] && difference <= allowed && !by_chance) break;
    }
    if (may_halve && difference > at_least(Scalar(tolerance / Scalar(2)), rounding(value))) {
      const Real middle = (cell.theta_low + cell.theta_high) / Real(2);
      add(total, {cell.theta_low, middle, cell.psi_low, cell.psi_high}, tolerance / Scalar(2), halvings + 1);
      add(total, {middle, cell.theta_high, cell.psi_low, cell.psi_high}, tolerance / Scalar(2), halvings + 1);
      return;
    }
    total.value = total.value + value;
    total.error = total.error + probe_margin() * along.error + difference + rounding(value);
  }

  struct Convergence {
    std::size_t order;
    Scalar error;
    bool converged;  // within the tolerance, or as far as rounding allows
  };

  /// The order in ψ from which on the integral along ψ changes by no more than `tolerance`, at a few angles
  /// θ'.
  Convergence converge_along(const Cell<Real>& cell, const Scalar& tolerance) {
    const std::vector<QuadratureNode<Real>>& nodes = rule(probes);
    const Real half = (cell.theta_high - cell.theta_low) / Real(2);
    std::array<Value, probes> values;
    values.fill(Value(0));
    Scalar error(0);
    for (const std::size_t order : orders_along) {
      error = Scalar(0);
      Scalar noise(0);
      for (std::size_t i = 0; i < probes; ++i) {
        const Value value =
            integrate_along(cell, Real(cell.theta_low + half * (Real(1) + nodes[i].x)), order);
        const Scalar weight = static_cast<Scalar>(half * nodes[i].weight);
        error = error + weight * distance(value, values[i]);
        noise = noise + weight * rounding(value);
        values[i] = value;
      }
      if (order > orders_along[1] && error <= at_least(tolerance, noise)) return {order, error, true};
    }
    return {orders_along.back(), error, false};
  }

  /// cos θ' times the integral of R(e) cos²ψ over the range of ψ of the cell.
  Value integrate_along(const Cell<Real>& cell, const Real& theta, std::size_t order) {
    using std::cos;
    using std::sin;
    const Real sin_theta = sin(theta);
    const Real cos_theta = cos(theta);
    const std::vector<Real> pieces = smooth_pieces(cell, {Real(0), sin_theta, cos_theta});
    Value sum(0);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      sum = sum + integrate(pieces[i], pieces[i + 1], order, [&](const Real& psi) {
              const Real cos_psi = cos(psi);
              return static_cast<Scalar>(cos_psi * cos_psi) *
                     reflectance({sin(psi), cos_psi * sin_theta, cos_psi * cos_theta});
            });
    }
    return static_cast<Scalar>(cos_theta) * sum;
  }

  Value reflectance(const Vec3<Real>& e) {
    const auto counted = [this](const facet_argument_t<Facet, Real>& bounce) {
      ++evaluations_;
      return facet_(bounce);
    };
    return unpolarized(directional_reflectance(cavity_, e, counted, most_bounces_));
  }

  /// The range of ψ of the cell, cut where some bounce is at the critical angle.
  /// @param e direction at ψ = 0
  std::vector<Real> smooth_pieces(const Cell<Real>& cell, const Vec3<Real>& e) const {
    using std::acos;
    std::vector<Real> pieces{cell.psi_low, cell.psi_high};
    if (!(critical_ > Real(0))) return pieces;
    for (const Panel first : {Panel::one, Panel::two}) {
      PanelImages<Real> images(cavity_, e, first);
      for (; images.bounce() <= cavity_.max_bounces(); images.advance()) {
        if (!(images.normal_component() > critical_)) continue;
        const Real psi = acos(critical_ / images.normal_component());
        if (psi > cell.psi_low && psi < cell.psi_high) pieces.push_back(psi);
      }
    }
    std::sort(pieces.begin(), pieces.end());
    return pieces;
  }

  /// Gauss–Legendre quadrature of `integrand` from `low` to `high`. At a critical angle reflectances start
  /// like a square root; substituting x = sin(πt/2) makes that smooth.
  template <class Integrand>
  Value integrate(const Real& low, const Real& high, std::size_t order, Integrand&& integrand) {
    using std::cos;
    using std::sin;
    const Real half = (high - low) / Real(2);
    const Real quarter_turn = pi<Real>() / Real(2);
    Value sum(0);
    for (const QuadratureNode<Real>& node : rule(order)) {
      Real x = node.x;
      Real weight = half * node.weight;
      if (critical_ > Real(0)) {
        weight = weight * quarter_turn * cos(quarter_turn * x);
        x = sin(quarter_turn * x);
      }
      sum = sum + static_cast<Scalar>(weight) * integrand(Real(low + half * (Real(1) + x)));
    }
    return sum;
  }

  const std::vector<QuadratureNode<Real>>& rule(std::size_t order) {
    if (rules_[order].empty()) rules_[order] = gauss_legendre<Real>(order);
    return rules_[order];
  }

  static Scalar distance(const Value& a, const Value& b) { return largest(Value(a + Scalar(-1) * b)); }

  /// The rounding error of a sum of this size, below which differences say nothing.
  static Scalar rounding(const Value& value) {
    return Scalar(4) * std::numeric_limits<Scalar>::epsilon() * largest(value);
  }

  const Cavity<Real>& cavity_;
  const Facet& facet_;
  int most_bounces_;
  Real critical_;
  long long evaluations_ = 0;
  std::array<std::vector<QuadratureNode<Real>>, orders_along.back() + 1> rules_;
};

}  // namespace detail

/// Bi-hemispherical reflectance (Eq. 26), with an estimate of its error and its cost.
///
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param tolerance absolute error to aim at, > 0; what rounding forbids is not attempted, so that the error
/// estimate
///        may come out larger (about 1e-15 in double)
/// @param most_bounces light that needs more bounces is left out
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the reflectance of unpolarised light
template <class Real, FacetReflectance<Real> Facet>
Integral<unpolarized_t<Facet, Real>> bihemispherical_reflectance(
    const Cavity<Real>& cavity, const Facet& facet, const scalar_t<unpolarized_t<Facet, Real>>& tolerance,
    int most_bounces = all_bounces) {
  using Scalar = scalar_t<unpolarized_t<Facet, Real>>;
  if (!(tolerance > Scalar(0))) {
    std::ostringstream message;
    message << "the tolerance of the bi-hemispherical reflectance must be positive, not " << tolerance;
    throw std::invalid_argument(message.str());
  }
  const Scalar norm = Scalar(4) / pi<Scalar>();
  detail::HemisphereQuadrature<Real, Facet> quadrature(cavity, facet, most_bounces);
  const auto quarter = quadrature(tolerance / norm);
  return {norm * quarter.value, norm * quarter.error, quarter.evaluations};
}

}  // namespace vcavity
