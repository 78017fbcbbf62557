// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// vcavity in kernels for NVIDIA's GPUs, compiled by Clang.
///
/// The functions of vcavity bear no marks for a GPU. Clang gives those between its two pragmas to both processors, and
/// complains only where a kernel calls what a GPU does not have: memory that is allocated, for instance. So the standard
/// headers, which have functions of either processor already, come first.
///
/// When not to use it: with nvcc, which knows no such pragma.

// Its deduction guides count as functions of the processor in Clang 19.
#pragma clang force_cuda_host_device begin
#include <array>
#pragma clang force_cuda_host_device end

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
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
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/detail/qualifier.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#pragma clang force_cuda_host_device begin
#include <vcavity/vcavity.hpp>
#pragma clang force_cuda_host_device end
