// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What Lambertian panels send each other, in the variable in which it becomes a product.
///
/// Radiosity at distance s from the apex of one panel is lit by that at t of the other through the kernel of two strips
/// (Sparrow, J. Heat Transfer 82, 1960; Hottel's strings, 1954)
///
///     K(s, t) = ½ s t sin²α / (s² + t² − 2st cos α)^{3/2}.
///
/// In x = −ln s it depends on the difference alone: a Wiener–Hopf equation whose kernel
/// κ(u) = ½ sin²α (2 cosh u − 2 cos α)^{−3/2} is even and has the transform
/// κ̂(τ) = (π sin²α / 2 cosh πτ) |P'_{−½+iτ}(−cos α)|. All that follows from it for constant light is in one number,
///
///     H(ρ) = exp[ −(1/π) ∫₀^∞ ln(1 − ρ κ̂(½ sinh v)) dv / cosh v ].
///
/// Method. The trapezoidal rule in v, whose error falls as exp(−π²/step), and whose nodes are needed once for each
/// aperture. κ̂ itself from the integral of Mehler and Dirichlet (DLMF 14.20.9, 14.12.1), which neither oscillates nor
/// cancels: with s' = π − t,
///
///     κ̂(τ)     = 2(τ² + ¼) ∫_α^π √(sin((s'−α)/2) sin((s'+α)/2)) C ds',  C = cosh(τ(π − s')) / cosh(πτ),
///     1 − κ̂(τ) = 2(τ² + ¼) [ ∫_α^π sin²(α/2) C / (sin(s'/2) + √…) ds' + ∫_0^α sin(s'/2) C ds' ].
///
/// Valid for every aperture in (0, π] and albedos in [−1, 1] (negative ones belong to light that is odd across the
/// groove); every result has nearly all its digits, however small the aperture, the albedo or what the albedo lacks
/// from 1.

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/logarithm_sum.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/small_differences.hpp"

namespace vcavity {

/// Interreflection of one albedo: what H and its logarithm say of constant light.
template <class Real>
struct InterreflectionGain {
  Real albedo;           ///< ρ
  Real log_rim;          ///< ln H
  Real reflectance;      ///< 1 − (1−ρ)H², of every direction within the aperture
  Real bihemispherical;  ///< 1 − (1−ρ)/(ρ sin(α/2)) · [1 − (1−ρ)H²]

  /// H, the gain of radiosity by interreflection at the rim.
  Real rim() const {
    using std::exp;
    return exp(log_rim);
  }

  /// H², the mean of the gain over a panel.
  Real mean() const {
    using std::exp;
    return exp(Real(2) * log_rim);
  }

  /// 1 − (1−ρ)H, the reflectance at grazing incidence across the groove.
  Real grazing() const { return albedo - (Real(1) - albedo) * rim_excess(); }

  /// H − 1
  Real rim_excess() const {
    using std::expm1;
    return expm1(log_rim);
  }
};

/// Light that starts evenly on one panel, by the number of times that it crosses the groove; p is the product of the
/// albedos of the two panels.
template <class Real>
struct CrossingGain {
  Real twice;        ///< mean radiosity of even numbers of crossings, without the light itself, over p
  Real odd;          ///< mean radiosity of odd numbers of crossings over the albedo of the other panel
  Real even_at_rim;  ///< as `twice`, but with the light itself, not divided by p, and at the rim
  Real odd_at_rim;   ///< as `odd`, at the rim
};

/// The transformed kernel of one aperture at the nodes of the quadrature for H.
template <class Real>
class InterreflectionKernel {
 public:
  /// A node of the quadrature (2/π) ∫₀^∞ … dv / cosh v.
  struct Node {
    Real weight;
    Real transform;   ///< κ̂
    Real complement;  ///< 1 − κ̂, with all its digits
  };

  explicit InterreflectionKernel(const Cavity<Real>& cavity)
      : InterreflectionKernel(cavity, quadrature(cavity)) {}

  /// A node for a groove of mirrors.
  struct ImageNode {
    Real weight;
    std::vector<Real> transforms;  ///< κ̂ of the aperture, of twice the aperture, and so on below π
  };

  /// The nodes of a groove together with the grooves that a panel forms with the mirror images of the other.
  static std::vector<ImageNode> images(const Cavity<Real>& cavity) {
    using std::sinh;
    const InterreflectionKernel kernel(cavity);
    std::vector<ImageNode> result;
    for (const Node& node : kernel.nodes_) result.push_back({node.weight, {node.transform}});
    for (int multiple = 2; Real(multiple) * cavity.aperture() < pi<Real>(); ++multiple) {
      const MehlerIntegral mehler(Real(multiple) * cavity.aperture());
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i].transforms.push_back(
            mehler.at(sinh(Real(static_cast<int>(i)) * step()) / Real(2)).transform);
    }
    return result;
  }

