// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel's reflectance as a rational function of the cosine, for renderers that ask for it at every bounce: no root,
/// one division.
///
/// Method. As a function of a complex cosine c the reflectance of unpolarised light has a pair of poles p, p* close to
/// the interval [0, 1] of real angles, where r_p has its own, p = −1/√(m + 2) with the contrast m = (n + ik)² − 1; its
/// branch points ±√(−m) are further away, the further the larger the index (interface.hpp). So R(c) |c − p|² is
/// smooth, and a polynomial P through its values at Chebyshev nodes converges fast:
///
///     R(c) ≈ P(c)/((c − Re p)² + (Im p)²).
///
/// Range: any interface; what the fit is worth is measured when it is made, `error()`: for metals at visible wavelengths
/// 2e-7 in float, that is rounding, and 1e-12 in double.
/// When not to use it: where `error()` is too large, as near total reflection, for indices close to 1, and for mirrors
/// whose n + k is above 100; for polarisation, since it knows no fields; for indices that change from call to call, since
/// the fit asks for hundreds of reflectances.

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>

#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/interface.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity {

/// @tparam Value a number, or a `Pack` or `glm::vec` of colours
template <class Value>
class RationalFacet {
 public:
  using Real = scalar_t<Value>;

  /// Of the polynomial; enough for metals that what is left is rounding.
  static constexpr std::size_t degree = std::is_same_v<Real, float> ? 7 : 12;

  /// @param facet an interface, whose values have as many components; best in double
  template <ContrastingFacet Facet>
  explicit RationalFacet(const Facet& facet) {
    using Exact = value_t<Facet, scalar_t<decltype(facet.permittivity())>>;
    const auto contrast = detail::as_complex(facet.contrast());
    // What fills a vector register up beyond the components takes part in divisions, which are slow for denormals.
    coefficients_.fill(Value(Real(0)));
    for (std::size_t i = 0; i < component_count(pole_re_); ++i) {
      const std::complex<double> pole =
          detail::singular_cosines({static_cast<double>(component(contrast.re, i)),
                                    static_cast<double>(component(contrast.im, i))})[0];
      component(pole_re_, i) = static_cast<Real>(pole.real());
      component(pole_im2_, i) = static_cast<Real>(pole.imag() * pole.imag());
      const auto polynomial = interpolation([&](double cosine) {
        const double reflectance =
            static_cast<double>(component(facet(static_cast<scalar_t<Exact>>(cosine)), i));
        const double off = cosine - static_cast<double>(component(pole_re_, i));
        return reflectance * (off * off + static_cast<double>(component(pole_im2_, i)));
      });
      for (std::size_t k = 0; k <= degree; ++k)
        component(coefficients_[k], i) = static_cast<Real>(polynomial[k]);
    }
    // No reflectance exceeds 1, though the fit may by its error: the little that is too much is taken from all.
    for_each_check([&](double cosine) {
      const Value found = (*this)(static_cast<Real>(cosine));
      for (std::size_t i = 0; i < component_count(found); ++i) {
        const Real excess = at_least(component(found, i), Real(1));
        for (Value& coefficient : coefficients_) component(coefficient, i) /= excess;
      }
    });
    for_each_check([&](double cosine) {
      const Value found = (*this)(static_cast<Real>(cosine));
      const Exact expected = facet(static_cast<scalar_t<Exact>>(cosine));
      for (std::size_t i = 0; i < component_count(found); ++i) {
        const double difference =
            std::fabs(static_cast<double>(component(found, i)) - static_cast<double>(component(expected, i)));
        // What is no number is no small error.
        if (!(difference <= error_)) error_ = std::isnan(difference) ? HUGE_VAL : difference;
      }
    });
  }

  /// The largest difference between this and the facet that it was made from, at 257 cosines;
  /// infinite if there is no fit.
  double error() const { return error_; }

  /// Reflectance of unpolarised light.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1], one for all components or one for each
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Value operator()(const Cosine& cos_theta_i) const {
    const Value c(cos_theta_i);
    Value polynomial = coefficients_[degree];
    for (std::size_t k = degree; k-- > 0;) polynomial = polynomial * c + coefficients_[k];
    const Value off = c - pole_re_;
    return polynomial / (off * off + pole_im2_);
  }

  /// The facet that reflects a part of what this one does, at the same cost.
  /// @param part in [0, 1], of each component
  RationalFacet dimmed(const Value& part) const {
    RationalFacet result = *this;
    for (Value& coefficient : result.coefficients_) coefficient = part * coefficient;
    return result;
  }

  /// One component of the values, counted from 0, for several directions at once.
  template <std::size_t directions>
  VCAVITY_INLINE RationalFacet<Pack<Real, directions>> over_directions(std::size_t i) const {
    using Lanes = Pack<Real, directions>;
    RationalFacet<Lanes> result;
    for (std::size_t k = 0; k <= degree; ++k) result.coefficients_[k] = Lanes(component(coefficients_[k], i));
    result.pole_re_ = Lanes(component(pole_re_, i));
    result.pole_im2_ = Lanes(component(pole_im2_, i));
    result.error_ = error_;
    return result;
  }

 private:
  template <class Other>
  friend class RationalFacet;

  using Polynomial = std::array<double, degree + 1>;

  RationalFacet() = default;

  /// Calls `visit` with cosines crowded at grazing incidence, where the pole is near.
  template <class Visit>
  static void for_each_check(const Visit& visit) {
    constexpr int checks = 256;
    for (int check = 0; check <= checks; ++check) visit(std::pow(double(check) / checks, 4));
  }

  /// The polynomial through the values of a function at the Chebyshev nodes of [0, 1], by Newton's divided
  /// differences.
  template <class Function>
  static Polynomial interpolation(const Function& function) {
    Polynomial nodes, differences;
    for (std::size_t k = 0; k <= degree; ++k) {
      // Every third node first: so the products of Newton's form stay of one size.
      static_assert((degree + 1) % 3 != 0, "each node once");
      const double place = static_cast<double>(3 * k % (degree + 1)) + 0.5;
      nodes[k] = 0.5 - 0.5 * std::cos(pi<double>() * place / static_cast<double>(degree + 1));
      differences[k] = function(nodes[k]);
    }
    for (std::size_t order = 1; order <= degree; ++order)
      for (std::size_t k = degree; k >= order; --k)
        differences[k] = (differences[k] - differences[k - 1]) / (nodes[k] - nodes[k - order]);
    Polynomial result{};
    for (std::size_t k = degree + 1; k-- > 0;) {
      // result · (c − nodes[k]) + differences[k]
      for (std::size_t power = degree; power > 0; --power)
        result[power] = result[power - 1] - nodes[k] * result[power];
      result[0] = differences[k] - nodes[k] * result[0];
    }
    return result;
  }

  std::array<Value, degree + 1> coefficients_;  // of P, in ascending order
  Value pole_re_{0};
  Value pole_im2_{0};
  double error_ = 0;
};

}  // namespace vcavity
