// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The BSDF of a rough surface for renderers that follow many paths in lockstep: the sums of rough_bsdf.hpp without a
/// branch on a direction.
///
/// Masks decide what counts, and the only loops are sums over whole numbers: over the ways that a pair of directions has,
/// so that all pairs are done when the one with the most ways is, and for each way over its bounces. How a sum is carried out is the renderer's business: a compiler of kernels has loops of its
/// own, of which it knows the derivative term by term. To be such a sum, the product T of the reflectances of a way is
/// the exponential of the sum of their logarithms, or of those of the products of four; what is reflected less than the smallest number counts as that.
///
/// The value is a smooth function of the roughness and the index at every pair of directions, with all
/// bounces. So directions may be drawn without derivatives, and the derivative of a picture is that of `value` divided by
/// a density that is kept as it is.
///
/// When not to use it: for directions that come one by one; `RoughGrooveBsdf` is faster, keeps T to rounding, and
/// follows polarisation.

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#include "vcavity/conventions.hpp"
#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/rough/connecting_grooves.hpp"
#include "vcavity/rough/drawn_ray.hpp"
#include "vcavity/rough/rough_bsdf.hpp"
#include "vcavity/rough/slope_distribution.hpp"
#include "vcavity/rough/way_series.hpp"

namespace vcavity {

/// Sums of numbers, by a loop of C++.
struct PlainSummation {
  /// @tparam Sums what the sums are made of
  /// @param first, end whole numbers n: those from `first` on and below `end` are summed over
  /// @param given what the terms depend on; nothing else that is computed with may be held by `terms`
  /// @param terms called with n, `given` and the sums so far, gives a tuple of terms; the sums so far may decide no
  ///        more than which terms count
  template <class... Sums, class Real, class Given, class Terms>
  static std::tuple<Sums...> over(const Real& first, const Real& end, const Given& given,
                                  const Terms& terms) {
    std::tuple<Sums...> sums{Sums(0)...};
    for (Real n = first; n < end; n += Real(1))
      sums = added(sums, terms(n, given, sums), std::index_sequence_for<Sums...>());
    return sums;
  }

  /// What derivatives take as given.
  template <class Value>
  static const Value& fixed(const Value& value) {
    return value;
  }

 private:
  template <class Sums, std::size_t... index>
  static Sums added(const Sums& a, const Sums& b, std::index_sequence<index...>) {
    return {std::get<index>(a) + std::get<index>(b)...};
  }
};

/// A rough surface as numbers, or arrays of them, from which distribution and facet are made where they are needed: it
/// has the member functions `slopes()`, the distribution, and `facet()`, the facet reflectance without polarisation.
template <class Surface>
concept RoughSurface =
    SlopeDistribution<std::remove_cvref_t<decltype(std::declval<const Surface&>().slopes())>> &&
    FacetReflectance<std::remove_cvref_t<decltype(std::declval<const Surface&>().facet())>,
                     scalar_t<std::remove_cvref_t<decltype(std::declval<const Surface&>().slopes())>>>;

/// What is drawn of a rough surface.
template <class Real>
struct RoughDraw {
  Vec3<Real> normal;   ///< of panel one of the groove
  DrawnRay<Real> ray;  ///< in that groove
};

/// @tparam Surface see above
/// @tparam Summation how sums are carried out, like `PlainSummation`
template <RoughSurface Surface, class Summation = PlainSummation>
class LockstepRoughBsdf {
 public:
  using Distribution = std::remove_cvref_t<decltype(std::declval<const Surface&>().slopes())>;
  using Facet = std::remove_cvref_t<decltype(std::declval<const Surface&>().facet())>;
  using Real = scalar_t<Distribution>;
  using Value = value_t<Facet, Real>;

  /// @param surface distribution and facet
  /// @param max_bounces light that needs more bounces is lost; in [1, RoughGrooveBsdf::highest_limit]
  LockstepRoughBsdf(Surface surface, int max_bounces)
      : surface_(std::move(surface)), max_bounces_(max_bounces) {}

  /// BSDF × cosine, and the density with which directions are drawn; 0 if either is below the horizon.
  /// @param wo, wi unit vectors away from the surface
  BsdfEvaluation<Real, Value> evaluate_with_pdf(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
    const ConnectingGrooves<Real> grooves(wo, wi);
    const Real first = first_density(grooves);
    const Given given = given_of(grooves, first);
    const auto terms = [](const Real& n, const Given& of, const std::tuple<Real, Value>& so_far) {
      const auto& [surface, all, counts, first_white] = of;
      const GrooveWays<Real> ways = all.way(counts, n);
      const Real white = counting_density(surface, all, ways, Real(first_white + std::get<0>(so_far)));
      return std::tuple<Real, Value>(Summation::fixed(white),
                                     scaled(white, throughput(surface, all.cos_eta, ways, white)));
    };
    const auto [white, light] =
        Summation::template over<Real, Value>(Real(0), std::get<2>(given).all, given, terms);
    const Value value = scaled(first, surface_.facet()(grooves.cosine_of_first())) + light;
    const auto is_above = is_above_horizon(wo, wi);
    return {select(is_above, value, Value(0)), select(is_above, Real(first + white), Real(0))};
  }

