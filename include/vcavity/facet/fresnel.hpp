// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel reflectance of a plane interface, for real and complex refractive indices.
///
/// Method. With c the cosine of the angle of incidence, s² = 1 − c², the contrast m = (n + ik)² − 1 and
/// w = √(m + c²) = √((n + ik)² − s²) (the normal component of the refracted wave vector, Re w ≥ 0, Im w ≥ 0),
/// the textbook amplitudes (Born & Wolf, "Principles of Optics", 7th ed., §1.5.2 and §14.2) are, exactly,
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
/// Range: n ≥ 0, k ≥ 0, n + k between 2e-9 and 1e9 for float (1e-76 and 1e76 for double), so that fourth
/// powers neither vanish nor overflow. Cosines outside [3e-10, 1] (1e-77 for double) count as the nearer end:
/// so grazing incidence has its limit even without an interface, where R = 0 and 1 − R = 1 at every angle. A
/// cosine that is not a number gives a result that is not a number.
/// Not for an absorbing incident medium, for gain (k < 0) or for magnetic materials.

#include <array>
#include <complex>
#include <concepts>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/complex.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/inline.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"

namespace vcavity {

/// Field amplitudes reflected from an interface, for unit incident amplitude.
template <class Value>
struct Amplitudes {
  Complex<Value> r_s;  ///< electric field normal to the plane of incidence
  Complex<Value> r_p;  ///< electric field in the plane of incidence; equals r_s at normal incidence
};

/// Absorptances, or transmittances into a transparent medium, of s and of p light.
template <class Value>
struct Absorptances {
  Value s;  ///< 1 − |r_s|²
  Value p;  ///< 1 − |r_p|², never less
};

/// What a facet of values `Value` takes for the cosine of the angle of incidence: a number, or a value with
/// an angle for each of its components.
template <class Cosine, class Value>
concept CosineFor = std::convertible_to<Cosine, scalar_t<Value>> || std::same_as<Cosine, Value>;

namespace detail {

/// The smallest cosine whose fourth power does not underflow: about 3e-10 for float, 1e-77 for double.
/// Smaller ones count as this one; at 0 the formulas of an interface without contrast would be 0/0.
template <class Real>
Real smallest_cosine() {
  using std::sqrt;
  if constexpr (std::is_floating_point_v<Real>) {
    return sqrt(sqrt(std::numeric_limits<Real>::min()));
  } else {
    static const Real value = sqrt(sqrt(std::numeric_limits<Real>::min()));
    return value;
  }
}

/// The smallest |n + ik|, for the same reason.
template <class Real>
Real smallest_index() {
  return Real(4) * smallest_cosine<Real>();
}

/// The largest n and k: fourth powers must not overflow. About 1e9 for float, 1e76 for double.
template <class Real>
Real largest_index() {
  using std::sqrt;
  return sqrt(sqrt(std::numeric_limits<Real>::max())) / Real(4);
}

/// Throws std::invalid_argument unless every component of `a` is in [low, largest_index].
template <class Value>
void require_index(const Value& a, const scalar_t<Value>& low, const char* name) {
  using Real = scalar_t<Value>;
  for_each_component(a, [&low, name](const Real& x) {
    if (!(x >= low && x <= largest_index<Real>())) {
      std::ostringstream message;
      message << name << " must lie in [" << low << ", " << largest_index<Real>() << "], not be " << x;
      throw std::invalid_argument(message.str());
    }
  });
}

/// What n = 1 + (n − 1) lost by rounding; its square would lose twice as much.
template <class Value>
Value lost_by_rounding(const Value& n, const Value& n_minus_1) {
  return n_minus_1 - (n - Value(1));
}

/// The angle of incidence.
/// @tparam Cosine a number, or a value with an angle for each of its components
template <class Cosine>
struct Incidence {
  using Real = scalar_t<Cosine>;

  /// Cosines are taken to lie in [`smallest_cosine`, 1].
  VCAVITY_INLINE explicit Incidence(const Cosine& cos_theta_i)
      : c(at_most(at_least(cos_theta_i, smallest_cosine<Real>()), Real(1))),
        c2(c * c),
        s2((Cosine(1) - c) * (Cosine(1) + c)) {}

