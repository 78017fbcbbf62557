// SPDX-License-Identifier: BSD-3-Clause
/// The same for rough and matte surfaces and for grooves of other shapes: no valid argument makes them perform an
/// invalid operation, divide by zero or overflow.

#include <cmath>
#include <limits>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "support/any_slopes.hpp"
#include "support/catch.hpp"
#include "support/hard_directions.hpp"
#include "traps/traps.hpp"

using namespace vcavity;
using vcavity::test::AnyEllipticSlopes;
using vcavity::test::AnyOtherSlopes;
using vcavity::test::hard_directions;
using vcavity::test::Sink;
using vcavity::test::Traps;
using vcavity::test::use_bsdf;

namespace {

/// Random numbers in [0, 1], both ends included.
template <class T>
std::vector<T> hard_numbers() {
  return {T(0), std::numeric_limits<T>::denorm_min(), T(0.3), T(1) - std::numeric_limits<T>::epsilon(), T(1)};
}

/// All that a renderer asks of a rough surface, for light and viewer from the hard directions.
template <class T, class Distribution, class Facet>
void use_rough(const Distribution& distribution, const Facet& facet, Sink<T>& sink) {
  const std::vector<Vec3<T>> directions = hard_directions<T>();
  const std::vector<T> numbers = hard_numbers<T>();
  for (const LongWays long_ways : {LongWays::lost, LongWays::without_loss}) {
    const RoughGrooveBsdf bsdf(distribution, facet, 6, long_ways);
    for (const Vec3<T>& wo : directions) {
      for (const Vec3<T>& wi : directions) {
        sink(bsdf.pdf(wo, wi));
        const auto both = bsdf.evaluate_with_pdf(wo, wi);
        sink(largest(unpolarized(both.value)));
        sink(largest(unpolarized(bsdf.evaluate_bounces(wo, wi, 2))));
        bsdf.for_each_part(wo, wi, Transport::importance,
                           [&](int, const auto& part) { sink(largest(unpolarized(part))); });
      }
      for (const T& u : numbers)
        for (const T& v : numbers)
          for (const T& w : numbers)
            if (const auto sample = bsdf.sample(wo, u, Vec2<T>(v, w))) {
              sink(largest(unpolarized(sample->weight)));
              sink(sample->probability);
              sink(largest(unpolarized(bsdf.evaluate(wo, sample->direction))));
            }
    }
  }
  for (const T& u : numbers)
    for (const T& v : numbers) {
      const Vec3<T> m = distribution.sample({u, v});
      sink(m);
      sink(distribution.density(m));
    }
  for (const Vec3<T>& m : directions) sink(distribution.density(m));
}

template <class T, class Distribution>
VCAVITY_NOINLINE void use_distribution(const Distribution& distribution, Sink<T>& sink) {
  const Traps traps;
  use_rough(distribution, Conductor<T>(T(0.1249), T(3.3391)), sink);
  use_rough(distribution, RationalFacet<T>(Conductor<T>(T(0.7), T(0))), sink);
  use_rough(distribution, polarized(Conductor<T>(T(1.5), T(0))), sink);
}

template <class T, class Distribution>
VCAVITY_NOINLINE void use_rough_albedo(const Distribution& distribution, Sink<T>& sink) {
  const Traps traps;
  const Conductor<T> silver(T(0.1249), T(3.3391));
  for (const Vec3<T>& e :
       {Vec3<T>(0, 0, 1), Vec3<T>(1, 0, 0), Vec3<T>(0, 1, 0), Vec3<T>(T(0.6), 0, T(0.8))}) {
    sink(directional_albedo(distribution, e, silver, T(0.1), 8).value);
    for_each_component(albedo_by_bounces<3>(distribution, e, silver, T(0.1)).value, sink);
  }
  sink(bihemispherical_reflectance(distribution, silver, T(0.1), 8).value);
  const RoughAlbedoTable<T> table(distribution, silver, T(0.3), 8);
  for (const Vec3<T>& e : hard_directions<T>()) sink(table(e));
}

template <class T>
std::vector<T> hard_apertures() {
  return {T(1e-3),
          T(0.5),
          std::nextafter(pi<T>() / T(3), T(0)),
          pi<T>() / T(2),
          std::nextafter(pi<T>() / T(2), T(4)),
          T(3),
          pi<T>()};
}

template <class T>
VCAVITY_NOINLINE void use_matte(const Cavity<T>& cavity, const T& one, const T& two, Sink<T>& sink) {
  const Traps traps;
  const LambertianCavity<T> matte(cavity, one, two);
  const LambertianGrooveBsdf<T> bsdf(matte);
  const InterreflectionKernel<T> kernel(cavity);
  sink(bihemispherical_reflectance(kernel, one));
  sink(bihemispherical_reflectance(kernel, one, two));
  const SpecularInterreflectionKernel<T> specular(cavity);
  sink(bihemispherical_reflectance(specular, one, T(1) - one));
  const std::vector<Vec3<T>> directions = hard_directions<T>();
  for (const Vec3<T>& wo : directions) {
    sink(matte.directional_reflectance(wo));
    sink(matte.directional_absorptance(wo));
    sink(matte.directional_error(wo));
    sink(bsdf.albedo(wo));
    for (const Vec3<T>& wi : directions) {
      sink(bsdf.evaluate(wo, wi));
      sink(bsdf.pdf(wo, wi));
    }
    for (const T& u : hard_numbers<T>())
      for (const T& v : hard_numbers<T>())
        if (const auto sample = bsdf.sample(wo, Vec2<T>(u, v))) {
          sink(sample->direction);
          sink(sample->weight);
          sink(sample->probability);
        }
  }
  for (const T& s : hard_numbers<T>())
    for (const Panel panel : {Panel::one, Panel::two}) sink(matte.radiosity(panel, s));
}

/// A groove of another shape.
template <class T, class Shape>
VCAVITY_NOINLINE void use_shape(const Shape& shape, Sink<T>& sink) {
  const Traps traps;
  for (const auto& [n, k] : {Vec2<T>(T(0.1249), T(3.3391)), Vec2<T>(T(0.7), T(0)), Vec2<T>(T(1), T(0))}) {
    const Conductor<T> facet(n, k);
    for (const Vec3<T>& e : hard_directions<T>()) {
      for (const auto& lobe : lobes(shape, e, facet)) {
        sink(lobe.weight);
        sink(lobe.throughput);
        sink(lobe.direction);
      }
      sink(directional_reflectance(shape, e, facet));
      sink(unpolarized_reflectance(shape, e, polarized(facet)));
      sink(unpolarized_reflectance(shape, e, separately_polarized(facet)));
      sink(directional_absorptance(shape, e, facet));
      sink(unpolarized(directional_absorptance(shape, e, polarized(facet))));
      sink(mean_bounces(shape, e));
      if constexpr (UnfoldableGroove<Shape, T>) {
        for (const LobeChoice choice : {LobeChoice::by_energy, LobeChoice::by_weight})
          for (const T& u : hard_numbers<T>()) {
            const GrooveBsdf bsdf(shape, facet, choice);
            use_bsdf(bsdf, e, sink, u);
            use_bsdf(SpreadGrooveBsdf(bsdf, T(0.01)), e, sink, u, Vec2<T>(u, T(1) - u));
          }
        for (const T& position : {T(-1), T(0), T(1)}) {
          const RayPath path = ray_path(shape, e, position);
          sink(ray_reflectance(shape, e, path, facet));
          sink(ray_exit_direction(shape, e, path));
        }
      }
    }
  }
}

}  // namespace

