// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Included before all else where Clang compiles the plug-in for a wheel that GCC has compiled, as those for Linux are.
///
/// For Clang, Dr.Jit's arrays bear an attribute that GCC does not know, `trivial_abi`: calls hand them over in registers. In
/// calls into such a wheel either side would look for them where they are not.

#include <drjit/array.h>

#undef DRJIT_TRIVIAL_ABI
#define DRJIT_TRIVIAL_ABI
