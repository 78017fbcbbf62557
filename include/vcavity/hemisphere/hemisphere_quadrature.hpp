// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Quadrature over the hemisphere for `bihemispherical_reflectance`: adaptive, and led by what the facet
/// tells about its singularities.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <vector>

#include "vcavity/groove/reflectance.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/hemisphere/kinks.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/legendre_series.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/sine_substitution.hpp"

namespace vcavity::detail {

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

/// A facet that notes the angles between the direction and the panels, in the plane across the groove.
template <class Real>
struct AngleRecorder {
  Real operator()(const Bounce<Real>& bounce) const {
    const double angle = std::atan2(static_cast<double>(bounce.cosine), static_cast<double>(bounce.tangent));
    angles.push_back(angle);
    constexpr double nearly_one = 0.9;
    if (std::sin(angle) > nearly_one) ++upright;
    return Real(1);
  }

  mutable std::vector<double> angles;
  mutable int upright = 0;  ///< the number of bounces off panels that face the direction
};

/// A rectangle of directions.
template <class Real>
struct Cell {
  Real theta_low, theta_high;  ///< bounds of θ'
  Real psi_low, psi_high;      ///< bounds of ψ
};

/// The integrand of the bi-hemispherical reflectance and its quadrature over cells.
///
/// By symmetry the light that meets either panel first reflects as much, and light from e_x as much as from
/// −e_x. So it is enough to follow what meets panel one first; its weights have half as many kinks.
///
/// In both angles the variable of integration draws nodes to the ends of the range as far as the facet asks
/// for it: towards grazing incidence, near which the reflectance of a metal changes most, and towards
/// critical angles, where reflectances start like a square root.
///
/// The first order tried is the one that the singularities of the facet ask for. Then the Legendre series of
/// the integrand is looked at: its last known terms, and the rate at which they fall off, tell how large are
/// those that the rule misses. The rate is the smaller one of those observed and derived from the
/// singularities, or 0.4 times the observed one where these are not known.
template <class Real, class Facet>
class HemisphereQuadrature {
 public:
  using Value = unpolarized_t<Facet, Real>;
  using Scalar = scalar_t<Value>;

  HemisphereQuadrature(const Cavity<Real>& cavity, const Facet& facet, int max_bounces)
      : cavity_(cavity),
        facet_(facet),
        max_bounces_(max_bounces),
        critical_(critical_cosine_of<Real>(facet)),
        singular_cosines_(critical_ > Real(0) ? std::vector<std::complex<double>>{}
                                              : singular_cosines_of(facet)),
        whole_along_(convergence_to(pi<Real>() / Real(2))) {}

  /// The integral of R_1(e) cos²ψ cos θ' over [−α/2, π/2] × [0, π/2], with R_1 the part of the reflectance
  /// that belongs to light which meets panel one first.
  Integral<Value> operator()(const Scalar& tolerance) {
    const std::vector<Real> kinks = kinks_of_panel(cavity_, critical_);
    const std::size_t cells = kinks.size() - 1;
    const Scalar least = tolerance / Scalar(static_cast<int>(2 * cells));
    Integral<Value> total{Value(0), Scalar(0), 0};
    for (std::size_t i = 0; i < cells; ++i) {
      // What the cells before have not used up is left for the others; if that is no number, `least`.
      const Scalar left = (tolerance - total.error) / Scalar(static_cast<int>(cells - i));
      add(total, {kinks[i], kinks[i + 1], Real(0), pi<Real>() / Real(2)}, left > least ? left : least, 0);
    }
    total.evaluations = evaluations_;
    return total;
  }

 private:
  using Rule = SeriesRule<Real>;

  /// Whether facets are asked for several directions of the same θ' at once.
  static constexpr bool in_packs() {
    if constexpr (std::is_floating_point_v<Real> && OverDirections<Facet>)
      return std::is_same_v<Value, Real>;
    else
      return false;
  }
  static constexpr std::size_t lanes = in_packs() ? 4 : 1;
  using Reals = std::conditional_t<in_packs(), Pack<Real, 4>, Real>;
  using Values = std::conditional_t<in_packs(), Pack<Real, 4>, Value>;

