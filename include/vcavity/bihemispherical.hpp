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
#include <complex>
#include <concepts>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <type_traits>
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

/// The singularities of a facet reflectance in the plane of complex cosines; none if it does not tell.
template <class Facet>
std::vector<std::complex<double>> singular_cosines_of(const Facet& facet) {
  if constexpr (requires { facet.singular_cosines(); }) {
    const auto points = facet.singular_cosines();
    return {points.begin(), points.end()};
  } else {
    return {};
  }
}

/// A facet that counts how often it is asked.
template <class Facet>
struct CountedFacet {
  template <class Argument>
  requires std::invocable<const Facet&, const Argument&>
  auto operator()(const Argument& bounce) const {
    *count += directions;
    return facet(bounce);
  }

  const Facet& facet;
  long long* count;
  int directions;  // of an argument
};

/// A rectangle of the square of directions.
template <class Real>
struct Cell {
  Real theta_low, theta_high;  ///< bounds of θ'
  Real psi_low, psi_high;      ///< bounds of ψ
};

/// The integrand of the bi-hemispherical reflectance and its quadrature over cells.
///
/// In both angles the variable of integration is u with x = sin(πu/2), −1 ≤ x ≤ 1 along the range of the
/// angle (or 0 ≤ x ≤ 1 where the integrand is even). That draws the nodes to the ends of the range: towards
/// grazing incidence, near which the reflectance of a metal changes most, and towards critical angles, where
/// it starts like a square root. Across, where the singularities of the facet are known to be far away, x
/// itself is better.
///
/// The first order tried is the one that the singularities ask for. Then the Legendre series of the integrand
/// is looked at: its last known terms, and the rate at which they fall off, tell how large are those that the
/// rule misses. The rate is the smaller one of those observed and derived from the singularities, or half the
/// observed one where none are known.
template <class Real, class Facet>
class HemisphereQuadrature {
 public:
  using Value = unpolarized_t<Facet, Real>;
  using Scalar = scalar_t<Value>;

  HemisphereQuadrature(const Cavity<Real>& cavity, const Facet& facet, int most_bounces)
      : cavity_(cavity),
        facet_(facet),
        most_bounces_(most_bounces),
        critical_(critical_cosine_of<Real>(facet)),
        singular_cosines_(critical_ > Real(0) ? std::vector<std::complex<double>>{}
                                              : singular_cosines_of(facet)) {}

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
  using Rule = SeriesRule<Real>;

  static constexpr std::size_t lanes = 4;  // directions of one ψ rule that are evaluated together
  using Pack = vcavity::Pack<Real, lanes>;
  static constexpr std::size_t least_along = 4, most_along = 64, least_across = 4, most_across = 40;
  static constexpr int most_halvings = 40;  // of one cell
  static constexpr long long most_evaluations = 50'000'000;

  /// Whether facets are asked for several directions at once.
  static constexpr bool in_packs() {
    if constexpr (std::is_floating_point_v<Real> && OverDirections<Facet>) {
      return std::is_same_v<Value, Real>;
    } else {
      return false;
    }
  }

  /// A sum of values, and of the terms of the Legendre series with them.
  struct Sum {
    Value integral = Value(0);
    std::array<Value, Rule::terms> terms{Value(0), Value(0), Value(0), Value(0)};

    void add(const Value& value, const Scalar& weight, const std::array<Scalar, Rule::terms>& projection) {
      integral = integral + weight * value;
      for (std::size_t i = 0; i < Rule::terms; ++i) terms[i] = terms[i] + projection[i] * value;
    }
  };

  /// The size of the terms of several series.
  struct Series {
    std::array<double, Rule::terms> sizes{};

    void add(const Sum& sum, const Real& scale) {
      for (std::size_t i = 0; i < Rule::terms; ++i)
        sizes[i] += static_cast<double>(scale) * static_cast<double>(largest(sum.terms[i]));
    }

    /// The error of a rule.
    /// @param known_rate at which the series falls off at most, 0 if unknown
    /// @param noise rounding error of the coefficients
    double error(const Rule& rule, double known_rate, double noise) const {
      constexpr double safety = 4;
      const double middle = std::max(sizes[0], sizes[1]);
      const double last = std::max(sizes[2], sizes[3]);
      if (last <= noise * rule.last_degree) return 0;
      const double observed =
          std::max(std::log(middle / last) / (rule.last_degree - rule.middle_degree), 0.0);
      const double rate = known_rate > 0 ? std::min(known_rate, observed) : 0.5 * observed;
      return safety * last * std::exp(-rate * (rule.exact_degree + 1 - rule.last_degree));
    }
  };

  /// The variable of integration across.
  struct Across {
    bool drawn_to_ends;
    double rate;
  };

  struct Orders {
    std::size_t along, across;
  };

  struct Estimate {
    Value value;
    double along_error, across_error;
  };

