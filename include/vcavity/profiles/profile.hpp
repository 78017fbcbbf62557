// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What every profile offers: lobes, directional reflectance and absorptance, mean number of bounces.
///
/// A profile is a surface made of equal grooves that are not only two panels: `TruncatedGroove`, `Trench`, and any
/// groove with `Land` between its rims. Each knows one thing, how to follow all light of a direction to where it leaves;
/// the functions here are made of that. The number of lobes has no constant bound where there is a floor, so they come
/// in a growing list.
///
/// When not to use it: for V-grooves without land; their own functions are faster, do not allocate and take packs of
/// directions.

#include <cstddef>
#include <limits>
#include <vector>

#include "vcavity/groove/reflectance.hpp"
#include "vcavity/profiles/face_facets.hpp"
#include "vcavity/profiles/face_path.hpp"

namespace vcavity {

/// A surface that follows light: `profile.follow(e, facets, visit)` calls visit(pencil, throughput) with every
/// `FacePencil` of the light of the direction e, and the product of the facet reflectances along its way; the weights add
/// up to 1. A fourth argument is the number of bounces beyond which light is left out.
template <class Shape>
concept Profile = Shape::is_profile;

/// The value of the facets of a profile.
template <class Facets, class Real>
using face_value_t = value_t<detail::any_facet_t<Facets>, Real>;

/// What adds up of it from one lobe to the next.
template <class Facets, class Real>
using face_power_t = power_t<detail::any_facet_t<Facets>, Real>;

/// Light that leaves a profile in one direction.
template <class Real, class Value>
struct ProfileLobe {
  FacePath path;         ///< the faces met
  Real weight;           ///< fraction of the light of the direction, (0, 1]
  Value throughput;      ///< product of the facet reflectances along the way
  Vec3<Real> direction;  ///< direction in which the light travels after its last bounce
};

/// The lobes of a direction, in the order in which they are found.
/// @param profile the profile
/// @param e direction towards the light, e.z ≥ 0
/// @param facets one facet reflectance, or `FaceFacets`
/// @param max_bounces lobes of more bounces are left out
/// @return lobes whose weights add up to 1 but for rounding; none is the rounding error of another
template <Profile Shape, class Facets>
auto lobes(const Shape& profile, const Vec3<typename Shape::value_type>& e, const Facets& facets,
           int max_bounces = all_bounces) {
  using Real = typename Shape::value_type;
  using Value = face_value_t<Facets, Real>;
  std::vector<ProfileLobe<Real, Value>> result;
  profile.follow(
      e, facets,
      [&](const FacePencil<Real>& light, const Value& throughput) {
        if (light.weight > negligible_fraction<Real>())
          result.push_back({light.path, light.weight, throughput, light.direction});
      },
      max_bounces);
  return result;
}

/// Directional reflectance of a profile.
/// @param profile the profile
/// @param e direction towards the light, or towards the viewer under diffuse light; e.z ≥ 0
/// @param facets one facet reflectance, or `FaceFacets`
/// @param max_bounces light that needs more bounces is left out
/// @return a value of the facets' type, or what its `power` makes of it
template <Profile Shape, class Facets>
auto directional_reflectance(const Shape& profile, const Vec3<typename Shape::value_type>& e,
                             const Facets& facets, int max_bounces = all_bounces) {
  using Real = typename Shape::value_type;
  using Value = face_value_t<Facets, Real>;
  face_power_t<Facets, Real> sum(0);
  profile.follow(
      e, facets,
      [&](const FacePencil<Real>& light, const Value& throughput) {
        sum = sum + scaled(light.weight, power(throughput));
      },
      max_bounces);
  return sum;
}

/// Directional reflectance of unpolarised light in any model of polarisation; parameters as above.
template <Profile Shape, class Facets>
auto unpolarized_reflectance(const Shape& profile, const Vec3<typename Shape::value_type>& e,
                             const Facets& facets, int max_bounces = all_bounces) {
  using Real = typename Shape::value_type;
  using Value = face_value_t<Facets, Real>;
  unpolarized_t<detail::any_facet_t<Facets>, Real> sum(0);
  profile.follow(
      e, facets,
      [&](const FacePencil<Real>& light, const Value& throughput) {
        sum = sum + scaled(light.weight, unpolarized(power(throughput)));
      },
      max_bounces);
  return sum;
}

namespace detail {

/// A facet that returns its energy balance, or that of its fields.
struct Balanced {
  template <class Facet>
  auto operator()(const Facet& facet) const {
    return EnergyBalanced<Facet>(facet);
  }
  template <class Facet>
  auto operator()(const Polarized<Facet>& facet) const {
    return FieldBalanced<Facet>(facet);
  }
};

template <class Value>
const Value& absorbed_part(const EnergyBalance<Value>& balance) {
  return balance.absorbed;
}
template <class Value>
const AbsorbedPower<Value>& absorbed_part(const AbsorbedPower<Value>& absorbed) {
  return absorbed;
}

}  // namespace detail

/// Directional absorptance of a profile, and by Kirchhoff's law its emissivity: a sum of positive terms that keeps its
/// digits where the reflectance is close to 1. Of `polarized` facets a quadratic form, `unpolarized` of which is the
/// absorptance of unpolarised light.
/// @param profile the profile
/// @param e direction towards the light or the observer, e.z ≥ 0
/// @param facets one facet that knows its absorptance, or `FaceFacets` of such
template <Profile Shape, class Facets>
auto directional_absorptance(const Shape& profile, const Vec3<typename Shape::value_type>& e,
                             const Facets& facets) {
  return detail::absorbed_part(
      directional_reflectance(profile, e, detail::each_facet(facets, detail::Balanced{})));
}

/// Mean number of bounces of the rays of a direction.
/// @param profile the profile
/// @param e direction towards the light, e.z ≥ 0
template <Profile Shape>
auto mean_bounces(const Shape& profile, const Vec3<typename Shape::value_type>& e) {
  using Real = typename Shape::value_type;
  Real mean(0);
  profile.follow(
      e, [](const Real&) { return Real(1); },
      [&](const FacePencil<Real>& light, const Real&) { mean += light.weight * Real(light.path.bounces()); });
  return mean;
}

/// The rays of a direction that the one through a point of the period belongs to. One on the border of two pencils
/// belongs to either.
/// @param profile the profile
/// @param e direction towards the light, e.z ≥ 0
/// @param position where the ray crosses the plane of the rims: a fraction of the period in [0, 1], from the rim of panel
///        one towards +y; land comes last
template <Profile Shape>
FacePencil<typename Shape::value_type> pencil_at(const Shape& profile,
                                                 const Vec3<typename Shape::value_type>& e,
                                                 const typename Shape::value_type& position) {
  using Real = typename Shape::value_type;
  FacePencil<Real> nearest{};
  Real least(2);
  profile.follow(
      e, [](const Real&) { return Real(1); },
      [&](const FacePencil<Real>& light, const Real&) {
        const Real outside = at_least(
            at_least(Real(light.start - position), Real(position - light.start - light.weight)), Real(0));
        if (light.weight > negligible_fraction<Real>() && outside < least) {
          least = outside;
          nearest = light;
        }
      });
  return nearest;
}

}  // namespace vcavity
