// SPDX-License-Identifier: BSD-3-Clause
#include "tools/kernel/kernel.hpp"

#include <vector>

namespace vcavity::tools {

#define VCAVITY_DECLARE_KERNEL(name)       \
  void name##_in_double(const KernelJob&); \
  void name##_in_single(const KernelJob&);

VCAVITY_DECLARE_KERNEL(baseline)
#ifdef VCAVITY_X86_KERNELS
VCAVITY_DECLARE_KERNEL(avx2)
VCAVITY_DECLARE_KERNEL(avx512)
#endif

std::span<const Kernel> kernels() {
  static const std::vector<Kernel> available = [] {
    std::vector<Kernel> result{{"baseline", baseline_in_double, baseline_in_single}};
#ifdef VCAVITY_X86_KERNELS
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) result.push_back({"AVX2", avx2_in_double, avx2_in_single});
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      result.push_back({"AVX-512", avx512_in_double, avx512_in_single});
#endif
    return result;
  }();
  return available;
}

void run_kernel(const KernelJob& job, Precision precision) {
  const Kernel& kernel = kernels().back();
  (precision == Precision::single_precision ? kernel.in_single : kernel.in_double)(job);
}

}  // namespace vcavity::tools
