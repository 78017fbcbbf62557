// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a scene says about a `vgroove`, checked when the scene is loaded.

#include <mitsuba/core/plugin.h>
#include <mitsuba/core/properties.h>
#include <mitsuba/render/ior.h>
#include <mitsuba/render/texture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "effects.hpp"
#include "spectra.hpp"

NAMESPACE_BEGIN(mitsuba)

/// Whether a texture's values belong to a mesh, which a BSDF does not know before rendering.
template <class Texture>
bool is_of_mesh(const Texture& texture) {
  return texture.class_name() == "MeshAttribute";
}

/// Whether a texture is not the same everywhere. Those of a mesh do not say so themselves.
template <class Texture>
bool varies(const Texture& texture) {
  return texture.is_spatially_varying() || is_of_mesh(texture);
}

/// A value of a variant that is known when a scene is loaded, as a number.
template <class Float>
double number_of(const Float& value) {
  if constexpr (dr::is_jit_v<Float>)
    return dr::detach(value).entry(0);
  else
    return value;
}

/// A number that may vary over a surface.
template <typename Float, typename Spectrum>
class SurfaceNumber {
 public:
  MI_IMPORT_TYPES(Texture)

  /// Where its values lie.
  struct Range {
    double low, high;
  };

  /// @param fallback the value where a scene gives none
  /// @param allowed what the values must lie between
  /// @param least_of_mesh what stands in for smaller values of a mesh, which are not known at load
  /// @throws std::runtime_error when a value lies elsewhere; of textures the texels are looked at, or as many
  ///         points as a texture without texels has
  SurfaceNumber(const Properties& props, const char* name, float fallback, Range allowed,
                double least_of_mesh)
      : texture_(props.get_texture<Texture>(name, fallback)),
        name_(name),
        allowed_(allowed),
        least_of_mesh_(least_of_mesh),
        constant_(fallback) {
    look_again();
  }

  /// Looks for the range of the texture's values, after they have changed.
  /// @throws std::runtime_error when a value is out of range
  void look_again() {
    range_.reset();
    if (!varies()) {
      constant_ = static_cast<float>(number_of(texture_->eval_1(dr::zeros<SurfaceInteraction3f>())));
      range_ = Range{constant_, constant_};
    } else if (!is_of_mesh(*texture_)) {
      range_ = range_of_texels();
    }
    if (range_)
      for (const double x : {range_->low, range_->high})
        if (!(x >= allowed_.low && x <= allowed_.high))
          Throw("vgroove: %s must lie in [%g, %g], not be %g", name_, allowed_.low, allowed_.high, x);
    smallest_ = static_cast<float>(range_ ? range_->low : least_of_mesh_);
    largest_ = static_cast<float>(range_ ? range_->high : allowed_.high);
  }

  /// Whether it is not the same everywhere.
  bool varies() const { return mitsuba::varies(*texture_); }

  /// The value of a number that does not vary.
  float constant() const { return constant_; }

  /// The value at a point.
  Float at(const SurfaceInteraction3f& si, const Mask& active = true) const {
    const Float value = texture_->eval_1(si, active);
    return dr::select(value >= smallest_, dr::minimum(value, largest_), smallest_);
  }

  /// The smallest value that a point may have.
  float smallest() const { return smallest_; }

  /// Nothing if it is not known before rendering.
  const std::optional<Range>& range() const { return range_; }

  const Texture* texture() const { return texture_.get(); }
  Texture* texture() { return texture_.get(); }

 private:
  Range range_of_texels() const {
    constexpr int fewest = 64, most = 1024;
    const auto resolution = texture_->resolution();
    const int columns = std::clamp(resolution.x(), fewest, most),
              rows = std::clamp(resolution.y(), fewest, most);
    SurfaceInteraction3f si = dr::zeros<SurfaceInteraction3f>();
    if constexpr (dr::is_jit_v<Float>) {
      const UInt32 texel = dr::arange<UInt32>(static_cast<std::size_t>(rows * columns));
      const UInt32 row = texel / static_cast<std::uint32_t>(columns);
      si.uv = Point2f(
          (Float(texel - row * static_cast<std::uint32_t>(columns)) + 0.5f) / static_cast<float>(columns),
          (Float(row) + 0.5f) / static_cast<float>(rows));
      const Float values = dr::detach(texture_->eval_1(si));
      if (dr::any(dr::isnan(values))) return {NAN, NAN};
      return {number_of(dr::min(values)), number_of(dr::max(values))};
    } else {
      return range_of_texels(si, rows, columns);
    }
  }

