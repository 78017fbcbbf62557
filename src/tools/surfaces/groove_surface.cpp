// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/groove_surface.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vcavity/vcavity.hpp>

namespace vcavity::tools {
namespace {

/// @tparam Facet the facet reflectance without polarisation, from which plans start
/// @tparam Model the same in a model of polarisation
template <class Facet, class Model>
class GrooveSurface final : public Surface {
 public:
  GrooveSurface(double aperture, const RefractiveIndex& index, Facet facet, Model model, int max_bounces)
      : cavity_(aperture),
        index_(index),
        facet_(std::move(facet)),
        model_(std::move(model)),
        max_bounces_(max_bounces) {}

  std::optional<RefractiveIndex> index() const override { return index_; }

  Reflected reflectance(const Vec3<double>& e) const override {
    return reflected(directional_reflectance(cavity_, e, model_, max_bounces_));
  }

  std::optional<double> absorptance(const Vec3<double>& e) const override {
    return unpolarized(directional_absorptance(cavity_, e, model_));
  }

  std::vector<SurfaceLobe> lobes(const Vec3<double>& e) const override {
    std::vector<SurfaceLobe> result;
    for (const auto& lobe : vcavity::lobes(cavity_, e, model_, max_bounces_))
      result.push_back({lobe.first_panel,
                        lobe.bounces,
                        {},
                        lobe.weight,
                        reflected(power(lobe.throughput)),
                        lobe.direction});
    return result;
  }

  std::optional<SurfaceRay> ray(const Vec3<double>& e, double position) const override {
    const RayPath path = ray_path(cavity_, e, position);
    return SurfaceRay{position,
                      path.first_panel,
                      path.bounces,
                      {},
                      reflected(ray_reflectance(cavity_, e, path, model_)),
                      ray_exit_direction(cavity_, e, path)};
  }

  Integral<double> bihemispherical(double tolerance) const override {
    return bihemispherical_reflectance(cavity_, model_, tolerance, max_bounces_);
  }

  EffectsPlan plan(double tolerance, Illumination illumination) const override {
    return plan_effects(cavity_, facet_, tolerance, illumination);
  }

  Integral<double> bihemispherical(const EffectsPlan& plan) const override {
    const auto integrate = [&](const auto& shape, const auto& facet) {
      using Real = std::remove_cvref_t<decltype(shape.aperture())>;
      const auto integral = bihemispherical_reflectance(
          shape, facet, static_cast<Real>(plan.bounds.quadrature), plan.max_bounces);
      // The plan allows the quadrature its share; it may have needed more.
      ErrorBounds bounds = plan.bounds;
      bounds.quadrature = std::max(bounds.quadrature, static_cast<double>(integral.error));
      return Integral<double>{static_cast<double>(integral.value), std::min(bounds.total(), 1.0),
                              integral.evaluations};
    };
    if constexpr (under_films)
      return with_effects(plan, cavity_, facet_, integrate);
    else
      return with_effects(plan, cavity_, index_.n, index_.k, integrate);
  }

 private:
  static constexpr bool under_films = std::is_same_v<Facet, Coated<Conductor<double>>>;

  Cavity<double> cavity_;
  RefractiveIndex index_;
  Facet facet_;
  Model model_;
  int max_bounces_;
};

}  // namespace

std::unique_ptr<const Surface> make_groove_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                   const LightModel& light) {
  const RefractiveIndex index = surface.material.at(wavelength_nm);
  return with_facet(index, surface.films, wavelength_nm, [&](const auto& facet) {
    return with_polarization(
        light.polarization, facet, [&](const auto& model) -> std::unique_ptr<const Surface> {
          using Groove = GrooveSurface<std::decay_t<decltype(facet)>, std::decay_t<decltype(model)>>;
          return std::make_unique<Groove>(radians(surface.aperture_deg), index, facet, model,
                                          light.max_bounces);
        });
  });
}

}  // namespace vcavity::tools
