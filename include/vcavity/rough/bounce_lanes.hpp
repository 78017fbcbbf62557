// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The light that goes through several grooves, with the reflectances of several bounces computed side by side.
///
/// Bounce i has the angle of incidence k − (i − ½)α in the plane across the groove, k being the elevation of the light
/// above the panel that is met first: its cosine, times cos η, is that of the facet. So no bounce needs the one before
/// it. Ways of up to four bounces go side by side, one bounce of all of them after the other, whether there is such a way
/// or not. Of longer ways there are few, and they come in pairs (`WayPair`): eight bounces of both go side by side. What
/// is reflected does not wait for what else is known of a groove, so that the processor does both at the same time. In
/// both cases the facet is asked for many directions at once, one component (colour) of its values after the other.
///
/// When not to use it: for facets that do not have `over_directions<n>(component)`, such as polarised ones, whose
/// values are no packs of numbers; `RoughGrooveBsdf` follows these bounce by bounce.

#include <array>
#include <cstddef>
#include <type_traits>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/lane_reduction.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/render/bsdf.hpp"
#include "vcavity/rough/groove_batches.hpp"

namespace vcavity {

/// How many numbers a value consists of.
template <class Value>
inline constexpr std::size_t number_count = 0;
template <Number Value>
inline constexpr std::size_t number_count<Value> = 1;
template <class Real, std::size_t size, std::size_t most_bytes>
inline constexpr std::size_t number_count<Pack<Real, size, most_bytes>> = size;

/// A facet whose values are numbers or packs of them, of which every component can be had for several directions at
/// once. They are asked for cosines from 0 to 1, and some ε more.
template <class Facet, class Real>
concept ComponentsOverDirections =
    number_count<value_t<Facet, Real>> > 0 && requires(const Facet& facet, std::size_t i) {
      facet.template over_directions<GrooveBatch<Real>::capacity>(i);
    };

namespace detail {

/// A sum.
inline constexpr auto plus = [](const auto& a, const auto& b) { return a + b; };

/// A product.
inline constexpr auto times = [](const auto& a, const auto& b) { return a * b; };

/// A value of the first components of a pack.
template <class Value, class Components>
VCAVITY_INLINE Value value_of(const Components& components) {
  if constexpr (Number<Value>)
    return components[0];
  else if constexpr (std::is_same_v<Value, Components>)
    return components;
  else
    return Value(components);
}

}  // namespace detail

/// The cosines of incidence at the bounces of the ways of one to four bounces, whether there is such a way or not: of the
/// first and of the last bounce, and of those between them.
///
/// With e_y towards the panel that is met first,
///
///     c_i = e_y cos (i − ½)α + e_z sin (i − ½)α,
///
/// and backwards the same of the direction in which the light leaves. So the first and the last cosine follow from those
/// of α/2, and c_2 = 2 cos α c_1 − c_0 from either end.
template <class Real>
class BounceRows {
 public:
  using Batch = GrooveBatch<Real>;
  using Lanes = typename Batch::Lanes;

  /// @param grooves what the batch is of
  /// @param first the batch of these ways
  VCAVITY_INLINE BounceRows(const ConnectingGrooves<Real>& grooves, const Batch& first) {
    const Vec3<Real>& e = grooves.to_light();
    const Vec3<Real>& o = grooves.leaving();
    const Lanes e_along = (e.y * Batch::sides()) * first.cos_half, e_up = e.z * first.sin_half;
    const Lanes o_along = (o.y * Batch::leaving_sides()) * first.cos_half, o_up = o.z * first.sin_half;
    const Lanes twice_cosine = Lanes(Real(2)) - Real(4) * (first.sin_half * first.sin_half);
    const Lanes from_first = e_along + e_up, from_last = o_along + o_up;
    const Lanes second = twice_cosine * from_first - (e_along - e_up);
    const Lanes last_but_one = twice_cosine * from_last - (o_along - o_up);
    first_ = in_range(from_first);
    last_ = in_range(from_last);
    // The ways of one and two bounces have none between: there is room for the third of those of four.
    between_ =
        in_range(Lanes::template blended<has(3)>(second, last_but_one.template rearranged<from_end>()));
  }

