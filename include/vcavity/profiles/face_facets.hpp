// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A facet of its own for every face of a surface with land, floors or both.
///
/// Where one facet serves all faces it is passed as it is. Models of polarisation and balances apply to each facet:
/// `polarized(FaceFacets{...})` is a `FaceFacets` too.

#include <type_traits>
#include <utility>

#include "vcavity/facet/energy_balance.hpp"
#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/panel_facets.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/polarization/absorbed_fields.hpp"
#include "vcavity/polarization/polarization.hpp"
#include "vcavity/profiles/face_path.hpp"

namespace vcavity {

/// Facet reflectances of all faces; they return the same type of value. What a shape does not have is not asked for.
template <class One, class Two = One, class Floor = One, class Land = One>
struct FaceFacets {
  One one;      ///< of panel one
  Two two;      ///< of panel two
  Floor floor;  ///< of the flat bottom
  Land land;    ///< of the flat between the grooves
};

template <class One, class Two, class Floor, class Land>
FaceFacets(One, Two, Floor, Land) -> FaceFacets<One, Two, Floor, Land>;

namespace detail {

template <class Facets>
inline constexpr bool is_face_facets = false;
template <class One, class Two, class Floor, class Land>
inline constexpr bool is_face_facets<FaceFacets<One, Two, Floor, Land>> = true;

/// The facet from whose values those of all faces are known.
template <class Facets>
struct AnyFacet {
  using type = Facets;
};
template <class One, class Two, class Floor, class Land>
struct AnyFacet<FaceFacets<One, Two, Floor, Land>> {
  using type = One;
};
template <class Facets>
using any_facet_t = typename AnyFacet<Facets>::type;

/// The value of a face for one bounce.
template <class Real, class Facets>
VCAVITY_INLINE value_t<any_facet_t<Facets>, Real> reflect_at(const Facets& facets, Face face,
                                                             const Bounce<Real>& bounce) {
  if constexpr (is_face_facets<Facets>) {
    switch (face) {
      case Face::one:
        return reflect(facets.one, bounce);
      case Face::two:
        return reflect(facets.two, bounce);
      case Face::floor:
        return reflect(facets.floor, bounce);
      case Face::land:
        break;
    }
    return reflect(facets.land, bounce);
  } else {
    return reflect(facets, bounce);
  }
}

/// The facets of the panels as one facet, for grooves that have no other faces.
template <class Facets>
struct WallFacets {
  const Facets* facets;

  template <class Real>
  VCAVITY_INLINE auto operator()(const Bounce<Real>& bounce) const {
    return reflect_at(*facets, face_of(bounce.panel), bounce);
  }
};

/// Calls `use` with a facet of the panels.
template <class Facets, class Use>
VCAVITY_INLINE decltype(auto) with_walls(const Facets& facets, Use&& use) {
  if constexpr (is_face_facets<Facets>)
    return use(WallFacets<Facets>{&facets});
  else
    return use(facets);
}

/// The same facets, each changed by `change`.
template <class Facets, class Change>
auto each_facet(const Facets& facets, Change&& change) {
  if constexpr (is_face_facets<Facets>)
    return FaceFacets{change(facets.one), change(facets.two), change(facets.floor), change(facets.land)};
  else
    return change(facets);
}

template <class One, class Two, class Change>
auto each_facet(const PanelFacets<One, Two>& facets, Change&& change) {
  return PanelFacets{change(facets.one), change(facets.two)};
}

}  // namespace detail

/// The facets with their fields followed exactly.
template <class One, class Two, class Floor, class Land>
auto polarized(const FaceFacets<One, Two, Floor, Land>& facets) {
  return detail::each_facet(facets, [](const auto& facet) { return polarized(facet); });
}

/// The facets with their s and p light followed on their own.
template <class One, class Two, class Floor, class Land>
auto separately_polarized(const FaceFacets<One, Two, Floor, Land>& facets) {
  return detail::each_facet(facets, [](const auto& facet) { return separately_polarized(facet); });
}

}  // namespace vcavity
