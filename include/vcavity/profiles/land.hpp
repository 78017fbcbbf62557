// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Flat land between grooves, at the height of their rims.
///
/// Light that leaves a groove meets nothing else, for nothing rises above the rims. So the land, a part g of the period,
/// is one more lobe: R = (1 − g) R_groove + g R_flat, exactly.

#include <cassert>
#include <concepts>
#include <utility>

#include "vcavity/facet/bounce.hpp"
#include "vcavity/groove/lobes.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/profiles/profile.hpp"

namespace vcavity {

/// Grooves with flat land between them.
/// @tparam Groove `Cavity`, `AsymmetricGroove`, or a profile
template <class Groove>
class Land {
 public:
  using value_type = scalar_t<Groove>;
  static constexpr bool is_profile = true;

  /// @param groove what lies between two lands
  /// @param fraction width of a land as a fraction of the period, in [0, 1)
  /// @throws std::invalid_argument when the fraction is out of range or is not a number
  Land(Groove groove, const value_type& fraction) : groove_(std::move(groove)), fraction_(fraction) {
    if (!(fraction >= value_type(0) && fraction < value_type(1))) {
      throw_invalid_argument("the land must take a fraction of the period in [0, 1), not ", fraction);
    }
  }

  /// What lies between two lands.
  const Groove& groove() const { return groove_; }

  /// Width of a land as a fraction of the period.
  const value_type& fraction() const { return fraction_; }

  /// No ray bounces more often.
  int max_bounces() const { return groove_.max_bounces(); }

  /// The area of all faces per area of the period, under diffuse light the mean number of bounces.
  value_type developed_area() const {
    return (value_type(1) - fraction_) * groove_.developed_area() + fraction_;
  }

  /// Follows all light of a direction; see `Profile`.
  /// @param e direction towards the light, e.z ≥ 0
  /// @param facets facet reflectances of the faces, or one for all
  /// @param visit called for each part of the light
  /// @param max_bounces light that needs more bounces is left out
  template <class Facets, class Visit>
  void follow(const Vec3<value_type>& e, const Facets& facets, Visit&& visit,
              int max_bounces = all_bounces) const {
    using Value = face_value_t<Facets, value_type>;
    assert(e.z >= value_type(0));
    const value_type rest = value_type(1) - fraction_;
    if constexpr (Profile<Groove>) {
      groove_.follow(
          e, facets,
          [&](FacePencil<value_type> light, const Value& throughput) {
            light.start = rest * light.start;
            light.weight = rest * light.weight;
            visit(light, throughput);
          },
          max_bounces);
    } else {
      detail::with_walls(facets, [&](const auto& walls) {
        value_type from_one(0), from_two(0);  // the light that enters nearer to the rims
        for_each_lobe(
            groove_, e, walls,
            [&](const UnfoldedRay<value_type>& last, const value_type& weight, const Value& throughput) {
              if (!(weight > value_type(0))) return;
              const Panel first = last.first_panel();
              value_type& nearer = first == Panel::one ? from_one : from_two;
              const value_type start =
                  first == Panel::one ? nearer : value_type(value_type(1) - nearer - weight);
              nearer += weight;
              visit(FacePencil<value_type>{{first, last.number(), false, Panel::one, 0, false},
                                           rest * start,
                                           rest * weight,
                                           exit_direction(groove_, last)},
                    throughput);
            },
            {.max_bounces = max_bounces});
      });
    }
    if (!(fraction_ > value_type(0)) || max_bounces < 1) return;
    const Bounce<value_type> bounce{e.z, -e.y, e.x, Panel::one, 1};
    visit(
        FacePencil<value_type>{
            {Panel::one, 0, false, Panel::one, 0, true}, rest, fraction_, {-e.x, -e.y, e.z}},
        detail::reflect_at(facets, Face::land, bounce));
  }

 private:
  Groove groove_;
  value_type fraction_;
};

}  // namespace vcavity
