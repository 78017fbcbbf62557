// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel's reflectance as a rational function of the cosine, for renderers that ask for it at every bounce: no root,
/// one division.
///
/// Method. At grazing incidence all light is reflected, and what is lost near it, 1 − R(c) ~ c, is an analytic function
/// of the cosine: its nearest singularities are the poles of r_p and r_s on the far side of 0, its branch points are
/// further away (interface.hpp). So a quotient of polynomials converges fast,
///
///     R(c) ≈ P(c)/Q(c),   P(0) = Q(0) = 1,
///
/// through the values at Chebyshev nodes: a linear system for the coefficients. Where it has a zero next to a pole, as
/// happens when it has more of them than there is to fit, one degree less is better; of four pairs of degrees the one with
/// the least error is taken.
///
/// Range: any interface; what the fit is worth is measured when it is made, `error()`: for most metals at visible
/// wavelengths 2e-7 in float and 1e-13 in double, that is rounding, in float 6e-7 for copper in the green; for glasses
/// 1e-6 and 1e-12.
/// When not to use it: where `error()` is too large, as near total reflection or for indices close to 1; for polarisation,
/// since it knows no fields; for indices that change from call to call, since the fit asks for hundreds of reflectances.

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/interface.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/linear_system.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity {

/// @tparam Value a number, or a `Pack` or `glm::vec` of colours
template <class Value>
class RationalFacet {
 public:
  using Real = scalar_t<Value>;

  /// Of both polynomials; enough for most metals that what is left is rounding.
  static constexpr std::size_t degree = detail::has_short_series<Value> ? 4 : 7;

  /// @param facet an interface, whose values have as many components; best in double
  template <ContrastingFacet Facet>
  explicit RationalFacet(const Facet& facet) {
    using Exact = value_t<Facet, scalar_t<decltype(facet.permittivity())>>;
    // What fills a vector register up beyond the components takes part in divisions, which are slow for denormals.
    numerator_.fill(Value(Real(1)));
    denominator_.fill(Value(Real(1)));
    for (std::size_t i = 0; i < component_count(numerator_[0]); ++i) {
      const Fit fit = best_fit([&](double cosine) {
        return static_cast<double>(component(facet(static_cast<scalar_t<Exact>>(cosine)), i));
      });
      for (std::size_t k = 0; k <= degree; ++k) component(numerator_[k], i) = fit.numerator[k];
      for (std::size_t k = 0; k < degree; ++k) component(denominator_[k], i) = fit.denominator[k];
      error_ = at_least(fit.error, error_);
    }
  }

  /// The largest difference between this and the facet that it was made from, at 257 cosines;
  /// infinite if there is no fit.
  double error() const { return error_; }

  /// Reflectance of unpolarised light.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1], one for all components or one for each
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Value operator()(const Cosine& cos_theta_i) const {
    const Fraction<Value> value = fraction(cos_theta_i);
    return value.numerator / value.denominator;
  }

  /// The same before the division; products of four of them are finite in float.
  /// @param cos_theta_i as above
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Fraction<Value> fraction(const Cosine& cos_theta_i) const {
    return fraction(numerator_, denominator_, Value(cos_theta_i));
  }

  /// The facet that reflects a part of what this one does, at the same cost.
  /// @param part in [0, 1], of each component
  RationalFacet dimmed(const Value& part) const {
    RationalFacet result = *this;
    for (Value& coefficient : result.numerator_) coefficient = part * coefficient;
    return result;
  }

  /// The same facet for values of another kind and the same precision.
  /// @param converted what a coefficient becomes
  template <class Other, class Converted>
  RationalFacet<Other> in(const Converted& converted) const {
    static_assert(RationalFacet<Other>::degree == degree);
    RationalFacet<Other> result;
    for (std::size_t k = 0; k <= degree; ++k) result.numerator_[k] = converted(numerator_[k]);
    for (std::size_t k = 0; k < degree; ++k) result.denominator_[k] = converted(denominator_[k]);
    result.error_ = error_;
    return result;
  }

  /// One component of the values, counted from 0, for several directions at once.
  template <std::size_t directions>
  VCAVITY_INLINE RationalFacet<Pack<Real, directions>> over_directions(std::size_t i) const {
    using Lanes = Pack<Real, directions>;
    return in<Lanes>([i](const Value& coefficient) { return Lanes(component(coefficient, i)); });
  }

 private:
  template <class Other>
  friend class RationalFacet;

  /// Coefficients of P, and of Q without the first one, which is 1; in ascending order.
  template <class Number>
  using Numerator = std::array<Number, degree + 1>;
  template <class Number>
  using Denominator = std::array<Number, degree>;

  // Its fourth power is finite in float, and so is the inverse of that.
  static constexpr double largest_denominator = 1e9;

  struct Fit {
    Numerator<Real> numerator{};
    Denominator<Real> denominator{};
    double error = HUGE_VAL;
  };

  RationalFacet() = default;

  template <class Number>
  VCAVITY_INLINE static Fraction<Number> fraction(const Numerator<Number>& above,
                                                  const Denominator<Number>& below, const Number& c) {
    Number p = above[degree], q = below[degree - 1];
    for (std::size_t k = degree; k-- > 0;) p = p * c + above[k];
    for (std::size_t k = degree - 1; k-- > 0;) q = q * c + below[k];
    q = q * c + Number(Real(1));
    return {p, q};
  }

  /// The cosine of a check, crowded at grazing incidence, where the poles are near.
  static constexpr int checks = 256;
  static Real check_cosine(int check) { return static_cast<Real>(std::pow(double(check) / checks, 4)); }

  /// The best of the fits to a reflectance.
  template <class Reflectance>
  static Fit best_fit(const Reflectance& reflectance) {
    Fit best;
    for (const std::size_t above : {degree, degree - 1})
      for (const std::size_t below : {degree, degree - 1}) {
        const Fit fit = interpolation(reflectance, above, below);
        // What is no number is no small error.
        if (fit.error < best.error) best = fit;
      }
    return best;
  }

  /// The quotient of polynomials of these degrees through the values of a reflectance at the Chebyshev nodes of [0, 1].
  template <class Reflectance>
  static Fit interpolation(const Reflectance& reflectance, std::size_t above, std::size_t below) {
    // 1 − R = c A(c)/Q(c) at the nodes; P = Q − c A.
    const std::size_t size = above + below;
    SquareMatrix<double> equations(size);
    std::vector<double> lost(size);
    for (std::size_t i = 0; i < size; ++i) {
      const double c =
          0.5 - 0.5 * std::cos(pi<double>() * (static_cast<double>(i) + 0.5) / static_cast<double>(size));
      lost[i] = 1 - reflectance(c);
      double power = 1;
      for (std::size_t k = 0; k < degree; ++k) {
        power *= c;
        if (k < above) equations[i][k] = power;
        if (k < below) equations[i][above + k] = -lost[i] * power;
      }
    }
    const std::vector<double> solution = LuFactors<double>(std::move(equations)).solve(std::move(lost));
    Fit fit;
    fit.numerator[0] = Real(1);
    for (std::size_t k = 0; k < degree; ++k) {
      const double q = k < below ? solution[above + k] : 0;
      const double a = k < above ? solution[k] : 0;
      fit.numerator[k + 1] = static_cast<Real>(q - a);
      fit.denominator[k] = static_cast<Real>(q);
    }
    // No reflectance exceeds 1, though the fit may by its error: the little that is too much is taken from all.
    Real highest(1);
    for (int check = 0; check <= checks; ++check) {
      const auto [p, q] = fraction(fit.numerator, fit.denominator, check_cosine(check));
      highest = at_least(Real(p / q), highest);
    }
    for (Real& coefficient : fit.numerator) coefficient /= highest;
    fit.error = 0;
    for (int check = 0; check <= checks; ++check) {
      const Real c = check_cosine(check);
      const auto [p, q] = fraction(fit.numerator, fit.denominator, c);
      const double difference = std::fabs(static_cast<double>(p / q) - reflectance(static_cast<double>(c)));
      const bool is_moderate = q > 1 / largest_denominator && q < largest_denominator;
      fit.error = is_moderate && !std::isnan(difference) ? at_least(difference, fit.error) : HUGE_VAL;
    }
    return fit;
  }

  Numerator<Value> numerator_;
  Denominator<Value> denominator_;
  double error_ = 0;
};

}  // namespace vcavity
