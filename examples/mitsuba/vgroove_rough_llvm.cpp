// SPDX-License-Identifier: BSD-3-Clause

/// Makes the rough surfaces of the vectorised variants that run on processors through LLVM.

#include "make_rough_lanes.hpp"
#include "vgroove_rough_lanes.hpp"

NAMESPACE_BEGIN(mitsuba)

template <typename Float, typename Spectrum>
BSDF<Float, Spectrum>* make_rough_lanes(const Properties& props,
                                        const GrooveParameters<Float, Spectrum>& parameters) {
  if (parameters.distribution == "ggx")
    return new VGrooveRoughLanes<Float, Spectrum, GgxLanes>(props, parameters);
  if (parameters.distribution == "beckmann")
    return new VGrooveRoughLanes<Float, Spectrum, BeckmannLanes>(props, parameters);
  return new VGrooveRoughLanes<Float, Spectrum, BrushedLanes>(props, parameters);
}

using LlvmFloat = drjit::DiffArray<JitBackend::LLVM, float>;
using LlvmWavelengths = Spectrum<LlvmFloat, 4>;

template BSDF<LlvmFloat, Color<LlvmFloat, 3>>* make_rough_lanes(
    const Properties&, const GrooveParameters<LlvmFloat, Color<LlvmFloat, 3>>&);
template BSDF<LlvmFloat, LlvmWavelengths>* make_rough_lanes(
    const Properties&, const GrooveParameters<LlvmFloat, LlvmWavelengths>&);
template BSDF<LlvmFloat, MuellerMatrix<LlvmWavelengths>>* make_rough_lanes(
    const Properties&, const GrooveParameters<LlvmFloat, MuellerMatrix<LlvmWavelengths>>&);

NAMESPACE_END(mitsuba)
