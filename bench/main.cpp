// SPDX-License-Identifier: BSD-3-Clause
/// Benchmarks of the library and of vcavity_maps. `scripts/bench.sh` runs them and makes tables of the
/// results.

#include <vcavity/version.hpp>

#include "benchmarks.hpp"

int main(int argc, char** argv) {
  using namespace vcavity::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
#ifdef __clang__
  benchmark::AddCustomContext("compiler", __VERSION__);
#else
  benchmark::AddCustomContext("compiler", "GCC " __VERSION__);
#endif
  benchmark::AddCustomContext("vcavity", VCAVITY_VERSION);
  add_fresnel_benchmarks();
  add_reflectance_benchmarks();
  add_profile_benchmarks();
  add_bihemispherical_benchmarks();
  add_kernel_benchmarks();
  add_map_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
