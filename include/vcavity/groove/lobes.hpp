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
#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <limits>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/lit_opening.hpp"
#include "vcavity/groove/narrow_groove.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// Pass as the largest number of bounces to follow them all.
inline constexpr int all_bounces = std::numeric_limits<int>::max();

/// Light that leaves the groove in one direction.
template <class Real, class Value>
struct Lobe {
  Panel first_panel;     ///< the panel met first
  int bounces;           ///< number of reflections
  Real weight;           ///< fraction of the opening, (0, 1]; the weights of a direction add up to 1
  Value throughput;      ///< product of the facet reflectances along the way
  Vec3<Real> direction;  ///< direction in which the light travels after its last bounce
};

/// A few lobes, without allocation.
/// @tparam capacity the largest number of them, `max_lobes` of the groove
template <class Real, class Value, std::size_t capacity = Cavity<Real>::max_lobes>
class Lobes {
 public:
  /// @param lobe one more; there must be room for it
  void push_back(const Lobe<Real, Value>& lobe) {
    assert(size_ < capacity);
    lobes_[size_++] = lobe;
  }
  std::size_t size() const { return size_; }
  const Lobe<Real, Value>& operator[](std::size_t i) const& { return lobes_[i]; }
  Lobe<Real, Value> operator[](std::size_t i) && { return lobes_[i]; }
  const Lobe<Real, Value>* begin() const { return lobes_.data(); }
  const Lobe<Real, Value>* end() const { return lobes_.data() + size_; }

 private:
  std::array<Lobe<Real, Value>, capacity> lobes_;
  std::size_t size_ = 0;
};

/// A groove of two plane panels that can be unfolded. It is made of numbers of type `value_type`, has at most
/// `max_lobes` lobes for any direction and `max_bounces()` bounces for any ray, and these functions, found by
/// argument-dependent look-up, with `Cavity` as the pattern:
///
///  - `unfold(groove, e, first)`, the ray in the fan of the images, in the frame of the bisector of the panels;
///  - `lit_opening(groove, e)`, the first panels, and for each the series of the fractions of the opening whose
///    rays reach a bounce; its members are those of `LitOpening`;
///  - `exit_direction(groove, ray)`, back in the frame of the groove.
/// @tparam Real number type of a direction, or a `Pack` of them
template <class Groove, class Real>
concept UnfoldableGroove = requires(const Groove& groove, const Vec3<Real>& e, const UnfoldedRay<Real>& ray) {
  typename Groove::value_type;
  { Groove::max_lobes } -> std::convertible_to<std::size_t>;
  { groove.aperture() } -> std::convertible_to<scalar_t<Groove>>;
  { groove.max_bounces() } -> std::same_as<int>;
  { unfold(groove, e, Panel::one) } -> std::same_as<UnfoldedRay<Real>>;
  { exit_direction(groove, ray) } -> std::same_as<Vec3<Real>>;
  { lit_opening(groove, e).direction() } -> std::convertible_to<Vec3<Real>>;
  { lit_opening(groove, e).first_panels() } -> std::same_as<int>;
  { lit_opening(groove, e).first_panel(0) } -> std::same_as<Panel>;
  { lit_opening(groove, e).reached(ray).first() } -> std::convertible_to<Real>;
  { lit_opening(groove, e).reached(ray).at(ray, e.z) } -> std::same_as<Real>;
  { lit_opening(groove, e).reached(ray).all_reach(ray) } -> std::same_as<bool>;
};

/// What to do with light of which nothing is left, its throughput being below the smallest normal number.
enum class DarkLight {
  followed,  ///< to its last bounce, though without any more Fresnel evaluations
  merged     ///< into one lobe that ends where the light does
};

/// The panels that light may meet first.
class FirstPanel {
 public:
  /// Either of them.
  constexpr FirstPanel() = default;

  /// Only one of them.
  /// @param only this one
  constexpr FirstPanel(Panel only) : one_(only == Panel::one), two_(only == Panel::two) {}

  /// Whether a panel is one of them.
  constexpr bool includes(Panel panel) const { return panel == Panel::one ? one_ : two_; }

 private:
  bool one_ = true;
  bool two_ = true;
};

/// Which light is followed.
struct Follow {
  int max_bounces = all_bounces;               ///< lobes of more bounces are left out
  DarkLight dark_light = DarkLight::followed;  ///< see there
  FirstPanel first_panel = {};                 ///< other light is left out
};

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
  const bool is_long = groove.max_bounces() >= long_series;

  const auto opening = lit_opening(groove, towards_light);
  for (int which = 0; which < opening.first_panels(); ++which) {
    const Panel first = opening.first_panel(which);
    if (!follow.first_panel.includes(first)) continue;
    UnfoldedRay<Real> ray = unfold(groove, opening.direction(), first);
    const auto fractions = opening.reached(ray);
    Real reached = fractions.first();
    if (!any_of(reached > scalar_t<Real>(0))) continue;

    Value throughput(1);
    if (most >= narrow_groove) {
      const auto rest = reflect_many<Value>(facet, ray, fractions, groove.aperture(), most);
      ray = rest.ray;
      throughput = rest.throughput;
    }
    for (;;) {
      if (!is_dark(throughput, ray.number())) {
        const Value reflected = reflect(facet, ray);
        if (!cheaper_than_branch<Value> && ray.number() == 1)
          throughput = reflected;
        else
          throughput = throughput * reflected;
      } else if (follow.dark_light == DarkLight::merged) {
        visit(ray, reached, throughput);
        break;
      }
      const UnfoldedRay<Real> last = ray;
      ray.advance();
      if (last.number() < most && is_long && fractions.all_reach(ray)) continue;

      // What reaches the next bounce; the rest leaves.
      Real next = last.number() < groove.max_bounces() ? fractions.at(ray, reached) : Real(0);
      next = select(next >= negligible, next, Real(0));
      next = select(Real(reached - next) >= negligible, next, reached);
      visit(last, Real(reached - next), throughput);
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
