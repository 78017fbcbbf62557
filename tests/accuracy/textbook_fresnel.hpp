// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel's formulas as textbooks print them, with Snell's law for the complex cosine of refraction, for
/// number types with many more digits than the result needs: cancellation costs some of them.

#include <cmath>
#include <limits>
#include <type_traits>
#include <vcavity/numbers/complex.hpp>

#include "support/reals.hpp"

namespace vcavity::test {

/// 1 − reflectance. Where nothing is left of its digits it is 0 if there were fifty, else unknown.
template <class Wide>
Wide rest_of_one(const Wide& reflectance) {
  const Wide rest = 1 - reflectance;
  if (rest > 1e9L * epsilon<Wide>()) return rest;
  return std::is_same_v<Wide, Digits50> ? Wide(0) : std::numeric_limits<Wide>::quiet_NaN();
}

/// The square root with a real and an imaginary part that are not negative, of a number with Im z ≥ 0.
template <class Wide>
Complex<Wide> principal_root(const Complex<Wide>& z) {
  using std::abs;
  using std::sqrt;
  const Wide modulus = sqrt(Wide(norm(z)));
  if (modulus == 0) return {Wide(0), Wide(0)};
  // The half with the larger modulus by the half-angle formula, the other by the product.
  const Wide larger = sqrt(Wide((modulus + abs(z.re)) / 2));
  const Wide smaller = z.im / (2 * larger);
  return z.re >= 0 ? Complex<Wide>{larger, smaller} : Complex<Wide>{smaller, larger};
}

/// Amplitudes of the reflected field.
/// Born & Wolf, "Principles of Optics", 7th ed., §1.5.2, Eq. (21), with a complex index (§14.2).
template <class Wide>
struct TextbookFresnel {
  Complex<Wide> r_s, r_p;

  /// @param n_minus_1 real part of the index, minus 1
  /// @param k extinction coefficient
  /// @param cosine of the angle of incidence
  TextbookFresnel(const Wide& n_minus_1, const Wide& k, const Wide& cosine) {
    const Complex<Wide> eta{Wide(1 + n_minus_1), k};
    const Complex<Wide> cos_i{cosine, Wide(0)};
    // Snell: sin θ_t = sin θ_i/η; then η cos θ_t = √(η² − sin² θ_i), the root that decays into the medium.
    const Complex<Wide> sin2_i{Wide(1 - cosine * cosine), Wide(0)};
    const Complex<Wide> eta_cos_t = principal_root(eta * eta - sin2_i);
    r_s = (cos_i - eta_cos_t) / (cos_i + eta_cos_t);
    const Complex<Wide> eta2_cos_i = eta * eta * cos_i;
    r_p = (eta2_cos_i - eta_cos_t) / (eta2_cos_i + eta_cos_t);
    // The library's sign makes r_p equal r_s at normal incidence.
    r_p = Complex<Wide>{Wide(-r_p.re), Wide(-r_p.im)};
  }

  Wide reflectance() const { return (norm(r_s) + norm(r_p)) / 2; }
};

}  // namespace vcavity::test