  static constexpr std::size_t least_along = 4, most_along = 64, most_across = 40;
  static constexpr int most_halvings = 40;  // of one cell
  static constexpr int most_parts = 8;      // of a range of ψ between two critical angles
  static constexpr long long most_evaluations = 50'000'000;

  /// A sum of values, and of the terms of the Legendre series with them.
  template <class Addend>
  struct Sum {
    Addend integral = Addend(0);
    std::array<Addend, Rule::terms> terms{Addend(0), Addend(0), Addend(0), Addend(0)};

    template <class Weight>
    void add(const Addend& value, const Weight& weight, const std::array<Weight, Rule::terms>& projection) {
      integral = integral + scaled(weight, value);
      for (std::size_t i = 0; i < Rule::terms; ++i) terms[i] = terms[i] + scaled(projection[i], value);
    }
  };

  /// The sizes of the terms of several series, added up.
  struct Series {
    std::array<double, Rule::terms> sizes{};

    template <class Addend>
    void add(const Sum<Addend>& sum, const Real& weight) {
      for (std::size_t i = 0; i < Rule::terms; ++i)
        sizes[i] += static_cast<double>(weight) * static_cast<double>(largest(total(sum.terms[i])));
    }

    /// The error of a rule.
    /// @param known_rate rate at which the series falls off in the end, 0 if unknown
    /// @param multiplicity of the singularities: with a pole of order p the terms fall off like k^(p − 1)
    /// exp(−rate k)
    /// @param noise rounding error of the coefficients
    double error(const Rule& rule, double known_rate, int multiplicity, double noise) const {
      constexpr double safety = 10;  // by trial, over random grooves and facets
      // Either of two neighbours may be small by chance, but hardly both.
      const std::size_t middle = sizes[0] > sizes[1] ? 0 : 1;
      const std::size_t last = sizes[2] > sizes[3] ? 2 : 3;
      if (sizes[last] <= noise * rule.degrees[last]) return 0;
      const double observed =
          std::max(std::log(sizes[middle] / sizes[last]) / (rule.degrees[last] - rule.degrees[middle]), 0.0);
      const double rate = known_rate > 0 ? std::min(known_rate, observed) : 0.4 * observed;
      const double missed_degree = rule.exact_degree + 1;
      const auto missed = [&](std::size_t known) {
        const double further = missed_degree - rule.degrees[known];
        return sizes[known] * std::pow(missed_degree / rule.degrees[known], multiplicity - 1) *
               std::exp(-rate * further);
      };
      return safety * std::max(missed(3), missed(2));  // of what is no number the first stays
    }
  };

  /// A node, or a pack of nodes, along ψ.
  struct AlongNode {
    Reals sine, cosine;  // of ψ
    Reals weight;
    std::array<Reals, Rule::terms> projection;
  };

  struct Estimate {
    Value value;
    double along_error, across_error;
  };

