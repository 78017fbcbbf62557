// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Lobes: where the light of one direction goes.
///
/// Rays of one direction that meet the same panel first and bounce equally often leave in one direction with
/// one throughput. They are a lobe, and a direction has at most four. The weight of a lobe, its fraction of
/// the opening, is known in closed form: of j bounces it is f_j − f_{j+1}, with the series f_j of
/// lit_opening.hpp. So the integral over the position (Eq. 20) needs no quadrature.
///
/// The groove may have another shape than the symmetric one, as long as its panels are planes that can be
/// unfolded: see `UnfoldableGroove`.

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/follow.hpp"
#include "vcavity/groove/lit_opening.hpp"
#include "vcavity/groove/narrow_groove.hpp"
#include "vcavity/groove/unfoldable_groove.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/short_list.hpp"

namespace vcavity {

/// Light that leaves the groove in one direction.
template <class Real, class Value>
struct Lobe {
  Panel first_panel;     ///< the panel met first
  int bounces;           ///< number of reflections
  Real weight;           ///< fraction of the opening, (0, 1]; the weights of a direction add up to 1
  Value throughput;      ///< product of the facet reflectances along the way
  Vec3<Real> direction;  ///< direction in which the light travels after its last bounce
};

/// The lobes of a direction, in a list without allocation.
/// @tparam capacity the largest number of them, `max_lobes` of the groove
template <class Real, class Value, std::size_t capacity = Cavity<Real>::max_lobes>
using Lobes = ShortList<Lobe<Real, Value>, capacity>;

/// Calls `visit` with every bounce after which light of a direction may leave, and the weight and throughput
/// of the light that does; the loop behind `lobes` and `directional_reflectance`. Weights may be 0.
///
/// A weight below `negligible_fraction` is the rounding error of a direction at a change of the bounce count.
/// It is counted with its neighbour, which may be much darker; so no such lobe appears.
///
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param towards_light direction towards the light, or towards the viewer under diffuse light; z ≥ 0
/// @param facet facet reflectance
/// @param visit called as visit(ray at the bounce, weight, throughput)
/// @param follow which light is followed
template <class Groove, class Real, FacetReflectance<Real> Facet, class Visit>
  requires UnfoldableGroove<Groove, Real>
VCAVITY_INLINE void for_each_lobe(const Groove& groove, const Vec3<Real>& towards_light, const Facet& facet,
                                  Visit&& visit, const Follow& follow = {}) {
  using Value = value_t<Facet, Real>;
  assert(!any_of(towards_light.z < scalar_t<Real>(0)));
  const int most = std::min(follow.max_bounces, groove.max_bounces());
  if (most < 1) return;
  const auto negligible = negligible_fraction<scalar_t<Real>>();

  const auto opening = lit_opening(groove, towards_light);
  for (int which = 0; which < opening.first_panels(); ++which) {
    const Panel first = opening.first_panel(which);
    if (!follow.first_panel.includes(first)) continue;
    UnfoldedRay<Real> ray = unfold(groove, opening.direction(), first);
    Real reached = opening.first_met(first);
    if (!any_of(reached > scalar_t<Real>(0))) continue;

    // All that makes long series fast; it changes no result (narrow_groove.hpp).
    const LongSeries<Groove, Real, Facet> series(groove, facet, ray, most, follow.dark_light);
    Value throughput(1);
    series.begin(ray, throughput);
    for (;;) {
      const bool is_followed = series.reflect(ray, throughput);
      const UnfoldedRay<Real> last = ray;
      ray.advance();
      if (is_followed && series.all_reach(last, ray)) continue;

      // What reaches the next image; the rest leaves.
      Real next =
          is_followed && last.number() < groove.max_bounces() ? opening.reached(ray, reached) : Real(0);
      next = select(next >= negligible, next, Real(0));
      next = select(Real(reached - next) >= negligible, next, reached);
      const Real weight = reached - next;
      if (cheaper_than_branch<Value> || any_of(weight > scalar_t<Real>(0))) visit(last, weight, throughput);
      if (last.number() >= most || !any_of(next > scalar_t<Real>(0))) break;
      reached = next;
    }
  }
}

/// The lobes of a direction, at most `max_lobes` of the groove.
///
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light, e.z ≥ 0. By reciprocity also the direction towards a viewer of the
///          groove in diffuse light; then `-direction` of a lobe is where its light comes from.
/// @param facet facet reflectance
/// @param max_bounces lobes of more bounces are left out
template <class Groove, FacetReflectance<scalar_t<Groove>> Facet>
  requires UnfoldableGroove<Groove, scalar_t<Groove>>
auto lobes(const Groove& groove, const Vec3<scalar_t<Groove>>& e, const Facet& facet,
           int max_bounces = all_bounces) {
  using Real = scalar_t<Groove>;
  using Value = value_t<Facet, Real>;
  Lobes<Real, Value, Groove::max_lobes> result;
  for_each_lobe(groove, e, facet,
                [&](const UnfoldedRay<Real>& last, const Real& weight, const Value& throughput) {
                  if (!(weight > Real(0))) return;
                  result.push_back(
                      {last.first_panel(), last.number(), weight, throughput, exit_direction(groove, last)});
                },
                {.max_bounces = max_bounces});
  return result;
}

}  // namespace vcavity
