// SPDX-License-Identifier: BSD-3-Clause
/// Results outlive the expressions that they are computed in.

#include <array>
#include <type_traits>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

template <class Value>
constexpr bool customisation_points_return_values =
    !std::is_reference_v<decltype(power(std::declval<const Value&>()))> &&
    !std::is_reference_v<decltype(unpolarized(power(std::declval<const Value&>())))> &&
    !std::is_reference_v<decltype(reversed(power(std::declval<const Value&>())))>;

static_assert(customisation_points_return_values<float>);
static_assert(customisation_points_return_values<glm::dvec3>);
static_assert(customisation_points_return_values<Pack<double, 8>>);
static_assert(customisation_points_return_values<EnergyBalance<double>>);
static_assert(customisation_points_return_values<SeparatePolarizations<double>>);
static_assert(customisation_points_return_values<Jones<double>>);
static_assert(customisation_points_return_values<FieldBalance<double>>);

// Members that are asked of temporaries.
static_assert(!std::is_reference_v<decltype(std::declval<Mueller<double>>()(0, 0))>);
static_assert(!std::is_reference_v<decltype(std::declval<Cavity<double>>().aperture())>);
static_assert(!std::is_reference_v<decltype(std::declval<Conductor<double>>().contrast())>);
static_assert(!std::is_reference_v<decltype(std::declval<Polarized<Conductor<double>>>().facet())>);
static_assert(!std::is_reference_v<decltype(std::declval<Lobes<double, double>>()[0])>);
static_assert(!std::is_reference_v<decltype(std::declval<VonMisesFisher<double>>().concentration())>);

/// Writes over what the functions called before have left on the stack.
VCAVITY_NOINLINE double overwrite_stack() {
  volatile double numbers[512];
  for (volatile double& x : numbers) x = -1;
  return numbers[17];
}

template <class Facet>
void check_reference(const Cavity<double>& groove, const Vec3<double>& e, const Facet& facet) {
  const auto expected = unpolarized_reflectance(groove, e, facet);
  const auto& kept = unpolarized(directional_reflectance(groove, e, facet));
  const auto& back = unpolarized(reversed(directional_reflectance(groove, e, facet)));
  const auto& added = unpolarized(power(lobes(groove, e, facet)[0].throughput));
  CHECK(overwrite_stack() == -1);
  CHECK(kept == expected);
  CHECK(back == expected);
  CHECK(added > 0);
}

}  // namespace

TEST_CASE("references to the reflectance of an expression stay valid") {
  const Cavity<double> groove(radians(50.0));
  const Vec3<double> e = direction(0.5, 0.4);
  const Conductor<double> silver(0.1249, 3.3391);
  check_reference(groove, e, silver);
  check_reference(groove, e, separately_polarized(silver));
  const auto& kept = directional_reflectance(groove, e, polarized(silver))(0, 0);
  const auto& aperture = Cavity<double>(1.0).aperture();
  const auto& facet = polarized(silver).facet();
  CHECK(overwrite_stack() == -1);
  CHECK(kept == unpolarized_reflectance(groove, e, polarized(silver)));
  CHECK(aperture == 1.0);
  CHECK(facet(0.5) == silver(0.5));
}