  /// Re w² = Re (n + ik)² − s² = Re m + c²: of these equal sums the one that cancels less.
  /// @param permittivity Re (n + ik)²
  /// @param contrast Re m
  template <class Value>
  VCAVITY_INLINE Value normal_component_squared(const Value& permittivity, const Value& contrast) const {
    if constexpr (Number<Cosine>) {
      return c2 < s2 ? Value(contrast + Value(c2)) : Value(permittivity - Value(s2));
    } else {
      return select_positive(Value(s2 - c2), Value(contrast + c2), Value(permittivity - s2));
    }
  }

  Cosine c;   ///< cosine of the angle of incidence
  Cosine c2;  ///< its square
  Cosine s2;  ///< the square of the sine
};

/// The angle of incidence of a facet of values `Value`.
template <class Value, CosineFor<Value> Cosine>
auto incidence_for(const Cosine& cos_theta_i) {
  if constexpr (std::same_as<Cosine, Value>) {
    return Incidence<Value>(cos_theta_i);
  } else {
    return Incidence<scalar_t<Value>>(static_cast<scalar_t<Value>>(cos_theta_i));
  }
}

/// A refracted wave at an interface of contrast m, with the combinations that all formulas share.
template <class Value>
struct RefractedWave {
  using Real = scalar_t<Value>;

  /// @param permittivity Re (n + ik)²
  /// @param contrast m = (n + ik)² − 1, Im m ≥ 0
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1], one for all components or one for each
  template <class Cosine>
  VCAVITY_INLINE RefractedWave(const Value& permittivity, const Complex<Value>& contrast,
                               const Cosine& cos_theta_i) {
    using std::sqrt;
    const auto incidence = incidence_for<Value>(cos_theta_i);
    c = Value(incidence.c);
    s2 = Value(incidence.s2);
    const Complex<Value> w2{incidence.normal_component_squared(permittivity, contrast.re), contrast.im};
    w_norm = sqrt(norm(w2));
    // The larger part of w comes from a sum, the smaller one from the product 2 Re w Im w = Im w²: no
    // cancellation.
    const Value larger = sqrt(Real(0.5) * (w_norm + select_nonnegative(w2.re, w2.re, Value(-w2.re))));
    const Value smaller = Real(0.5) * w2.im / at_least(larger, std::numeric_limits<Real>::min());
    w.re = select_nonnegative(w2.re, larger, smaller);
    w.im = select_nonnegative(w2.re, smaller, larger);
  }

  /// |c + w|²
  VCAVITY_INLINE Value sum_norm() const { return c * c + Real(2) * (c * w.re) + w_norm; }

  /// |c − w|²|c + w|², which is |m|²; that is less exact where c and w are of unlike size.
  VCAVITY_INLINE Value difference_norm(const Value& contrast_norm) const {
    const Value c2 = c * c;
    const Value real = c2 - w_norm;
    const Value imaginary = Real(2) * (c * w.im);
    return select_nonnegative(Value(w_norm - Real(3) * c2), Value(real * real + imaginary * imaginary),
                              contrast_norm);
  }

  /// |c w + s²|²
  VCAVITY_INLINE Value parallel_sum_norm() const { return norm(Complex<Value>{c * w.re + s2, c * w.im}); }

  /// |c w − s²|²
  VCAVITY_INLINE Value parallel_difference_norm() const {
    return norm(Complex<Value>{c * w.re - s2, c * w.im});
  }

