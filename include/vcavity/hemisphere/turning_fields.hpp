// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fields in narrow grooves: where the plane of incidence turns slowly, s and p light go on each on its own.
///
/// Method. From one bounce to the next the plane of incidence turns about the ray by
///
///     δ = α e_x/(e_x² + e_t²),
///
/// with the components e_x along the groove and e_t along the panel. In axes that turn with it, taken halfway between two
/// bounces, a bounce is R(δ/2) diag(r_p, r_s) R(δ/2) with the rotation R. It keeps a p field with a little of s, (1, β),
/// and an s field with a little of p, (β, 1):
///
///     β = ½ δ (r_p + r_s)/(r_p − r_s),
///
/// and multiplies them by r_p (1 − δ β) and r_s (1 + δ β): the other polarisation is one more way to lose light,
/// which adds up over thousands of bounces. As in the adiabatic theorem of quantum mechanics, the two fields go on as they
/// are while δ and the amplitudes change slowly. They are measured so that a bounce back and forth is symmetric, in units
/// of √(1 − β²); a field of one such unit carries the power (1 + |β|²)/|1 − β²|.
///
/// With the mixing a = δ max(|r_s|, |r_p|)/|r_p − r_s|, and the part b² of the light that has changed from one of these
/// fields to the other before, what neglects their interference and the change of δ is off by terms of a b and of a³.
///
/// When not to use it: near normal incidence, where the plane of incidence turns fast and r_s = r_p; and next to critical
/// angles, where the amplitudes change fast.

#include <cmath>
#include <cstddef>

#include "vcavity/facet/bounce.hpp"
#include "vcavity/hemisphere/plain_numbers.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/linear.hpp"
#include "vcavity/polarization/polarization.hpp"

namespace vcavity::detail {

/// Light by its polarisation at the first and at the last bounce.
template <class Value>
struct EndPolarizations : Linear<EndPolarizations<Value>, Value> {
  using value_type = scalar_t<Value>;

  Value ss, sp, ps, pp;

  EndPolarizations() = default;
  EndPolarizations(const Value& s_as_s, const Value& s_as_p, const Value& p_as_s, const Value& p_as_p)
      : ss(s_as_s), sp(s_as_p), ps(p_as_s), pp(p_as_p) {}
  explicit EndPolarizations(int light)
      : EndPolarizations(Value(value_type(light)), Value(value_type(light)), Value(value_type(light)),
                         Value(value_type(light))) {}

