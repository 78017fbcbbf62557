// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Polarisation followed as s and p light on their own, ½(Π|r_s|² + Π|r_p|²), as if all planes of incidence were
/// parallel.
///
/// When not to use it: for light that does not travel across the groove; right for that alone.

#include <utility>

#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/facet_wrapper.hpp"
#include "vcavity/facet/panel_facets.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/linear.hpp"
#include "vcavity/polarization/mueller.hpp"

namespace vcavity {

/// Reflectances of s and of p light, multiplied and added on their own.
template <class Value>
struct SeparatePolarizations : Linear<SeparatePolarizations<Value>, Value> {
  using value_type = scalar_t<Value>;

  Value s;
  Value p;

  SeparatePolarizations() = default;
  SeparatePolarizations(const Value& s_part, const Value& p_part) : s(s_part), p(p_part) {}

  /// 1: all reflected. 0: no light at all.
  explicit SeparatePolarizations(int light)
      : s(Value(static_cast<value_type>(light))), p(Value(static_cast<value_type>(light))) {}

  friend SeparatePolarizations operator*(const SeparatePolarizations& a, const SeparatePolarizations& b) {
    return {a.s * b.s, a.p * b.p};
  }
  /// Both parts of an operation on reflectances; see `Linear`.
  template <class Operation, class... Reflectances>
  VCAVITY_INLINE static SeparatePolarizations combine(const Operation& operation,
                                                      const Reflectances&... reflectances) {
    return {Value(operation(reflectances.s...)), Value(operation(reflectances.p...))};
  }
  friend SeparatePolarizations at_most(const SeparatePolarizations& a, const value_type& ceiling) {
    return {at_most(a.s, ceiling), at_most(a.p, ceiling)};
  }
  friend value_type largest(const SeparatePolarizations& a) { return at_least(largest(a.s), largest(a.p)); }
};

/// The reflectance of unpolarised light.
template <class Value>
Value unpolarized(const SeparatePolarizations<Value>& reflectance) {
  return scalar_t<Value>(0.5) * (reflectance.s + reflectance.p);
}

/// How much the reflectance depends on the polarisation of the incident light, (max − min)/(max + min) in
/// [0, 1]; 0 where no light leaves.
template <class Value>
Value diattenuation(const SeparatePolarizations<Value>& r) {
  const Value none(0);
  return degree_of_polarization(Stokes<Value>{r.s + r.p, r.s - r.p, none, none});
}

/// Facet reflectance for s and p light on their own.
template <class Facet>
class SeparatelyPolarized : public FacetWrapper<SeparatelyPolarized, Facet> {
 public:
  using FacetWrapper<SeparatelyPolarized, Facet>::FacetWrapper;
  using FacetWrapper<SeparatelyPolarized, Facet>::facet;

  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <class Real>
    requires FieldReflector<Facet, Real>
  auto operator()(const Real& cos_theta_i) const {
    const auto amplitudes = facet().amplitudes(cos_theta_i);
    return SeparatePolarizations(norm(amplitudes.r_s), norm(amplitudes.r_p));
  }

  /// What is not reflected of either.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <class Real>
  auto absorptance(const Real& cos_theta_i) const
    requires requires(const Facet& facet) { facet.absorptances(cos_theta_i); }
  {
    const auto [s, p] = facet().absorptances(cos_theta_i);
    return SeparatePolarizations(s, p);
  }
};

/// The facet with its s and p light followed on their own.
/// @param facet a facet with amplitudes, such as `Conductor` or `Dielectric`
template <class Facet>
SeparatelyPolarized<Facet> separately_polarized(Facet facet) {
  return SeparatelyPolarized<Facet>(std::move(facet));
}

/// The same for a groove of two materials.
/// @param facets one for each panel
template <class One, class Two>
auto separately_polarized(PanelFacets<One, Two> facets) {
  return PanelFacets{separately_polarized(std::move(facets.one)),
                     separately_polarized(std::move(facets.two))};
}

}  // namespace vcavity