  /// Adds the integral over one cell, halved along the angle in which the highest order does not suffice.
  void add(Integral<Value>& total, const Cell<Real>& cell, const Scalar& tolerance, int halvings) {
    const bool even = is_even(cell);
    const double along_rate = rate_along(cell);
    const Across across = variable_across(cell);
    const double half_tolerance = 0.5 * static_cast<double>(tolerance);
    Orders orders{first_order(along_rate, even ? 4 : 2, half_tolerance, least_along, most_along),
                  first_order(across.rate, 2, half_tolerance, least_across, most_across)};
    for (;;) {
      const Estimate estimate = integrate(cell, orders, along_rate, across);
      const double enough = std::max(half_tolerance, static_cast<double>(rounding(estimate.value)));
      const bool along_converged = estimate.along_error <= enough;
      const bool across_converged = estimate.across_error <= enough;
      if ((along_converged && across_converged) || halvings >= most_halvings ||
          evaluations_ >= most_evaluations) {
        total.value = total.value + estimate.value;
        total.error = total.error + static_cast<Scalar>(estimate.along_error + estimate.across_error) +
                      rounding(estimate.value);
        return;
      }
      if (!along_converged && orders.along >= most_along) {
        const Real middle = (cell.psi_low + cell.psi_high) / Real(2);
        add(total, {cell.theta_low, cell.theta_high, cell.psi_low, middle}, tolerance / Scalar(2),
            halvings + 1);
        add(total, {cell.theta_low, cell.theta_high, middle, cell.psi_high}, tolerance / Scalar(2),
            halvings + 1);
        return;
      }
      if (!across_converged && orders.across >= most_across) {
        const Real middle = (cell.theta_low + cell.theta_high) / Real(2);
        add(total, {cell.theta_low, middle, cell.psi_low, cell.psi_high}, tolerance / Scalar(2),
            halvings + 1);
        add(total, {middle, cell.theta_high, cell.psi_low, cell.psi_high}, tolerance / Scalar(2),
            halvings + 1);
        return;
      }
      if (!along_converged) orders.along = raised(orders.along, most_along);
      if (!across_converged) orders.across = raised(orders.across, most_across);
    }
  }

  /// Whether the integrand is even about the lower end of ψ.
  bool is_even(const Cell<Real>& cell) const { return cell.psi_low == Real(0) && !(critical_ > Real(0)); }

  /// The order whose error is about `tolerance`; a guess where the rate is not known.
  /// @param degrees that a node adds to those that are exact
  static std::size_t first_order(double rate, int degrees, double tolerance, std::size_t least,
                                 std::size_t most) {
    constexpr double guessed_rate = 0.8;
    const double wanted =
        std::log(1 / std::min(tolerance, 0.1)) / (degrees * (rate > 0 ? rate : guessed_rate));
    return in_steps(static_cast<std::size_t>(std::min(wanted, 1e3)) + 1, least, most);
  }

  static std::size_t raised(std::size_t order, std::size_t most) {
    return in_steps(order + std::max<std::size_t>(2, order / 3), 0, most);
  }

  /// Even orders only: few rules are kept, and their nodes fill packs.
  static std::size_t in_steps(std::size_t order, std::size_t least, std::size_t most) {
    const std::size_t step = order > 16 ? 4 : 2;
    return std::clamp((order + step - 1) / step * step, least, most);
  }

  /// The rate at which the series along ψ falls off at least, whatever θ'; 0 if unknown.
  double rate_along(const Cell<Real>& cell) const {
    if (!is_even(cell)) return 0;
    double rate = std::numeric_limits<double>::infinity();
    for (const std::complex<double>& cosine : singular_cosines_)
      rate = std::min(rate, rate_drawn_to_ends(std::acos(cosine) / static_cast<double>(cell.psi_high)));
    return singular_cosines_.empty() ? 0 : rate;
  }

  /// The same across; for the angles of incidence only the width of the cell counts, as if some began at
  /// grazing.
  Across variable_across(const Cell<Real>& cell) const {
    if (singular_cosines_.empty()) return {critical_ > Real(0), 0};
    const double half = 0.5 * static_cast<double>(cell.theta_high - cell.theta_low);
    double plain = std::numeric_limits<double>::infinity();
    double drawn = plain;
    for (const std::complex<double>& cosine : singular_cosines_) {
      const std::complex<double> angle = std::asin(cosine) / half;
      const std::complex<double> nearest(
          std::min(angle.real(), 0.0) - (angle.real() < 1 ? 1 - std::max(angle.real(), 0.0) : 0.0),
          angle.imag());
      plain = std::min(plain, convergence_rate(nearest));
      drawn = std::min(drawn, rate_drawn_to_ends(nearest));
    }
    return drawn > plain ? Across{true, drawn} : Across{false, plain};
  }

  /// The rate of convergence in u, for a singularity at x = sin(πu/2).
  static double rate_drawn_to_ends(const std::complex<double>& x) {
    return convergence_rate(std::asin(x) / std::asin(1.0));
  }

