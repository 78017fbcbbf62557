// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Spectra of Mitsuba as values of vcavity, and the facets that they make.
///
/// What `conductor` renders is rendered here as well. Spectra that end inside the visible range are 0 beyond their
/// ends, and colours of an index may have components of 0. An index of 0 reflects all light in `conductor`, and is
/// a perfect mirror here. Every other index is brought into the range that `Conductor` accepts, so that a facet which
/// is made at a point of a surface never throws.

#include <mitsuba/core/spectrum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vcavity/vcavity.hpp>

namespace vgroove {

/// One component per colour or wavelength.
template <class Real, class UnpolarizedSpectrum>
using Values = vcavity::Pack<Real, drjit::size_v<UnpolarizedSpectrum>>;

/// Components of an index within the range of `Conductor` in float, which is the narrower one.
struct Index {
  static constexpr float smallest = 1e-8f;
  static constexpr float largest = 1e8f;

  /// @param n,k as a texture gives them: any numbers, or no numbers at all
  /// @return n and k of a facet; those of a perfect mirror where neither is a number other than 0
  static Index of(float n, float k) {
    const Index index{within(n), within(k)};
    return index.n + index.k >= smallest ? index : mirror();
  }

  /// Reflects all light, as `material: none` does.
  static constexpr Index mirror() { return {0.f, 1.f}; }

  friend bool operator==(const Index&, const Index&) = default;

  float n;
  float k;

 private:
  /// The formula of `conductor` for unpolarised light depends on squares only.
  static float within(float x) { return std::isnan(x) ? 0.f : std::min(std::abs(x), largest); }
};

/// The part of its light that a facet is left with by a tint: no more than all of it, or bounces would amplify.
/// @param tint as a texture gives it
inline float tint_of(float tint) {
  return tint > 0 ? std::min(tint, 1.f) : 0.f;
}

/// The facet of an index that Mitsuba gives.
template <class Real, class UnpolarizedSpectrum>
vcavity::Conductor<Values<Real, UnpolarizedSpectrum>> conductor(const UnpolarizedSpectrum& eta,
                                                                const UnpolarizedSpectrum& k) {
  Values<Real, UnpolarizedSpectrum> n_values, k_values;
  for (std::size_t i = 0; i < drjit::size_v<UnpolarizedSpectrum>; ++i) {
    const Index index = Index::of(eta[i], k[i]);
    n_values[i] = static_cast<Real>(index.n);
    k_values[i] = static_cast<Real>(index.k);
  }
  return {n_values, k_values};
}

/// Such a facet as a rational function, where that is about as exact as Fresnel's formula in float, whose rounding is up
/// to 5e-7; nothing elsewhere.
/// @param eta,k the same everywhere
template <class UnpolarizedSpectrum>
std::optional<vcavity::RationalFacet<Values<float, UnpolarizedSpectrum>>> fitted_conductor(
    const UnpolarizedSpectrum& eta, const UnpolarizedSpectrum& k) {
  constexpr double largest_error = 1e-6;
  const vcavity::RationalFacet<Values<float, UnpolarizedSpectrum>> facet(conductor<double>(eta, k));
  return facet.error() < largest_error ? std::optional(facet) : std::nullopt;
}

/// n and k of such a facet, for the arrays of a vectorised variant.
/// @tparam Values of vcavity, one component per colour or wavelength, each an array
template <class Values, class UnpolarizedSpectrum>
std::pair<Values, Values> index_of_lanes(const UnpolarizedSpectrum& eta, const UnpolarizedSpectrum& k) {
  const auto within = [](const UnpolarizedSpectrum& x) -> UnpolarizedSpectrum {
    return drjit::select(drjit::isnan(x), 0.f, drjit::minimum(drjit::abs(x), Index::largest));
  };
  const UnpolarizedSpectrum n_values = within(eta), k_values = within(k);
  const auto is_index = n_values + k_values >= Index::smallest;
  return {Values(UnpolarizedSpectrum(drjit::select(is_index, n_values, Index::mirror().n))),
          Values(UnpolarizedSpectrum(drjit::select(is_index, k_values, Index::mirror().k)))};
}

/// Values of vcavity as a spectrum of Mitsuba.
template <class UnpolarizedSpectrum, class Real>
UnpolarizedSpectrum to_spectrum(const Values<Real, UnpolarizedSpectrum>& values) {
  // In one step: an array that is written number by number and then read as a whole keeps the processor waiting.
  return [&values]<std::size_t... i>(std::index_sequence<i...>) {
    return UnpolarizedSpectrum(static_cast<float>(values[i])...);
  }(std::make_index_sequence<drjit::size_v<UnpolarizedSpectrum>>());
}

/// A facet that reflects a given part of what another one reflects: `specular_reflectance`, at each bounce, as in
/// grooves modelled as a mesh of such mirrors.
template <class Facet, class Value>
class Tinted {
 public:
  /// @param tint factor on the reflectance, in [0, 1]
  Tinted(const Facet& facet, const Value& tint) : facet_(facet), tint_(tint), amplitude_(sqrt(tint)) {}

  /// Reflectance of unpolarised light.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <class Cosine>
  Value operator()(const Cosine& cos_theta_i) const {
    return tint_ * facet_(cos_theta_i);
  }

  /// The same before a division, for facets that know it.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <class Cosine>
  vcavity::Fraction<Value> fraction(const Cosine& cos_theta_i) const
    requires requires(const Facet& facet) { facet.fraction(cos_theta_i); }
  {
    const auto untinted = facet_.fraction(cos_theta_i);
    return {tint_ * untinted.numerator, untinted.denominator};
  }

  /// Amplitudes r_s and r_p.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <class Cosine>
  vcavity::Amplitudes<Value> amplitudes(const Cosine& cos_theta_i) const {
    const auto of_facet = facet_.amplitudes(cos_theta_i);
    return {scaled(of_facet.r_s), scaled(of_facet.r_p)};
  }

  /// That of the facet, whose rounding errors are no smaller.
  auto contrast() const { return facet_.contrast(); }

 private:
  vcavity::Complex<Value> scaled(const vcavity::Complex<Value>& r) const {
    return {amplitude_ * r.re, amplitude_ * r.im};
  }

  Facet facet_;
  Value tint_;
  Value amplitude_;
};

/// An index and a tint, as numbers.
struct TintedIndex {
  Index index;
  float tint;

  /// The facet in double.
  auto facet() const {
    return Tinted(vcavity::Conductor<double>(index.n, index.k), static_cast<double>(tint));
  }

  friend bool operator==(const TintedIndex&, const TintedIndex&) = default;
};

}  // namespace vgroove
