// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// How different two colours look.

#include "tools/colour/colour.hpp"

namespace vcavity::tools {

/// The CIEDE2000 difference of two colours, with the parametric factors k_L = k_C = k_H = 1; about 1 is just
/// visible.
///
/// Source: G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000 color-difference formula: Implementation notes,
/// supplementary test data, and mathematical observations", Color Res. Appl. 30(1), 21-30 (2005), eq. 2-22;
/// ISO/CIE 11664-6.
double delta_e_2000(const Lab& first, const Lab& second);

}  // namespace vcavity::tools