  /// Adds the integral over one cell, halved along the angle in which the highest order does not suffice.
  void add(Integral<Value>& total, const Cell<Real>& cell, const Scalar& tolerance, int halvings) {
    const Convergence along = convergence_along(cell);
    const AngleRecorder<Real> bounces = bounces_in(cell);
    const Convergence across = convergence_across(cell, bounces.angles);
    const int degrees_along = is_even(cell) ? 4 : 2;  // made exact by each node
    constexpr int degrees_across = 2;
    const double half_tolerance = 0.5 * static_cast<double>(tolerance);
    // Towards grazing along the groove, bounces off panels that face the light share the pole of r_p² nearest
    // to them.
    const int multiplicity = 2 * std::max(bounces.upright, 1);
    // What sufficed for the cell before is a good guess for its neighbour.
    const Orders along_orders{4, halvings > 0 ? least_along : std::max(least_along, usual_along_), most_along,
                              degrees_along * along.rate};
    const Orders across_orders{1, least_across(cell), most_across, degrees_across * across.rate};
    std::size_t along_order = along_orders.first(half_tolerance * std::exp2(-std::min(multiplicity, 6)));
    std::size_t across_order = across_orders.first(half_tolerance);
    int parts = 1;
    for (;;) {
      const Estimate estimate =
          integrate(cell, along_order, along, multiplicity, parts, across_order, across);
      // What along does not use up is left for across.
      const double enough = std::max(half_tolerance, static_cast<double>(rounding(estimate.value)));
      const double enough_across = 2 * enough - std::min(estimate.along_error, enough);
      const bool as_far_as_possible = is_cut() && along_order >= most_along && parts >= most_parts;
      const bool along_converged = as_far_as_possible || estimate.along_error <= enough;
      const bool across_converged = estimate.across_error <= enough_across;
      const bool is_number = std::isfinite(estimate.along_error + estimate.across_error);
      if ((along_converged && across_converged) || !is_number || halvings >= most_halvings ||
          evaluations_ >= most_evaluations) {
        if (halvings == 0) usual_along_ = along_order;
        total.value = total.value + estimate.value;
        total.error = total.error + static_cast<Scalar>(estimate.along_error + estimate.across_error) +
                      rounding(estimate.value);
        return;
      }
      const Scalar half = tolerance / Scalar(2);
      if (!along_converged && along_order >= most_along && is_cut()) {
        parts *= 2;  // halving the cell would add kinks, where the cuts cross its middle
        continue;
      }
      if (!along_converged && along_order >= most_along) {
        const Real middle = (cell.psi_low + cell.psi_high) / Real(2);
        add(total, {cell.theta_low, cell.theta_high, cell.psi_low, middle}, half, halvings + 1);
        add(total, {cell.theta_low, cell.theta_high, middle, cell.psi_high}, half, halvings + 1);
        return;
      }
      if (!across_converged && across_order >= most_across) {
        const Real middle = (cell.theta_low + cell.theta_high) / Real(2);
        add(total, {cell.theta_low, middle, cell.psi_low, cell.psi_high}, half, halvings + 1);
        add(total, {middle, cell.theta_high, cell.psi_low, cell.psi_high}, half, halvings + 1);
        return;
      }
      if (!along_converged) along_order = along_orders.next(along_order, enough / estimate.along_error);
      if (!across_converged)
        across_order = across_orders.next(across_order, enough_across / estimate.across_error);
    }
  }

  /// The orders of the rules for one of the angles.
  struct Orders {
    std::size_t
        step;  ///< along ψ 4: nodes come in packs; across 1, for every node stands for many directions
    std::size_t least, most;
    double rate;  ///< per node; a guess stands in for 0

    /// The number of nodes that bring an error down by a factor.
    std::size_t nodes(double factor) const {
      constexpr double guess = 1.5;
      const double order = std::log(1 / std::min(factor, 0.5)) / (rate > 0 ? rate : guess);
      return step * static_cast<std::size_t>(std::ceil(std::min(order, 1e3) / static_cast<double>(step)));
    }

    std::size_t first(double error) const { return std::clamp(nodes(error), least, most); }

    /// The next order to try; a little higher where the rate is not known.
    std::size_t next(std::size_t order, double factor) const {
      return std::min(order + (rate > 0 ? nodes(factor) : (order + 15) / 16 * 4), most);
    }
  };

  /// The least order across a cell. In a wide one, a few terms of the series do not show how it falls off.
  static std::size_t least_across(const Cell<Real>& cell) {
    const double quarter_turns =
        static_cast<double>(cell.theta_high - cell.theta_low) / (std::numbers::pi / 2);
    return std::max<std::size_t>(4, static_cast<std::size_t>(std::lround(4 * quarter_turns)));
  }

  /// Whether ψ is cut at critical angles.
  bool is_cut() const { return critical_ > Real(0); }

  /// Whether the integrand is even about the lower end of ψ.
  bool is_even(const Cell<Real>& cell) const { return cell.psi_low == Real(0) && !is_cut(); }

  /// The variable along ψ; the rate holds for all θ'.
  Convergence convergence_along(const Cell<Real>& cell) const {
    if (!is_even(cell)) return {DrawnVariable(1), 0};
    return cell.psi_high < pi<Real>() / Real(2) ? convergence_to(cell.psi_high) : whole_along_;
  }

