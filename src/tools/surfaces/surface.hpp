// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A reflecting surface as the commands see it, chosen at run time: one interface for every shape and finish.
///
/// Method: each shape is a class in a file of its own that forwards to the library, where the types of facet and
/// polarisation are chosen once, when it is made; see make_surface(). What a surface does not have (lobes of a matte
/// one, a single ray through a rough one) it leaves out, and the commands say so.
/// When not to use it: in inner loops. A virtual call and a value of a few hundred bytes for every direction cost more
/// than the physics of a bare groove; maps of that have a kernel of their own.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vcavity/conventions.hpp>
#include <vcavity/hemisphere/integral.hpp>
#include <vcavity/plan/planner.hpp>
#include <vcavity/polarization/mueller.hpp>
#include <vcavity/polarization/polarization.hpp>
#include <vector>

#include "tools/materials/material.hpp"

namespace vcavity::tools {

/// What becomes of light: the part of unpolarised light that is reflected and, as far as the model of polarisation
/// knows, the rest.
struct Reflected {
  double unpolarized = 0;
  std::optional<double>
      diattenuation;  ///< (max − min)/(max + min) over all polarisations; not for model `none`
  std::optional<Mueller<double>> mueller;  ///< only for model `full`
};

/// What the library returns, in any model of polarisation, as `Reflected`.
template <class Power>
Reflected reflected(const Power& reflectance) {
  if constexpr (std::is_same_v<Power, double>) {
    return {reflectance, std::nullopt, std::nullopt};
  } else if constexpr (std::is_same_v<Power, Mueller<double>>) {
    return {unpolarized(reflectance), diattenuation(reflectance), reflectance};
  } else {
    return {unpolarized(reflectance), diattenuation(reflectance), std::nullopt};
  }
}

/// Light of one direction that leaves in one direction.
struct SurfaceLobe {
  std::optional<Panel> first_panel;  ///< the panel met first; nothing for light that meets none
  int bounces = 0;
  std::string facets;  ///< the way in facets, such as "1F2", "L" for land; empty where only panels alternate
  double weight = 0;   ///< fraction of the light of the direction
  Reflected throughput;
  Vec3<double> direction{};  ///< in which the light travels after its last bounce
};

/// The ray through one point of the opening.
struct SurfaceRay {
  double position = 0;  ///< fraction of the half width of the opening
  std::optional<Panel> first_panel;
  int bounces = 0;
  std::string facets;  ///< as in a lobe
  Reflected reflectance;
  Vec3<double> direction{};  ///< in which the light travels after its last bounce
};

/// The bidirectional reflectance distribution function for a pair of directions. In the mirror direction of a rough
/// surface it is infinite: there the error is, and the value is that of the light of one bounce.
struct SurfaceBrdf {
  Reflected value;   ///< per steradian
  double error = 0;  ///< estimate of the absolute error; 0 where the value is a closed form
};

/// A surface at one wavelength, in one model of polarisation. Directions are unit vectors away from the surface, with
/// z ≥ 0, in the axes of the mean surface (conventions.hpp). All members may be called from several threads at once.
class Surface {
 public:
  Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;
  virtual ~Surface() = default;

  /// The refractive index of the material; that of panel one where there are several. Nothing for a surface that is
  /// not made of one.
  virtual std::optional<RefractiveIndex> index() const { return std::nullopt; }

  /// Directional-hemispherical reflectance.
  /// @param e towards the light, or towards the viewer under diffuse light
  virtual Reflected reflectance(const Vec3<double>& e) const = 0;

  /// The same for maps, which ask for thousands of directions: where it is an integral it may come from a table, with
  /// an error that cannot be seen.
  /// @param e towards the light, or towards the viewer under diffuse light
  virtual Reflected reflectance_in_maps(const Vec3<double>& e) const { return reflectance(e); }

  /// Directional absorptance of unpolarised light where it is known apart from 1 − reflectance, with all digits.
  /// @param e towards the light
  virtual std::optional<double> absorptance(const Vec3<double>& e) const;

  /// All light of a direction, where it leaves in a few directions; else nothing.
  /// @param e towards the light
  virtual std::vector<SurfaceLobe> lobes(const Vec3<double>& e) const;

  /// A single ray, where that is defined.
  /// @param e towards the light
  /// @param position where it crosses the opening, a fraction of its half width in [−1, 1]
  virtual std::optional<SurfaceRay> ray(const Vec3<double>& e, double position) const;

  /// The BRDF, where light leaves in all directions; nothing for mirrors.
  /// @param e towards the light
  /// @param toward towards the viewer
  virtual std::optional<SurfaceBrdf> brdf(const Vec3<double>& e, const Vec3<double>& toward) const;

  /// The reflectance by the number of bounces, for surfaces that have a BRDF and know them; else empty.
  /// @param e towards the light
  virtual std::map<int, double> by_bounces(const Vec3<double>& e) const;

  /// The BRDF for unpolarised light by the number of bounces, per steradian; empty where these are not known.
  /// @param e towards the light
  /// @param toward towards the viewer
  virtual std::map<int, double> by_bounces(const Vec3<double>& e, const Vec3<double>& toward) const;

  /// Other results for a direction, a JSON object of numbers; empty unless the shape has some, such as
  /// `groove_reflectance` where there is land.
  /// @param e towards the light
  virtual nlohmann::ordered_json more_about(const Vec3<double>& e) const;

  /// Bi-hemispherical reflectance of unpolarised light.
  /// @param tolerance absolute error to aim at, > 0
  virtual Integral<double> bihemispherical(double tolerance) const = 0;

  /// Which effects a tolerance calls for, starting from the full physics whatever the model of this surface. It asks for
  /// float only where that is computed.
  /// @param tolerance absolute error of the reflectance, > 0
  /// @throws UsageError unless the planner knows the shape
  virtual EffectsPlan plan(double tolerance, Illumination illumination) const;

  /// Bi-hemispherical reflectance with the effects of a plan.
  /// @throws UsageError unless the planner knows the shape
  virtual Integral<double> bihemispherical(const EffectsPlan& plan) const;
};

}  // namespace vcavity::tools
