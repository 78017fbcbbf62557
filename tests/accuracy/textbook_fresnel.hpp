// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel's formulas as textbooks print them, with Snell's law for the complex cosine of refraction, in 50
/// digits: cancellation costs some of the fifty, and leaves plenty.

#include <vcavity/complex.hpp>

#include "support/reals.hpp"

namespace vcavity::test {

/// Born & Wolf, "Principles of Optics", 7th ed., §1.5.2, Eq. (21), with a complex index (§14.2).
struct TextbookFresnel {
  Complex<Digits50> r_s, r_p;

  /// @param n_minus_1 real part of the index, minus 1
  /// @param k extinction coefficient
  /// @param cosine of the angle of incidence
  TextbookFresnel(const Digits50& n_minus_1, const Digits50& k, const Digits50& cosine) {
    const Complex<Digits50> eta{Digits50(1 + n_minus_1), k};
    const Complex<Digits50> cos_i{cosine, Digits50(0)};
    // Snell: sin θ_t = sin θ_i/η; then η cos θ_t = √(η² − sin² θ_i), the root that decays into the medium.
    const Complex<Digits50> sin2_i{Digits50(1 - cosine * cosine), Digits50(0)};
    const Complex<Digits50> eta_cos_t = principal_root(eta * eta - sin2_i);
    r_s = (cos_i - eta_cos_t) / (cos_i + eta_cos_t);
    const Complex<Digits50> eta2_cos_i = eta * eta * cos_i;
    r_p = (eta2_cos_i - eta_cos_t) / (eta2_cos_i + eta_cos_t);
    // The library's sign makes r_p equal r_s at normal incidence.
    r_p = Complex<Digits50>{Digits50(-r_p.re), Digits50(-r_p.im)};
  }

  Digits50 reflectance() const { return (norm(r_s) + norm(r_p)) / 2; }

 private:
  static Complex<Digits50> principal_root(const Complex<Digits50>& z) {
    const Digits50 modulus = sqrt(Digits50(norm(z)));
    if (modulus == 0) return {Digits50(0), Digits50(0)};
    // The half with the larger modulus by the half-angle formula, the other by the product.
    const Digits50 larger = sqrt(Digits50((modulus + abs(z.re)) / 2));
    const Digits50 smaller = z.im / (2 * larger);
    return z.re >= 0 ? Complex<Digits50>{larger, smaller} : Complex<Digits50>{smaller, larger};
  }
};

}  // namespace vcavity::test
