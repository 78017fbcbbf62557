// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What all plane interfaces share: which indices they take, the contrast, and the wave that is refracted.
///
/// Method. Indices are relative to the incident medium. With c the cosine of the angle of incidence and
/// s² = 1 − c², an interface is known by the contrast m = (n + ik)² − 1, because the normal component of the
/// refracted wave vector is w = √(m + c²) = √((n + ik)² − s²), Re w ≥ 0, Im w ≥ 0. Where the index is close
/// to 1, m is formed from n − 1 and keeps its digits; of the two sums under the root the one that cancels
/// less is used.
///
/// Range: n ≥ 0, k ≥ 0, n + k between 2e-9 and 1e9 for float (1e-76 and 1e76 for double), so that fourth
/// powers neither vanish nor overflow. Cosines outside [3e-10, 1] (1e-77 for double) count as the nearer end.
///
/// When not to use it: for the reflectance; that is fresnel.hpp and coated.hpp.

#include <array>
#include <complex>
#include <concepts>
#include <limits>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/complex.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/per_component.hpp"

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
  if constexpr (std::is_floating_point_v<Real> || !Number<Real>) {
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

/// Throws std::invalid_argument unless every component of `a` is in [low, largest_index]. What is not made of numbers,
/// such as expressions that are evaluated later, cannot be asked.
template <class Value>
void require_index([[maybe_unused]] const Value& a, [[maybe_unused]] const scalar_t<Value>& low,
                   [[maybe_unused]] const char* name) {
  using Real = scalar_t<Value>;
  if constexpr (Number<Real>) {
    for_each_component(a, [&low, name](const Real& x) {
      if (!(x >= low && x <= largest_index<Real>())) {
        throw_invalid_argument(name, " must lie in [", low, ", ", largest_index<Real>(), "], not be ", x);
      }
    });
  }
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
      return select(s2 > c2, Value(contrast + c2), Value(permittivity - s2));
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

/// What a wave refracted into any medium starts from: the real part of its squared normal component w².
/// @tparam Value a number, or a value with one index for each of its components
template <class Value>
struct Refraction {
  /// @param permittivity Re (n + ik)²
  /// @param contrast Re m
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1], one for all components or one for each
  template <class Cosine>
  VCAVITY_INLINE Refraction(const Value& permittivity, const Value& contrast, const Cosine& cos_theta_i) {
    const auto incidence = incidence_for<Value>(cos_theta_i);
    c = Value(incidence.c);
    s2 = Value(incidence.s2);
    w2 = incidence.normal_component_squared(permittivity, contrast);
  }

  Value c;   ///< cosine of the angle of incidence
  Value s2;  ///< its squared sine
  Value w2;  ///< Re w²
};

/// The wave refracted into a transparent medium, where w is real; in total reflection w counts as 0.
template <class Value>
struct TransparentWave : Refraction<Value> {
  using Real = scalar_t<Value>;
  using Refraction<Value>::c, Refraction<Value>::s2, Refraction<Value>::w2;

  /// @param permittivity n²
  /// @param contrast m = n² − 1
  /// @param cos_theta_i as for `Refraction`
  template <class Cosine>
  VCAVITY_INLINE TransparentWave(const Value& permittivity, const Value& contrast, const Cosine& cos_theta_i)
      : Refraction<Value>(permittivity, contrast, cos_theta_i) {
    using std::sqrt;
    w = sqrt(at_least(w2, Real(0)));
    cw = c * w;
  }

  /// (w − c)(w + c), which is m; that is less exact where c and w are of unlike size.
  VCAVITY_INLINE Value difference(const Value& contrast) const {
    return select(w >= Real(2) * c, Value((w - c) * (w + c)), contrast);
  }

  /// (c + w)²
  VCAVITY_INLINE Value sum_norm() const { return (c + w) * (c + w); }

  Value w;   ///< normal component of the refracted wave vector
  Value cw;  ///< c w
};

/// The wave refracted into an absorbing medium, or totally reflected from a transparent one.
template <class Value>
struct RefractedWave : Refraction<Value> {
  using Real = scalar_t<Value>;
  using Refraction<Value>::c, Refraction<Value>::s2, Refraction<Value>::w2;

  /// @param permittivity Re (n + ik)²
  /// @param contrast m, Im m ≥ 0
  /// @param cos_theta_i as for `Refraction`
  template <class Cosine>
  VCAVITY_INLINE RefractedWave(const Value& permittivity, const Complex<Value>& contrast,
                               const Cosine& cos_theta_i)
      : Refraction<Value>(permittivity, contrast.re, cos_theta_i) {
    using std::sqrt;
    w_norm = sqrt(norm(Complex<Value>{w2, contrast.im}));
    // The larger part of w comes from a sum, the smaller one from the product 2 Re w Im w = Im w²: no
    // cancellation.
    const Value larger = sqrt(Real(0.5) * (w_norm + select(w2 >= Real(0), w2, Value(-w2))));
    const Value smaller = Real(0.5) * contrast.im / at_least(larger, std::numeric_limits<Real>::min());
    w.re = select(w2 >= Real(0), larger, smaller);
    w.im = select(w2 >= Real(0), smaller, larger);
  }

  /// |c + w|²
  VCAVITY_INLINE Value sum_norm() const { return c * c + Real(2) * (c * w.re) + w_norm; }

  /// |c − w|²|c + w|², which is |m|²; that is less exact where c and w are of unlike size.
  VCAVITY_INLINE Value difference_norm(const Value& contrast_norm) const {
    const Value c2 = c * c;
    const Value real = c2 - w_norm;
    const Value imaginary = Real(2) * (c * w.im);
    return select(w_norm >= Real(3) * c2, Value(real * real + imaginary * imaginary), contrast_norm);
  }

  /// |c w + s²|²
  VCAVITY_INLINE Value parallel_sum_norm() const { return norm(Complex<Value>{c * w.re + s2, c * w.im}); }

  /// |c w − s²|²
  VCAVITY_INLINE Value parallel_difference_norm() const {
    return norm(Complex<Value>{c * w.re - s2, c * w.im});
  }

  Complex<Value> w;  ///< normal component of the refracted wave vector
  Value w_norm;      ///< |w|²
};

/// A contrast as a complex number, be it that of an absorbing or of a transparent medium.
template <class Value>
Complex<Value> as_complex(const Complex<Value>& contrast) {
  return contrast;
}
template <class Value>
Complex<Value> as_complex(const Value& contrast) {
  return {contrast, Value(0)};
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
  return select(Value(1) >= c2, sqrt(c2), Value(0));
}

}  // namespace detail

}  // namespace vcavity