TEMPLATE_TEST_CASE("no rough surface runs into a trap", "", float, double) {
  using T = TestType;
  Sink<T> sink;
  const auto elliptic = [&](const auto& slopes) { use_distribution(AnyEllipticSlopes<T>(slopes), sink); };
  const auto other = [&](const auto& slopes) { use_distribution(AnyOtherSlopes<T>(slopes), sink); };
  for (const T& roughness : {T(1e-3), T(0.3), T(1)}) {
    elliptic(GgxSlopes<T>(roughness));
    elliptic(BeckmannSlopes<T>(roughness));
    for (const T& concentration : {T(0), T(3), T(1e6)})
      other(BrushedSlopes(BeckmannSlopes<T>(roughness), concentration));
  }
  elliptic(GgxSlopes<T>(T(0.05), T(0.8)));
  other(TabulatedSlopes<T>({{T(0.1), T(1)}, {T(0.3), T(0)}, {T(0.4), T(2)}, {T(20), T(0)}}));
  for (const T& share : {T(0), T(0.4), T(1)})
    other(MixedSlopes(GgxSlopes<T>(T(0.1)), BeckmannSlopes<T>(T(0.6)), share));
  CHECK(sink.count() > 100000);
}

// In float, whose range is the shortest: in others it takes minutes.
TEST_CASE("no albedo of a rough surface runs into a trap") {
  Sink<float> sink;
  use_rough_albedo(GgxSlopes<float>(0.3f), sink);
  use_rough_albedo(BrushedSlopes(BeckmannSlopes<float>(0.2f), 3.0f), sink);
  CHECK(sink.count() > 50);
}