  /// The variable from 0 to ψ.
  Convergence convergence_to(const Real& psi) const {
    if (singular_cosines_.empty()) return {DrawnVariable(1), 0};
    std::vector<std::complex<double>> singularities;
    for (const std::complex<double>& cosine : singular_cosines_)
      singularities.push_back(std::acos(cosine) / static_cast<double>(psi));
    return best_variable(singularities);
  }

  /// The variable across; the rate holds for all ψ.
  /// @param angles between the light and the panels in the middle of the cell
  Convergence convergence_across(const Cell<Real>& cell, const std::vector<double>& angles) const {
    if (singular_cosines_.empty()) return {DrawnVariable(critical_ > Real(0) ? 1 : 0), 0};
    const double half = 0.5 * static_cast<double>(cell.theta_high - cell.theta_low);
    std::vector<std::complex<double>> singularities;
    for (const std::complex<double>& cosine : singular_cosines_) {
      const std::complex<double> grazing = std::asin(cosine);
      for (const double angle : angles) {
        singularities.push_back((grazing - angle) / half);
        singularities.push_back((std::numbers::pi - grazing - angle) / half);
      }
    }
    return best_variable(singularities);
  }

  /// The bounces of the directions of a cell.
  AngleRecorder<Real> bounces_in(const Cell<Real>& cell) const {
    using std::cos;
    using std::sin;
    const Real middle = (cell.theta_low + cell.theta_high) / Real(2);
    AngleRecorder<Real> recorder;
    unpolarized_reflectance(cavity_, Vec3<Real>{Real(0), sin(middle), cos(middle)}, recorder, max_bounces_,
                            Panel::one);
    return recorder;
  }

  /// The integral over a cell by rules of given orders, and its errors.
  Estimate integrate(const Cell<Real>& cell, std::size_t along_order, const Convergence& along,
                     int multiplicity, int parts, std::size_t across_order, const Convergence& across) {
    using std::cos;
    using std::sin;
    const Rule& across_rule = series_rule<Real, Symmetry::none>(across_order);
    const Rule& along_rule = is_even(cell) ? series_rule<Real, Symmetry::even>(along_order)
                                           : series_rule<Real, Symmetry::none>(along_order);
    if (!is_cut()) {
      nodes_.clear();
      add_nodes(along_rule, along.variable, is_even(cell) ? Real(-cell.psi_high) : cell.psi_low,
                cell.psi_high);
    }
    const Real middle = (cell.theta_low + cell.theta_high) / Real(2);
    const Real half = (cell.theta_high - cell.theta_low) / Real(2);
    Sum<Value> sum;
    Series series_along;
    for (const auto& node : across_rule.nodes) {
      const auto [x, slope] = across.variable.at(node.x);
      const Real theta = middle + half * x;
      const Real sin_theta = sin(theta);
      const Real cos_theta = cos(theta);
      const Real scale = half * slope * cos_theta;
      Value inner(0);
      if (is_cut()) {
        const std::vector<Real> pieces = smooth_pieces(cell, {Real(0), sin_theta, cos_theta});
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
          const Real width = (pieces[i + 1] - pieces[i]) / Real(parts);
          for (int part = 0; part < parts; ++part) {
            nodes_.clear();
            add_nodes(along_rule, along.variable, pieces[i] + Real(part) * width,
                      pieces[i] + Real(part + 1) * width);
            inner = inner + integrate_along(series_along, node.weight * scale, sin_theta, cos_theta);
          }
        }
      } else {
        inner = integrate_along(series_along, node.weight * scale, sin_theta, cos_theta);
      }
      std::array<Real, Rule::terms> projection;
      for (std::size_t i = 0; i < Rule::terms; ++i) projection[i] = node.projection[i] * scale;
      sum.add(inner, Real(node.weight * scale), projection);
    }
    Series series_across;
    series_across.add(sum, Real(1));
    const double noise = static_cast<double>(rounding(sum.integral));
    const double along_error = series_along.error(along_rule, along.rate, multiplicity, noise);
    // What is wrong with the integrals along ψ is noise to the series across.
    return {sum.integral, along_error,
            series_across.error(across_rule, across.rate, 2, noise + along_error / across_rule.degrees[3])};
  }

