// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel reflectance of a plane interface, for real and complex refractive indices.
///
/// Method. With the cosine c of the angle of incidence, s² = 1 − c², the contrast m and the normal component
/// w of the refracted wave vector (interface.hpp), the textbook amplitudes (Born & Wolf, "Principles of
/// Optics", 7th ed., §1.5.2 and §14.2) are, exactly,
///
///     r_s = (c − w)/(c + w)                        = −m/(c + w)²
///     r_p = r_s · (c w − s²)/(c w + s²)
///     1 − |r_s|² = 4 c Re w/|c + w|²
///     1 − |r_p|² = (1 − |r_s|²) · (|w|² + s²)/|c w + s²|²
///
/// The right-hand sides subtract nothing that nearly cancels, except in r_p at Brewster's angle, where it
/// vanishes. So the reflectance keeps its digits as n → 1 (m is then formed from n − 1), the absorptance as R
/// → 1, and k → 0 is the dielectric, total internal reflection included.
///
/// The sign of r_p is the one that makes r_p = r_s at normal incidence.
///
/// Range: that of interface.hpp. Cosines next to 0 count as a smallest one: so grazing incidence has its
/// limit even without an interface, where R = 0 and 1 − R = 1 at every angle. A cosine that is not a number
/// gives a result that is not a number.
/// Not for an absorbing incident medium, for gain (k < 0) or for magnetic materials.

#include <array>
#include <complex>
#include <concepts>
#include <cstddef>

#include "vcavity/facet/interface.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/complex.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity {

namespace detail {

template <class Value, class Cosine>
VCAVITY_INLINE Amplitudes<Value> fresnel_amplitudes(const Value& permittivity, const Complex<Value>& contrast,
                                                    const Cosine& cos_theta_i) {
  using Real = scalar_t<Value>;
  const RefractedWave<Value> wave(permittivity, contrast, cos_theta_i);
  // (c − w)/(c + w) = (c² − |w|² − 2ic Im w)/|c + w|². Where c² − |w|² would cancel, m stands in for w² − c²:
  // it is −(|m|² + 2c² Re m)/(c² + |w|²).
  const Value c2 = wave.c * wave.c;
  const Value far = wave.w_norm - Real(2) * c2;  // not negative where nothing cancels
  const Value numerator = select(far >= Real(0), Value(c2 - wave.w_norm),
                                 Value(Real(-1) * (norm(contrast) + Real(2) * (c2 * contrast.re))));
  const Value denominator = select(far >= Real(0), Value(1), Value(c2 + wave.w_norm));
  const Value inverse = Value(1) / (denominator * wave.sum_norm());
  const Complex<Value> r_s{numerator * inverse, Real(-2) * (wave.c * wave.w.im * (denominator * inverse))};
  const Complex<Value> cw = wave.c * wave.w;
  const Complex<Value> s2{wave.s2, Value(0)};
  return {r_s, r_s * ((cw - s2) / (cw + s2))};
}

/// What the interfaces to absorbing and to transparent media have in common.
/// @tparam Interface the class that derives from it, with the member function `absorptances`
/// @tparam Value a number, or a `glm::vec` or `Pack` with one index per colour or wavelength
/// @tparam Contrast `Complex<Value>` or `Value`
template <class Interface, class Value, class Contrast>
class FresnelInterface {
 public:
  using Real = scalar_t<Value>;

  /// Absorptance of unpolarised light, 1 − reflectance, to full relative precision; for a transparent medium
  /// the transmittance into it.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Value absorptance(const Cosine& cos_theta_i) const {
    const Absorptances<Value> part = static_cast<const Interface&>(*this).absorptances(cos_theta_i);
    return Real(0.5) * (part.s + part.p);
  }

