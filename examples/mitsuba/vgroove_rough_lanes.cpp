// SPDX-License-Identifier: BSD-3-Clause

/// Makes the rough surfaces of the vectorised variants of one backend of Dr.Jit, `VGROOVE_BACKEND`: LLVM or CUDA.

#include "vgroove_rough_lanes.hpp"
#include "make_rough_lanes.hpp"

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

using FloatLanes = drjit::DiffArray<JitBackend::VGROOVE_BACKEND, float>;
using WavelengthLanes = Spectrum<FloatLanes, 4>;

template BSDF<FloatLanes, Color<FloatLanes, 3>>* make_rough_lanes(
    const Properties&, const GrooveParameters<FloatLanes, Color<FloatLanes, 3>>&);
template BSDF<FloatLanes, WavelengthLanes>* make_rough_lanes(
    const Properties&, const GrooveParameters<FloatLanes, WavelengthLanes>&);
template BSDF<FloatLanes, MuellerMatrix<WavelengthLanes>>* make_rough_lanes(
    const Properties&, const GrooveParameters<FloatLanes, MuellerMatrix<WavelengthLanes>>&);

NAMESPACE_END(mitsuba)