  /// One after the other.
  Range range_of_texels(SurfaceInteraction3f& si, int rows, int columns) const {
    Range range{HUGE_VAL, -HUGE_VAL};
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        si.uv = Point2f((column + 0.5f) / columns, (row + 0.5f) / rows);
        const double value = number_of(texture_->eval_1(si));
        range = {std::min(range.low, value), std::max(range.high, value)};
        if (std::isnan(value)) return {value, value};
      }
    }
    return range;
  }

  ref<Texture> texture_;
  const char* name_;
  Range allowed_;
  double least_of_mesh_;
  std::optional<Range> range_;
  float constant_;
  float smallest_;
  float largest_;
};

/// What a scene says about a groove.
template <typename Float, typename Spectrum>
class GrooveParameters {
 public:
  MI_IMPORT_TYPES(Texture)
  using Number = SurfaceNumber<Float, Spectrum>;

  /// @throws std::runtime_error when a parameter is out of range or contradicts another one
  explicit GrooveParameters(const Properties& props)
      : aperture(props, "aperture", 60.f, {narrowest_aperture, 180}, narrowest_of_mesh),
        tilt(props, "tilt", 0.f, {-90, 90}, -90),
        rotation(props, "rotation", 0.f, {-3600, 3600}, -3600),
        tint(props.get_texture<Texture>("specular_reflectance", 1.f)),
        lobe_width(vcavity::radians(props.get<float>("lobe_width", 0.f))) {
    const std::string material = props.get<std::string>("material", "none");
    if (material == "none") {
      const bool dielectric = props.has_property("eta") && !props.has_property("k");
      eta = props.get_unbounded_texture<Texture>("eta", 0.f);
      k = props.get_unbounded_texture<Texture>("k", dielectric ? 0.f : 1.f);
    } else {
      if (props.has_property("eta") || props.has_property("k"))
        Throw("vgroove: give either a material or eta and k");
      eta = part_of_index(material + ".eta");
      k = part_of_index(material + ".k");
    }
    tilted = props.has_property("tilt");
    check_tilt();
    tinted = props.has_property("specular_reflectance");
    if (props.has_property("groove_axis")) {
      const ScalarVector3f direction = props.get<ScalarVector3f>("groove_axis");
      if (!(dr::squared_norm(direction) > 0))
        Throw("vgroove: groove_axis must be a direction, not %s", direction);
      axis = Vector3f(dr::normalize(direction));
    }
    if (lobe_width != 0) (void)vcavity::VonMisesFisher<float>(lobe_width);  // refuses what is no width
    read_roughness(props);
    decide_effects(props);
  }

  /// Whether grooves of many apertures and directions make the surface, rather than parallel ones.
  bool is_rough() const { return !distribution.empty(); }

  /// Whether fields can be followed through this surface.
  bool follows_fields() const { return !is_rough() || !dr::is_jit_v<Float>; }

  /// What `to_string` says.
  std::string in_words() const {
    std::ostringstream text;
    text << "VGroove[" << std::endl;
    if (is_rough()) {
      text << "  distribution = " << distribution << "," << std::endl
           << "  roughness_u = " << string::indent(roughness_u->texture()) << "," << std::endl
           << "  roughness_v = " << string::indent(roughness_v->texture()) << "," << std::endl;
      if (distribution == "brushed") text << "  concentration = " << concentration << "," << std::endl;
    } else {
      text << "  aperture = " << string::indent(aperture.texture()) << "," << std::endl;
      if (tilted) text << "  tilt = " << string::indent(tilt.texture()) << "," << std::endl;
      text << "  lobe_width = " << vcavity::degrees(lobe_width) << "," << std::endl;
    }
    text << "  rotation = " << string::indent(rotation.texture()) << "," << std::endl
         << "  effects = " << vgroove::described(effects) << "," << std::endl
         << "  eta = " << string::indent(eta) << "," << std::endl
         << "  k = " << string::indent(k) << std::endl
         << "]";
    return text.str();
  }