  /// Amplitudes r_s and r_p; complex also for a transparent medium, where reflection is total.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Amplitudes<Value> amplitudes(const Cosine& cos_theta_i) const {
    return detail::fresnel_amplitudes(permittivity_, detail::as_complex(contrast_), cos_theta_i);
  }

  /// Cosine of the critical angle, below which a transparent medium of n < 1 reflects totally; with a small k
  /// the reflectance varies fastest there. 0 if there is none in (0, 1].
  Value critical_cosine() const { return detail::critical_cosine(as_complex(contrast_).re); }

  /// The complex cosines at which the reflectance is singular, up to conjugation; quadrature wants to know
  /// them.
  std::array<std::complex<double>, 3> singular_cosines() const
    requires Number<Value>
  {
    const Complex<Value> m = as_complex(contrast_);
    return detail::singular_cosines({static_cast<double>(m.re), static_cast<double>(m.im)});
  }

  /// (n + ik)² − 1
  Contrast contrast() const { return contrast_; }

  /// Re (n + ik)²; where n is small, with digits that the contrast has lost.
  Value permittivity() const { return permittivity_; }

 protected:
  FresnelInterface() = default;
  FresnelInterface(const Value& permittivity, const Contrast& contrast)
      : permittivity_(permittivity), contrast_(contrast) {}

  Value permittivity_;  // Re (n + ik)²
  Contrast contrast_;
};

}  // namespace detail

/// Interface to an absorbing medium, such as a metal, of complex index n + ik; valid for k = 0 as well.
/// @tparam Value a number, or a `glm::vec` or `Pack` with one index per colour or wavelength
template <class Value>
class Conductor : public detail::FresnelInterface<Conductor<Value>, Value, Complex<Value>> {
  using Base = detail::FresnelInterface<Conductor<Value>, Value, Complex<Value>>;
  using Base::contrast_, Base::permittivity_;

 public:
  using Real = scalar_t<Value>;

  /// @param n real part of the refractive index relative to the incident medium, ≥ 0
  /// @param k extinction coefficient, ≥ 0
  /// @throws std::invalid_argument when a component is out of range, see above, or not a number
  Conductor(const Value& n, const Value& k) : Conductor(n, n - Value(1), n + Value(1), k) {}

  /// The same from n − 1, for indices so close to 1 that n itself cannot carry the difference.
  static Conductor from_contrast(const Value& n_minus_1, const Value& k) {
    return Conductor(Value(1) + n_minus_1, n_minus_1, Value(2) + n_minus_1, k);
  }

  /// Reflectance of unpolarised light, (|r_s|² + |r_p|²)/2, in [0, 1].
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Value operator()(const Cosine& cos_theta_i) const {
    const detail::RefractedWave<Value> wave(permittivity_, contrast_, cos_theta_i);
    const Value sum_norm = wave.sum_norm();
    const Value r_s = wave.difference_norm(contrast_norm_) / (sum_norm * sum_norm);
    const Value ratio = wave.parallel_difference_norm() / wave.parallel_sum_norm();
    return at_most(Value(Real(0.5) * (r_s * (Value(1) + ratio))), Real(1));
  }

  /// What is not reflected of s and of p light, to full relative precision.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Absorptances<Value> absorptances(const Cosine& cos_theta_i) const {
    const detail::RefractedWave<Value> wave(permittivity_, contrast_, cos_theta_i);
    const Value s = Real(4) * (wave.c * wave.w.re) / wave.sum_norm();
    const Value ratio = (wave.w_norm + wave.s2) / wave.parallel_sum_norm();
    return {at_most(s, Real(1)), at_most(Value(s * ratio), Real(1))};
  }

  /// The same facet in another number type, or for a `Pack` of equal components.
  template <class Other>
  Conductor<Other> in() const
    requires Number<Value>
  {
    return {static_cast<Other>(permittivity_),
            {static_cast<Other>(contrast_.re), static_cast<Other>(contrast_.im)},
            static_cast<Other>(contrast_norm_)};
  }

  /// The same facet for several directions at once: it takes a `Pack` of cosines.
  template <std::size_t directions>
  Conductor<Pack<Real, directions>> over_directions() const
    requires Number<Value>
  {
    return in<Pack<Real, directions>>();
  }

  /// The same for one component of the values: component `i`, counted from 0.
  template <std::size_t directions>
  Conductor<Pack<Real, directions>> over_directions(std::size_t i) const {
    using Lanes = Pack<Real, directions>;
    return {Lanes(component(permittivity_, i)),
            {Lanes(component(contrast_.re, i)), Lanes(component(contrast_.im, i))},
            Lanes(component(contrast_norm_, i))};
  }

 private:
  template <class Other>
  friend class Conductor;

  Conductor(const Value& permittivity, const Complex<Value>& contrast, const Value& contrast_norm)
      : Base(permittivity, contrast), contrast_norm_(contrast_norm) {}

  Conductor(const Value& n, const Value& n_minus_1, const Value& n_plus_1, const Value& k) {
    detail::require_index(n, Real(0), "the refractive index n");
    detail::require_index(k, Real(0), "the extinction coefficient k");
    detail::require_index(Value(n + k), detail::smallest_index<Real>(), "n + k");
    permittivity_ = n * n - k * k + Real(2) * (n * detail::lost_by_rounding(n, n_minus_1));
    contrast_ = {n_minus_1 * n_plus_1 - k * k, Real(2) * (n * k)};
    contrast_norm_ = norm(contrast_);
  }

  Value contrast_norm_;  // |m|²
};

