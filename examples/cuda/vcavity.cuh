// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// vcavity in kernels for NVIDIA's GPUs, compiled by Clang.
///
/// The functions of vcavity bear no marks for a GPU. Clang gives those between its two pragmas to both processors, and
/// complains only where a kernel calls what a GPU does not have: memory that is allocated, for instance. So the standard
/// headers, which have functions of either processor already, come first.
///
/// When not to use it: with nvcc, which knows no such pragma.

#include <cstddef>

// What libstdc++ from 13 on calls where a precondition of a constant expression fails is a function of the processor. From 20
// on Clang brings one for GPUs.
#if defined(_GLIBCXX_RELEASE) && _GLIBCXX_RELEASE >= 13 && __clang_major__ < 20
namespace std {
__device__ inline void __glibcxx_assert_fail() {}
}  // namespace std
#endif

#include <cmath>
#include <new>
#include <type_traits>
#include <utility>

// Its deduction guides count as functions of the processor in Clang 19.
#pragma clang force_cuda_host_device begin
#include <array>
#pragma clang force_cuda_host_device end

#include <algorithm>
#include <bit>
#include <cassert>
#include <complex>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#pragma clang force_cuda_host_device begin
#include <vcavity/vcavity.hpp>
#pragma clang force_cuda_host_device end
