// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Agreement ray by ray for grooves with unequal panels, floors and land: every ray has to meet the same faces.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "statistics.hpp"
#include "textbook_fresnel.hpp"
#include "tracer.hpp"

namespace agreement {

/// A groove with land beside it. Angles in radians.
struct ProfileShape {
  double slope_one, slope_two;  ///< of the panels to the mean plane
  double floor;                 ///< width of the flat bottom over the depth, 0 for none
  double land;                  ///< fraction of the period, in [0, 1)
};

/// A ray of light that enters a period.
struct ProfileRay {
  double theta, phi;  ///< of the direction towards the light, as in `LightRay`
  double
      position;  ///< where it crosses the plane of the rims: a fraction of the period, from the rim of panel one
};

/// A material for each face: panel one, panel two, floor, land.
using FaceMaterials = std::array<tracer::Material, 4>;

/// What a theory says about one ray.
struct ProfileAnswer {
  std::string faces;          ///< 1, 2, F and L, in the order in which they are met
  glm::dvec3 exit_direction;  ///< of travel, after the last bounce
  double reflectance;         ///< product over the bounces
};

/// A theory of single rays.
using ProfileTheory =
    std::function<ProfileAnswer(const ProfileShape&, const ProfileRay&, const FaceMaterials&)>;

/// vcavity on one ray.
ProfileAnswer closed_form_profile_ray(const ProfileShape&, const ProfileRay&, const FaceMaterials&);

/// The kinds of shapes that are drawn at random.
enum class ShapeKind { asymmetric, floor, trench };

/// A random shape; one in two with land.
ProfileShape random_shape(ShapeKind kind, Uniform& uniform);

/// Counts of one comparison.
struct ProfileAgreement {
  std::int64_t rays = 0;
  std::int64_t inside_margin = 0;       ///< rays within `edge_margin` of an edge
  std::int64_t mismatches = 0;          ///< rays outside it for which tracer and theory differ
  std::int64_t met_another_groove = 0;  ///< rays that left one groove and met another
  std::size_t max_bounces = 0;          ///< of any ray
  double largest_direction_error = 0;   ///< outside the margin, where the faces are the same
  double largest_product_error = 0;     ///< the same, relative
  std::string first_mismatch;           ///< description of the first ray that differs

  ProfileAgreement& operator+=(const ProfileAgreement& other);

  /// Theory and tracer agree.
  bool holds() const { return rays > 0 && mismatches == 0 && met_another_groove == 0; }
};

/// Traces rays over one shape after the other and compares each with the theory, the materials of the faces at random.
ProfileAgreement compare_profile_rays(const ProfileTheory& theory, ShapeKind kind, int shapes,
                                      std::int64_t rays_each, std::uint64_t seed);

/// A wrong theory.
struct ProfileMutant {
  const char* error;
  ShapeKind kind;  ///< of the shapes that show it
  ProfileTheory theory;
};

/// Theories with one error each, of the kinds that people make.
std::vector<ProfileMutant> profile_mutants();

/// The method of the mutants without an error, for shapes without a floor: so that it is the error that shows.
ProfileAnswer plain_series_ray(const ProfileShape&, const ProfileRay&, const FaceMaterials&);

}  // namespace agreement
