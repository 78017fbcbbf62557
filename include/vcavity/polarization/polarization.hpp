// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Facets that keep track of polarisation. The model is a type: wrap a facet in one of these and pass it
/// where a facet reflectance is expected.
///
///  - A facet by itself reflects unpolarised light at every bounce, as in the paper (Eq. 17).
///  - `separately_polarized(facet)` follows s and p light on their own, ½(Π|r_s|² + Π|r_p|²), as if all
///    planes of incidence were parallel. Right only for light that travels across the groove.
///  - `polarized(facet)` follows the field: exact.
///
/// Method of the exact model. Let c and d be the components of the direction e along the normal of the panel
/// and along the panel, away from the apex; e_x the one along the groove. In the axes a, b of the incident
/// light (conventions.hpp) the plane of incidence lies along p̂ ∝ (e_x c, ±d), + on panel one and − on panel
/// two, so that the reflection is
///
///     K = diag(1, −1) (r_s I + (r_p − r_s) p̂ p̂ᵀ),
///
/// in the axes of the reflected light: a is the mirror image of a, b the opposite of that of b, because a
/// mirror swaps left and right. The field of a lobe is the product of the K of its bounces. Where e is normal
/// to the panel r_p = r_s, and there is no need of a p̂; nor is there for light along the groove, the limit of
/// grazing incidence in which every reflection is total.

#include <limits>
#include <utility>

#include "vcavity/facet/bounce.hpp"
#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/facet_wrapper.hpp"
#include "vcavity/facet/fresnel.hpp"
#include "vcavity/facet/panel_facets.hpp"
#include "vcavity/numbers/compiler.hpp"
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

/// The plane of incidence of a bounce as the matrix p̂ p̂ᵀ, in the axes of the incident light.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
struct IncidencePlane {
  Real aa, ab, bb;

  /// Next to 0 where there is no such plane, as at normal incidence; nothing depends on it then.
  explicit IncidencePlane(const Bounce<Real>& bounce) {
    Real p_a = bounce.along * bounce.cosine;
    Real p_b = bounce.panel == Panel::one ? bounce.tangent : Real(-bounce.tangent);
    // Almost along the groove both are so small that their squares would vanish; only their ratio counts.
    using Scalar = scalar_t<Real>;
    const Scalar small = detail::smallest_cosine<Scalar>();
    const Real scale =
        select(Real(magnitude(p_a) + magnitude(p_b)) >= small, Real(1), Real(Scalar(1) / (small * small)));
    p_a = p_a * scale;
    p_b = p_b * scale;
    const Real inverse = Real(1) / at_least(Real(p_a * p_a + p_b * p_b), smallest_divisor<Scalar>());
    aa = p_a * p_a * inverse;
    ab = p_a * p_b * inverse;
    bb = p_b * p_b * inverse;
  }
};

/// Facet reflectance for fields, with the plane of incidence of each bounce.
template <class Facet>
class Polarized : public FacetWrapper<Polarized, Facet> {
 public:
  using FacetWrapper<Polarized, Facet>::FacetWrapper;
  using FacetWrapper<Polarized, Facet>::facet;

  /// The Jones matrix of a bounce, from the axes of the light that meets the panel to those of the light that
  /// leaves it.
  template <class Real>
    requires FieldReflector<Facet, Real>
  VCAVITY_INLINE auto operator()(const Bounce<Real>& bounce) const {
    return jones(facet().amplitudes(bounce.cosine), IncidencePlane<Real>(bounce));
  }

 private:
  template <class Value, class Real>
  static Jones<Value> jones(const Amplitudes<Value>& facet, const IncidencePlane<Real>& plane) {
    const Complex<Value> none{Value(0), Value(0)};
    const Complex<Value> difference = facet.r_p - facet.r_s;
    const auto part = [&difference](const Real& share) {
      if constexpr (Number<Real>) {
        return Value(static_cast<scalar_t<Value>>(share)) * difference;
      } else {
        return share * difference;
      }
    };
    const Complex<Value> mixed = part(plane.ab);
    return {facet.r_s + part(plane.aa), mixed, none - mixed, none - (facet.r_s + part(plane.bb))};
  }
};

/// The facet with its s and p light followed on their own.
/// @param facet a facet with amplitudes, such as `Conductor` or `Dielectric`
template <class Facet>
SeparatelyPolarized<Facet> separately_polarized(Facet facet) {
  return SeparatelyPolarized<Facet>(std::move(facet));
}

/// The facet with its fields followed exactly; reflectances are then Mueller matrices.
/// @param facet a facet with amplitudes, such as `Conductor` or `Dielectric`
template <class Facet>
Polarized<Facet> polarized(Facet facet) {
  return Polarized<Facet>(std::move(facet));
}

/// The same for a groove of two materials.
/// @param facets one for each panel
template <class One, class Two>
auto separately_polarized(PanelFacets<One, Two> facets) {
  return PanelFacets{separately_polarized(std::move(facets.one)),
                     separately_polarized(std::move(facets.two))};
}

/// The same for a groove of two materials.
/// @param facets one for each panel
template <class One, class Two>
auto polarized(PanelFacets<One, Two> facets) {
  return PanelFacets{polarized(std::move(facets.one)), polarized(std::move(facets.two))};
}

}  // namespace vcavity
