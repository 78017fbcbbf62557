// SPDX-License-Identifier: BSD-3-Clause
/// Directional reflectance of grooves of other shapes and of facets under films, beside the symmetric bare groove.

#include "benchmarks.hpp"
#include "scenes.hpp"

namespace vcavity::bench {
namespace {

/// Time for one direction of a map, one by one in double.
template <class Shape, class Facets>
void add(const std::string& shape, const Shape& groove, const Facets& facets) {
  const auto directions = map_directions<double>();
  benchmark::RegisterBenchmark(name_of("profile", shape).c_str(), [=](benchmark::State& state) {
    run_over(state, directions, directions.size(),
             [&](const Vec3<double>& e) { return unpolarized_reflectance(groove, e, facets); });
  });
}

/// The same for packs of directions.
template <class Groove, class Facet>
void add_packs(const std::string& shape, const Groove& groove, const Facet& facet) {
  constexpr std::size_t lanes = pack_lanes<double>;
  const auto directions = packed<lanes>(map_directions<double>());
  const auto wide = over_directions<lanes>(facet);
  benchmark::RegisterBenchmark(name_of("profile", shape).c_str(), [=](benchmark::State& state) {
    run_over(state, directions, directions.size() * lanes,
             [&](const auto& e) { return unpolarized_reflectance(groove, e, wide); });
  });
}

}  // namespace

void add_profile_benchmarks() {
  const Conductor<double> metal = silver<double>();
  const double aperture = radians(60.0);
  const Cavity<double> symmetric(aperture);
  const AsymmetricGroove<double> untilted(aperture, 0.0), tilted(aperture, radians(20.0));
  add("symmetric", symmetric, metal);
  add("unequal panels, tilt 0°", untilted, metal);
  add("unequal panels, tilt 20°", tilted, metal);
  add("unequal panels, tilt 20°, two materials", tilted, PanelFacets{metal, Conductor<double>(3.2, 3.3)});
  add("symmetric, land 0.2", Land(symmetric, 0.2), metal);
  add("floor 0.3", TruncatedGroove<double>(radians(60.0), radians(60.0), 0.3), metal);
  add("trench 0.5, land 0.2", Land(Trench<double>(0.5), 0.2), metal);

  const Film<double> oxide(2.4, 0, 0.12), glass(1.5, 0, 0.2);
  const Coated one(metal, oxide);
  const Coated two(metal, glass, oxide);
  add("symmetric, one film", symmetric, one);
  add("symmetric, two films", symmetric, two);
  add_packs("symmetric, packs", symmetric, metal);
  add_packs("symmetric, one film, packs", symmetric, one);
  add_packs("unequal panels, tilt 20°, packs", tilted, metal);
}

}  // namespace vcavity::bench