  friend EndPolarizations operator*(const EndPolarizations& a, const EndPolarizations& b) {
    return {a.ss * b.ss, a.sp * b.sp, a.ps * b.ps, a.pp * b.pp};
  }
  /// All parts of an operation; see `Linear`.
  template <class Operation, class... Lights>
  VCAVITY_INLINE static EndPolarizations combine(const Operation& operation, const Lights&... lights) {
    return {Value(operation(lights.ss...)), Value(operation(lights.sp...)), Value(operation(lights.ps...)),
            Value(operation(lights.pp...))};
  }
  /// All of the light.
  friend Value unpolarized(const EndPolarizations& light) {
    return (light.ss + light.pp) + (light.sp + light.ps);
  }
  friend value_type largest(const EndPolarizations& a) {
    return at_least(at_least(largest(a.ss), largest(a.sp)), at_least(largest(a.ps), largest(a.pp)));
  }
};

template <class Value>
struct PlainNumbers<EndPolarizations<Value>> {
  static constexpr std::size_t of_each = PlainNumbers<Value>::count;
  static constexpr std::size_t count = 4 * of_each;
  static auto& at(EndPolarizations<Value>& value, std::size_t i) {
    Value* const parts[] = {&value.ss, &value.sp, &value.ps, &value.pp};
    return PlainNumbers<Value>::at(*parts[i / of_each], i % of_each);
  }
};

/// A bounce of fields whose plane of incidence turns.
template <class Value>
struct TurningBounce {
  Value s, p;           ///< reflectances of the fields that it keeps
  Value mixing;         ///< a
  Complex<Value> beta;  ///< β
  Value unit;           ///< |1 − β²|, the square of the unit of these fields
  Value power;          ///< of a field of one unit
};

/// @param reflection of the bounce
/// @param bounce where
/// @param aperture of the groove
template <class Value, class Real>
TurningBounce<Value> turning_bounce(const Jones<Value>& reflection, const Bounce<Value>& bounce,
                                    const Real& aperture) {
  using std::sqrt;
  const Real smallest = smallest_divisor<Real>();
  // r_p + r_s and r_p − r_s from K = diag(1, −1) (r_s I + (r_p − r_s) p̂ p̂ᵀ)
  const IncidencePlane<Value> plane(bounce);
  const Complex<Value> sum = reflection.aa - reflection.bb;
  const Complex<Value> difference = Value(plane.aa - plane.bb) * (reflection.aa + reflection.bb) +
                                    Value(Real(4) * plane.ab) * reflection.ab;
  const Value s = Real(0.25) * norm(sum - difference), p = Real(0.25) * norm(sum + difference);
  const Value distance = at_least(Value(norm(difference)), smallest);
  const Value across = bounce.tangent * bounce.tangent + bounce.along * bounce.along;
  const Value turn = aperture * (bounce.along / at_least(across, smallest));
  const Value mixing = turn * sqrt(select(s >= p, s, p) / distance);
  // Where there is no slow turning there is no β either.
  constexpr Real largest_mixing = Real(0.5);
  const Value known_turn = select(mixing >= largest_mixing, Value(Real(0)), turn);
  const Complex<Value> beta = Value(Real(0.5) * (known_turn / distance)) * (sum * conj(difference));
  const Complex<Value> loss = known_turn * beta;
  const Complex<Value> one{Value(Real(1)), Value(Real(0))};
  const Value unit = sqrt(norm(one - beta * beta));
  return {
      s * norm(one + loss), p * norm(one - loss), mixing, beta, unit, (Value(Real(1)) + norm(beta)) / unit};
}

/// What measures the two fields that are kept: their parts of a field are E_a and E_b times these factors, added up.
template <class Value>
struct KeptFields {
  struct Factors {
    Complex<Value> a, b;
  };
  Factors s, p;

  /// @param turning, bounce half a step beyond the first or the last bounce
  /// @param last whether it is the last
  KeptFields(const TurningBounce<Value>& turning, const Bounce<Value>& bounce, bool last) {
    using std::sqrt;
    using Real = scalar_t<Value>;
    // Axes along and across the plane of incidence. From bounce to bounce they are mirrored (conventions.hpp), and
    // towards the first bounce they turn the other way.
    const Real side = Real((bounce.panel == Panel::one) != last ? 1 : -1);
    const Value p_a = bounce.along * bounce.cosine, p_b = bounce.tangent, none(Real(0));
    const Value scale =
        Value(Real(1)) / sqrt(at_least(Value(p_a * p_a + p_b * p_b), smallest_divisor<Real>()));
    const Complex<Value> cosine{p_a * scale, none}, sine{p_b * scale, none};
    const Complex<Value> beta = Value(Real(last ? -1 : 1)) * turning.beta;
    p = {cosine - beta * sine, Value(side) * (sine + beta * cosine)};
    s = {beta * cosine - sine, Value(side) * (cosine + beta * sine)};
  }
};

/// The light of a way by its polarisation at either end, in units of the fields that are kept there.
/// @param way from the first bounce to the last one
template <class Value>
EndPolarizations<Value> by_end_polarizations(const Jones<Value>& way, const KeptFields<Value>& first,
                                             const KeptFields<Value>& last) {
  using Factors = typename KeptFields<Value>::Factors;
  const auto light = [&way](const Factors& in, const Factors& out) {
    const Complex<Value> to_a = way.aa * in.a + way.ab * in.b, to_b = way.ba * in.a + way.bb * in.b;
    return Value(scalar_t<Value>(0.5) * norm(out.a * to_a + out.b * to_b));
  };
  return {light(first.s, last.s), light(first.s, last.p), light(first.p, last.s), light(first.p, last.p)};
}

}  // namespace vcavity::detail
