// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Directional albedo of a rough surface: the part of the light of a direction that it reflects at all.
///
/// It is the mean of the directional reflectances of the grooves over their distribution (both facets of a groove
/// belong to it, so that no shadowing comes in),
///
///     ∫∫ R(e; α, ψ) q(α, ψ) dα dψ,
///
/// for which there is no closed form. Method: the random numbers that draw a groove are the variables of the integral,
/// the one of the azimuth outside. At a given azimuth the reflectance has kinks at known apertures only, where a
/// lobe appears or the opening is lit in another way; the range is cut there and integrated adaptively. With
/// u = sin²χ for the random number of the slope the integrand is smooth at both ends.
///
/// When not to use it: for every sample of a rendering. `RoughAlbedoTable` is for that.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/lobes.hpp"
#include "vcavity/groove/reflectance.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/rough/adaptive_gauss.hpp"
#include "vcavity/rough/mean_axes.hpp"
#include "vcavity/rough/mixed_slopes.hpp"
#include "vcavity/rough/slope_distribution.hpp"

namespace vcavity {

namespace detail {

/// The grooves of a distribution that have one azimuth, by their slope.
template <SlopeDistribution Distribution>
class GroovesOfAzimuth {
 public:
  using Real = scalar_t<Distribution>;

  /// @param u_azimuth the random number that decides the azimuth
  GroovesOfAzimuth(const Distribution& distribution, const Real& u_azimuth)
      : distribution_(distribution), u_azimuth_(u_azimuth) {
    using std::sqrt;
    const Vec3<Real> m = distribution.sample({Real(0.5), u_azimuth});
    const Real across = sqrt(m.x * m.x + m.y * m.y);
    y_axis_ = {m.x / across, m.y / across};
  }

  /// The unit vector across the grooves.
  const Vec2<Real>& across() const { return y_axis_; }

  /// A direction of the surface in the frame of the grooves.
  Vec3<Real> to_groove(const Vec3<Real>& v) const {
    return {v.x * y_axis_.y - v.y * y_axis_.x, v.x * y_axis_.x + v.y * y_axis_.y, v.z};
  }

  /// The aperture of the groove at χ, in (0, π]; it falls from π at 0.
  Real aperture(const Real& chi) const {
    using std::atan2;
    using std::sin;
    using std::sqrt;
    const Real sine = sin(chi);
    const Vec3<Real> m = distribution_.sample({at_most(Real(sine * sine), Real(1)), u_azimuth_});
    const Real half = atan2(at_least(m.z, least_cosine()), Real(sqrt(m.x * m.x + m.y * m.y)));
    return Real(2) * half;
  }

  /// Half of all binary digits: where an integral is cut beside a kink, its error is the square of what lies between.
  static constexpr int enough_for_kinks = std::numeric_limits<Real>::digits / 2 + 1;

  /// Where the aperture has fallen to a value: by halving, since the distribution tells no more.
  /// @param low, high χ between which to look
  /// @param digits so many binary ones
  Real chi(const Real& aperture_there, Real low, Real high,
           int digits = std::numeric_limits<Real>::digits) const {
    for (int digit = 0; digit < digits; ++digit) {
      const Real middle = (low + high) / Real(2);
      (aperture(middle) > aperture_there ? low : high) = middle;
    }
    return (low + high) / Real(2);
  }

 private:
  /// So small that no groove is narrower in earnest, but that the number of its bounces is one.
  static Real least_cosine() { return std::numeric_limits<Real>::epsilon(); }