  /// Whether the shape of the grooves differs from point to point.
  bool shape_varies() const {
    return is_rough() ? roughness_u->varies() || roughness_v->varies() : aperture.varies() || tilt.varies();
  }

  /// Whether the shape or the direction of the grooves does.
  bool varies() const { return shape_varies() || rotation.varies() || axis; }

  /// Whether the index differs from point to point.
  bool index_varies() const { return mitsuba::varies(*eta) || mitsuba::varies(*k); }

  /// Whether the tint differs from point to point.
  bool tint_varies() const { return tinted && mitsuba::varies(*tint); }

  /// Looks at the shape of the grooves again, after it has changed.
  /// @throws std::runtime_error when it is out of range
  void look_again() {
    aperture.look_again();
    tilt.look_again();
    rotation.look_again();
    if (is_rough()) {
      roughness_u->look_again();
      roughness_v->look_again();
    }
    check_tilt();
  }

  /// Smaller ones are no `Cavity`, wherever on a surface they are.
  static constexpr double narrowest_aperture = 1e-6;  // degrees
  static constexpr double narrowest_of_mesh = 0.01;   // degrees
  /// The least angle of a panel of tilted grooves to the surface: for less, lengths of panels are rounding errors.
  static constexpr float least_slope = 0.01f;  // degrees

  Number aperture;  ///< degrees
  Number tilt;      ///< degrees
  bool tilted;      ///< whether `tilt` may differ from 0
  Number rotation;  ///< degrees
  std::optional<Vector3f> axis;
  std::string distribution;  ///< ggx, beckmann, brushed; empty for parallel grooves
  std::optional<Number> roughness_u, roughness_v;
  bool anisotropic = false;  ///< whether they are two, alpha_u and alpha_v
  float concentration = 0;   ///< of the azimuths of brushed grooves
  ref<Texture> eta, k, tint;
  bool tinted;       ///< whether `tint` may differ from 1
  float lobe_width;  ///< radians; 0 for mirror directions
  vgroove::Effects effects{false};

 private:
  /// n or k of one of Mitsuba's materials. Transparent ones have k = 0 at all wavelengths, which `ior_from_file`, and so
  /// `conductor`, refuses in spectral variants.
  static ref<Texture> part_of_index(const std::string& name) {
    const std::string path = "data/ior/" + name + ".spd";
    std::vector<double> wavelengths, values;
    spectrum_from_file(fs::path(path), wavelengths, values);
    if (std::any_of(values.begin(), values.end(), [](double value) { return value != 0; }))
      return ior_from_file<Spectrum, Texture>(path);
    Properties zero("uniform");
    zero.set("value", 0.0);
    return PluginManager::instance()->create_object<Texture>(zero);
  }

  /// Textures of a mesh are not known; points give what is left of their tilts.
  void check_tilt() const {
    if (!tilted || !aperture.range() || !tilt.range()) return;
    const double widest = aperture.range()->high;
    const double most = (180 - widest) / 2 - least_slope;
    if (!(most >= 0))
      Throw("vgroove: tilted grooves must have an aperture of at most %g, not %g", 180 - 2 * least_slope,
            widest);
    for (const double x : {tilt.range()->low, tilt.range()->high})
      if (!(std::abs(x) <= most))
        Throw("vgroove: the tilt of grooves of aperture %g must lie in [%g, %g], not be %g", widest, -most,
              most, x);
  }