  const Cavity<Real>& cavity() const { return cavity_; }

  /// The nodes at which κ̂ is not negligible, in ascending order of v.
  const std::vector<Node>& nodes() const { return nodes_; }

  /// The weight of all further nodes together.
  Real tail_weight() const { return tail_weight_; }

  /// H and what follows from it, at a price that hardly depends on the aperture.
  /// @param albedo ρ in [−1, 1]
  InterreflectionGain<Real> gain(const Real& albedo) const {
    using std::exp;
    using std::log;
    using std::log1p;
    const Real sin_half = cavity_.sin_half();
    const Real lack = Real(1) - albedo;
    if (albedo > Real(0) && lack <= albedo * logarithms_.all_above()) {
      // 1 − ρκ̂ from what is missing of 1 in either factor.
      const Real log_mean = -log(albedo) - logarithms_.with_all_above(Real(lack / albedo));
      const Real absorbed = lack * exp(log_mean);
      return {albedo, log_mean / Real(2), Real(1) - absorbed,
              Real(1) - lack * (Real(1) - absorbed) / (albedo * sin_half)};
    }
    // ln[(1−ρ)H²] = −(2/π) ∫ ln(1 + z(1 − κ̂)) dv / cosh v with z = ρ/(1−ρ): all terms of one sign, and the integral of
    // z(1 − κ̂) itself is z sin(α/2), so that a small reflectance is not the difference of large numbers.
    const Real z = albedo / lack;
    if (z == Real(0)) return {albedo, Real(0), Real(0), Real(0)};
    const LogarithmAndRest<Real> sum = z < Real(0) ? logarithms_.at_negative(z) : logarithms_.at(z);
    const ExponentialAndRest<Real> absorbed = exponential_and_rest(Real(-sum.logarithm));
    return {albedo, (-log1p(Real(-albedo)) - sum.logarithm) / Real(2), -absorbed.less_one,
            (sum.rest + absorbed.rest) / (z * sin_half)};
  }

  /// H(√p)² and H(−√p)², taken apart into even and odd numbers of crossings; with all digits as p tends to 0.
  /// @param product p = ρ₁ρ₂ in [0, 1]
  CrossingGain<Real> crossings(const Real& product) const {
    using std::atanh;
    using std::cosh;
    using std::exp;
    using std::expm1;
    using std::log1p;
    using std::sinh;
    using std::sqrt;
    const Real root = sqrt(product);
    // ln H(√p)² = even + odd, ln H(−√p)² = even − odd.
    Real even_over_product(0);
    Real odd_over_root(0);
    for (const Node& node : nodes_) {
      const Real x = root * node.transform;
      const bool tiny = !(x * x > std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon());
      const Real square = node.transform * node.transform;
      even_over_product += node.weight / Real(2) * (tiny ? square : Real(-log1p(Real(-x * x)) / product));
      odd_over_root += node.weight * (tiny ? node.transform : Real(atanh(x) / root));
    }
    const Real even = product * even_over_product;
    const Real odd = root * odd_over_root;
    if (!(odd > sqrt(std::numeric_limits<Real>::min())))
      return {even_over_product + odd_over_root * odd_over_root / Real(2), odd_over_root, Real(1),
              odd_over_root / Real(2)};
    const Real half_sinh = sinh(odd / Real(2));
    return {(expm1(even) + Real(2) * exp(even) * half_sinh * half_sinh) / product,
            exp(even) * sinh(odd) / root, exp(even / Real(2)) * cosh(odd / Real(2)),
            exp(even / Real(2)) * half_sinh / root};
  }

 private:
  /// −ln ε, and a little more.
  static Real digits() {
    using std::log;
    return Real(2) - log(std::numeric_limits<Real>::epsilon());
  }

  /// Of the trapezoidal rule.
  static Real step() { return pi<Real>() * pi<Real>() / digits(); }

  struct Quadrature {
    std::vector<Node> nodes;
    Real tail_weight;
  };

