// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Grooves whose two panels are made of different materials.
///
/// It works with every value, polarised light included: `polarized` and `separately_polarized` of a
/// `PanelFacets` apply to either facet. Not for `bihemispherical_reflectance` of a symmetric groove, which
/// takes it for granted that light reflects as well off either panel first.

#include <cstddef>
#include <utility>
#include <vector>

#include "vcavity/facet/facet.hpp"

namespace vcavity {

/// A facet of its own for each panel.
/// @tparam One facet reflectance of panel one
/// @tparam Two that of panel two; it returns the same type of value
template <class One, class Two = One>
struct PanelFacets {
  One one;
  Two two;

  /// The value of the facet of the panel of this bounce.
  template <class Real>
    requires(FacetReflectance<One, Real> && std::same_as<value_t<One, Real>, value_t<Two, Real>>)
  VCAVITY_INLINE value_t<One, Real> operator()(const Bounce<Real>& bounce) const {
    return bounce.panel == Panel::one ? reflect(one, bounce) : reflect(two, bounce);
  }

  /// What is not reflected there.
  template <class Real>
    requires(AbsorbingFacet<One, Real> && AbsorbingFacet<Two, Real>)
  value_t<One, Real> absorptance(const Bounce<Real>& bounce) const {
    return bounce.panel == Panel::one ? part(one, bounce) : part(two, bounce);
  }

  /// Both facets for several directions at once.
  template <std::size_t directions>
  auto over_directions() const
    requires(OverDirections<One> && OverDirections<Two>)
  {
    using WideOne = decltype(one.template over_directions<directions>());
    using WideTwo = decltype(two.template over_directions<directions>());
    return PanelFacets<WideOne, WideTwo>{one.template over_directions<directions>(),
                                         two.template over_directions<directions>()};
  }

 private:
  template <class Facet, class Real>
  static auto part(const Facet& facet, const Bounce<Real>& bounce) {
    if constexpr (std::invocable<const Facet&, const Real&>)
      return facet.absorptance(bounce.cosine);
    else
      return facet.absorptance(bounce);
  }
};

template <class One, class Two>
PanelFacets(One, Two) -> PanelFacets<One, Two>;

}  // namespace vcavity
