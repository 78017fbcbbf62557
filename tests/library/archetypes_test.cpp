// SPDX-License-Identifier: BSD-3-Clause
/// The contract between groove and facet (facet/facet.hpp), checked by the compiler: types that have what its concepts
/// ask for and nothing else.

#include <array>
#include <complex>
#include <concepts>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

/// A value with what `FacetValue` and `FacetPower` ask for, and not even a constructor without arguments.
class BareValue {
 public:
  using value_type = double;

  explicit BareValue(int light) : amount_(light) {}

  friend BareValue operator*(const BareValue& a, const BareValue& b) {
    return BareValue(a.amount_ * b.amount_, Made());
  }
  friend BareValue operator+(const BareValue& a, const BareValue& b) {
    return BareValue(a.amount_ + b.amount_, Made());
  }
  friend BareValue operator*(double s, const BareValue& a) { return BareValue(s * a.amount_, Made()); }
  friend double largest(const BareValue& a) { return a.amount_; }

  static BareValue of(double amount) { return BareValue(amount, Made()); }

 private:
  struct Made {};
  BareValue(double amount, Made) : amount_(amount) {}

  double amount_;
};

/// The same with a constructor without arguments, for lists of lobes, and a limit, for absorptances.
struct ListedValue : BareValue {
  ListedValue() : BareValue(0) {}
  explicit ListedValue(int light) : BareValue(light) {}
  ListedValue(const BareValue& value) : BareValue(value) {}
  friend ListedValue operator*(const ListedValue& a, const ListedValue& b) {
    return static_cast<const BareValue&>(a) * static_cast<const BareValue&>(b);
  }
  friend ListedValue operator+(const ListedValue& a, const ListedValue& b) {
    return static_cast<const BareValue&>(a) + static_cast<const BareValue&>(b);
  }
  friend ListedValue operator*(double s, const ListedValue& a) {
    return s * static_cast<const BareValue&>(a);
  }
  friend ListedValue at_most(const ListedValue& a, double ceiling) {
    return BareValue::of(vcavity::at_most(largest(a), ceiling));
  }
};

double reflectance_at(double cosine) {
  return 0.9 - 0.4 * cosine;
}

/// Facets that can be called, and no more.
struct BareFacet {
  BareValue operator()(const double& cosine) const { return BareValue::of(reflectance_at(cosine)); }
};
struct BounceFacet {
  BareValue operator()(const Bounce<double>& bounce) const {
    return BareValue::of(reflectance_at(bounce.cosine));
  }
};
struct ListedFacet {
  ListedValue operator()(const double& cosine) const { return BareValue::of(reflectance_at(cosine)); }
};

/// A facet that tells all it may tell, each in the plainest way.
struct TellingFacet : ListedFacet {
  struct Parts {
    ListedValue s, p;
  };
  struct Fields {
    std::complex<double> r_s, r_p;
  };
  ListedValue absorptance(const double& cosine) const { return BareValue::of(1 - reflectance_at(cosine)); }
  Parts absorptances(const double& cosine) const { return {absorptance(cosine), absorptance(cosine)}; }
  Fields amplitudes(const double&) const { return {}; }
  double critical_cosine() const { return 0.5; }
  std::array<std::complex<double>, 1> singular_cosines() const { return {std::complex<double>(0.0, 2.0)}; }
  double contrast() const { return 1.25; }
  template <std::size_t>
  ListedFacet over_directions() const {
    return {};
  }
};

static_assert(FacetValue<BareValue> && FacetPower<BareValue>);
static_assert(!std::default_initializable<BareValue> && std::default_initializable<ListedValue>);
static_assert(FacetReflectance<BareFacet, double> && FacetReflectance<BounceFacet, double> &&
              FacetReflectance<ListedFacet, double>);

static_assert(AbsorbingFacet<TellingFacet, double> && !AbsorbingFacet<BareFacet, double>);
static_assert(FieldAbsorber<TellingFacet, double> && !FieldAbsorber<BareFacet, double>);
static_assert(FieldReflector<TellingFacet, double> && !FieldReflector<BareFacet, double>);
static_assert(CriticalFacet<TellingFacet, double> && !CriticalFacet<BareFacet, double>);
static_assert(SingularFacet<TellingFacet> && !SingularFacet<BareFacet>);
static_assert(ContrastingFacet<TellingFacet> && !ContrastingFacet<BareFacet>);
static_assert(OverDirections<TellingFacet> && !OverDirections<BareFacet>);

/// What cannot be multiplied is no value.
struct Unmultipliable {
  using value_type = double;
  explicit Unmultipliable(int) {}
  [[maybe_unused]] friend double largest(const Unmultipliable&) { return 0; }
};
static_assert(!FacetValue<Unmultipliable> && !FacetReflectance<int, double>);

}  // namespace

TEST_CASE("a value that can do no more than the contract asks for has the reflectances of a number") {
  const auto number = [](const double& cosine) { return reflectance_at(cosine); };
  for (const double aperture_deg : {150.0, 45.0, 2.0, 0.4}) {
    const Cavity<double> groove(radians(aperture_deg));
    const Vec3<double> e = direction(0.4, 0.3);
    CAPTURE(aperture_deg);
    const double expected = directional_reflectance(groove, e, number);
    CHECK(largest(directional_reflectance(groove, e, BareFacet())) == Approx(expected));
    CHECK(largest(directional_reflectance(groove, e, BounceFacet())) == Approx(expected));
    CHECK(largest(unpolarized_reflectance(groove, e, BareFacet())) == Approx(expected));
    CHECK(largest(directional_absorptance(groove, e, TellingFacet())) == Approx(1 - expected));
    CHECK(largest(ray_reflectance(groove, e, 0.2, BareFacet())) ==
          Approx(ray_reflectance(groove, e, 0.2, number)));
  }
}

TEST_CASE("with a constructor without arguments it has lobes too, and can be drawn by a renderer") {
  const Cavity<double> groove(radians(45.0));
  const Vec3<double> e = direction(0.4, 0.3);
  const double expected = largest(directional_reflectance(groove, e, ListedFacet()));
  double sum = 0;
  for (const auto& lobe : lobes(groove, e, ListedFacet())) sum += lobe.weight * largest(lobe.throughput);
  CHECK(sum == Approx(expected));
  const GrooveBsdf bsdf(groove, ListedFacet());
  CHECK(largest(bsdf.albedo(e)) == Approx(expected));
  REQUIRE(bsdf.sample(e, 0.5));
}
