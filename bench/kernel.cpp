// SPDX-License-Identifier: BSD-3-Clause
/// The kernel of maps for each instruction set that the processor has, beside Fresnel's formula alone.

#include "tools/kernel/kernel.hpp"

#include <stdexcept>

#include "bare_fresnel.hpp"
#include "benchmarks.hpp"
#include "scenes.hpp"
#include "tools/materials/catalogue.hpp"

namespace vcavity::bench {
namespace {

using namespace tools;

constexpr double aperture_deg = 60;

const BareLoops& bare_loops(std::string_view instruction_set) {
  if (instruction_set == "baseline") return bare_baseline;
#ifdef VCAVITY_X86_KERNELS
  if (instruction_set == "AVX2") return bare_avx2;
  if (instruction_set == "AVX-512") return bare_avx512;
#endif
  throw std::logic_error("no bare loop for " + std::string(instruction_set));
}

/// Both report the time for one Fresnel evaluation; the kernel's are those that its directions need.
template <class Real>
void add(const Kernel& kernel, void (*run)(const KernelJob&), BareFresnel<Real> bare,
         const std::vector<RefractiveIndex>& indices) {
  Directions directions;
  for (const Vec3<double>& e : map_directions<double>()) directions.push_back(e);
  const std::vector<Real> cosines =
      recorded_cosines(Cavity<Real>(radians(Real(aperture_deg))), map_directions<Real>(), silver<Real>());
  const auto name = [&](const char* group) {
    return name_of(group, std::string(kernel.instruction_set), type_name<Real>,
                   std::to_string(indices.size()));
  };
  const std::size_t evaluations = cosines.size() * indices.size();
  benchmark::RegisterBenchmark(name("bare").c_str(), [=](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(bare(indices, cosines));
    count_items(state, evaluations);
  });
  benchmark::RegisterBenchmark(name("kernel").c_str(), [=](benchmark::State& state) {
    std::vector<double> values(directions.size() * indices.size());
    const KernelJob job{radians(aperture_deg),
                        Quantity::reflectance,
                        Polarization::none,
                        all_bounces,
                        indices,
                        directions,
                        values};
    for (auto _ : state) {
      run(job);
      benchmark::ClobberMemory();
    }
    count_items(state, evaluations);
  });
}

}  // namespace

void add_kernel_benchmarks() {
  const Material silver_by_wavelength = load_material("Ag");
  std::vector<RefractiveIndex> spectrum;
  for (int nm = 400; nm <= 700; nm += 10) spectrum.push_back(silver_by_wavelength.at(nm));
  const std::vector<RefractiveIndex> one{silver_by_wavelength.at(550)};
  for (const Kernel& kernel : kernels())
    for (const auto& indices : {spectrum, one}) {
      const BareLoops& bare = bare_loops(kernel.instruction_set);
      add<double>(kernel, kernel.in_double, bare.in_double, indices);
      add<float>(kernel, kernel.in_single, bare.in_single, indices);
    }
}

}  // namespace vcavity::bench
