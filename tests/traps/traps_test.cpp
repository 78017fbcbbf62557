// SPDX-License-Identifier: BSD-3-Clause
/// With the traps of the processor armed, no valid argument makes the library perform an invalid operation,
/// divide by zero or overflow: any of these ends the process on the spot.
///
/// Underflow is no mistake here: the product of many small reflectances is 0.

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/hard_directions.hpp"
#include "traps/traps.hpp"

using namespace vcavity;
using vcavity::test::hard_directions;
using vcavity::test::Sink;
using vcavity::test::Traps;
using vcavity::test::use_bsdf;

namespace {

template <class T>
struct Index {
  T n, k;
};

/// Indices at the ends of their range, close to 1, transparent and opaque.
template <class T>
std::vector<Index<T>> hard_indices() {
  const T least = vcavity::detail::smallest_index<T>();
  const T most = vcavity::detail::largest_index<T>();
  const T epsilon = std::numeric_limits<T>::epsilon();
  std::vector<Index<T>> result;
  for (const T& n : {T(0), least, T(1e-3), T(0.05), T(0.7), T(1) - epsilon, T(1), T(1) + epsilon, T(1.0003),
                     T(1.5), T(100), most})
    for (const T& k : {T(0), std::numeric_limits<T>::denorm_min(), T(1e-8), T(1), T(100), most})
      if (n + k >= least && n + k <= most) result.push_back({n, k});
  return result;
}

template <class T>
std::vector<T> hard_cosines() {
  return {T(0),
          std::numeric_limits<T>::denorm_min(),
          std::numeric_limits<T>::min(),
          T(1e-9),
          T(0.3),
          T(1) / std::sqrt(T(3.25)),  // Brewster's angle of 1.5
          std::sqrt(T(0.51)),         // the critical angle of 0.7
          T(1) - std::numeric_limits<T>::epsilon(),
          T(1)};
}

template <class T>
std::vector<T> hard_apertures() {
  std::vector<T> result{T(1e-3), T(0.5), T(3)};
  for (int k = 1; k <= 5; ++k)
    for (const T& target : {T(0), T(4)}) result.push_back(std::nextafter(pi<T>() / T(k), target));
  result.push_back(pi<T>());
  return result;
}

template <class T>
VCAVITY_NOINLINE void use_facets(const std::vector<Index<T>>& indices, const std::vector<T>& cosines,
                                 Sink<T>& sink) {
  const Traps traps;
  const auto use = [&](const auto& facet, const T& c) {
    sink(facet(c));
    sink(facet.absorptance(c));
    sink(facet.amplitudes(c));
  };
  for (const Index<T>& index : indices)
    for (const T& c : cosines) {
      const bool has_contrast = index.n >= T(1e-3);  // else n − 1 rounds to −1
      const bool transparent = index.k == T(0) && index.n > T(0);
      use(Conductor<T>(index.n, index.k), c);
      if (has_contrast) use(Conductor<T>::from_contrast(index.n - T(1), index.k), c);
      if (transparent) use(Dielectric<T>(index.n), c);
      if (transparent && has_contrast) use(Dielectric<T>::from_contrast(index.n - T(1)), c);
    }
}

template <class T>
VCAVITY_NOINLINE void use_films(const std::vector<T>& cosines, Sink<T>& sink) {
  const Traps traps;
  // The ends of the ranges, epsilon-near-zero films, films that are not there.
  for (const T& n : {T(2e-4), T(1), T(1.5), T(5e3)})
    for (const T& k : {T(0), std::numeric_limits<T>::denorm_min(), T(1), T(5e3)})
      for (const T& thickness : {T(0), std::numeric_limits<T>::denorm_min(), T(0.1), T(1e6)}) {
        std::vector<Film<T>> films;
        for (int i = 0; i < 6; ++i) {
          films.emplace_back(n, k, thickness);
          films.emplace_back(T(1) / n, k, thickness);
        }
        for (const T& of_substrate : {T(2e-4), T(1), T(5e3)}) {
          const Coated facet(Conductor<T>(of_substrate, k), films);
          for (const T& c : cosines) {
            sink(facet(c));
            sink(facet.absorptance(c));
            sink(facet.amplitudes(c));
          }
        }
      }
}

template <class T>
VCAVITY_NOINLINE void use_groove(const Cavity<T>& cavity, const Vec3<T>& e, const Conductor<T>& facet,
                                 Sink<T>& sink) {
  const Traps traps;
  for (const auto& lobe : lobes(cavity, e, facet)) {
    sink(lobe.weight);
    sink(lobe.throughput);
    sink(lobe.direction);
  }
  sink(directional_reflectance(cavity, e, facet));
  sink(directional_absorptance(cavity, e, facet));
  sink(mean_bounces(cavity, e));
  for (const T& position : {T(-1), T(0), std::numeric_limits<T>::denorm_min(), T(1)}) {
    const RayPath path = ray_path(cavity, e, position);
    sink(ray_reflectance(cavity, e, path, facet));
    sink(ray_exit_direction(cavity, e, path));
  }
  for (const LobeChoice choice : {LobeChoice::by_energy, LobeChoice::by_weight}) {
    const GrooveBsdf bsdf(cavity, facet, choice);
    use_bsdf(bsdf, e, sink, T(0.5));
    use_bsdf(GrooveBsdf(cavity, polarized(facet), choice), e, sink, T(1));
    for (const T& width : {VonMisesFisher<T>::smallest_width(), T(0.01), T(10)})
      for (const T& u : {T(0), T(0.3), T(1)})
        use_bsdf(SpreadGrooveBsdf(bsdf, width), e, sink, u, Vec2<T>(u, u));
  }
  RecordedDirection<T> recorded(cavity, e);
  sink(recorded.reflectance(facet));
  sink(unpolarized(directional_absorptance(cavity, e, polarized(facet))));
  sink(unpolarized(directional_absorptance(cavity, e, separately_polarized(facet))));
  const PanelFacets panels{facet, Conductor<T>(T(1.5), T(0))};
  sink(directional_reflectance(cavity, e, panels));
  sink(directional_absorptance(cavity, e, panels));
  sink(paper_method::directional_reflectance(cavity, e, facet, 3));
  sink(polarization_axis(e));
  sink(Cavity<T>::from_normal(cavity.cos_half(), cavity.sin_half()).aperture());
  const GrooveFrame<T> frame(e, {T(1), T(0), T(0)});
  sink(frame.to_local(frame.to_world(e)));
  const auto mueller = directional_reflectance(cavity, e, polarized(facet));
  sink(unpolarized(mueller));
  sink(polarizance(mueller));
  sink(diattenuation(mueller));
  sink(diattenuation(directional_reflectance(cavity, e, separately_polarized(facet))));
  const Vec2<T> on_disc = project_to_disc(e);
  if (const auto back = direction_on_disc(on_disc)) sink(*back);
}

template <class T>
VCAVITY_NOINLINE void use_hemisphere(const Cavity<T>& cavity, const Conductor<T>& facet, Sink<T>& sink) {
  const Traps traps;
  sink(bihemispherical_reflectance(cavity, facet, T(1e-3)).value);
  sink(bihemispherical_reflectance(cavity, polarized(facet), T(1e-3)).value);
}

/// The signal that ends a process in which `operation` is done with traps armed; 0 if it survives.
template <class Operation>
int fatal_signal(const Operation& operation) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGFPE, SIG_DFL);
    const Traps traps;
    operation();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

