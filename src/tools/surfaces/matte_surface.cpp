// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/matte_surface.hpp"

#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

/// What all wavelengths of a groove share.
/// @tparam Geometry made from a groove
/// @param key of its shape
template <class Geometry, class Key, class Groove>
std::shared_ptr<const Geometry> geometry_of(const Key& key, const Groove& groove) {
  static std::mutex mutex;
  static std::map<Key, std::weak_ptr<const Geometry>> known;
  const std::lock_guard lock(mutex);
  std::shared_ptr<const Geometry> geometry = known[key].lock();
  if (!geometry) {
    geometry = std::make_shared<const Geometry>(groove);
    known[key] = geometry;
  }
  return geometry;
}

class MatteSurface final : public Surface {
 public:
  MatteSurface(double aperture, double albedo_one, double albedo_two)
      : cavity_(aperture), one_(albedo_one), two_(albedo_two) {}

  Reflected reflectance(const Vec3<double>& e) const override {
    return reflected(matte().directional_reflectance(e));
  }

  std::optional<double> absorptance(const Vec3<double>& e) const override {
    return matte().directional_absorptance(e);
  }

  std::optional<SurfaceBrdf> brdf(const Vec3<double>& e, const Vec3<double>& toward) const override {
    return SurfaceBrdf{reflected(matte().brdf(e, toward)), matte().brdf_error(e, toward)};
  }

  // A closed form, whatever the tolerance. That of two albedos is a difference that loses digits in narrow grooves.
  Integral<double> bihemispherical(double) const override {
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    return {bihemispherical_reflectance(InterreflectionKernel<double>(cavity_), one_, two_),
            one_ == two_ ? rounding : rounding * cavity_.inverse_sin_half(), 0};
  }

 private:
  /// Light of single directions needs the quadrature, which diffuse light does not.
  const LambertianCavity<double>& matte() const {
    std::call_once(made_, [this] {
      matte_.emplace(geometry_of<LambertianGeometry<double>>(cavity_.aperture(), cavity_), one_, two_);
    });
    return *matte_;
  }

  Cavity<double> cavity_;
  double one_, two_;
  mutable std::once_flag made_;
  mutable std::optional<LambertianCavity<double>> matte_;
};

/// Panels of unequal slope, which need the quadrature for all light.
class AsymmetricMatteSurface final : public Surface {
 public:
  AsymmetricMatteSurface(const AsymmetricGroove<double>& groove, double albedo_one, double albedo_two)
      : matte_(geometry_of<AsymmetricLambertianGeometry<double>>(std::pair(groove.aperture(), groove.tilt()),
                                                                 groove),
               albedo_one, albedo_two) {}

  Reflected reflectance(const Vec3<double>& e) const override {
    return reflected(matte_.directional_reflectance(e));
  }

  std::optional<double> absorptance(const Vec3<double>& e) const override {
    return matte_.directional_absorptance(e);
  }

  std::optional<SurfaceBrdf> brdf(const Vec3<double>& e, const Vec3<double>& toward) const override {
    return SurfaceBrdf{reflected(matte_.brdf(e, toward)), matte_.brdf_error(e, toward)};
  }

  Integral<double> bihemispherical(double) const override {
    return {matte_.bihemispherical_reflectance(), matte_.bihemispherical_error(), 0};
  }

 private:
  AsymmetricLambertianCavity<double> matte_;
};

/// Panels with a specular part besides: what becomes of diffuse light is all that is known of them.
class MatteSpecularSurface final : public Surface {
 public:
  MatteSpecularSurface(double aperture, double diffuse, double specular)
      : cavity_(aperture), diffuse_(diffuse), specular_(specular) {}

  Reflected reflectance(const Vec3<double>&) const override {
    throw UsageError(
        "--specular: only the reflectance under diffuse light is known of such panels, expected the command "
        "table");
  }

  Integral<double> bihemispherical(double) const override {
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    return {bihemispherical_reflectance(SpecularInterreflectionKernel<double>(cavity_), diffuse_, specular_),
            rounding * cavity_.inverse_sin_half(), 0};
  }

 private:
  Cavity<double> cavity_;
  double diffuse_, specular_;
};

/// Mirrors of one reflectance at all angles.
class ConstantMirrorSurface final : public Surface {
 public:
  ConstantMirrorSurface(double aperture, double reflectance, int max_bounces)
      : cavity_(aperture), reflectance_(reflectance), max_bounces_(max_bounces) {}