  /// The light that is left of each way.
  /// @param facet facet reflectance for the lanes
  /// @param white what goes each way for facets that reflect all light
  template <class Facet>
  VCAVITY_INLINE Lanes left_of(const Facet& facet, const Lanes& white) const {
    const Fraction<Lanes> first = fraction_of(facet, first_), last = fraction_of(facet, last_),
                          between = fraction_of(facet, between_);
    const Fraction<Lanes> third{between.numerator.template rearranged<to_end>(),
                                between.denominator.template rearranged<to_end>()};
    const Lanes above =
        (first.numerator * numerator<2>(last)) * (numerator<3>(between) * numerator<4>(third));
    const Lanes below = (first.denominator * last.denominator) * (between.denominator * third.denominator);
    return white * (above / below);
  }

 private:
  static constexpr std::array<std::size_t, Batch::capacity> from_end{4, 5, 6, 7, 0, 1, 2, 3},
      to_end{0, 1, 0, 1, 4, 5, 2, 3};

  /// Where ways have so many bounces.
  static constexpr std::array<bool, Batch::capacity> has(std::size_t bounces) {
    std::array<bool, Batch::capacity> result{};
    for (std::size_t lane = 0; lane < result.size(); ++lane) result[lane] = lane / 2 + 1 >= bounces;
    return result;
  }

  /// The numerator where ways have so many bounces; elsewhere the denominator, so that all is reflected.
  template <std::size_t bounces>
  VCAVITY_INLINE static Lanes numerator(const Fraction<Lanes>& reflectance) {
    return Lanes::template blended<has(bounces)>(reflectance.numerator, reflectance.denominator);
  }

  /// In [0, 1]: outside, a facet may be infinite, and 0 times that is no number. Cosines are there where there is no way,
  /// and next to the mirror direction, where rounding turns the grooves.
  VCAVITY_INLINE static Lanes in_range(const Lanes& cosine) {
    return at_most(at_least(cosine, Real(0)), Real(1));
  }

  Lanes first_, last_, between_;
};

/// Light that goes through several grooves, lane by lane.
/// @tparam components of the light
template <class Real, std::size_t components>
struct LightInLanes {
  using Lanes = typename GrooveBatch<Real>::Lanes;

  std::array<Lanes, components> light;  ///< each component
  Lanes white;                          ///< the same for facets that reflect all light

  /// All of it.
  template <class Value>
  VCAVITY_INLINE BsdfEvaluation<Real, Value> sum() const {
    std::array<Lanes, components + 1> all;
    for (std::size_t c = 0; c < components; ++c) all[c] = light[c];
    all[components] = white;
    const auto sums = detail::combined_lanes(detail::plus, all);
    return {detail::value_of<Value>(sums), sums[components]};
  }
};

/// The light of the ways of one to four bounces.
/// @param facet facet reflectance
/// @param grooves what the batch is of
/// @param first the batch of these ways
/// @param white what goes each way for facets that reflect all light
template <class Real, ComponentsOverDirections<Real> Facet>
VCAVITY_INLINE auto light_of_short_ways(const Facet& facet, const ConnectingGrooves<Real>& grooves,
                                        const GrooveBatch<Real>& first,
                                        const typename GrooveBatch<Real>::Lanes& white) {
  const BounceRows<Real> rows(grooves, first);
  LightInLanes<Real, number_count<value_t<Facet, Real>>> result;
  for (std::size_t c = 0; c < result.light.size(); ++c)
    result.light[c] = rows.left_of(facet.template over_directions<GrooveBatch<Real>::capacity>(c), white);
  result.white = white;
  return result;
}

/// Eight bounces of two ways side by side, in lanes that alternate between the ways.
template <class Real>
class PairBounces {
 public:
  using Batch = GrooveBatch<Real>;
  using Lanes = typename Batch::Lanes;
  static constexpr std::size_t bounces = Batch::capacity;
  using Two = Pack<Real, 2 * bounces>;

  /// The first eight.
  /// @param cos_eta cos η
  /// @param ways the ways
  VCAVITY_INLINE PairBounces(const Real& cos_eta, const WayPair<Real>& ways)
      : cos_eta_(cos_eta), elevation_(ways.elevation), number_(Two::load(of_bounces.data())) {
    const Real first = Real(ways.bounces), second = Real(ways.bounces + 2);
    ends_ = twice(alternating(first, ways.has_both ? second : Real(0)));
    aperture_ = twice(Lanes(ways.sweep) / alternating(first, second));
  }