TEMPLATE_TEST_CASE("the traps are real: they end a process that runs into one", "", float, double,
                   long double) {
  using T = TestType;
  volatile T zero = T(0), one = T(1), largest = std::numeric_limits<T>::max(), result = T(0);
  CHECK(fatal_signal([&] { result = zero / zero; }) == SIGFPE);
  CHECK(fatal_signal([&] { result = one / zero; }) == SIGFPE);
  CHECK(fatal_signal([&] { result = largest * largest; }) == SIGFPE);
  CHECK(fatal_signal([&] { result = one / largest; }) == 0);
}

TEMPLATE_TEST_CASE("no facet runs into a trap", "", float, double, long double) {
  using T = TestType;
  Sink<T> sink;
  use_facets(hard_indices<T>(), hard_cosines<T>(), sink);
  CHECK(sink.count() > 5000);
  use_films(hard_cosines<T>(), sink);
  CHECK(sink.count() > 10000);
}

TEMPLATE_TEST_CASE("no groove runs into a trap", "", float, double, long double) {
  using T = TestType;
  Sink<T> sink;
  const std::vector<Index<T>> indices{{T(0.1249), T(3.3391)}, {T(1.5), T(0)}, {T(0.7), T(0)}, {T(1), T(0)}};
  for (const T& aperture : hard_apertures<T>())
    for (const Vec3<T>& e : hard_directions<T>())
      for (const Index<T>& index : indices)
        use_groove(Cavity<T>(aperture), e, Conductor<T>(index.n, index.k), sink);
  CHECK(sink.count() > 10000);
}

TEMPLATE_TEST_CASE("no integral over the hemisphere runs into a trap", "", float, double, long double) {
  using T = TestType;
  Sink<T> sink;
  const std::vector<Index<T>> indices{{T(0.1249), T(3.3391)}, {T(0.7), T(0)}, {T(1), T(0)}};
  for (const T& aperture : {T(0.5), pi<T>() / T(2), pi<T>()})
    for (const Index<T>& index : indices)
      use_hemisphere(Cavity<T>(aperture), Conductor<T>(index.n, index.k), sink);
  CHECK(sink.count() == 18);
}
