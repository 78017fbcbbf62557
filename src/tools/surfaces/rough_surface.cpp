// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/rough_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vcavity/vcavity.hpp>

#include "tools/support/text_table.hpp"
#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {
namespace {

/// Absolute error of directional albedos, which are integrals. Smaller than what a table for people shows.
constexpr double albedo_tolerance = 1e-6;

/// The same of the elements of its Mueller matrix; the axes of the leaving light make these vary faster.
constexpr double matrix_tolerance = 1e-4;

/// The same in maps.
constexpr double table_tolerance = 1e-4;

/// The distribution of the command line: one type, so that the physics is compiled once for all.
class ChosenSlopes {
 public:
  using value_type = double;

  explicit ChosenSlopes(const Roughness& roughness) : slopes_(made(roughness)) {}

  double density(const Vec3<double>& m) const {
    return std::visit([&m](const auto& slopes) { return slopes.density(m); }, slopes_);
  }
  Vec3<double> sample(const Vec2<double>& u) const {
    return std::visit([&u](const auto& slopes) { return slopes.sample(u); }, slopes_);
  }

 private:
  using Slopes =
      std::variant<GgxSlopes<double>, BeckmannSlopes<double>, BrushedSlopes<BeckmannSlopes<double>>>;

  static Slopes made(const Roughness& roughness) {
    switch (roughness.distribution) {
      case Roughness::Distribution::ggx:
        return GgxSlopes<double>(roughness.along_x, roughness.along_y);
      case Roughness::Distribution::beckmann:
        return BeckmannSlopes<double>(roughness.along_x, roughness.along_y);
      default:
        return BrushedSlopes(BeckmannSlopes<double>(roughness.along_x), roughness.concentration);
    }
  }

  Slopes slopes_;
};

/// @tparam Model facet reflectance in a model of polarisation
template <class Model>
class RoughSurface final : public Surface {
 public:
  RoughSurface(const Roughness& roughness, const RefractiveIndex& index, Model model, int max_bounces)
      : bsdf_(ChosenSlopes(roughness), std::move(model), std::min(max_bounces, Bsdf::highest_limit)),
        index_(index),
        max_bounces_(max_bounces) {}

  std::optional<RefractiveIndex> index() const override { return index_; }

  Reflected reflectance(const Vec3<double>& e) const override {
    const double albedo =
        directional_albedo(bsdf_.distribution(), e, bsdf_.facet(), albedo_tolerance, max_bounces_).value;
    if constexpr (std::is_same_v<typename Bsdf::Value, Mueller<double>>) {
      const Mueller<double> matrix =
          polarized_albedo(bsdf_.distribution(), e, bsdf_.facet(), matrix_tolerance, max_bounces_).value;
      // Maps of the degree of polarisation would want it at every point, and the table does not have it.
      return {albedo, std::nullopt, matrix};
    } else {
      return {albedo, std::nullopt, std::nullopt};
    }
  }

  Reflected reflectance_in_maps(const Vec3<double>& e) const override {
    std::call_once(table_made_, [this] {
      table_.emplace(bsdf_.distribution(), bsdf_.facet(), table_tolerance, max_bounces_);
    });
    return {(*table_)(e), std::nullopt, std::nullopt};
  }

  std::optional<SurfaceBrdf> brdf(const Vec3<double>& e, const Vec3<double>& toward) const override {
    const Vec3<double> o = off_horizon(toward);
    const bool is_infinite = max_bounces_ > 1 && is_mirror_direction(e, o);
    const typename Bsdf::Value value = is_infinite ? bsdf_.evaluate_bounces(e, o, 1, Transport::importance)
                                                   : bsdf_.evaluate(e, o, Transport::importance);
    const Reflected brdf = reflected(typename Bsdf::Value((1 / o.z) * value));
    if (max_bounces_ == 1 || !(brdf.unpolarized > 0)) return SurfaceBrdf{brdf, 0};
    return SurfaceBrdf{brdf, is_infinite ? infinity : error_near_mirror(e, o, brdf.unpolarized)};
  }

  std::map<int, double> by_bounces(const Vec3<double>& e) const override {
    const auto parts =
        albedo_by_bounces<listed_bounces + 1>(bsdf_.distribution(), e, bsdf_.facet(), albedo_tolerance);
    std::map<int, double> result;
    for (int bounces = 1; bounces <= std::min(max_bounces_, listed_bounces); ++bounces)
      result[bounces] = parts.value[static_cast<std::size_t>(bounces - 1)];
    return result;
  }

