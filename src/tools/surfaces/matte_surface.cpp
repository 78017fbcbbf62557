// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/matte_surface.hpp"

#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <vcavity/vcavity.hpp>

#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

using Geometry = std::shared_ptr<const LambertianGeometry<double>>;

/// What all wavelengths of an aperture share.
Geometry geometry_of(double aperture) {
  static std::mutex mutex;
  static std::map<double, std::weak_ptr<const LambertianGeometry<double>>> known;
  const std::lock_guard lock(mutex);
  Geometry geometry = known[aperture].lock();
  if (!geometry) {
    geometry = std::make_shared<const LambertianGeometry<double>>(Cavity<double>(aperture));
    known[aperture] = geometry;
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
    return SurfaceBrdf{reflected(matte().brdf(e, toward)), matte().brdf_error(e, toward), {}};
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
    std::call_once(made_, [this] { matte_.emplace(geometry_of(cavity_.aperture()), one_, two_); });
    return *matte_;
  }

  Cavity<double> cavity_;
  double one_, two_;
  mutable std::once_flag made_;
  mutable std::optional<LambertianCavity<double>> matte_;
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

}  // namespace

std::unique_ptr<const Surface> make_albedo_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                   const LightModel& light) {
  const PanelAlbedos& albedos = surface.albedos.value();
  if (light.polarization != Polarization::none)
    throw UsageError(
        "--polarization: panels of a given albedo say nothing of polarised light, expected none");
  if (surface.roughness)
    throw UsageError("--distribution: is of mirrors of a --material, not of panels with an --albedo");
  if (!surface.profile.is_plain())
    throw UsageError(
        "--albedo: is of symmetric grooves, expected none of --tilt, --slopes, --panels, --floor and --land");
  const double aperture = radians(surface.aperture_deg);
  if (surface.finish == Finish::mirror) {
    if (albedos.differ)
      throw UsageError("--albedo: mirrors share one albedo, expected one, not " + albedos.name());
    return std::make_unique<ConstantMirrorSurface>(aperture, albedos.one.at(wavelength_nm),
                                                   light.max_bounces);
  }
  if (light.max_bounces != all_bounces)
    throw UsageError("--max-bounces: between matte panels light is not followed bounce by bounce");
  return std::make_unique<MatteSurface>(aperture, albedos.one.at(wavelength_nm),
                                        albedos.two.at(wavelength_nm));
}

}  // namespace vcavity::tools
