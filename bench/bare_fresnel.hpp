// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel's formula in a loop and nothing else, compiled for each instruction set with the flags of the map
/// kernel: what that kernel could reach if all the rest cost nothing.

#include <span>

#include "tools/materials/material.hpp"

namespace vcavity::bench {

/// Adds up the reflectances of a metal for all cosines and all indices: packs of cosines if there is one
/// index, packs of indices if there are more. Cosines beyond the last full pack are left out.
/// @return the sum, so that no evaluation can be left out
template <class Real>
using BareFresnel = Real (*)(std::span<const tools::RefractiveIndex> indices, std::span<const Real> cosines);

/// The loops for one of the instruction sets in `tools::kernels()`.
struct BareLoops {
  BareFresnel<double> in_double;
  BareFresnel<float> in_single;
};

extern const BareLoops bare_baseline, bare_avx2, bare_avx512;

}  // namespace vcavity::bench
