// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Light reflected by specular V-grooves, in closed form. The includes below are in reading order, a room after the
/// other; the headers of a room use only those of the rooms before it.

// clang-format off: the order is that of reading.
// Whatever macros the headers of a system have left.
#include "vcavity/numbers/hide_macros.hpp"
#include "vcavity/version.hpp"
// numbers/ knows no light: what the library computes with.
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/complex.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/per_component.hpp"
#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/small_differences.hpp"
#include "vcavity/numbers/linear_system.hpp"
#include "vcavity/numbers/gauss_legendre.hpp"
#include "vcavity/numbers/legendre_series.hpp"
#include "vcavity/numbers/sine_substitution.hpp"
#include "vcavity/numbers/adaptive_quadrature.hpp"
#include "vcavity/numbers/progression_sum.hpp"
// What is where, and in which units.
#include "vcavity/conventions.hpp"
// facet/: one bounce.
#include "vcavity/facet/bounce.hpp"
#include "vcavity/facet/facet.hpp"
#include "vcavity/facet/interface.hpp"
#include "vcavity/facet/fresnel.hpp"
#include "vcavity/facet/coated.hpp"
#include "vcavity/facet/energy_balance.hpp"
#include "vcavity/facet/panel_facets.hpp"
// groove/: what the groove makes of it, for one ray and for one direction.
#include "vcavity/groove/cavity.hpp"
#include "vcavity/groove/unfolding.hpp"
#include "vcavity/groove/ray.hpp"
#include "vcavity/groove/lit_opening.hpp"
#include "vcavity/groove/narrow_groove.hpp"
#include "vcavity/groove/lobes.hpp"
#include "vcavity/groove/reflectance.hpp"
#include "vcavity/groove/recorded_direction.hpp"
#include "vcavity/groove/asymmetric_groove.hpp"
// polarization/: light as a transverse wave.
#include "vcavity/polarization/jones.hpp"
#include "vcavity/polarization/mueller.hpp"
#include "vcavity/polarization/polarization.hpp"
#include "vcavity/polarization/absorbed_fields.hpp"
// hemisphere/: light from everywhere.
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/hemisphere/kinks.hpp"
#include "vcavity/hemisphere/long_series.hpp"
#include "vcavity/hemisphere/bounce_series.hpp"
#include "vcavity/hemisphere/facet_singularities.hpp"
#include "vcavity/hemisphere/cavity_integrand.hpp"
#include "vcavity/hemisphere/counted_facet.hpp"
#include "vcavity/hemisphere/hemisphere_quadrature.hpp"
#include "vcavity/hemisphere/bihemispherical.hpp"
#include "vcavity/hemisphere/paper_method.hpp"
#include "vcavity/hemisphere/adaptive_hemisphere.hpp"
#include "vcavity/hemisphere/asymmetric_bihemispherical.hpp"
// profiles/: grooves with more faces than two panels.
#include "vcavity/profiles/face_path.hpp"
#include "vcavity/profiles/face_facets.hpp"
#include "vcavity/profiles/profile.hpp"
#include "vcavity/profiles/truncated_groove.hpp"
#include "vcavity/profiles/trench.hpp"
#include "vcavity/profiles/land.hpp"
#include "vcavity/profiles/smooth_ranges.hpp"
#include "vcavity/profiles/bihemispherical.hpp"
#include "vcavity/profiles/rounding.hpp"
// matte/: panels that reflect by Lambert's law.
#include "vcavity/matte/interreflection_kernel.hpp"
#include "vcavity/matte/panel_exchange.hpp"
#include "vcavity/matte/lambertian_cavity.hpp"
#include "vcavity/matte/lambertian_specular.hpp"
// render/: what a renderer needs.
#include "vcavity/render/groove_frame.hpp"
#include "vcavity/render/bsdf.hpp"
#include "vcavity/render/von_mises_fisher.hpp"
#include "vcavity/render/spread_bsdf.hpp"
#include "vcavity/render/lambertian_bsdf.hpp"
#include "vcavity/render/projection.hpp"
// rough/: distributions of grooves.
#include "vcavity/rough/slope_distribution.hpp"
#include "vcavity/rough/elliptic_slopes.hpp"
#include "vcavity/rough/axial_von_mises.hpp"
#include "vcavity/rough/brushed_slopes.hpp"
#include "vcavity/rough/tabulated_slopes.hpp"
#include "vcavity/rough/mixed_slopes.hpp"
#include "vcavity/rough/connecting_grooves.hpp"
#include "vcavity/rough/drawn_ray.hpp"
#include "vcavity/rough/mean_axes.hpp"
#include "vcavity/rough/rough_bsdf.hpp"
#include "vcavity/rough/adaptive_gauss.hpp"
#include "vcavity/rough/rough_albedo.hpp"
#include "vcavity/rough/rough_bihemispherical.hpp"
// plan/: what of all this a scene needs.
#include "vcavity/plan/planner.hpp"
#include "vcavity/plan/rough_planner.hpp"
#include "vcavity/numbers/restore_macros.hpp"
// clang-format on
