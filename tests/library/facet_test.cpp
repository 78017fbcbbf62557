// SPDX-License-Identifier: BSD-3-Clause
/// The contract between groove and facet, checked with facets and a value that do no more than it asks for.

#include <array>
#include <complex>
#include <type_traits>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

/// A value that has what facet.hpp asks of values, and nothing else.
class BareValue {
 public:
  using value_type = double;
  explicit BareValue(int light) : x_(light) {}
  explicit BareValue(double x) : x_(x) {}
  double number() const { return x_; }
  friend BareValue operator*(const BareValue& a, const BareValue& b) { return BareValue(a.x_ * b.x_); }
  friend BareValue operator+(const BareValue& a, const BareValue& b) { return BareValue(a.x_ + b.x_); }
  friend BareValue operator*(double s, const BareValue& a) { return BareValue(s * a.x_); }
  friend double largest(const BareValue& a) { return a.x_; }

 private:
  double x_;
};

/// Facets that answer one question each.
struct OfCosine {
  BareValue operator()(double cosine) const { return BareValue(0.5 + 0.5 * cosine); }
};
struct OfBounce {
  BareValue operator()(const Bounce<double>& bounce) const { return BareValue(0.5 + 0.5 * bounce.cosine); }
};
struct SAndP {
  double s, p;
};
struct Field {
  std::complex<double> r_s, r_p;
};
struct Absorbing : OfCosine {
  BareValue absorptance(double cosine) const { return BareValue(0.5 - 0.5 * cosine); }
};
struct AbsorbingFields {
  SAndP absorptances(double) const { return {0.1, 0.2}; }
};
struct Reflecting {
  Field amplitudes(double) const { return {}; }
};
struct Critical {
  double critical_cosine() const { return 0.25; }
};
struct Singular {
  std::array<std::complex<double>, 1> singular_cosines() const { return {{{2, 3}}}; }
};
struct Contrasting {
  double contrast() const { return 1.25; }
};
struct Wide {
  template <std::size_t directions>
  auto over_directions() const {
    return [](const Pack<double, directions>& cosines) { return cosines; };
  }
};

static_assert(FacetValue<BareValue> && FacetPower<BareValue>);
static_assert(FacetReflectance<OfCosine, double> && FacetReflectance<OfBounce, double>);
static_assert(std::same_as<facet_argument_t<OfCosine, double>, double>);
static_assert(std::same_as<facet_argument_t<OfBounce, double>, Bounce<double>>);
static_assert(AbsorbingFacet<Absorbing, double> && !AbsorbingFacet<OfCosine, double>);
static_assert(FieldAbsorber<AbsorbingFields, double> && !FieldAbsorber<Absorbing, double>);
static_assert(FieldReflector<Reflecting, double> && !FieldReflector<OfCosine, double>);
static_assert(CriticalFacet<Critical, double> && !CriticalFacet<OfCosine, double>);
static_assert(SingularFacet<Singular> && !SingularFacet<OfCosine>);
static_assert(ContrastingFacet<Contrasting> && !ContrastingFacet<OfCosine>);
static_assert(OverDirections<Wide> && !OverDirections<OfCosine>);

/// What the facets of the library tell.
template <class Facet>
constexpr bool tells_all =
    AbsorbingFacet<Facet, double> && FieldAbsorber<Facet, double> && FieldReflector<Facet, double> &&
    CriticalFacet<Facet, double> && SingularFacet<Facet> && ContrastingFacet<Facet> && OverDirections<Facet>;
static_assert(tells_all<Conductor<double>> && tells_all<Dielectric<double>>);

/// Neither a value without a sum, nor a number that no cosine can become, makes a facet.
struct NoSum {
  explicit NoSum(int) {}
  using value_type = double;
  [[maybe_unused]] friend NoSum operator*(const NoSum& a, const NoSum&) { return a; }
  [[maybe_unused]] friend double largest(const NoSum&) { return 0; }
};
static_assert(FacetValue<NoSum> && !FacetPower<NoSum>);
static_assert(!FacetReflectance<decltype([](double) { return NoSum(1); }), double>);
static_assert(!FacetReflectance<int, double>);

}  // namespace

TEST_CASE("facets and values that do no more than the contract asks for are followed through the groove") {
  const Cavity<double> groove(radians(40.0));
  const Vec3<double> e = direction(0.4, 0.7);
  const double expected =
      directional_reflectance(groove, e, [](double cosine) { return 0.5 + 0.5 * cosine; });
  CHECK(directional_reflectance(groove, e, OfCosine()).number() == expected);
  CHECK(directional_reflectance(groove, e, OfBounce()).number() == expected);
  CHECK(critical_cosine_of<double>(Critical()) == 0.25);
  CHECK(critical_cosine_of<double>(OfCosine()) == 0);
  CHECK(singular_cosines_of(Singular()).size() == 1);
  CHECK(singular_cosines_of(OfCosine()).empty());
}

