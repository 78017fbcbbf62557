// SPDX-License-Identifier: BSD-3-Clause
/// Bi-hemispherical reflectance: time and Fresnel evaluations against the tolerance.

#include "benchmarks.hpp"
#include "scenes.hpp"

namespace vcavity::bench {
namespace {

template <class Facet>
void add(const std::string& material, const std::string& aperture_deg, const std::string& tolerance,
         const Facet& facet) {
  benchmark::RegisterBenchmark(name_of("bihemispherical", material, aperture_deg, tolerance).c_str(),
                               [=, groove = Cavity<double>(radians(std::stod(aperture_deg))),
                                target = std::stod(tolerance)](benchmark::State& state) {
                                 long long evaluations = 0;
                                 for (auto _ : state) {
                                   auto integral = bihemispherical_reflectance(groove, facet, target);
                                   benchmark::DoNotOptimize(integral);
                                   evaluations = integral.evaluations;
                                 }
                                 state.counters["evaluations"] = static_cast<double>(evaluations);
                               });
}

template <class Facet>
void add_grooves(const std::string& material, const Facet& facet) {
  for (const char* aperture_deg : {"45", "60", "90", "120", "150"})
    for (const char* tolerance : {"1e-3", "1e-5", "1e-7", "1e-10", "1e-13"})
      add(material, aperture_deg, tolerance, facet);
}

}  // namespace

void add_bihemispherical_benchmarks() {
  add_grooves("silver", silver<double>());
  add_grooves("glass", glass<double>());
}

}  // namespace vcavity::bench
