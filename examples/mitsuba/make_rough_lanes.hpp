// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The rough surfaces of the vectorised variants, which are compiled apart from parallel grooves.

#include <mitsuba/render/bsdf.h>

#include "parameters.hpp"

NAMESPACE_BEGIN(mitsuba)

/// @param props of the plug-in
/// @param parameters with a distribution
/// @return a new BSDF
template <typename Float, typename Spectrum>
BSDF<Float, Spectrum>* make_rough_lanes(const Properties& props,
                                        const GrooveParameters<Float, Spectrum>& parameters);

NAMESPACE_END(mitsuba)