  static Quadrature quadrature(const Cavity<Real>& cavity) {
    using std::asinh;
    using std::cosh;
    using std::sinh;
    const MehlerIntegral mehler(cavity.aperture());
    const Real last = asinh(Real(2) * (digits() + Real(4)) / cavity.aperture());
    Quadrature result{{}, Real(0)};
    for (int i = 0;; ++i) {
      const Real v = Real(i) * step();
      const Real weight = (i == 0 ? Real(1) : Real(2)) * step() / (pi<Real>() * cosh(v));
      const Real negligible = std::numeric_limits<Real>::epsilon() / Real(16);
      if (v <= last) {
        Node node = mehler.at(sinh(v) / Real(2));
        node.weight = weight;
        if (weight * node.transform > negligible * cavity.sin_half()) {
          result.nodes.push_back(node);
          continue;
        }
      }
      result.tail_weight += weight;
      if (weight < negligible * result.tail_weight) break;
    }
    return result;
  }

  InterreflectionKernel(const Cavity<Real>& cavity, Quadrature quadrature)
      : cavity_(cavity),
        nodes_(std::move(quadrature.nodes)),
        tail_weight_(quadrature.tail_weight),
        logarithms_(logarithms(nodes_, tail_weight_)) {}

  /// Σ of the weights times ln(1 + z(1 − κ̂)); where κ̂ is negligible, ln(1 + z).
  static LogarithmSum<Real> logarithms(const std::vector<Node>& nodes, const Real& tail_weight) {
    std::vector<Real> weights, places;
    for (const Node& node : nodes) {
      weights.push_back(node.weight);
      places.push_back(node.complement);
    }
    weights.push_back(tail_weight);
    places.push_back(Real(1));
    return {std::move(weights), std::move(places)};
  }

  /// The two integrals, with the factors that τ does not change.
  class MehlerIntegral {
   public:
    explicit MehlerIntegral(const Real& aperture) : aperture_(aperture) {
      using std::acosh;
      using std::ceil;
      using std::cosh;
      using std::sin;
      using std::sinh;
      using std::sqrt;
      const auto rule = gauss_legendre<Real>(std::numeric_limits<Real>::digits * 3 / 10 + 5);
      const Real sin_half = sin(aperture / Real(2));
      // s' − α = α(cosh y − 1) takes the square root away and follows the logarithmic scale from α to π.
      const Real length = pi<Real>() - aperture;
      if (length > Real(0)) {
        const Real range = acosh(Real(1) + length / aperture);
        const int panels = static_cast<int>(ceil(range));
        const Real half_width = range / Real(2 * panels);
        for (int panel = 0; panel < panels; ++panel)
          for (const QuadratureNode<Real>& node : rule) {
            const Real y = half_width * (Real(2 * panel + 1) + node.x);
            const Real half_sinh = sinh(y / Real(2));
            const Real beyond = Real(2) * aperture * half_sinh * half_sinh;
            const Real weight = node.weight * half_width * aperture * sinh(y);
            // The nearest float to π lies above π.
            const Real product = sin(beyond / Real(2)) * sin(aperture + beyond / Real(2));
            const Real root = sqrt(at_least(product, Real(0)));
            const Real angle = aperture + beyond;
            outer_.push_back(
                {angle, weight * root, weight * sin_half * sin_half / (sin(angle / Real(2)) + root)});
          }
      }
      for (const QuadratureNode<Real>& node : rule) {
        const Real angle = aperture * (Real(1) + node.x) / Real(2);
        inner_.push_back({angle, Real(0), node.weight * aperture / Real(2) * sin(angle / Real(2))});
      }
    }

    /// κ̂(τ) and 1 − κ̂(τ).
    Node at(const Real& tau) const {
      const Real factor = Real(2) * (tau * tau + Real(0.25));
      if (tau * aperture_ > Real(1)) {
        Real sum(0);
        for (const Term& term : outer_) sum += term.transform * attenuation(tau, term.angle);
        return {Real(0), factor * sum, Real(1) - factor * sum};
      }
      Real sum(0);
      for (const auto* terms : {&outer_, &inner_})
        for (const Term& term : *terms) sum += term.complement * attenuation(tau, term.angle);
      return {Real(0), Real(1) - factor * sum, factor * sum};
    }

   private:
    struct Term {
      Real angle;
      Real transform;
      Real complement;
    };

    /// cosh(τ(π − s')) / cosh(πτ), where neither need be representable.
    static Real attenuation(const Real& tau, const Real& angle) {
      using std::exp;
      return (exp(-tau * angle) + exp(-tau * (Real(2) * pi<Real>() - angle))) /
             (Real(1) + exp(-Real(2) * pi<Real>() * tau));
    }

    Real aperture_;
    std::vector<Term> outer_;
    std::vector<Term> inner_;
  };

  Cavity<Real> cavity_;
  std::vector<Node> nodes_;
  Real tail_weight_;
  LogarithmSum<Real> logarithms_;
};

}  // namespace vcavity