  Value c;           ///< cosine of the angle of incidence
  Value s2;          ///< its squared sine
  Complex<Value> w;  ///< normal component of the refracted wave vector
  Value w_norm;      ///< |w|²
};

template <class Value, class Cosine>
VCAVITY_INLINE Amplitudes<Value> fresnel_amplitudes(const Value& permittivity, const Complex<Value>& contrast,
                                                    const Cosine& cos_theta_i) {
  using Real = scalar_t<Value>;
  const RefractedWave<Value> wave(permittivity, contrast, cos_theta_i);
  // (c − w)/(c + w) = (c² − |w|² − 2ic Im w)/|c + w|². Where c² − |w|² would cancel, m stands in for w² − c²:
  // it is −(|m|² + 2c² Re m)/(c² + |w|²).
  const Value c2 = wave.c * wave.c;
  const Value far = wave.w_norm - Real(2) * c2;  // not negative where nothing cancels
  const Value numerator = select_nonnegative(
      far, Value(c2 - wave.w_norm), Value(Real(-1) * (norm(contrast) + Real(2) * (c2 * contrast.re))));
  const Value denominator = select_nonnegative(far, Value(1), Value(c2 + wave.w_norm));
  const Value inverse = Value(1) / (denominator * wave.sum_norm());
  const Complex<Value> r_s{numerator * inverse, Real(-2) * (wave.c * wave.w.im * (denominator * inverse))};
  const Complex<Value> cw = wave.c * wave.w;
  const Complex<Value> s2{wave.s2, Value(0)};
  return {r_s, r_s * ((cw - s2) / (cw + s2))};
}

/// The singularities of the reflectance as a function of a complex cosine, up to conjugation: the pole of
/// r_p, where c w = −s², and the branch points of w.
/// @param m contrast
inline std::array<std::complex<double>, 3> singular_cosines(const std::complex<double>& m) {
  const std::complex<double> branch = std::sqrt(-m);
  return {-1.0 / std::sqrt(m + 2.0), branch, -branch};
}

/// √(−m) where that is a cosine, else 0.
template <class Value>
Value critical_cosine(const Value& contrast) {
  using Real = scalar_t<Value>;
  using std::sqrt;
  const Value c2 = at_least(Value(-contrast), Real(0));
  return select_nonnegative(Value(Value(1) - c2), sqrt(c2), Value(0));
}

}  // namespace detail

/// Interface to an absorbing medium, such as a metal, of complex index n + ik; valid for k = 0 as well.
/// @tparam Value a number, or a `glm::vec` or `Pack` with one index per colour or wavelength
template <class Value>
class Conductor {
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

  /// Absorptance of unpolarised light, 1 − reflectance, to full relative precision; for k = 0 the
  /// transmittance into the medium.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Value absorptance(const Cosine& cos_theta_i) const {
    const Absorptances<Value> part = absorptances(cos_theta_i);
    return Real(0.5) * (part.s + part.p);
  }

  /// The same for s and for p light.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Absorptances<Value> absorptances(const Cosine& cos_theta_i) const {
    const detail::RefractedWave<Value> wave(permittivity_, contrast_, cos_theta_i);
    const Value s = Real(4) * (wave.c * wave.w.re) / wave.sum_norm();
    const Value ratio = (wave.w_norm + wave.s2) / wave.parallel_sum_norm();
    return {at_most(s, Real(1)), at_most(Value(s * ratio), Real(1))};
  }

  /// Amplitudes r_s and r_p.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Amplitudes<Value> amplitudes(const Cosine& cos_theta_i) const {
    return detail::fresnel_amplitudes(permittivity_, contrast_, cos_theta_i);
  }

  /// The cosine at which the reflectance varies fastest when n < 1 and k is small (the critical angle if k =
  /// 0); 0 if there is none in (0, 1].
  Value critical_cosine() const { return detail::critical_cosine(contrast_.re); }

  /// The complex cosines at which the reflectance is singular, up to conjugation; quadrature wants to know
  /// them.
  std::array<std::complex<double>, 3> singular_cosines() const
    requires Number<Value>
  {
    return detail::singular_cosines({static_cast<double>(contrast_.re), static_cast<double>(contrast_.im)});
  }

  /// (n + ik)² − 1
  const Complex<Value>& contrast() const { return contrast_; }

  /// The same facet for several directions at once: it takes a `Pack` of cosines.
  template <std::size_t directions>
  Conductor<Pack<Real, directions>> over_directions() const
    requires Number<Value>
  {
    using Values = Pack<Real, directions>;
    Conductor<Values> result;
    result.permittivity_ = Values(permittivity_);
    result.contrast_ = {Values(contrast_.re), Values(contrast_.im)};
    result.contrast_norm_ = Values(contrast_norm_);
    return result;
  }

 private:
  template <class Other>
  friend class Conductor;

  Conductor() = default;

  Conductor(const Value& n, const Value& n_minus_1, const Value& n_plus_1, const Value& k) {
    detail::require_index(n, Real(0), "the refractive index n");
    detail::require_index(k, Real(0), "the extinction coefficient k");
    detail::require_index(Value(n + k), detail::smallest_index<Real>(), "n + k");
    permittivity_ = n * n - k * k + Real(2) * (n * detail::lost_by_rounding(n, n_minus_1));
    contrast_ = {n_minus_1 * n_plus_1 - k * k, Real(2) * (n * k)};
    contrast_norm_ = norm(contrast_);
  }

  Value permittivity_;  // Re (n + ik)²
  Complex<Value> contrast_;
  Value contrast_norm_;
};

