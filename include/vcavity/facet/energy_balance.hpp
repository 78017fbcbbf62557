// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Reflected and absorbed light side by side, so that the absorptance 1 − R keeps its digits when R is close
/// to 1.
///
/// After a bounce that absorbs A₁ of the light and reflects R₁, a second one absorbs R₁ A₂ more: sums of
/// positive terms, never a difference of rounded numbers.

#include <concepts>
#include <type_traits>

#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/facet_wrapper.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/linear.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// What became of unit flux: `reflected + absorbed` = 1 up to rounding, or less where bounces were left out.
template <class Value>
struct EnergyBalance : Linear<EnergyBalance<Value>, Value> {
  using value_type = scalar_t<Value>;

  Value reflected;
  Value absorbed;

  EnergyBalance() = default;
  EnergyBalance(const Value& reflected_part, const Value& absorbed_part)
      : reflected(reflected_part), absorbed(absorbed_part) {}

  /// 1: all reflected. 0: no light at all.
  explicit EnergyBalance(int light) : reflected(light == 0 ? Value(0) : Value(1)), absorbed(Value(0)) {}

  /// The rounding of many bounces never adds up to more than all of the light.
  friend EnergyBalance operator*(const EnergyBalance& first, const EnergyBalance& second) {
    return {first.reflected * second.reflected,
            at_most(Value(first.absorbed + first.reflected * second.absorbed), value_type(1))};
  }
  /// Both parts of an operation on balances; see `Linear`.
  template <class Operation, class... Balances>
  VCAVITY_INLINE static EnergyBalance combine(const Operation& operation, const Balances&... balances) {
    return {Value(operation(balances.reflected...)), Value(operation(balances.absorbed...))};
  }
  friend value_type largest(const EnergyBalance& a) { return largest(a.reflected); }
};

/// Facet reflectance that returns the energy balance of each bounce.
template <class Facet>
class EnergyBalanced : public FacetWrapper<EnergyBalanced, Facet> {
 public:
  using FacetWrapper<EnergyBalanced, Facet>::FacetWrapper;
  using FacetWrapper<EnergyBalanced, Facet>::facet;

  /// @param bounce cosine of the angle of incidence in [0, 1], or a `Bounce`, whichever the facet asks for
  template <class Argument>
    requires std::invocable<const Facet&, const Argument&>
  auto operator()(const Argument& bounce) const {
    using Value = std::remove_cvref_t<std::invoke_result_t<const Facet&, const Argument&>>;
    return EnergyBalance<Value>(facet()(bounce), facet().absorptance(bounce));
  }
};

}  // namespace vcavity