  const Distribution& distribution_;
  Real u_azimuth_;
  Vec2<Real> y_axis_;
};

/// Calls `visit` with every distribution that a mixture is made of, and its share.
template <SlopeDistribution Distribution, class Visit>
void for_each_part(const Distribution& distribution, const scalar_t<Distribution>& share, Visit&& visit) {
  visit(distribution, share);
}

template <class First, class Second, class Visit>
void for_each_part(const MixedSlopes<First, Second>& mixture, const scalar_t<First>& share, Visit&& visit) {
  using Real = scalar_t<First>;
  if (mixture.share() > Real(0)) for_each_part(mixture.first(), share * mixture.share(), visit);
  if (mixture.share() < Real(1)) for_each_part(mixture.second(), share * (Real(1) - mixture.share()), visit);
}

/// The mean over the azimuths of a distribution.
/// @param tolerance absolute error to aim at
/// @param of_azimuth called with a distribution that is no mixture, the random number of the azimuth and a
///        tolerance; returns a `Quadrature`
template <class Value, SlopeDistribution Distribution, class OfAzimuth>
Quadrature<Value> mean_over_azimuths(const Distribution& distribution, const scalar_t<Value>& tolerance,
                                     const OfAzimuth& of_azimuth) {
  using Real = scalar_t<Distribution>;
  using Scalar = scalar_t<Value>;
  constexpr int halvings = 8;
  Quadrature<Value> sum{Value(0), Scalar(0), 0};
  for_each_part(distribution, Real(1), [&](const auto& part, const Real& share) {
    const auto shared = [&](const Real& u_azimuth) {
      auto mean = of_azimuth(part, u_azimuth, Scalar(tolerance / Scalar(2)));
      mean.value = scaled(share, mean.value);
      mean.error *= static_cast<Scalar>(share);
      return mean;
    };
    // Quarters: where light comes along an axis of the distribution, the grooves are alike on both sides of it.
    for (int quarter = 0; quarter < 4; ++quarter)
      sum = sum + integrate<Value>(shared, Real(quarter) / Real(4), Real(quarter + 1) / Real(4),
                                   tolerance / Scalar(8), halvings);
  });
  return sum;
}

/// Throws std::invalid_argument unless the tolerance of an integral is positive.
template <class Scalar>
void require_tolerance(const Scalar& tolerance, const char* integral) {
  if (tolerance > Scalar(0)) return;
  throw_invalid_argument("the tolerance of the ", integral, " must be positive, not ", tolerance);
}

/// The apertures at which the reflectance of a groove has a kink, in ascending order; those of more than 16 bounces are
/// small and not listed.
template <class Real>
class ApertureKinks {
 public:
  /// @param e direction towards the light in the frame of the grooves
  explicit ApertureKinks(const Vec3<Real>& e) {
    using std::abs;
    using std::atan2;
    const Real half_turn = pi<Real>();
    const Real from_normal = atan2(Real(abs(e.y)), e.z);  // |θ'|
    add(Real(2) * from_normal);
    for (int k = 1; k <= most_bounces; ++k) {
      const Real n = static_cast<Real>(k);
      add(half_turn / n);
      for (const Real& turn : {from_normal, Real(-from_normal)}) {
        add((half_turn + Real(2) * turn) / n);
        add((half_turn + turn) / (n - Real(0.5)));
      }
    }
    std::sort(angles_.begin(), angles_.begin() + static_cast<std::ptrdiff_t>(size_));
  }

  std::size_t size() const { return size_; }
  const Real& operator[](std::size_t i) const { return angles_[i]; }

 private:
  static constexpr int most_bounces = 16;

  void add(const Real& angle) {
    if (angle > Real(0) && angle < pi<Real>()) angles_[size_++] = angle;
  }

