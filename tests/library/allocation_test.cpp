// SPDX-License-Identifier: BSD-3-Clause
/// What a renderer calls for every path allocates nothing, from the first call on. This is a program of its own,
/// for the sake of its `operator new` and of the first call.

#include <atomic>
#include <cstdlib>
#include <new>
#include <vcavity/vcavity.hpp>

#include "support/any_slopes.hpp"
#include "support/catch.hpp"

namespace {
std::atomic<long> allocations{0};
}

VCAVITY_NOINLINE void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
VCAVITY_NOINLINE void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
VCAVITY_NOINLINE void operator delete(void* memory) noexcept {
  std::free(memory);
}
VCAVITY_NOINLINE void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

using namespace vcavity;
using vcavity::test::AnyEllipticSlopes;
using vcavity::test::AnyOtherSlopes;

namespace {

/// The sum of what a BSDF answers, so that no call can be left out.
template <class Bsdf, class Real, class... Random>
Real use(const Bsdf& bsdf, const Vec3<Real>& wo, const Random&... random) {
  Real sum = largest(unpolarized(bsdf.albedo(wo)));
  for (const Transport transport : {Transport::radiance, Transport::importance})
    if (const auto sample = bsdf.sample(wo, random..., transport))
      sum += largest(unpolarized(sample->weight)) + sample->probability + bsdf.pdf(wo, sample->direction) +
             largest(unpolarized(bsdf.evaluate(wo, sample->direction)));
  return sum;
}

/// The allocations of all calls for a facet, counted after its objects are built.
template <class Real, class Facet>
long allocations_of(const Facet& facet) {
  long count = 0;
  for (const Real aperture_deg : {Real(0.05), Real(0.3), Real(0.8), Real(5), Real(60), Real(180)}) {
    const Cavity<Real> groove(radians(aperture_deg));
    for (const LobeChoice choice : {LobeChoice::by_energy, LobeChoice::by_weight}) {
      const GrooveBsdf bsdf(groove, facet, choice);
      const SpreadGrooveBsdf spread(bsdf, Real(0.02));
      volatile Real kept = 0;
      const long before = allocations;
      for (const Real theta : {Real(0), Real(0.02), Real(0.7), Real(1.5)}) {
        const Vec3<Real> wo = direction(theta, Real(0.3));
        kept = kept + use(bsdf, wo, Real(0.4)) + use(spread, wo, Real(0.4), Vec2<Real>(Real(0.3), Real(0.6)));
        kept = kept + largest(unpolarized(directional_reflectance(groove, wo, facet)));
        kept = kept + mean_bounces(groove, wo);
        kept = kept + largest(unpolarized(ray_reflectance(groove, wo, Real(0.5), facet)));
      }
      count += allocations - before;
    }
  }
  return count;
}

/// The allocations of all calls for a rough surface.
template <class Distribution, class Facet>
long allocations_of_rough(const Distribution& distribution, const Facet& facet) {
  using Real = scalar_t<Distribution>;
  const RoughGrooveBsdf bsdf(distribution, facet);
  volatile Real kept = 0;
  const long before = allocations;
  for (const Real theta : {Real(0), Real(0.7), Real(1.5)}) {
    const Vec3<Real> wo = direction(theta, Real(0.3));
    for (const Real u : {Real(0), Real(0.4), Real(1)})
      if (const auto sample = bsdf.sample(wo, u, Vec2<Real>(Real(0.3), u)))
        kept = kept + largest(unpolarized(sample->weight)) + bsdf.pdf(wo, sample->direction) +
               largest(unpolarized(bsdf.evaluate(wo, sample->direction))) +
               largest(unpolarized(bsdf.evaluate_bounces(wo, sample->direction, 2)));
  }
  return allocations - before;
}

/// The allocations of the reflectances of a groove of another shape.
template <class Shape, class Facet>
long allocations_of_shape(const Shape& shape, const Facet& facet) {
  using Real = typename Shape::value_type;
  volatile Real kept = 0;
  const long before = allocations;
  for (const Real theta : {Real(0), Real(0.7), Real(1.5)}) {
    const Vec3<Real> e = direction(theta, Real(0.3));
    kept = kept + largest(unpolarized(directional_reflectance(shape, e, facet))) +
           largest(unpolarized_reflectance(shape, e, facet)) + mean_bounces(shape, e);
    if constexpr (UnfoldableGroove<Shape, Real>)
      kept = kept + use(GrooveBsdf(shape, facet), e, Real(0.4)) +
             use(SpreadGrooveBsdf(GrooveBsdf(shape, facet), Real(0.02)), e, Real(0.4),
                 Vec2<Real>(Real(0.3), Real(0.6)));
  }
  return allocations - before;
}

}  // namespace

TEST_CASE("the counter counts") {
  // Through a volatile pointer, as compilers may leave out a pair of new and delete that nobody sees.
  const long before = allocations;
  void* volatile kept = ::operator new(1000);
  const long after = allocations;
  ::operator delete(kept);
  CHECK(after == before + 1);
}

