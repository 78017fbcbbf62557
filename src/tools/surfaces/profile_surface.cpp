// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/profile_surface.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>
#include <vcavity/plan/profile_planner.hpp>
#include <vcavity/profiles/bihemispherical.hpp>

#include "tools/surfaces/profile_shape.hpp"

namespace vcavity::tools {
namespace {

/// @tparam Shape a groove and its land
/// @tparam Plain the facets of its faces without polarisation, from which plans start
/// @tparam Facets the same in a model of polarisation
template <class Shape, class Plain, class Facets>
class ProfileSurface final : public Surface {
 public:
  using Value = face_value_t<Facets, double>;
  using Power = face_power_t<Facets, double>;

  /// @param names_faces whether lobes are to say which faces they meet
  ProfileSurface(Shape shape, const RefractiveIndex& index, Plain plain, Facets facets, bool names_faces,
                 int max_bounces)
      : shape_(std::move(shape)),
        index_(index),
        plain_(std::move(plain)),
        facets_(std::move(facets)),
        names_faces_(names_faces),
        max_bounces_(max_bounces) {}

  std::optional<RefractiveIndex> index() const override { return index_; }

  Reflected reflectance(const Vec3<double>& e) const override {
    Power sum(0);
    follow(e, [&](const FacePencil<double>& light, const Power& throughput) {
      sum = sum + light.weight * throughput;
    });
    return reflected(sum);
  }

  std::optional<double> absorptance(const Vec3<double>& e) const override {
    return unpolarized(directional_absorptance(shape_, e, facets_));
  }

  std::vector<SurfaceLobe> lobes(const Vec3<double>& e) const override {
    std::vector<SurfaceLobe> result;
    follow(e, [&](const FacePencil<double>& light, const Power& throughput) {
      if (light.weight > negligible_fraction<double>())
        result.push_back({first_panel(light.path), light.path.bounces(), faces(light.path), light.weight,
                          reflected(throughput), light.direction});
    });
    return result;
  }

  std::optional<SurfaceRay> ray(const Vec3<double>& e, double position) const override {
    const auto light = pencil_at(shape_, e, (1 - shape_.fraction()) * (1 + position) / 2);
    SurfaceRay ray{position,    first_panel(light.path), light.path.bounces(), faces(light.path),
                   Reflected{}, light.direction};
    shape_.follow(e, facets_, [&](const FacePencil<double>& pencil, const Value& throughput) {
      if (pencil.path == light.path) ray.reflectance = reflected(power(throughput));
    });
    return ray;
  }

  nlohmann::ordered_json more_about(const Vec3<double>& e) const override {
    if (!(shape_.fraction() > 0)) return nlohmann::ordered_json::object();
    double groove = 0;
    follow(e, [&](const FacePencil<double>& light, const Power& throughput) {
      if (!light.path.meets_land) groove += light.weight * unpolarized(throughput);
    });
    return {{"groove_reflectance", groove / (1 - shape_.fraction())}};
  }

  Integral<double> bihemispherical(double tolerance) const override {
    return bihemispherical_of(facets_, tolerance, max_bounces_);
  }

  /// In double, in which this surface computes everything.
  EffectsPlan plan(double tolerance, Illumination illumination) const override {
    EffectsPlan plan = plan_effects(shape_, plain_, tolerance, illumination);
    if (plan.single_precision) {
      plan.single_precision = false;
      plan.bounds.rounding = rounding_bound<double>(shape_, plain_, illumination);
    }
    return plan;
  }

  Integral<double> bihemispherical(const EffectsPlan& plan) const override {
    const Integral<double> integral =
        plan.polarization ? bihemispherical_of(polarized(plain_), plan.bounds.quadrature, plan.max_bounces)
                          : bihemispherical_of(plain_, plan.bounds.quadrature, plan.max_bounces);
    // The plan allows the quadrature its share; it may have needed more.
    ErrorBounds bounds = plan.bounds;
    bounds.quadrature = std::max(bounds.quadrature, integral.error);
    return {integral.value, std::min(bounds.total(), 1.0), integral.evaluations};
  }

 private:
  /// Calls `visit` with all light that needs no more bounces than are followed, and the power of its throughput.
  template <class Visit>
  void follow(const Vec3<double>& e, const Visit& visit) const {
    shape_.follow(e, facets_, [&](const FacePencil<double>& light, const Value& throughput) {
      if (light.path.bounces() <= max_bounces_) visit(light, Power(power(throughput)));
    });
  }

  template <class Own>
  Integral<double> bihemispherical_of(const Own& facets, double tolerance, int max_bounces) const {
    if constexpr (!std::is_same_v<Shape, Land<Cavity<double>>>) {
      return bihemispherical_reflectance(shape_, facets, tolerance, max_bounces);
    } else {
      // The panels are of one material here, which makes it cheap.
      const auto grooves = bihemispherical_reflectance(shape_.groove(), facets.one, tolerance, max_bounces);
      const double land = shape_.fraction();
      if (!(land > 0)) return grooves;
      const auto flat =
          bihemispherical_reflectance(Cavity<double>(pi<double>()), facets.land, tolerance, max_bounces);
      return {(1 - land) * grooves.value + land * flat.value, (1 - land) * grooves.error + land * flat.error,
              grooves.evaluations + flat.evaluations};
    }
  }

  static std::optional<Panel> first_panel(const FacePath& path) {
    if (path.meets_land || path.walls == 0) return std::nullopt;
    return path.first_wall;
  }

  std::string faces(const FacePath& path) const { return names_faces_ ? path.text() : std::string(); }

  Shape shape_;
  RefractiveIndex index_;
  Plain plain_;
  Facets facets_;
  bool names_faces_;
  int max_bounces_;
};

/// @param facet makes the facet of a material
template <class MakeFacet>
std::unique_ptr<const Surface> with_facets(const SurfaceDescription& surface, const RefractiveIndex& index,
                                           const LightModel& light, const MakeFacet& facet) {
  const ProfileDescription& profile = surface.profile;
  const FaceFacets facets{facet(surface.material), facet(profile.panel_two.value_or(surface.material)),
                          facet(profile.floor_material.value_or(surface.material)),
                          facet(profile.land_material.value_or(surface.material))};
  const bool names_faces = profile.land.value_or(0) > 0 || profile.floor.value_or(0) > 0;
  return with_polarization(light.polarization, facets, [&](const auto& model) {
    return with_profile(surface, [&](const auto& shape) -> std::unique_ptr<const Surface> {
      using Made = ProfileSurface<std::decay_t<decltype(shape)>, std::decay_t<decltype(facets)>,
                                  std::decay_t<decltype(model)>>;
      return std::make_unique<Made>(shape, index, facets, model, names_faces, light.max_bounces);
    });
  });
}

}  // namespace

std::unique_ptr<const Surface> make_profile_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                    const LightModel& light) {
  const RefractiveIndex index = surface.material.at(wavelength_nm);
  if (has_films(surface.films))
    return with_facets(surface, index, light, [&](const Material& material) {
      return coated_facet(material.at(wavelength_nm), surface.films, wavelength_nm);
    });
  return with_facets(surface, index, light, [&](const Material& material) {
    const RefractiveIndex own = material.at(wavelength_nm);
    return Conductor<double>(own.n, own.k);
  });
}

}  // namespace vcavity::tools
