// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Absorptance where polarisation is followed exactly, to full relative precision also where R is close to 1.
///
/// Method. A bounce absorbs the part E† A E of a field E, with the matrix A = a_s I + (a_p − a_s) p̂ p̂ᵀ of the
/// facet's absorptances (p̂: polarization.hpp). After a first way of Jones matrix J and absorption A₁, a
/// second one absorbs A₁ + J† A₂ J in all: as in energy_balance.hpp a sum of what is not negative, in place
/// of the difference 1 − R.

#include <utility>

#include "vcavity/groove/reflectance.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/linear.hpp"
#include "vcavity/polarization/polarization.hpp"

namespace vcavity {

/// Absorbed power as a quadratic form of the field, E† A E, with the Hermitian matrix A; axes as for `Jones`.
template <class Value>
struct AbsorbedPower : Linear<AbsorbedPower<Value>, Value> {
  using value_type = scalar_t<Value>;

  Value aa, bb;
  Complex<Value> ab;

  AbsorbedPower() = default;
  AbsorbedPower(const Value& along_a, const Value& along_b, const Complex<Value>& mixed)
      : aa(along_a), bb(along_b), ab(mixed) {}

  /// 0: nothing. 1: all of the light.
  explicit AbsorbedPower(int light)
      : AbsorbedPower(light == 0 ? Value(0) : Value(1), light == 0 ? Value(0) : Value(1),
                      {Value(0), Value(0)}) {}

  /// All parts of an operation on powers; see `Linear`.
  template <class Operation, class... Powers>
  VCAVITY_INLINE static AbsorbedPower combine(const Operation& operation, const Powers&... powers) {
    return {Value(operation(powers.aa...)),
            Value(operation(powers.bb...)),
            {Value(operation(powers.ab.re...)), Value(operation(powers.ab.im...))}};
  }
};

/// The part of unpolarised light that is absorbed.
template <class Value>
Value unpolarized(const AbsorbedPower<Value>& absorbed) {
  return scalar_t<Value>(0.5) * (absorbed.aa + absorbed.bb);
}

/// What a way absorbs of light that comes there through another one: J† A J.
/// @param j of the first way
/// @param a of the second
template <class Value>
AbsorbedPower<Value> absorbed_behind(const Jones<Value>& j, const AbsorbedPower<Value>& a) {
  const Complex<Value> from_a_in_a = a.aa * j.aa + a.ab * j.ba, from_a_in_b = conj(a.ab) * j.aa + a.bb * j.ba;
  const Complex<Value> from_b_in_a = a.aa * j.ab + a.ab * j.bb, from_b_in_b = conj(a.ab) * j.ab + a.bb * j.bb;
  return {(conj(j.aa) * from_a_in_a + conj(j.ba) * from_a_in_b).re,
          (conj(j.ab) * from_b_in_a + conj(j.bb) * from_b_in_b).re,
          conj(j.aa) * from_b_in_a + conj(j.ba) * from_b_in_b};
}

/// What became of a field: the part that is reflected, and the power that was absorbed on the way.
template <class Value>
struct FieldBalance {
  using value_type = scalar_t<Value>;

  Jones<Value> field;
  AbsorbedPower<Value> absorbed;

  FieldBalance() = default;
  FieldBalance(const Jones<Value>& reflected, const AbsorbedPower<Value>& absorbed_power)
      : field(reflected), absorbed(absorbed_power) {}

  /// 1: all reflected. 0: no light at all.
  explicit FieldBalance(int light) : field(light), absorbed(0) {}

  friend FieldBalance operator*(const FieldBalance& first, const FieldBalance& second) {
    return {first.field * second.field, first.absorbed + absorbed_behind(first.field, second.absorbed)};
  }
  friend value_type largest(const FieldBalance& a) { return largest(a.field); }
  friend FieldBalance at_most(const FieldBalance& a, const value_type& ceiling) {
    return {at_most(a.field, ceiling), a.absorbed};
  }
};

/// Of the lobes of a direction it is the absorbed powers that add up here.
template <class Value>
AbsorbedPower<Value> power(const FieldBalance<Value>& balance) {
  return balance.absorbed;
}

/// A polarised facet that returns the balance of each bounce.
template <class Facet>
class FieldBalanced {
 public:
  explicit FieldBalanced(Polarized<Facet> facet) : facet_(std::move(facet)) {}

  /// The balance of a bounce, from the axes of the light that meets the panel to those of the light that
  /// leaves it.
  template <class Real>
  auto operator()(const Bounce<Real>& bounce) const {
    const auto [s, p] = facet_.facet().absorptances(bounce.cosine);
    const IncidencePlane<Real> plane(bounce);
    const auto part = [d = p - s](const Real& share) { return scaled(share, d); };
    using Value = decltype(part(plane.aa));
    return FieldBalance<Value>(facet_(bounce),
                               {s + part(plane.aa), s + part(plane.bb), {part(plane.ab), Value(0)}});
  }

 private:
  Polarized<Facet> facet_;
};

/// Directional absorptance with fields followed exactly; `unpolarized` of it is that of unpolarised light,
/// and by Kirchhoff's law the emissivity.
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light or the observer, e.z ≥ 0
/// @param facet a `polarized` facet with a member `absorptances`, such as `Conductor`
template <class Groove, class Facet, class Direction = Vec3<scalar_t<Groove>>>
  requires UnfoldableGroove<Groove, typename Direction::value_type>
auto directional_absorptance(const Groove& groove, const Direction& e, const Polarized<Facet>& facet) {
  return directional_reflectance(groove, e, FieldBalanced<Facet>(facet));
}

/// The same for a groove of two materials.
/// @param groove a `Cavity`, or another groove that can be unfolded
/// @param e direction towards the light or the observer, e.z ≥ 0
/// @param facets `polarized` facets with a member `absorptances`
template <class Groove, class One, class Two, class Direction = Vec3<scalar_t<Groove>>>
  requires UnfoldableGroove<Groove, typename Direction::value_type>
auto directional_absorptance(const Groove& groove, const Direction& e,
                             const PanelFacets<Polarized<One>, Polarized<Two>>& facets) {
  return directional_reflectance(groove, e,
                                 PanelFacets{FieldBalanced<One>(facets.one), FieldBalanced<Two>(facets.two)});
}

}  // namespace vcavity