  void read_roughness(const Properties& props) {
    const bool uniform = props.has_property("roughness"), two = props.has_property("alpha_u");
    distribution = props.get<std::string>("distribution", "");
    if (!is_rough()) {
      if (uniform || two) Throw("vgroove: give a distribution (ggx, beckmann or brushed) with the roughness");
      return;
    }
    if (distribution != "ggx" && distribution != "beckmann" && distribution != "brushed")
      Throw("vgroove: distribution must be ggx, beckmann or brushed, not %s", distribution);
    if (props.has_property("aperture") || tilted || props.has_property("lobe_width"))
      Throw("vgroove: aperture, tilt and lobe_width are for parallel grooves, not for a distribution");
    if (two != props.has_property("alpha_v") || (two && uniform))
      Throw("vgroove: give either a roughness or both alpha_u and alpha_v");
    if (two && distribution == "brushed")
      Throw("vgroove: brushed takes a roughness, not alpha_u and alpha_v");
    anisotropic = two;
    constexpr typename Number::Range allowed{1e-3, 10};
    roughness_u.emplace(props, two ? "alpha_u" : "roughness", 0.3f, allowed, allowed.low);
    roughness_v.emplace(props, two ? "alpha_v" : "roughness", 0.3f, allowed, allowed.low);
    if (distribution == "brushed") {
      concentration = props.get<float>("concentration", 100.f);
      (void)vcavity::AxialVonMises<float>(concentration);  // refuses what is no concentration
    }
  }

  void decide_effects(const Properties& props) {
    const int max_bounces = props.get<int>("max_bounces", -1);
    if (max_bounces == 0 || max_bounces < -1)
      Throw("vgroove: max_bounces must be positive or -1, not %d", max_bounces);
    const bool with_tolerance = props.has_property("tolerance");
    const double tolerance = props.get<double>("tolerance", 1e-3);
    if (!(tolerance > 0)) Throw("vgroove: tolerance must be positive, not %g", tolerance);
    const std::string asked = props.get<std::string>("effects", with_tolerance ? "auto" : "");
    if (asked != "" && asked != "full" && asked != "paper" && asked != "auto")
      Throw("vgroove: effects must be full, paper or auto, not %s", asked);
    if (with_tolerance && asked != "auto") Throw("vgroove: tolerance is for effects = auto, not %s", asked);
    if (asked != "" && props.has_property("polarized")) Throw("vgroove: give either effects or polarized");
    if (asked == "auto" && props.has_property("max_bounces"))
      Throw("vgroove: give either tolerance or max_bounces");

    if (asked == "auto") {
      plan(tolerance);
      Log(Info, "vgroove: tolerance %g: %s", tolerance, vgroove::described(effects));
      return;
    }
    effects.polarization = asked == ""
                               ? props.get<bool>("polarized", is_polarized_v<Spectrum> && follows_fields())
                               : asked == "full" && follows_fields();
    if (effects.polarization && !follows_fields())
      Throw("vgroove: rough surfaces do not follow polarisation in vectorised variants");
    if (max_bounces > 0) effects.max_bounces = max_bounces;
  }

  /// Over all shapes of the surface, and all colours or wavelengths that the variant may ask for.
  void plan(double tolerance) {
    const bool known = (is_rough() ? roughness_u->range() && roughness_v->range()
                                   : aperture.range() && (!tilted || tilt.range())) &&
                       !index_varies();
    if (!known) {
      Log(Info,
          "vgroove: nothing is left out, because the material or the shape varies in a way not known at "
          "load");
      effects.polarization = follows_fields();
      return;
    }
    if (distribution == "ggx") {
      plan_rough(tolerance, [](double u, double v) { return vcavity::GgxSlopes<double>(u, v); });
    } else if (distribution == "beckmann") {
      plan_rough(tolerance, [](double u, double v) { return vcavity::BeckmannSlopes<double>(u, v); });
    } else if (distribution == "brushed") {
      plan_rough(tolerance, [&](double u, double) {
        return vcavity::BrushedSlopes(vcavity::GgxSlopes<double>(u), static_cast<double>(concentration));
      });
    } else {
      plan_grooves(tolerance);
    }
  }

  /// Numbers of a range, both ends included; one if it is no range.
  static std::vector<double> steps(double low, double high, int count) {
    std::vector<double> result{low};
    for (int i = 1; i <= count && high > low; ++i) result.push_back(low + (high - low) * i / count);
    return result;
  }

