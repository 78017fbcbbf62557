// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Light reflected by specular V-grooves, in closed form. The includes below are in reading order.

#include "version.hpp"
// What is where, and in which units.
#include "cavity.hpp"
#include "conventions.hpp"
// What a facet reflects: one bounce.
#include "complex.hpp"
#include "fresnel.hpp"
#include "pack.hpp"
#include "value.hpp"
// What the groove makes of it: one ray, one direction, the hemisphere.
#include "bihemispherical.hpp"
#include "bounces.hpp"
#include "energy_balance.hpp"
#include "lobes.hpp"
#include "quadrature.hpp"
#include "reflectance.hpp"
// What a renderer needs.
#include "bsdf.hpp"
#include "groove_frame.hpp"
#include "spread_bsdf.hpp"
#include "von_mises_fisher.hpp"
// Light as a transverse wave: the same with polarisation.
#include "absorbed_fields.hpp"
#include "itinerary.hpp"
#include "jones.hpp"
#include "mueller.hpp"
#include "polarization.hpp"
// What of all this a scene needs.
#include "planner.hpp"
// To look at it, and to compare with.
#include "paper_method.hpp"
#include "projection.hpp"
