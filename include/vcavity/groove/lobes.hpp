// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Lobes: where the light of one direction goes.
///
/// Rays of one direction that meet the same panel first and bounce equally often leave in one direction with
/// one throughput. They are a lobe, and a direction has at most four. The weight of a lobe, its fraction of
/// the opening, is known in closed form, so the integral over the position (Eq. 20) needs no quadrature.
///
/// Method. Let f_j be the fraction of the opening whose rays meet a given panel first and bounce at least j
/// times, and t = |e_y|/e_z = |tan θ'|. For directions within the aperture, |θ'| < α/2, light reaches both
/// panels directly and
///
///     f_j = clamp(c_j, 0, c_1) / (2 e_z sin(α/2)),   c_j = e · N^(j);
///
/// beyond, only the panel that faces the light is met first and
///
///     f_j = clamp( sin(jα/2)/sin(α/2) · (cos((j−1)α/2) − t sin((j−1)α/2)), 0, 1 ),
///
/// a product that keeps its digits as e_z → 0. The weight of the lobe of j bounces is f_j − f_{j+1}.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/bounces.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/inline.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/progression_sum.hpp"

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

/// Up to four lobes, without allocation.
template <class Real, class Value>
class Lobes {
 public:
  void push_back(const Lobe<Real, Value>& lobe) {
    assert(size_ < 4);
    lobes_[size_++] = lobe;
  }
  std::size_t size() const { return size_; }
  const Lobe<Real, Value>& operator[](std::size_t i) const { return lobes_[i]; }
  const Lobe<Real, Value>* begin() const { return lobes_.data(); }
  const Lobe<Real, Value>* end() const { return lobes_.data() + size_; }

 private:
  std::array<Lobe<Real, Value>, 4> lobes_;
  std::size_t size_ = 0;
};

/// A fraction of the opening below this is the rounding error of a direction at a change of the bounce count.
template <Number Real>
Real negligible_fraction() {
  return Real(4) * std::numeric_limits<Real>::epsilon();
}

/// The opening of the groove as the light of a direction finds it.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
struct LitOpening {
  using Scalar = scalar_t<Real>;

  /// @param e direction towards the light, e.z ≥ least_up
  VCAVITY_INLINE LitOpening(const Cavity<Scalar>& cavity, const Vec3<Real>& e)
      : inverse_e_z(Real(1) / e.z), inverse_width((Scalar(0.5) * cavity.inverse_sin_half()) * inverse_e_z) {
    const Real other_normal = cavity.sin_half() * e.z - cavity.cos_half() * magnitude(e.y);
    const Real share = other_normal * inverse_width;
    both = share - Real(negligible_fraction<Scalar>());
    other_share = select_positive(both, share, Real(0));
    any_both = any_positive(both);
    all_both = all_positive(both);
  }

  /// The least e.z, so small that light travels along the groove whatever it is; inverses are finite.
  static Scalar least_up(const Cavity<Scalar>& cavity) {
    return smallest_divisor<Scalar>() * cavity.inverse_sin_half();
  }

  Real inverse_e_z;    ///< 1/e_z
  Real inverse_width;  ///< of the width of the opening as the light sees it, 2 e_z sin(α/2)
  Real other_share;  ///< fraction of the opening whose rays meet the panel first that does not face the light
  Real both;         ///< positive where light reaches both panels directly
  bool any_both;
  bool all_both;
};

/// The series f_j of one first panel.
/// @tparam Real number type of a component, or a `Pack` of them: as many directions at once
template <class Real>
class ReachedFractions {
 public:
  using Scalar = scalar_t<Real>;

  /// @param e direction towards the light, e.z ≥ least_up
  /// @param opening as the light finds it
  /// @param first the image of the panel met first
  ReachedFractions(const Cavity<Scalar>& cavity, const Vec3<Real>& e, const LitOpening<Real>& opening,
                   const PanelImages<Real>& first)
      : cavity_(cavity),
        e_(e),
        opening_(opening),
        first_(first.panel() == facing_panel(e) ? Real(Real(1) - opening.other_share) : opening.other_share),
        surely_reached_(first.normal_component() +
                        Real(Scalar(16) * std::numeric_limits<Scalar>::epsilon())) {}

  /// f_1: the fraction of the opening whose rays meet this panel first.
  const Real& first() const { return first_; }

