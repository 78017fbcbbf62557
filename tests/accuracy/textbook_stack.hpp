// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Thin films by characteristic matrices as textbooks print them (Born & Wolf, "Principles of Optics", 7th
/// ed., §1.6), for number types with many more digits, and a larger range of exponents, than the result
/// needs.

#include <cmath>
#include <vcavity/numbers/complex.hpp>
#include <vcavity/numbers/number.hpp>
#include <vector>

#include "accuracy/textbook_fresnel.hpp"

namespace vcavity::test {

/// A medium of a stack.
template <class Wide>
struct Layer {
  Complex<Wide> n;  ///< relative to the incident medium
  Wide thickness;   ///< in wavelengths of the incident medium
};

/// Amplitudes of the reflected field; r_p equals r_s at normal incidence.
template <class Wide>
struct TextbookStack {
  Complex<Wide> r_s, r_p;

  /// @param films the top one first
  /// @param substrate index
  /// @param cosine of the angle of incidence
  TextbookStack(const std::vector<Layer<Wide>>& films, const Complex<Wide>& substrate, const Wide& cosine) {
    r_s = amplitude(films, substrate, cosine, [](const Complex<Wide>& q, const Complex<Wide>&) { return q; });
    r_p = amplitude(films, substrate, cosine,
                    [](const Complex<Wide>& q, const Complex<Wide>& n) { return q / (n * n); });
    r_p = Complex<Wide>{Wide(-r_p.re), Wide(-r_p.im)};
  }

  Wide reflectance() const { return (norm(r_s) + norm(r_p)) / 2; }

 private:
  /// @param admittance of a wave of normal component q in a medium of index n
  template <class Admittance>
  static Complex<Wide> amplitude(const std::vector<Layer<Wide>>& films, const Complex<Wide>& substrate,
                                 const Wide& cosine, const Admittance& admittance) {
    using std::cos;
    using std::cosh;
    using std::sin;
    using std::sinh;
    const Complex<Wide> sin2{Wide(1 - cosine * cosine), Wide(0)};
    const auto normal_component = [&](const Complex<Wide>& n) { return principal_root(n * n - sin2); };
    // Electric and magnetic field along the films, at the substrate and then above each film.
    Complex<Wide> e{Wide(1), Wide(0)}, h = admittance(normal_component(substrate), substrate);
    for (auto film = films.rbegin(); film != films.rend(); ++film) {
      const Complex<Wide> q = normal_component(film->n);
      const Complex<Wide> x = admittance(q, film->n);
      const Complex<Wide> phase = Wide(2 * pi<Wide>() * film->thickness) * q;
      const Complex<Wide> cosine_of{Wide(cos(phase.re) * cosh(phase.im)),
                                    Wide(-sin(phase.re) * sinh(phase.im))};
      // −i sin
      const Complex<Wide> sine_of{Wide(cos(phase.re) * sinh(phase.im)),
                                  Wide(-sin(phase.re) * cosh(phase.im))};
      const Complex<Wide> e_above = cosine_of * e + sine_of * (h / x);
      h = cosine_of * h + sine_of * (x * e);
      e = e_above;
    }
    const Complex<Wide> incident = cosine * e;
    return (incident - h) / (incident + h);
  }
};

}  // namespace vcavity::test