  Reflected reflectance(const Vec3<double>& e) const override {
    return reflected(directional_reflectance(cavity_, e, facet(), max_bounces_));
  }

  std::vector<SurfaceLobe> lobes(const Vec3<double>& e) const override {
    std::vector<SurfaceLobe> result;
    for (const auto& lobe : vcavity::lobes(cavity_, e, facet(), max_bounces_))
      result.push_back(
          {lobe.first_panel, lobe.bounces, {}, lobe.weight, reflected(lobe.throughput), lobe.direction});
    return result;
  }

  std::optional<SurfaceRay> ray(const Vec3<double>& e, double position) const override {
    const RayPath path = ray_path(cavity_, e, position);
    return SurfaceRay{position,
                      path.first_panel,
                      path.bounces,
                      {},
                      reflected(ray_reflectance(cavity_, e, path, facet())),
                      ray_exit_direction(cavity_, e, path)};
  }

  Integral<double> bihemispherical(double tolerance) const override {
    return bihemispherical_reflectance(cavity_, facet(), tolerance, max_bounces_);
  }

 private:
  struct Facet {
    double reflectance;
    double operator()(double) const { return reflectance; }
  };
  Facet facet() const { return {reflectance_}; }

  Cavity<double> cavity_;
  double reflectance_;
  int max_bounces_;
};

/// The angle between the panels, and that of their bisector from z.
struct Shape {
  double aperture;
  double tilt;
};

Shape shape_of(const SurfaceDescription& surface) {
  const ProfileDescription& profile = surface.profile;
  if (!profile.slopes_deg) return {radians(surface.aperture_deg), radians(profile.tilt_deg.value_or(0))};
  // The digits of the aperture are those of the sum of the slopes in degrees.
  const auto& [one, two] = *profile.slopes_deg;
  return {radians(180 - one - two), radians((one - two) / 2)};
}

}  // namespace

std::unique_ptr<const Surface> make_albedo_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                   const LightModel& light) {
  const PanelAlbedos& albedos = surface.albedos.value();
  if (light.polarization != Polarization::none)
    throw UsageError(
        "--polarization: panels of a given albedo say nothing of polarised light, expected none");
  if (surface.roughness)
    throw UsageError("--distribution: is of mirrors of a --material, not of panels with an --albedo");
  const ProfileDescription& profile = surface.profile;
  if (profile.land || profile.floor || profile.floor_material || profile.land_material)
    throw UsageError("--albedo: is of panels, expected neither --floor nor --land");
  const double one = albedos.one.at(wavelength_nm);
  if (surface.finish == Finish::mirror) {
    if (albedos.differ)
      throw UsageError("--albedo: mirrors share one albedo, expected one, not " + albedos.name());
    if (!profile.is_plain())
      throw UsageError(
          "--finish mirror: with an --albedo is of symmetric grooves, expected no --tilt or --slopes");
    if (surface.specular) throw UsageError("--specular: is a part of matte panels, expected --finish matte");
    return std::make_unique<ConstantMirrorSurface>(radians(surface.aperture_deg), one, light.max_bounces);
  }
  if (light.max_bounces != all_bounces)
    throw UsageError("--max-bounces: between matte panels light is not followed bounce by bounce");
  if (surface.specular) {
    if (albedos.differ || !profile.is_plain())
      throw UsageError(
          "--specular: is of panels of one albedo in symmetric grooves, expected neither two albedos nor "
          "--tilt or "
          "--slopes");
    const double specular = surface.specular->at(wavelength_nm);
    if (one + specular > 1)
      throw UsageError("--specular: '" + exact(specular) + "' with an albedo of " + exact(one) +
                       " reflects more than all light, expected a sum of at most 1");
    return std::make_unique<MatteSpecularSurface>(radians(surface.aperture_deg), one, specular);
  }
  const double two = albedos.two.at(wavelength_nm);
  const Shape shape = shape_of(surface);
  if (shape.tilt != 0)
    return std::make_unique<AsymmetricMatteSurface>(AsymmetricGroove<double>(shape.aperture, shape.tilt), one,
                                                    two);
  return std::make_unique<MatteSurface>(shape.aperture, one, two);
}

}  // namespace vcavity::tools