  /// Adds the nodes of a rule from ψ = low to high to `nodes_`, with cos²ψ in their weights.
  void add_nodes(const Rule& rule, const DrawnVariable& variable, const Real& low, const Real& high) {
    using std::cos;
    using std::sin;
    const Real middle = (low + high) / Real(2);
    const Real half = (high - low) / Real(2);
    for (std::size_t start = 0; start < rule.nodes.size(); start += lanes) {
      AlongNode node{};
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const auto& [u, weight, projection] = rule.nodes[start + lane];
        const auto [x, slope] = variable.at(u);
        const Real psi = middle + half * x;
        const Real cosine = cos(psi);
        const Real factor = half * slope * cosine * cosine;
        component(node.sine, lane) = sin(psi);
        component(node.cosine, lane) = cosine;
        component(node.weight, lane) = factor * weight;
        for (std::size_t i = 0; i < Rule::terms; ++i)
          component(node.projection[i], lane) = factor * projection[i];
      }
      nodes_.push_back(node);
    }
  }

  /// The integral of R(e) cos²ψ over the nodes along ψ.
  /// @param weight of the angle θ' in the whole
  Value integrate_along(Series& series, const Real& weight, const Real& sin_theta, const Real& cos_theta) {
    Sum<Values> sum;
    for (const AlongNode& node : nodes_)
      sum.add(reflectance({node.sine, sin_theta * node.cosine, cos_theta * node.cosine}), node.weight,
              node.projection);
    series.add(sum, weight);
    return total(sum.integral);
  }

  /// R_1(e)
  Values reflectance(const Vec3<Reals>& e) {
    if constexpr (in_packs()) {
      const auto facet = facet_.template over_directions<lanes>();
      const CountedFacet<decltype(facet)> counted{facet, &evaluations_, static_cast<int>(lanes)};
      // Packs want e.y ≥ 0; the mirror image of e meets panel two.
      return unpolarized_reflectance(cavity_, Vec3<Reals>{e.x, magnitude(e.y), e.z}, counted, max_bounces_,
                                     e.y[0] < Real(0) ? Panel::two : Panel::one);
    } else {
      return unpolarized_reflectance(cavity_, e, CountedFacet<Facet>{facet_, &evaluations_, 1}, max_bounces_,
                                     Panel::one);
    }
  }

  static Real& component(Reals& values, std::size_t lane) {
    if constexpr (in_packs())
      return values[lane];
    else
      return values;
  }

  /// The sum over the directions of a pack.
  template <class Addend>
  static Value total(const Addend& values) {
    if constexpr (in_packs() && !std::is_same_v<Addend, Value>)
      return std::accumulate(values.begin(), values.end(), Value(0));
    else
      return values;
  }

  /// The range of ψ of the cell, cut where some bounce is at the critical angle.
  /// @param e direction at ψ = 0
  std::vector<Real> smooth_pieces(const Cell<Real>& cell, const Vec3<Real>& e) const {
    using std::acos;
    std::vector<Real> pieces{cell.psi_low, cell.psi_high};
    for (UnfoldedRay<Real> ray(cavity_, e, Panel::one); ray.number() <= cavity_.max_bounces();
         ray.advance()) {
      if (!(ray.normal_component() > critical_)) continue;
      const Real psi = acos(critical_ / ray.normal_component());
      if (psi > cell.psi_low && psi < cell.psi_high) pieces.push_back(psi);
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
  int max_bounces_;
  Real critical_;
  std::vector<std::complex<double>> singular_cosines_;  // known, and none of them in [0, 1]
  Convergence whole_along_;                             // from ψ = 0 to π/2
  std::vector<AlongNode> nodes_;
  std::size_t usual_along_ = 0;  // the order along ψ of the last cell
  long long evaluations_ = 0;
};

}  // namespace vcavity::detail