  std::array<Real, 5 * most_bounces + 1> angles_;
  std::size_t size_ = 0;
};

/// The mean over the grooves of one azimuth of what they make of light from one direction.
/// @param of_groove called with a `Cavity` and the direction in its frame; has kinks where lobes have them
template <class Value, class Distribution, class OfGroove>
Quadrature<Value> mean_over_slopes(const Distribution& distribution, const scalar_t<Distribution>& u_azimuth,
                                   const Vec3<scalar_t<Distribution>>& e, const scalar_t<Value>& tolerance,
                                   const OfGroove& of_groove) {
  using Real = scalar_t<Distribution>;
  using Scalar = scalar_t<Value>;
  using std::cos;
  using std::sin;
  const GroovesOfAzimuth<Distribution> grooves(distribution, u_azimuth);
  const Vec3<Real> direction = grooves.to_groove(e);
  const auto integrand = [&](const Real& chi) {
    const Real weight = Real(2) * Real(sin(chi)) * Real(cos(chi));  // du/dχ
    const Cavity<Real> groove(grooves.aperture(chi));
    return Quadrature<Value>{scaled(weight, of_groove(groove, direction)), Scalar(0), 1};
  };
  const ApertureKinks<Real> kinks(direction);
  const Real end = pi<Real>() / Real(2);
  const Real too_short = Real(64) * std::numeric_limits<Real>::epsilon();
  constexpr int halvings = 12;
  Quadrature<Value> sum{Value(0), Scalar(0), 0};
  Real low(0);
  for (std::size_t i = kinks.size() + 1; i-- > 0;) {
    const Real high = i > 0 ? grooves.chi(kinks[i - 1], low, end, grooves.enough_for_kinks) : end;
    if (high - low < too_short) continue;
    sum = sum + integrate<Value, 6>(integrand, low, high, tolerance * static_cast<Scalar>((high - low) / end),
                                    halvings);
    low = high;
  }
  return sum;
}

/// The mean reflectance of the grooves of one azimuth.
template <class Distribution, class Facet>
auto reflectance_of_azimuth(const Distribution& distribution, const scalar_t<Distribution>& u_azimuth,
                            const Vec3<scalar_t<Distribution>>& e, const Facet& facet,
                            const scalar_t<unpolarized_t<Facet, scalar_t<Distribution>>>& tolerance,
                            int max_bounces) {
  using Real = scalar_t<Distribution>;
  return mean_over_slopes<unpolarized_t<Facet, Real>>(
      distribution, u_azimuth, e, tolerance, [&](const Cavity<Real>& groove, const Vec3<Real>& direction) {
        return unpolarized_reflectance(groove, direction, facet, max_bounces);
      });
}

}  // namespace detail

/// Directional albedo, for unpolarised light.
///
/// @param distribution of the grooves
/// @param e unit vector towards the light, or towards a viewer in diffuse light; e.z ≥ 0
/// @param facet facet reflectance
/// @param tolerance absolute error to aim at, > 0
/// @param max_bounces light that needs more bounces is lost
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the albedo, an estimate of its error and the number of directional reflectances evaluated
template <SlopeDistribution Distribution, FacetReflectance<scalar_t<Distribution>> Facet>
Integral<unpolarized_t<Facet, scalar_t<Distribution>>> directional_albedo(
    const Distribution& distribution, const Vec3<scalar_t<Distribution>>& e, const Facet& facet,
    const scalar_t<unpolarized_t<Facet, scalar_t<Distribution>>>& tolerance, int max_bounces = all_bounces) {
  using Real = scalar_t<Distribution>;
  using Value = unpolarized_t<Facet, Real>;
  detail::require_tolerance(tolerance, "directional albedo");
  const auto sum = detail::mean_over_azimuths<Value>(
      distribution, tolerance,
      [&](const auto& part, const Real& u_azimuth, const scalar_t<Value>& inner_tolerance) {
        return detail::reflectance_of_azimuth(part, u_azimuth, e, facet, inner_tolerance, max_bounces);
      });
  return {sum.value, sum.error, sum.evaluations};
}

/// Directional albedo of polarised light: the Mueller matrix of all light of a direction that is reflected, whatever
/// direction it leaves in, each described in the axes of the mean surface (mean_axes.hpp). It is the integral of a
/// `RoughGrooveBsdf` of polarised facets over the directions of the leaving light.
///
/// The first row says what part of light of any polarisation is reflected; what is missing to 1, 0, 0, 0 is, by
/// Kirchhoff's law, the polarised emissivity towards `e`. The first column is how the reflected light is polarised on
/// average.
///
/// @param distribution of the grooves
/// @param e unit vector towards the light, e.z ≥ 0
/// @param facet polarised facet reflectance, such as `polarized(Conductor(…))`
/// @param tolerance absolute error to aim at, > 0, of every element; the axes turn fast where light leaves along the
///        mean normal, so that a tenth takes more time than for unpolarised light
/// @param max_bounces light that needs more bounces is lost
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the matrix, an estimate of the error of its elements and the number of directional reflectances evaluated
template <SlopeDistribution Distribution, FacetReflectance<scalar_t<Distribution>> Facet>
Integral<power_t<Facet, scalar_t<Distribution>>> polarized_albedo(
    const Distribution& distribution, const Vec3<scalar_t<Distribution>>& e, const Facet& facet,
    const scalar_t<power_t<Facet, scalar_t<Distribution>>>& tolerance, int max_bounces = all_bounces) {
  using Real = scalar_t<Distribution>;
  using Value = power_t<Facet, Real>;
  detail::require_tolerance(tolerance, "polarised albedo");
  const auto sum = detail::mean_over_azimuths<Value>(
      distribution, tolerance,
      [&](const auto& part, const Real& u_azimuth, const scalar_t<Value>& inner_tolerance) {
        const Vec2<Real> across = detail::GroovesOfAzimuth(part, u_azimuth).across();
        return detail::mean_over_slopes<Value>(
            part, u_azimuth, e, inner_tolerance,
            [&](const Cavity<Real>& groove, const Vec3<Real>& direction) {
              Value reflected(0);
              for (const auto& lobe : lobes(groove, direction, facet, max_bounces))
                reflected = reflected + in_mean_axes(scaled(lobe.weight, power(lobe.throughput)), direction,
                                                     lobe.direction, across);
              return reflected;
            });
      });
  return {sum.value, sum.error, sum.evaluations};
}

/// The directional albedo by the number of bounces: the part of the light of a direction that leaves after j
/// bounces in component j − 1, and after `components` bounces or more in the last one.
///
/// @param distribution of the grooves
/// @param e unit vector towards the light, e.z ≥ 0
/// @param facet facet reflectance of numbers
/// @param tolerance absolute error to aim at, > 0, of every component
/// @throws std::invalid_argument when the tolerance is not a positive number
template <std::size_t components, SlopeDistribution Distribution,
          FacetReflectance<scalar_t<Distribution>> Facet>
Integral<Pack<unpolarized_t<Facet, scalar_t<Distribution>>, components>> albedo_by_bounces(
    const Distribution& distribution, const Vec3<scalar_t<Distribution>>& e, const Facet& facet,
    const unpolarized_t<Facet, scalar_t<Distribution>>& tolerance) {
  using Real = scalar_t<Distribution>;
  using Value = Pack<unpolarized_t<Facet, Real>, components>;
  detail::require_tolerance(tolerance, "albedo by the number of bounces");
  const auto of_groove = [&](const Cavity<Real>& groove, const Vec3<Real>& direction) {
    Value parts(0);
    for (const auto& lobe : lobes(groove, direction, facet)) {
      const std::size_t bounces = static_cast<std::size_t>(lobe.bounces);
      parts[std::min(bounces, components) - 1] += lobe.weight * unpolarized(power(lobe.throughput));
    }
    return parts;
  };
  const auto sum = detail::mean_over_azimuths<Value>(
      distribution, tolerance,
      [&](const auto& part, const Real& u_azimuth, const scalar_t<Value>& inner_tolerance) {
        return detail::mean_over_slopes<Value>(part, u_azimuth, e, inner_tolerance, of_groove);
      });
  return {sum.value, sum.error, sum.evaluations};
}

}  // namespace vcavity
