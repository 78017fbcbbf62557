// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Facets that keep track of polarisation. The model is a type: wrap a facet in one of these and pass it
/// where a facet reflectance is expected.
///
///  - A facet by itself reflects unpolarised light at every bounce, as in the paper (Eq. 17).
///  - `separately_polarized(facet)` follows s and p light on their own, ½(Π|r_s|² + Π|r_p|²), as if all
///    planes of incidence were parallel. Right only for light that travels across the groove.
///  - `polarized(facet)` follows the field: exact.

#include "vcavity/polarization/full.hpp"
#include "vcavity/polarization/separate.hpp"
