// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Bi-hemispherical reflectance of profiles: diffuse light in, all reflected light out.
///
/// Land adds its own flat reflectance. Where there is a floor the kinks of the weights are found by trial
/// (smooth_ranges.hpp), and the quadrature is adaptive (adaptive_hemisphere.hpp): reckon with 10⁵ to 10⁶ evaluations of
/// the facet for 1e-9.

#include <concepts>
#include <limits>
#include <type_traits>
#include <vector>

#include "vcavity/facet/panel_facets.hpp"
#include "vcavity/groove/asymmetric_groove.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/hemisphere/adaptive_hemisphere.hpp"
#include "vcavity/hemisphere/asymmetric_bihemispherical.hpp"
#include "vcavity/hemisphere/bihemispherical.hpp"
#include "vcavity/hemisphere/counted_facet.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/profiles/land.hpp"
#include "vcavity/profiles/profile.hpp"
#include "vcavity/profiles/smooth_ranges.hpp"

namespace vcavity {

namespace detail {

/// A facet that notes at which elevation ψ along the groove its bounces pass the critical angle.
template <class Real>
struct CriticalElevations {
  /// @param cosine of incidence at ψ = 0
  Real operator()(const Real& cosine) const {
    using std::acos;
    if (critical > Real(0) && cosine > critical) elevations->push_back(acos(critical / cosine));
    return Real(1);
  }

  Real critical;
  std::vector<Real>* elevations;
};

/// Bi-hemispherical reflectance of grooves with panels of their own materials. A symmetric one counts as one of no tilt,
/// for its own function takes it that light finds both panels alike.
template <class Groove, class One, class Two, class Scalar>
auto reflectance_of_panels(const Groove& groove, const PanelFacets<One, Two>& facets, const Scalar& tolerance,
                           int max_bounces) {
  using Real = scalar_t<Groove>;
  if constexpr (!std::same_as<Groove, Cavity<Real>>) {
    return bihemispherical_reflectance(groove, facets, tolerance, max_bounces);
  } else {
    // A plane, half of it of either material.
    if (!(pi<Real>() - groove.aperture() > Real(16) * std::numeric_limits<Real>::epsilon())) {
      const auto one = bihemispherical_reflectance(groove, facets.one, tolerance, max_bounces);
      const auto two = bihemispherical_reflectance(groove, facets.two, tolerance, max_bounces);
      using Result = std::remove_const_t<decltype(one)>;
      return Result{Scalar(0.5) * (one.value + two.value), (one.error + two.error) / Scalar(2),
                    one.evaluations + two.evaluations};
    }
    const AsymmetricGroove<Real> untilted(groove.aperture(), Real(0));
    return bihemispherical_reflectance(untilted, facets, tolerance, max_bounces);
  }
}

}  // namespace detail

/// Bi-hemispherical reflectance of a profile with a floor.
/// @param profile the profile
/// @param facets one facet reflectance, or `FaceFacets`
/// @param tolerance absolute error to aim at, > 0; the error estimate is larger where it cannot be reached
/// @param max_bounces light that needs more bounces is left out
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the reflectance of unpolarised light
template <Profile Shape, class Facets>
auto bihemispherical_reflectance(
    const Shape& profile, const Facets& facets,
    const scalar_t<unpolarized_t<detail::any_facet_t<Facets>, typename Shape::value_type>>& tolerance,
    int max_bounces = all_bounces) {
  using Real = typename Shape::value_type;
  using Value = unpolarized_t<detail::any_facet_t<Facets>, Real>;
  using Scalar = scalar_t<Value>;
  if (!(tolerance > Scalar(0))) {
    throw_invalid_argument("the tolerance of the bi-hemispherical reflectance must be positive, not ",
                           tolerance);
  }
  long long evaluations = 0;
  const auto counted = detail::each_facet(facets, [&](const auto& facet) {
    return CountedFacet<std::remove_cvref_t<decltype(facet)>>(facet, evaluations);
  });
  const auto reflectance = [&](const Vec3<Real>& e) {
    return unpolarized_reflectance(profile, e, counted, max_bounces);
  };
  const auto cuts = [&](const Vec3<Real>& e, std::vector<Real>& elevations) {
    const auto noting = detail::each_facet(facets, [&](const auto& facet) {
      return detail::CriticalElevations<Real>{critical_cosine_of<Real>(facet), &elevations};
    });
    profile.follow(e, noting, [](const FacePencil<Real>&, const Real&) {}, max_bounces);
  };
  const auto ranges = detail::smooth_ranges(profile, static_cast<Real>(tolerance));
  detail::AdaptiveHemisphere<Real, Value, decltype(reflectance), decltype(cuts)> quadrature(reflectance, cuts,
                                                                                            evaluations);
  Integral<Value> result = quadrature(ranges.ends, tolerance);
  // Light that meets one face more or less than it was counted with changes the reflectance by its flux at most.
  result.error = detail::at_most_all_light(Scalar(result.error + static_cast<Scalar>(ranges.overlooked)));
  return result;
}

/// Bi-hemispherical reflectance of grooves with land between them.
/// @param profile the profile
/// @param facets one facet reflectance, or `FaceFacets`
/// @param tolerance absolute error to aim at, > 0
/// @param max_bounces light that needs more bounces is left out
/// @throws std::invalid_argument when the tolerance is not a positive number
/// @return the reflectance of unpolarised light
template <class Groove, class Facets>
auto bihemispherical_reflectance(
    const Land<Groove>& profile, const Facets& facets,
    const scalar_t<unpolarized_t<detail::any_facet_t<Facets>, scalar_t<Groove>>>& tolerance,
    int max_bounces = all_bounces) {
  using Real = scalar_t<Groove>;
  using Value = unpolarized_t<detail::any_facet_t<Facets>, Real>;
  using Scalar = scalar_t<Value>;
  const auto sum = [&](const Integral<Value>& grooves) {
    if (!(profile.fraction() > Real(0))) return grooves;
    Integral<Value> flat;
    if constexpr (detail::is_face_facets<Facets>)
      flat = bihemispherical_reflectance(Cavity<Real>(pi<Real>()), facets.land, tolerance, max_bounces);
    else
      flat = bihemispherical_reflectance(Cavity<Real>(pi<Real>()), facets, tolerance, max_bounces);
    const Scalar land = static_cast<Scalar>(profile.fraction());
    const Scalar rest = Scalar(1) - land;
    return Integral<Value>{rest * grooves.value + land * flat.value, rest * grooves.error + land * flat.error,
                           grooves.evaluations + flat.evaluations};
  };
  if constexpr (Profile<Groove>)
    return sum(bihemispherical_reflectance(profile.groove(), facets, tolerance, max_bounces));
  else if constexpr (detail::is_face_facets<Facets>)
    return sum(detail::reflectance_of_panels(profile.groove(), PanelFacets{facets.one, facets.two}, tolerance,
                                             max_bounces));
  else
    return sum(bihemispherical_reflectance(profile.groove(), facets, tolerance, max_bounces));
}

}  // namespace vcavity