TEMPLATE_TEST_CASE("no call for a path allocates, from the first on", "", float, double) {
  using Real = TestType;
  const Conductor<Real> silver(Real(0.1249), Real(3.3391));
  CHECK(allocations_of<Real>(silver) == 0);
  CHECK(allocations_of<Real>(Dielectric<Real>(Real(1.5))) == 0);
  CHECK(allocations_of<Real>(EnergyBalanced<Conductor<Real>>(silver)) == 0);
  CHECK(allocations_of<Real>(separately_polarized(silver)) == 0);
  CHECK(allocations_of<Real>(polarized(silver)) == 0);
  CHECK(allocations_of<Real>(PanelFacets{silver, Conductor<Real>(Real(1.5), Real(0))}) == 0);
  using Colour = Vec3<Real>;
  CHECK(allocations_of<Real>(Conductor<Colour>(Colour(Real(0.3)), Colour(Real(3)))) == 0);
  using Spectrum = Pack<Real, 8>;
  CHECK(allocations_of<Real>(Conductor<Spectrum>(Spectrum(Real(0.3)), Spectrum(Real(3)))) == 0);
}

TEMPLATE_TEST_CASE("no call for a path that meets a film allocates", "", float, double) {
  using Real = TestType;
  const Conductor<Real> silver(Real(0.1249), Real(3.3391));
  const Film<Real> film(Real(1.5), Real(0), Real(0.4));
  CHECK(allocations_of<Real>(Coated(silver, film)) == 0);
  CHECK(allocations_of<Real>(polarized(Coated(silver, film, film))) == 0);
}

TEMPLATE_TEST_CASE("no call for a path on a rough surface allocates", "", float, double) {
  using Real = TestType;
  const Conductor<Real> silver(Real(0.1249), Real(3.3391));
  const GgxSlopes<Real> ggx(Real(0.3));
  const BeckmannSlopes<Real> beckmann(Real(0.1), Real(0.4));
  const TabulatedSlopes<Real> table({{Real(0.3), Real(1)}, {Real(2), Real(0)}});
  using Elliptic = AnyEllipticSlopes<Real>;
  using Other = AnyOtherSlopes<Real>;
  const auto of = [&](const auto& facet) {
    return allocations_of_rough(Elliptic(ggx), facet) + allocations_of_rough(Elliptic(beckmann), facet) +
           allocations_of_rough(Other(table), facet) +
           allocations_of_rough(Other(BrushedSlopes(BeckmannSlopes<Real>(Real(0.2)), Real(5))), facet) +
           allocations_of_rough(Other(MixedSlopes(ggx, beckmann, Real(0.4))), facet);
  };
  CHECK(of(silver) == 0);
  CHECK(of(RationalFacet<Real>(silver)) == 0);
  CHECK(of(polarized(silver)) == 0);
  using Spectrum = Pack<Real, 8>;
  CHECK(of(Conductor<Spectrum>(Spectrum(Real(0.3)), Spectrum(Real(3)))) == 0);
  const RoughAlbedoTable<Real> albedo(ggx, silver, Real(1e-2), 8);
  volatile Real kept = 0;
  const long before = allocations;
  kept = kept + albedo(direction(Real(0.7), Real(0.3)));
  CHECK(allocations == before);
}

TEMPLATE_TEST_CASE("no call for a path on a matte groove allocates", "", float, double) {
  using Real = TestType;
  const LambertianGrooveBsdf<Real> bsdf(
      LambertianCavity<Real>(Cavity<Real>(radians(Real(40))), Real(0.8), Real(0.3)));
  volatile Real kept = 0;
  const long before = allocations;
  for (const Real theta : {Real(0), Real(0.2), Real(0.7), Real(1.5)}) {
    const Vec3<Real> wo = direction(theta, Real(0.3));
    kept = kept + bsdf.albedo(wo);
    if (const auto sample = bsdf.sample(wo, Vec2<Real>(Real(0.1), Real(0.6))))
      kept = kept + sample->weight + bsdf.pdf(wo, sample->direction) + bsdf.evaluate(wo, sample->direction);
  }
  CHECK(allocations == before);
}

TEMPLATE_TEST_CASE("no reflectance of a matte groove of unequal panels allocates", "", float, double) {
  using Real = TestType;
  const AsymmetricLambertianCavity<Real> matte(AsymmetricGroove<Real>::from_slopes(Real(0.3), Real(1.2)),
                                               Real(0.8), Real(0.3));
  volatile Real kept = 0;
  const long before = allocations;
  for (const Real theta : {Real(0), Real(0.2), Real(0.7), Real(1.5)}) {
    const Vec3<Real> e = direction(theta, Real(0.3));
    kept = kept + matte.directional_reflectance(e) + matte.directional_absorptance(e) +
           matte.directional_error(e);
    kept = kept + matte.radiosity(Panel::one, Real(0.5));
  }
  kept = kept + matte.bihemispherical_reflectance();
  CHECK(allocations == before);
}

TEMPLATE_TEST_CASE("no reflectance of a groove of another shape allocates", "", float, double) {
  using Real = TestType;
  const Conductor<Real> silver(Real(0.1249), Real(3.3391));
  const AsymmetricGroove<Real> blazed = AsymmetricGroove<Real>::from_slopes(Real(0.3), Real(1.2));
  CHECK(allocations_of_shape(blazed, silver) == 0);
  CHECK(allocations_of_shape(blazed, polarized(silver)) == 0);
  CHECK(allocations_of_shape(Land(blazed, Real(0.2)), silver) == 0);
  CHECK(allocations_of_shape(TruncatedGroove<Real>(Real(0.3), Real(1.2), Real(0.5)), silver) == 0);
  CHECK(allocations_of_shape(Trench<Real>(Real(0.5)), polarized(silver)) == 0);
}