  std::map<int, double> by_bounces(const Vec3<double>& e, const Vec3<double>& toward) const override {
    const Vec3<double> o = off_horizon(toward);
    const int most = is_mirror_direction(e, o) ? 1 : listed_parts;  // the others are infinite there
    std::map<int, double> result;
    bsdf_.for_each_part(e, o, Transport::importance, [&](int bounces, const typename Bsdf::Value& part) {
      if (bounces <= most) result[bounces] += unpolarized(part) / o.z;
    });
    return result;
  }

  Integral<double> bihemispherical(double tolerance) const override {
    return bihemispherical_reflectance(bsdf_.distribution(), bsdf_.facet(), tolerance, max_bounces_);
  }

 private:
  using Bsdf = RoughGrooveBsdf<ChosenSlopes, Model>;
  static constexpr int listed_bounces = 31;  // of the albedo, an integral for each
  static constexpr int listed_parts = 256;   // of a BRDF, of which few exist

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Rounding of directions, relative to their length.
  static constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

  /// The horizontal part of the sum of two directions, h.
  static double tilt(const Vec3<double>& e, const Vec3<double>& o) {
    return std::hypot(e.x + o.x, e.y + o.y);
  }

  /// Whether the viewer is in the mirror direction, as far as rounding lets one tell: light of two and more bounces grows
  /// like 1/|h| towards it, where its BRDF is infinite.
  static bool is_mirror_direction(const Vec3<double>& e, const Vec3<double>& o) {
    return !(tilt(e, o) > rounding);
  }

  /// The error of the BRDF where the viewer is so close to the mirror direction that rounding of the two counts.
  static double error_near_mirror(const Vec3<double>& e, const Vec3<double>& o, double brdf) {
    constexpr double matters = 1e-10;
    const double relative = rounding / tilt(e, o);
    return relative > matters ? brdf * relative : 0;
  }

  /// At grazing angles the BRDF has a limit, which a small height comes close to.
  static Vec3<double> off_horizon(const Vec3<double>& o) {
    constexpr double least_height = 1e-100;
    return {o.x, o.y, std::max(o.z, least_height)};
  }

  Bsdf bsdf_;
  RefractiveIndex index_;
  int max_bounces_;
  mutable std::once_flag table_made_;
  mutable std::optional<RoughAlbedoTable<double>> table_;
};

const char* name_of(Roughness::Distribution distribution) {
  switch (distribution) {
    case Roughness::Distribution::ggx:
      return "ggx";
    case Roughness::Distribution::beckmann:
      return "beckmann";
    default:
      return "brushed";
  }
}

}  // namespace

nlohmann::ordered_json fields_of(const Roughness& roughness) {
  nlohmann::ordered_json fields{{"distribution", name_of(roughness.distribution)}};
  if (roughness.along_x == roughness.along_y)
    fields["roughness"] = roughness.along_x;
  else
    fields.update({{"roughness_x", roughness.along_x}, {"roughness_y", roughness.along_y}});
  if (roughness.distribution == Roughness::Distribution::brushed)
    fields["concentration"] = roughness.concentration;
  return fields;
}

std::string in_words(const Roughness& roughness) {
  std::string words = name_of(roughness.distribution);
  words.append(", roughness ").append(exact(roughness.along_x));
  if (roughness.along_x != roughness.along_y)
    words.append(" along x and ").append(exact(roughness.along_y)).append(" along y");
  if (roughness.distribution == Roughness::Distribution::brushed)
    words.append(", concentration ").append(exact(roughness.concentration));
  return words;
}

std::string file_stem(const Roughness& roughness) {
  std::string stem = name_of(roughness.distribution);
  stem.append("-").append(exact(roughness.along_x));
  if (roughness.along_x != roughness.along_y) stem.append("-").append(exact(roughness.along_y));
  if (roughness.distribution == Roughness::Distribution::brushed)
    stem.append("-").append(exact(roughness.concentration));
  return stem;
}

std::unique_ptr<const Surface> make_rough_surface(const SurfaceDescription& surface, double wavelength_nm,
                                                  const LightModel& light) {
  const RefractiveIndex index = surface.material.at(wavelength_nm);
  return with_facet(index, surface.films, wavelength_nm, [&](const auto& facet) {
    return with_polarization(
        light.polarization, facet, [&](const auto& model) -> std::unique_ptr<const Surface> {
          using Rough = RoughSurface<std::decay_t<decltype(model)>>;
          return std::make_unique<Rough>(*surface.roughness, index, model, light.max_bounces);
        });
  });
}

}  // namespace vcavity::tools