  /// Whether all of these rays bounce at an image too, at the cost of a comparison: c_j > c_1, by more than
  /// rounding, which is up to 8 ε in each (docs/accuracy.md).
  bool all_reach(const PanelImages<Real>& image) const {
    return all_positive(Real(image.normal_component() - surely_reached_));
  }

  /// f_j, where j is the number of the image.
  /// @param before f_{j−1}, which f_j never exceeds
  VCAVITY_INLINE Real at(const PanelImages<Real>& image, const Real& before) const {
    Real on_one(0);
    if (!opening_.all_both) {
      const auto turn = cavity_.multiple(image.bounce() - 1);
      const Real slope = turn.cosine * e_.z - turn.sine * magnitude(e_.y);
      const Scalar fan = cavity_.multiple(image.bounce()).sine * cavity_.inverse_sin_half();
      on_one = at_least(at_most(Real(fan * (slope * opening_.inverse_e_z)), before), Scalar(0));
      if (!opening_.any_both) return on_one;
    }
    const Real share = image.normal_component() * opening_.inverse_width;
    return select_positive(opening_.both, at_least(at_most(share, before), Scalar(0)), on_one);
  }

 private:
  const Cavity<Scalar>& cavity_;
  const Vec3<Real>& e_;
  const LitOpening<Real>& opening_;
  Real first_;
  Real surely_reached_;  // a normal component above this
};

/// What to do with light of which nothing is left, its throughput being below the smallest normal number.
enum class DarkLight {
  followed,  ///< to its last bounce, though without any more Fresnel evaluations
  merged     ///< into one lobe that ends where the light does
};

/// From this number of bounces on it may pay to do many at once.
inline constexpr int narrow_groove = 200;

/// Where light goes on bounce by bounce.
template <class Real, class Value>
struct Continuation {
  PanelImages<Real> images;  ///< at the next bounce
  Value throughput;          ///< of the bounces before
};

/// In a narrow groove, does many bounces at once, all of which reach every ray of the first panel: the
/// logarithm of their product is a sum over an arithmetic progression of angles. Does nothing where that does
/// not pay, or the facet is no function of the cosine with positive numbers for values.
/// @param images at the first bounce
/// @param most_bounces none beyond these is done
template <class Value, class Real, class Facet>
[[gnu::noinline]] Continuation<Real, Value> reflect_many(const Facet& facet, PanelImages<Real> images,
                                                         const scalar_t<Real>& aperture, int most_bounces) {
  Value throughput(1);
  if constexpr (std::is_floating_point_v<Real> && std::is_floating_point_v<Value> &&
                std::invocable<const Facet&, const Real&>) {
    constexpr int least_log2 = 7;  // shorter series are done bounce by bounce
    const Real first_angle = std::atan2(images.normal_component(), images.tangent_component());
    const Real size = std::hypot(images.normal_component(), images.tangent_component());
    // All rays bounce until the angle has passed a right one and is as far beyond it as it began before it.
    const Real all_reached = (pi<Real>() - Real(2) * first_angle) / aperture - Real(1);
    int left = std::min(most_bounces, static_cast<int>(std::min(all_reached, Real(most_bounces)))) - 1;
    const auto log_reflectance = [&](const Real& index) {
      const Value reflectance = facet(size * std::sin(first_angle + (index - Real(1)) * aperture));
      return static_cast<Real>(std::log(at_least(reflectance, std::numeric_limits<Value>::min())));
    };
    int log2 = 28;
    while (left >= 1 << least_log2) {
      while (1 << log2 > left) --log2;
      const int count = 1 << log2;
      const auto sum = progression_sum<Real>(log_reflectance, images.bounce(), log2,
                                             Real(3 * count) * std::numeric_limits<Real>::epsilon());
      if (!sum) break;
      throughput *= static_cast<Value>(std::exp(*sum));
      images.advance(count);
      left -= count;
    }
  }
  return {images, throughput};
}

/// Whether nothing is left of a throughput. That shows in long series only, and is looked for now and then.
template <class Value>
bool is_dark(const Value& throughput, int bounce) {
  constexpr int seldom = 8;
  return bounce % seldom == 0 && largest(throughput) < std::numeric_limits<scalar_t<Value>>::min();
}

/// Whether it is faster to multiply a value by 1, or to add 0, than to find out that there is no need.
template <class Value>
inline constexpr bool cheaper_than_branch = Number<Value>;

