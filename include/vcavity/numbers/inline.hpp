// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks the small functions of the innermost loops.
///
/// All that a direction needs, Fresnel's formula included, is meant to become one loop whose numbers stay in
/// registers. By themselves compilers do that in small programs only: in large ones they stop at a limit, and
/// calls and memory then take as much time again.
#define VCAVITY_INLINE [[gnu::always_inline]] inline
