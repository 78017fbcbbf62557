// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Polarisation followed exactly, as the field of the wave from bounce to bounce.
///
/// Method. Let c and d be the components of the direction e along the normal of the panel
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

#include <utility>

#include "vcavity/facet/bounce.hpp"
#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/facet_wrapper.hpp"
#include "vcavity/facet/fresnel.hpp"
#include "vcavity/facet/panel_facets.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/polarization/mueller.hpp"

namespace vcavity {

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

/// The facet with its fields followed exactly; reflectances are then Mueller matrices.
/// @param facet a facet with amplitudes, such as `Conductor` or `Dielectric`
template <class Facet>
Polarized<Facet> polarized(Facet facet) {
  return Polarized<Facet>(std::move(facet));
}

/// The same for a groove of two materials.
/// @param facets one for each panel
template <class One, class Two>
auto polarized(PanelFacets<One, Two> facets) {
  return PanelFacets{polarized(std::move(facets.one)), polarized(std::move(facets.two))};
}

}  // namespace vcavity