/// Interface to a transparent medium of real index n. Below n = 1 it reflects totally at grazing angles.
/// @tparam Value a number, or a `glm::vec` or `Pack` with one index per colour or wavelength
template <class Value>
class Dielectric {
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
    const Wave wave(permittivity_, contrast_, cos_theta_i);
    const Value r_s = wave.difference(contrast_) / wave.sum_norm();
    const Value ratio = (wave.cw - wave.s2) / (wave.cw + wave.s2);
    const Value reflectance = Real(0.5) * (r_s * r_s * (Value(1) + ratio * ratio));
    return select_nonnegative(wave.w2, at_most(reflectance, Real(1)), Value(1));
  }

  /// The part of unpolarised light that is refracted into the medium, 1 − reflectance, to full relative
  /// precision.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Value absorptance(const Cosine& cos_theta_i) const {
    const Absorptances<Value> part = absorptances(cos_theta_i);
    return Real(0.5) * (part.s + part.p);
  }

  /// The same for s and for p light.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Absorptances<Value> absorptances(const Cosine& cos_theta_i) const {
    const Wave wave(permittivity_, contrast_, cos_theta_i);
    const Value parallel_sum = wave.cw + wave.s2;
    const Value s = Real(4) * wave.cw / wave.sum_norm();
    const Value ratio = (wave.w * wave.w + wave.s2) / (parallel_sum * parallel_sum);
    const auto refracted = [&wave](const Value& part) {
      return select_nonnegative(wave.w2, at_most(part, Real(1)), Value(0));
    };
    return {refracted(s), refracted(Value(s * ratio))};
  }

  /// Amplitudes r_s and r_p; complex in total reflection.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  VCAVITY_INLINE Amplitudes<Value> amplitudes(const Cosine& cos_theta_i) const {
    return detail::fresnel_amplitudes(permittivity_, Complex<Value>{contrast_, Value(0)}, cos_theta_i);
  }

  /// Cosine of the critical angle, below which reflection is total; 0 for n ≥ 1.
  Value critical_cosine() const { return detail::critical_cosine(contrast_); }

  /// The complex cosines at which the reflectance is singular, up to conjugation; quadrature wants to know
  /// them.
  std::array<std::complex<double>, 3> singular_cosines() const
    requires Number<Value>
  {
    return detail::singular_cosines(static_cast<double>(contrast_));
  }

  /// n² − 1
  const Value& contrast() const { return contrast_; }

  /// The same facet for several directions at once: it takes a `Pack` of cosines.
  template <std::size_t directions>
  Dielectric<Pack<Real, directions>> over_directions() const
    requires Number<Value>
  {
    using Values = Pack<Real, directions>;
    Dielectric<Values> result;
    result.permittivity_ = Values(permittivity_);
    result.contrast_ = Values(contrast_);
    return result;
  }

 private:
  struct Wave {
    template <class Cosine>
    VCAVITY_INLINE Wave(const Value& permittivity, const Value& contrast, const Cosine& cos_theta_i) {
      using std::sqrt;
      const auto incidence = detail::incidence_for<Value>(cos_theta_i);
      c = Value(incidence.c);
      s2 = Value(incidence.s2);
      w2 = incidence.normal_component_squared(permittivity, contrast);
      w = sqrt(at_least(w2, Real(0)));
      cw = c * w;
    }
    /// (w − c)(w + c), which is m; that is less exact where c and w are of unlike size.
    VCAVITY_INLINE Value difference(const Value& contrast) const {
      return select_nonnegative(Value(w - Real(2) * c), Value((w - c) * (w + c)), contrast);
    }
    /// (c + w)²
    Value sum_norm() const { return (c + w) * (c + w); }
    Value c, s2, w2, w, cw;
  };

  template <class Other>
  friend class Dielectric;

  Dielectric() = default;

  Dielectric(const Value& n, const Value& n_minus_1, const Value& n_plus_1) {
    detail::require_index(n, detail::smallest_index<Real>(), "the refractive index n");
    permittivity_ = n * n + Real(2) * (n * detail::lost_by_rounding(n, n_minus_1));
    contrast_ = n_minus_1 * n_plus_1;
  }

  Value permittivity_;  // n²
  Value contrast_;
};

}  // namespace vcavity
