// SPDX-License-Identifier: BSD-3-Clause
/// What a renderer calls for every path allocates nothing, from the first call on. This is a program of its own,
/// for the sake of its `operator new` and of the first call.

#include <atomic>
#include <cstdlib>
#include <new>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

namespace {
std::atomic<long> allocations{0};
}

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

using namespace vcavity;

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