template <class Real, std::size_t size, std::size_t bytes>
inline constexpr bool cheaper_than_branch<Pack<Real, size, bytes>> = true;

/// Calls `visit` with every bounce after which light of a direction may leave, and the weight and throughput
/// of the light that does; the loop behind `lobes` and `directional_reflectance`. Weights may be 0.
///
/// A weight below `negligible_fraction` is the rounding error of a direction at a change of the bounce count.
/// It is counted with its neighbour, which may be much darker; so no such lobe appears.
///
/// @param towards_light direction towards the light, or towards the viewer under diffuse light; z ≥ 0
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param most_bounces lobes of more bounces are left out
/// @param visit called as visit(images at the bounce, weight, throughput)
/// @param only if given, light that meets the other panel first is left out
template <class Real, FacetReflectance<Real> Facet, class Visit>
VCAVITY_INLINE void for_each_lobe(const Cavity<scalar_t<Real>>& cavity, const Vec3<Real>& towards_light,
                                  const Facet& facet, int most_bounces, Visit&& visit,
                                  DarkLight dark_light = DarkLight::followed,
                                  std::optional<Panel> only = std::nullopt) {
  using Value = value_t<Facet, Real>;
  assert(!any_positive(Real(-towards_light.z)));
  const int most = std::min(most_bounces, cavity.max_bounces());
  if (most < 1) return;

  const Vec3<Real> e{towards_light.x, towards_light.y,
                     at_least(towards_light.z, LitOpening<Real>::least_up(cavity))};
  const LitOpening<Real> opening(cavity, e);
  const Panel facing = facing_panel(e);
  const scalar_t<Real> negligible = negligible_fraction<scalar_t<Real>>();
  const bool is_narrow = cavity.max_bounces() > Cavity<scalar_t<Real>>::tabulated_multiples;
  for (int panel = 0; panel < (opening.any_both ? 2 : 1); ++panel) {
    const Panel first = panel == 0 ? facing : opposite(facing);
    if (only && *only != first) continue;
    PanelImages<Real> images(cavity, e, first);
    const ReachedFractions<Real> fractions(cavity, e, opening, images);
    Real reached = fractions.first();
    if (!any_positive(reached)) continue;
    Value throughput(1);
    if (most >= narrow_groove) {
      const auto rest = reflect_many<Value>(facet, images, cavity.aperture(), most);
      images = rest.images;
      throughput = rest.throughput;
    }
    for (;;) {
      if (!is_dark(throughput, images.bounce())) {
        const Value reflected = reflect(facet, images);
        if (!cheaper_than_branch<Value> && images.bounce() == 1)
          throughput = reflected;
        else
          throughput = throughput * reflected;
      } else if (dark_light == DarkLight::merged) {
        visit(images, reached, throughput);
        break;
      }
      const PanelImages<Real> last = images;
      images.advance();
      if (last.bounce() < most && is_narrow && fractions.all_reach(images)) continue;
      Real next = last.bounce() < cavity.max_bounces() ? fractions.at(images, reached) : Real(0);
      next = select_nonnegative(Real(next - Real(negligible)), next, Real(0));
      next = select_nonnegative(Real(reached - next - Real(negligible)), next, reached);
      visit(last, Real(reached - next), throughput);
      if (last.bounce() >= most || !any_positive(next)) break;
      reached = next;
    }
  }
}

/// The lobes of a direction, at most four.
///
/// @param e direction towards the light, e.z ≥ 0. By reciprocity also the direction towards a viewer of the
/// groove in
///          diffuse light; then `-direction` of a lobe is where its light comes from.
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param most_bounces lobes of more bounces are left out
template <class Real, FacetReflectance<Real> Facet>
Lobes<Real, value_t<Facet, Real>> lobes(const Cavity<Real>& cavity, const Vec3<Real>& e, const Facet& facet,
                                        int most_bounces = all_bounces) {
  using Value = value_t<Facet, Real>;
  Lobes<Real, Value> result;
  for_each_lobe(
      cavity, e, facet, most_bounces,
      [&](const PanelImages<Real>& last, const Real& weight, const Value& throughput) {
        if (!(weight > Real(0))) return;
        const Panel first = last.bounce() % 2 == 1 ? last.panel() : opposite(last.panel());
        result.push_back({first, last.bounce(), weight, throughput, last.exit_direction(cavity, e)});
      });
  return result;
}

}  // namespace vcavity