  void plan_grooves(double tolerance) {
    constexpr float step_nm = 10;
    const auto [narrowest, widest] = *aperture.range();
    if (!tilted) {
      std::vector<vcavity::Cavity<double>> grooves;
      for (const double angle : steps(narrowest, widest, 8)) grooves.emplace_back(vcavity::radians(angle));
      effects = vgroove::planned_effects(grooves, materials(step_nm), tolerance, is_polarized_v<Spectrum>);
      return;
    }
    // A plan takes four times as long as for equal panels; grooves that tilt either way have the same.
    const auto [low, high] = *tilt.range();
    const double least = low * high > 0 ? std::min(std::abs(low), std::abs(high)) : 0.0;
    std::vector<vcavity::AsymmetricGroove<double>> grooves;
    for (const double angle : steps(narrowest, widest, 4))
      for (const double tilt_deg : steps(least, std::max(std::abs(low), std::abs(high)), 2))
        grooves.emplace_back(vcavity::radians(angle), vcavity::radians(tilt_deg));
    effects = vgroove::planned_effects(grooves, materials(step_nm), tolerance, is_polarized_v<Spectrum>);
  }

  template <class Make>
  void plan_rough(double tolerance, Make&& make) {
    std::vector distributions{make(roughness_u->range()->low, roughness_v->range()->low)};
    if (roughness_u->varies() || roughness_v->varies())
      distributions.push_back(make(roughness_u->range()->high, roughness_v->range()->high));
    constexpr float step_nm = 40;  // each takes a hundred times as long as for parallel grooves
    effects = vgroove::planned_effects(distributions, materials(step_nm), tolerance,
                                       is_polarized_v<Spectrum> && follows_fields());
    if (effects.polarization && !follows_fields()) {
      Log(Warn,
          "vgroove: a tolerance of %g calls for polarisation, which rough surfaces do not follow in "
          "vectorised "
          "variants",
          tolerance);
      effects.polarization = false;
      effects.error_bound.reset();
    }
    constexpr int most = 4096;  // of RoughGrooveBsdf
    effects.max_bounces = std::min(effects.max_bounces, most);
  }

  /// What the surface consists of, as far as it is known at load; the brightest tint where there are many.
  std::vector<vgroove::TintedIndex> materials(float step_nm) const {
    std::vector<vgroove::TintedIndex> result;
    for_each_spectrum(step_nm, [&](const SurfaceInteraction3f& si) {
      const UnpolarizedSpectrum n = eta->eval(si), extinction = k->eval(si);
      const UnpolarizedSpectrum part = tint_varies() ? UnpolarizedSpectrum(1.f) : tint->eval(si);
      for (std::size_t i = 0; i < dr::size_v<UnpolarizedSpectrum>; ++i) {
        const vgroove::TintedIndex material{vgroove::Index::of(static_cast<float>(number_of(n[i])),
                                                               static_cast<float>(number_of(extinction[i]))),
                                            vgroove::tint_of(static_cast<float>(number_of(part[i])))};
        if (std::find(result.begin(), result.end(), material) == result.end()) result.push_back(material);
      }
    });
    return result;
  }

  /// Calls `use` with interactions whose wavelengths, if the variant has any, cover what Mitsuba renders.
  template <class Use>
  static void for_each_spectrum([[maybe_unused]] float step_nm, Use&& use) {
    SurfaceInteraction3f si = dr::zeros<SurfaceInteraction3f>();
    if constexpr (is_spectral_v<Spectrum>) {
      constexpr std::size_t lanes = dr::size_v<Wavelength>;
      for (float start = MI_CIE_MIN; start <= MI_CIE_MAX; start += step_nm * lanes) {
        for (std::size_t i = 0; i < lanes; ++i)
          si.wavelengths[i] =
              std::min(start + step_nm * static_cast<float>(i), static_cast<float>(MI_CIE_MAX));
        use(si);
      }
    } else {
      use(si);
    }
  }
};

NAMESPACE_END(mitsuba)