  /// The density alone.
  /// @param wo, wi unit vectors away from the surface
  Real pdf(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
    const ConnectingGrooves<Real> grooves(wo, wi);
    const Real first = first_density(grooves);
    const Given given = given_of(grooves, first);
    const auto terms = [](const Real& n, const Given& of, const std::tuple<Real>& so_far) {
      const auto& [surface, all, counts, first_white] = of;
      return std::tuple<Real>(Summation::fixed(
          counting_density(surface, all, all.way(counts, n), Real(first_white + std::get<0>(so_far)))));
    };
    const auto [white] = Summation::template over<Real>(Real(0), std::get<2>(given).all, given, terms);
    return select(is_above_horizon(wo, wi), Real(first + white), Real(0));
  }

  /// Draws a ray.
  /// @param wo unit vector away from the surface
  /// @param u_ray random number, uniform in [0, 1]: of the ray in the groove
  /// @param u_groove two random numbers, uniform in [0, 1]: of the groove
  /// @return as derivatives take it as given; its `ray.leaving()` is a sample of the density `pdf`, if it has no more bounces than the limit
  RoughDraw<Real> draw(const Vec3<Real>& wo, const Real& u_ray, const Vec2<Real>& u_groove) const {
    const Vec3<Real> normal = surface_.slopes().sample(u_groove);
    const Vec3<Real> m{Summation::fixed(normal.x), Summation::fixed(normal.y), Summation::fixed(normal.z)};
    return {m, DrawnRay<Real>(wo, m, u_ray)};
  }

  /// What a drawn way alone contributes: all there is where rounding of the direction has moved a narrow peak of the
  /// distribution away from it, so that `evaluate_with_pdf` finds nothing there.
  /// @param wo, wi unit vectors away from the surface
  /// @param drawn led from `wo` to `wi`
  /// @param where the mask of the directions for which this is wanted
  template <class Mask>
  BsdfEvaluation<Real, Value> evaluate_drawn(const Vec3<Real>& wo, const Vec3<Real>& wi,
                                             const RoughDraw<Real>& drawn, const Mask& where) const {
    const ConnectingGrooves<Real> grooves(wo, wi);
    const GrooveWays<Real> way = drawn.ray.way();
    const Real facets = surface_.slopes().density(drawn.normal);
    const ConnectingGroove<Real> first{Panel::one, 1, way.cos_half, way.sin_half, way.beam};
    const Real white = select(where,
                              select(way.bounces > Real(1), grooves.all_ways().densities(way, facets),
                                     grooves.density(first, facets)),
                              Real(0));
    return {scaled(white, throughput(surface_, grooves.cos_eta(), way, white)), white};
  }

  /// The bounce limit.
  int max_bounces() const { return max_bounces_; }

 private:
  /// What the ways of two and more bounces depend on, and how many there are; and the density of the one of a single
  /// bounce.
  using Given = std::tuple<Surface, AllWays<Real>, WayCounts<Real>, Real>;

  Given given_of(const ConnectingGrooves<Real>& grooves, const Real& first) const {
    const AllWays<Real> all = grooves.all_ways();
    return {surface_, all, all.counts(Real(max_bounces_)), first};
  }

  /// How many bounces follow one another without a loop, for one division and one logarithm.
  static constexpr int block_size = 4;

  static auto is_above_horizon(const Vec3<Real>& wo, const Vec3<Real>& wi) {
    return at_most(wo.z, wi.z) >= Real(0);
  }

  Real first_density(const ConnectingGrooves<Real>& grooves) const {
    const ConnectingGroove<Real> first = grooves.first();
    return grooves.density(first, surface_.slopes().density(grooves.normal(first)));
  }

  /// The density of a way; 0 where it is so small that the sum does not change.
  static Real counting_density(const Surface& surface, const AllWays<Real>& all, const GrooveWays<Real>& ways,
                               const Real& so_far) {
    const Real white = all.densities(ways, Real(surface.slopes().density(all.normals(ways))));
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    return select(white > Real(epsilon * epsilon * so_far), white, Real(0));
  }

  /// The product of the reflectances of all bounces of a way.
  /// @param white the light of the way; where there is none, no bounce is asked for
  static Value throughput(const Surface& surface, const Real& cos_eta, const GrooveWays<Real>& ways,
                          const Real& white) {
    using std::exp;
    using std::floor;
    using std::log;
    using Bounces = std::tuple<Surface, Real, Real, Real, Real>;
    const auto terms = [](const Real& block, const Bounces& bounces, const std::tuple<Value>&) {
      const auto& [of, eta, elevation, aperture, end] = bounces;
      const auto facet = of.facet();
      Fraction<Value> product{Value(1), Value(1)};
      for (int i = 0; i < block_size; ++i) {
        const Real number = Real(block_size) * block + Real(i);
        const auto exists = number < end;
        const Real angle = select(exists, Real(elevation - aperture * (number + Real(0.5))), Real(0));
        const Real cosine = at_least(Real(eta * detail::acute_cosine(angle)), Real(0));
        const auto [numerator, denominator] = fraction_of(facet, Value(cosine));
        product.numerator = product.numerator * select(exists, numerator, denominator);
        product.denominator = product.denominator * denominator;
      }
      const Value reflected = product.numerator / product.denominator;
      return std::tuple<Value>(log(at_least(reflected, smallest_divisor<scalar_t<Value>>())));
    };
    const Real end = select(white > Real(0), ways.bounces, Real(0));
    const Bounces bounces{surface, cos_eta, ways.elevation, Real(Real(2) * ways.half_aperture), end};
    const Real blocks = floor(Real((Real(1) / Real(block_size)) * (end + Real(block_size - 1))));
    const auto [logarithm] = Summation::template over<Value>(Real(0), blocks, bounces, terms);
    return exp(logarithm);
  }

  Surface surface_;
  int max_bounces_;
};

}  // namespace vcavity