TEST_CASE("a bounce tells the components of the light in the frame of its panel, its panel and its number") {
  const Cavity<double> groove(radians(50.0));
  const Vec3<double> e = direction(0.3, 0.9);
  for (const auto& lobe : lobes(groove, e, [](double) { return 1.0; })) {
    int expected_number = 0;
    Panel expected_panel = lobe.first_panel;
    Vec3<double> towards_light = e;
    const auto check = [&](const Bounce<double>& bounce) {
      CHECK(bounce.number == ++expected_number);
      CHECK(bounce.panel == expected_panel);
      const Vec3<double> normal = groove.normal(bounce.panel), tangent = groove.tangent(bounce.panel);
      const auto dot = [&](const Vec3<double>& a) {
        return a.x * towards_light.x + a.y * towards_light.y + a.z * towards_light.z;
      };
      CHECK(bounce.cosine == Approx(dot(normal)).margin(1e-14));
      CHECK(bounce.tangent == Approx(dot(tangent)).margin(1e-14));
      CHECK(bounce.along == e.x);
      // The mirror turns the direction of travel; towards the light is the opposite.
      const double twice = 2 * dot(normal);
      towards_light = {towards_light.x - twice * normal.x, towards_light.y - twice * normal.y,
                       towards_light.z - twice * normal.z};
      expected_panel = opposite(expected_panel);
      return 1.0;
    };
    ray_reflectance(groove, e, RayPath{lobe.first_panel, lobe.bounces}, check);
    CHECK(expected_number == lobe.bounces);
  }
}

namespace {

/// The same as `PanelFacets`, ray by ray and with only numbers.
double by_rays(const Cavity<double>& groove, const Vec3<double>& e, const Conductor<double>& one,
               const Conductor<double>& two) {
  double sum = 0;
  for (const auto& lobe : lobes(groove, e, [](double) { return 1.0; })) {
    double throughput = lobe.weight;
    ray_reflectance(groove, e, RayPath{lobe.first_panel, lobe.bounces}, [&](const Bounce<double>& bounce) {
      throughput *= (bounce.panel == Panel::one ? one : two)(bounce.cosine);
      return 1.0;
    });
    sum += throughput;
  }
  return sum;
}

}  // namespace

TEST_CASE("each panel reflects by its own facet, in every model of polarisation") {
  const Conductor<double> silver(0.1249, 3.3391), glass(1.5, 0);
  const PanelFacets facets{silver, glass};
  for (const double aperture_deg : {25.0, 60.0, 130.0}) {
    const Cavity<double> groove(radians(aperture_deg));
    for (const double phi : {0.0, 0.8, 2.5, 3.1}) {
      const Vec3<double> e = direction(0.6, phi);
      CAPTURE(aperture_deg, phi);
      CHECK(directional_reflectance(groove, e, facets) ==
            Approx(by_rays(groove, e, silver, glass)).epsilon(1e-14));
      CHECK(directional_reflectance(groove, e, facets) + directional_absorptance(groove, e, facets) ==
            Approx(1).epsilon(1e-14));
      const auto fields = polarized(facets);
      CHECK(unpolarized(directional_reflectance(groove, e, fields)) +
                unpolarized(directional_absorptance(groove, e, fields)) ==
            Approx(1).epsilon(1e-14));
      const auto separate = separately_polarized(facets);
      CHECK(unpolarized(directional_reflectance(groove, e, separate)) +
                unpolarized(directional_absorptance(groove, e, separate)) ==
            Approx(1).epsilon(1e-14));
      // Two panels of one material are a groove of that material.
      const PanelFacets same{glass, glass};
      CHECK(directional_reflectance(groove, e, same) == directional_reflectance(groove, e, glass));
      CHECK(directional_reflectance(groove, e, polarized(same))(1, 0) ==
            directional_reflectance(groove, e, polarized(glass))(1, 0));
      // The mirror image of the groove and of the light.
      CHECK(directional_reflectance(groove, e, PanelFacets{glass, silver}) ==
            Approx(directional_reflectance(groove, Vec3<double>{e.x, -e.y, e.z}, facets)).epsilon(1e-14));
    }
  }
}

TEST_CASE("facets of two panels can be had for several directions at once") {
  const PanelFacets facets{Conductor<double>(0.1249, 3.3391), Conductor<double>(1.5, 0)};
  const Cavity<double> groove(radians(60.0));
  const Vec3<double> first = direction(0.3, 0.4), second = direction(1.1, 1.2);
  const Vec3<Pack<double, 2>> both{Pack<double, 2>({first.x, second.x}), Pack<double, 2>({first.y, second.y}),
                                   Pack<double, 2>({first.z, second.z})};
  const auto reflectances = directional_reflectance(groove, both, facets.over_directions<2>());
  CHECK(reflectances[0] == Approx(directional_reflectance(groove, first, facets)).epsilon(1e-15));
  CHECK(reflectances[1] == Approx(directional_reflectance(groove, second, facets)).epsilon(1e-15));
}