  /// Goes on to the next eight.
  VCAVITY_INLINE void advance() { number_ = number_ + Two(Real(static_cast<int>(bounces))); }

  /// Where there is such a bounce.
  VCAVITY_INLINE auto exist() const { return ends_ > number_; }

  /// The cosines of incidence; any where there is no bounce.
  VCAVITY_INLINE Two cosines() const {
    return cos_eta_ *
           detail::acute_cosine(select(exist(), Two(elevation_) - aperture_ * number_, Two(Real(0))));
  }

  /// Numbers of the two ways in turn.
  VCAVITY_INLINE static Lanes alternating(const Real& first, const Real& second) {
    return select(Batch::sides() > Real(0), Lanes(first), Lanes(second));
  }

  /// The products of the reflectances of every fourth bounce, as far as there are any.
  /// @param facet facet reflectance for the lanes
  /// @param cosines those of the bounces
  template <class Facet>
  VCAVITY_INLINE Lanes reflected(const Facet& facet, const Two& cosines) const {
    const auto [numerator, denominator] = fraction_of(facet, cosines);
    return product(select(exist(), numerator, denominator)) / product(denominator);
  }

  /// The products over the bounces of each way, in lanes that alternate between the ways.
  /// @param four the products over every fourth bounce
  VCAVITY_INLINE static Lanes combined(const Lanes& four) {
    const Lanes two = four * four.template rearranged<by_four>();
    return two * two.template rearranged<by_two>();
  }

 private:
  static constexpr std::array of_bounces{0.5f, 0.5f, 1.5f, 1.5f, 2.5f, 2.5f, 3.5f, 3.5f,
                                         4.5f, 4.5f, 5.5f, 5.5f, 6.5f, 6.5f, 7.5f, 7.5f};
  static constexpr std::array<std::size_t, bounces> by_four{4, 5, 6, 7, 0, 1, 2, 3},
      by_two{2, 3, 0, 1, 6, 7, 4, 5};

  /// Of the first half and the second half.
  VCAVITY_INLINE static Lanes product(const Two& x) {
    return x.template slice<bounces>(0) * x.template slice<bounces>(1);
  }

  VCAVITY_INLINE static Two twice(const Lanes& x) { return Two(std::array{x, x}); }

  Real cos_eta_, elevation_;
  Two number_;  // of the bounce, less ½
  Two ends_;    // how many bounces there are
  Two aperture_;
};

/// Adds the light of two ways.
/// @param light what it is added to, in the first two lanes
/// @param facet facet reflectance
/// @param cos_eta cos η, the length of the direction of the light in the plane across the groove
/// @param ways the ways
/// @param white what goes each way for facets that reflect all light
template <class Real, ComponentsOverDirections<Real> Facet, std::size_t components>
VCAVITY_INLINE void add_pair(LightInLanes<Real, components>& light, const Facet& facet, const Real& cos_eta,
                             const WayPair<Real>& ways, const std::array<Real, 2>& white) {
  using Bounces = PairBounces<Real>;
  using Lanes = typename Bounces::Lanes;
  using Two = typename Bounces::Two;
  constexpr std::size_t width = 2 * Bounces::bounces;
  Bounces bounces(cos_eta, ways);
  std::array<Lanes, components> products;
  const Two cosines = bounces.cosines();
  for (std::size_t c = 0; c < components; ++c)
    products[c] = bounces.reflected(facet.template over_directions<width>(c), cosines);
  const int most = ways.bounces + (ways.has_both ? 2 : 0);
  for (int done = Bounces::bounces; done < most; done += static_cast<int>(Bounces::bounces)) {
    bounces.advance();
    const Two further = bounces.cosines();
    for (std::size_t c = 0; c < components; ++c)
      products[c] = products[c] * bounces.reflected(facet.template over_directions<width>(c), further);
  }
  const Lanes white_lanes = select(Lanes(Real(2)) > GrooveBatch<Real>::lane_numbers(),
                                   Bounces::alternating(white[0], white[1]), Lanes(Real(0)));
  for (std::size_t c = 0; c < components; ++c)
    light.light[c] = light.light[c] + white_lanes * Bounces::combined(products[c]);
  light.white = light.white + white_lanes;
}

}  // namespace vcavity