TEMPLATE_TEST_CASE("no matte groove runs into a trap", "", float, double, long double) {
  using T = TestType;
  Sink<T> sink;
  for (const T& aperture : hard_apertures<T>()) {
    use_matte(Cavity<T>(aperture), T(0), T(0), sink);
    use_matte(Cavity<T>(aperture), T(0.5), T(0.5), sink);
    use_matte(Cavity<T>(aperture), T(1), T(1), sink);
    use_matte(Cavity<T>(aperture), T(0), T(1), sink);
    use_matte(Cavity<T>(aperture), T(0.9), T(0.2), sink);
  }
  CHECK(sink.count() > 10000);
}

template <class T>
VCAVITY_NOINLINE void use_matte_asymmetric(const AsymmetricGroove<T>& groove, const T& one, const T& two,
                                           Sink<T>& sink) {
  const Traps traps;
  const AsymmetricLambertianCavity<T> matte(groove, one, two);
  sink(matte.bihemispherical_reflectance());
  sink(matte.bihemispherical_error());
  const std::vector<Vec3<T>> directions = hard_directions<T>();
  for (const Vec3<T>& e : directions) {
    if (!(e.z >= T(0))) continue;
    sink(matte.directional_reflectance(e));
    sink(matte.directional_absorptance(e));
    sink(matte.directional_error(e));
    // Where both graze the BRDF is infinite.
    for (const Vec3<T>& viewer : directions)
      if (std::max(e.z, viewer.z) > T(1e-6)) {
        sink(matte.brdf(e, viewer));
        sink(matte.brdf_error(e, viewer));
      }
  }
  for (const T& s : hard_numbers<T>())
    for (const Panel panel : {Panel::one, Panel::two}) sink(matte.radiosity(panel, s));
}

TEMPLATE_TEST_CASE("no matte groove of unequal panels runs into a trap", "", float, double) {
  using T = TestType;
  Sink<T> sink;
  for (const T& one : {T(0.05), T(0.4), T(pi<T>() / T(2))})
    for (const T& two : {T(0.1), T(1.5)}) {
      const auto groove = AsymmetricGroove<T>::from_slopes(one, two);
      use_matte_asymmetric(groove, T(1), T(1), sink);
      use_matte_asymmetric(groove, T(0), T(1), sink);
      use_matte_asymmetric(groove, T(0.9), T(0.2), sink);
    }
  CHECK(sink.count() > 10000);
}

TEMPLATE_TEST_CASE("no groove of another shape runs into a trap", "", float, double) {
  using T = TestType;
  Sink<T> sink;
  const T right = pi<T>() / T(2);
  for (const T& one : {T(1e-3), T(0.4), T(1.2), right})
    for (const T& two : {T(1e-3), T(0.7), T(1.5)}) {
      const auto groove = AsymmetricGroove<T>::from_slopes(one, two);
      use_shape(groove, sink);
      use_shape(Land(groove, T(0.3)), sink);
      for (const T& floor : {T(0), T(1e-3), T(2)}) use_shape(TruncatedGroove<T>(one, two, floor), sink);
    }
  for (const T& floor : {T(1e-3), T(0.5), T(100)}) {
    use_shape(Trench<T>(floor), sink);
    use_shape(Land(Trench<T>(floor), T(0)), sink);
  }
  CHECK(sink.count() > 10000);
}