  /// The integral over a cell by rules of given orders, and its errors.
  Estimate integrate(const Cell<Real>& cell, const Orders& orders, double along_rate, const Across& across) {
    const Rule& rule = series_rule<Real, Symmetry::none>(orders.across);
    const bool even = is_even(cell);
    const Rule& along = even ? series_rule<Real, Symmetry::even>(orders.along)
                             : series_rule<Real, Symmetry::none>(orders.along);
    Sum sum;
    Series series_along;
    for (const auto& node : rule.nodes) {
      const Position at = position(node.x, cell.theta_low, cell.theta_high, across.drawn_to_ends);
      Value inner(0);
      add_along(inner, series_along, cell, at.angle, along, even, node.weight * at.slope);
      std::array<Scalar, Rule::terms> projection;
      for (std::size_t i = 0; i < Rule::terms; ++i)
        projection[i] = static_cast<Scalar>(node.projection[i] * at.slope);
      sum.add(inner, static_cast<Scalar>(node.weight * at.slope), projection);
    }
    Series series_across;
    series_across.add(sum, Real(1));
    const double noise = static_cast<double>(rounding(sum.integral));
    return {sum.integral, series_along.error(along, along_rate, noise),
            series_across.error(rule, across.rate, noise)};
  }

  /// Adds cos θ' times the integral of R(e) cos²ψ over the range of ψ of the cell.
  /// @param scale weight of the angle θ'
  void add_along(Value& integral, Series& series, const Cell<Real>& cell, const Real& theta, const Rule& rule,
                 bool even, const Real& scale) {
    using std::cos;
    using std::sin;
    const Real sin_theta = sin(theta);
    const Real cos_theta = cos(theta);
    const std::vector<Real> pieces = smooth_pieces(cell, {Real(0), sin_theta, cos_theta});
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      Sum sum;
      const Real low = even ? -pieces[i + 1] : pieces[i];
      for (std::size_t start = 0; start < rule.nodes.size(); start += lanes)
        add_nodes(sum, rule, start, low, pieces[i + 1], sin_theta, cos_theta);
      integral = integral + sum.integral;
      series.add(sum, scale);
    }
  }

  /// Adds up to `lanes` nodes of a rule along ψ.
  void add_nodes(Sum& sum, const Rule& rule, std::size_t start, const Real& low, const Real& high,
                 const Real& sin_theta, const Real& cos_theta) {
    using std::cos;
    using std::sin;
    const std::size_t count = std::min(lanes, rule.nodes.size() - start);
    std::array<Real, lanes> sines, cosines, factors;
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::size_t index = start + std::min(i, count - 1);
      const Position at = position(rule.nodes[index].x, low, high, true);
      sines[i] = sin(at.angle);
      cosines[i] = cos(at.angle);
      factors[i] = cos_theta * cosines[i] * cosines[i] * at.slope;
    }
    std::array<Value, lanes> values;
    if constexpr (in_packs()) {
      const Pack cos_psi(cosines);
      const auto facet = facet_.template over_directions<lanes>();
      const CountedFacet<decltype(facet)> counted{facet, &evaluations_, static_cast<int>(count)};
      const Pack reflectances = unpolarized(
          directional_reflectance(cavity_, Vec3<Pack>{Pack(sines), sin_theta * cos_psi, cos_theta * cos_psi},
                                  counted, most_bounces_));
      std::copy(reflectances.begin(), reflectances.end(), values.begin());
    } else {
      const CountedFacet<Facet> counted{facet_, &evaluations_, 1};
      for (std::size_t i = 0; i < count; ++i)
        values[i] = unpolarized(directional_reflectance(
            cavity_, Vec3<Real>{sines[i], cosines[i] * sin_theta, cosines[i] * cos_theta}, counted,
            most_bounces_));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto& node = rule.nodes[start + i];
      std::array<Scalar, Rule::terms> projection;
      for (std::size_t term = 0; term < Rule::terms; ++term)
        projection[term] = static_cast<Scalar>(node.projection[term] * factors[i]);
      sum.add(values[i], static_cast<Scalar>(node.weight * factors[i]), projection);
    }
  }

  /// An angle, and its derivative after the variable of integration.
  struct Position {
    Real angle;
    Real slope;
  };

  /// @param u in [−1, 1]
  static Position position(const Real& u, const Real& low, const Real& high, bool drawn_to_ends) {
    using std::cos;
    using std::sin;
    const Real half = (high - low) / Real(2);
    if (!drawn_to_ends) return {low + half * (Real(1) + u), half};
    const Real quarter_turn = pi<Real>() / Real(2);
    return {low + half * (Real(1) + sin(quarter_turn * u)), half * quarter_turn * cos(quarter_turn * u)};
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

  /// The rounding error of a sum of this size, below which differences say nothing.
  static Scalar rounding(const Value& value) {
    return Scalar(4) * std::numeric_limits<Scalar>::epsilon() * largest(value);
  }

  const Cavity<Real>& cavity_;
  const Facet& facet_;
  int most_bounces_;
  Real critical_;
  std::vector<std::complex<double>> singular_cosines_;  // known, and away from the cosines in [0, 1]
  long long evaluations_ = 0;
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