/// Interface to a transparent medium of real index n. Below n = 1 it reflects totally at grazing angles.
/// @tparam Value a number, or a `glm::vec` or `Pack` with one index per colour or wavelength
template <class Value>
class Dielectric : public detail::FresnelInterface<Dielectric<Value>, Value, Value> {
  using Base = detail::FresnelInterface<Dielectric<Value>, Value, Value>;
  using Base::contrast_, Base::permittivity_;

 public:
  using Real = scalar_t<Value>;

  /// @param n refractive index relative to the incident medium, > 0
  /// @throws std::invalid_argument when a component is out of range, see above, or not a number
  explicit Dielectric(const Value& n) : Dielectric(n, n - Value(1), n + Value(1)) {}

  /// The same from n − 1, for indices so close to 1 that n itself cannot carry the difference.
  static Dielectric from_contrast(const Value& n_minus_1) {
    return Dielectric(Value(1) + n_minus_1, n_minus_1, Value(2) + n_minus_1);
  }

  /// Reflectance of unpolarised light, (|r_s|² + |r_p|²)/2, in [0, 1].
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Value operator()(const Cosine& cos_theta_i) const {
    const detail::TransparentWave<Value> wave(permittivity_, contrast_, cos_theta_i);
    const Value r_s = wave.difference(contrast_) / wave.sum_norm();
    const Value ratio = (wave.cw - wave.s2) / (wave.cw + wave.s2);
    const Value reflectance = Real(0.5) * (r_s * r_s * (Value(1) + ratio * ratio));
    return select(wave.w2 >= Real(0), at_most(reflectance, Real(1)), Value(1));
  }

  /// What is refracted into the medium of s and of p light, to full relative precision.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Absorptances<Value> absorptances(const Cosine& cos_theta_i) const {
    const detail::TransparentWave<Value> wave(permittivity_, contrast_, cos_theta_i);
    const Value parallel_sum = wave.cw + wave.s2;
    const Value s = Real(4) * wave.cw / wave.sum_norm();
    const Value ratio = (wave.w * wave.w + wave.s2) / (parallel_sum * parallel_sum);
    const auto refracted = [&wave](const Value& part) {
      return select(wave.w2 >= Real(0), at_most(part, Real(1)), Value(0));
    };
    return {refracted(s), refracted(Value(s * ratio))};
  }

  /// The same facet in another number type, or for a `Pack` of equal components.
  template <class Other>
  Dielectric<Other> in() const
    requires Number<Value>
  {
    return {static_cast<Other>(permittivity_), static_cast<Other>(contrast_)};
  }

  /// The same facet for several directions at once: it takes a `Pack` of cosines.
  template <std::size_t directions>
  Dielectric<Pack<Real, directions>> over_directions() const
    requires Number<Value>
  {
    return in<Pack<Real, directions>>();
  }

  /// The same for one component of the values: component `i`, counted from 0.
  template <std::size_t directions>
  Dielectric<Pack<Real, directions>> over_directions(std::size_t i) const {
    using Lanes = Pack<Real, directions>;
    return {Lanes(component(permittivity_, i)), Lanes(component(contrast_, i))};
  }

 private:
  template <class Other>
  friend class Dielectric;

  Dielectric(const Value& permittivity, const Value& contrast) : Base(permittivity, contrast) {}

  Dielectric(const Value& n, const Value& n_minus_1, const Value& n_plus_1) {
    detail::require_index(n, detail::smallest_index<Real>(), "the refractive index n");
    permittivity_ = n * n + Real(2) * (n * detail::lost_by_rounding(n, n_minus_1));
    contrast_ = n_minus_1 * n_plus_1;
  }
};

}  // namespace vcavity
