// SPDX-License-Identifier: BSD-3-Clause
/// Fresnel's formula alone, at the cosines that a groove of 60° asks for: the yardstick of everything else.

#include "benchmarks.hpp"
#include "scenes.hpp"

namespace vcavity::bench {
namespace {

template <std::size_t lanes, class Real, class Facet>
void add(const std::string& material, const std::vector<Real>& cosines, const Facet& facet) {
  const auto inputs = packed<lanes>(cosines);
  const std::string name = name_of("fresnel", material, type_name<Real>, std::to_string(lanes));
  benchmark::RegisterBenchmark(name.c_str(),
                               [inputs, facets = over_directions<lanes>(facet)](benchmark::State& state) {
                                 run_over(state, inputs, inputs.size() * lanes, facets);
                               });
}

template <class Real, class Facet>
void add_pack_widths(const std::string& material, const Facet& facet) {
  const Cavity<Real> groove(radians(Real(60)));
  const std::vector<Real> cosines = recorded_cosines(groove, map_directions<Real>(), facet);
  add<1>(material, cosines, facet);
  add<native_lanes<Real>>(material, cosines, facet);
  add<pack_lanes<Real>>(material, cosines, facet);
}

}  // namespace

void add_fresnel_benchmarks() {
  add_pack_widths<double>("silver", silver<double>());
  add_pack_widths<double>("glass", glass<double>());
  add_pack_widths<float>("silver", silver<float>());
  add_pack_widths<float>("glass", glass<float>());
}

}  // namespace vcavity::bench
