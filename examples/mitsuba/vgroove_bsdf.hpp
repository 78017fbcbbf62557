// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The BSDF `vgroove`, of one type for each set of effects, so that no sample asks what a scene calls for.

#include <mitsuba/render/bsdf.h>
#include <mitsuba/render/mueller.h>

#include <concepts>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "parameters.hpp"
#include "spectra.hpp"

NAMESPACE_BEGIN(mitsuba)

/// What is followed at each bounce, as a type.
/// @tparam RealType number type of the directions and reflectances
template <class RealType, bool is_polarized>
struct Following {
  using Real = RealType;
  static constexpr bool polarization = is_polarized;
};

/// Grooves that are the same all over a surface, of facets without a tint.
struct Uniform {
  static constexpr bool varies = false;
  static constexpr bool tinted = false;
};

/// The same with one tint for all.
struct UniformTinted {
  static constexpr bool varies = false;
  static constexpr bool tinted = true;
};

/// Grooves or tints that depend on the point.
struct Varying {
  static constexpr bool varies = true;
  static constexpr bool tinted = true;
};

/// Axes of the grooves in the shading frame: x runs along them, or along most of them.
template <class Real>
struct GrooveAxes {
  Real cosine, sine;

  vcavity::Vec3<Real> to_groove(const vcavity::Vec3<Real>& v) const {
    return {cosine * v.x + sine * v.y, cosine * v.y - sine * v.x, v.z};
  }
  vcavity::Vec3<Real> from_groove(const vcavity::Vec3<Real>& v) const {
    return {cosine * v.x - sine * v.y, cosine * v.y + sine * v.x, v.z};
  }
};

/// Parallel grooves of one aperture, whose light goes into mirror directions.
struct Mirrors {
  static constexpr BSDFFlags kind = BSDFFlags::DeltaReflection;

  /// The shape where it is the same everywhere.
  template <class Real, class Parameters>
  static vcavity::Cavity<Real> shape(const Parameters& parameters) {
    const Real aperture = vcavity::radians(Real(parameters.aperture.constant()));
    return vcavity::Cavity<Real>(std::min(aperture, vcavity::pi<Real>()));
  }

  /// The shape at a point: one sine and cosine, all other angles are sums.
  template <class Real, class Parameters, class Interaction>
  static vcavity::Cavity<Real> shape_at(const Parameters& parameters, const Interaction& si) {
    const Real aperture = vcavity::radians(Real(parameters.aperture.at(si)));
    return vcavity::Cavity<Real>::by_addition(std::min(aperture, vcavity::pi<Real>()));
  }

  template <class Real>
  static vcavity::Vec3<Real> polarization_axis(const vcavity::Vec3<Real>& k) {
    return vcavity::polarization_axis(k);
  }

  /// @param groove a shape, or a function that makes it
  template <class Real, class Groove, class Facet, class Parameters>
  static auto bsdf(const Groove& groove, const Facet& facet, const Parameters& parameters) {
    return vcavity::GrooveBsdf(groove, facet, vcavity::LobeChoice::by_energy, parameters.effects.max_bounces);
  }
};

/// The same with panels that are not equally steep.
struct TiltedMirrors : Mirrors {
  template <class Real, class Parameters>
  static vcavity::AsymmetricGroove<Real> shape(const Parameters& parameters) {
    return {vcavity::radians(Real(parameters.aperture.constant())),
            vcavity::radians(Real(parameters.tilt.constant()))};
  }

  template <class Real, class Parameters, class Interaction>
  static vcavity::AsymmetricGroove<Real> shape_at(const Parameters& parameters, const Interaction& si) {
    const float aperture = std::min(parameters.aperture.at(si), 180 - 4 * Parameters::least_slope);
    const float most = (180 - aperture) / 2 - Parameters::least_slope;
    return {vcavity::Cavity<Real>::by_addition(vcavity::radians(Real(aperture))),
            vcavity::radians(Real(std::clamp(parameters.tilt.at(si), -most, most)))};
  }
};

/// Grooves whose directions are spread around the mirror directions.
/// @tparam Narrow without
template <class Narrow>
struct Spread : Narrow {
  static constexpr BSDFFlags kind = BSDFFlags::GlossyReflection;

  template <class Real, class Groove, class Facet, class Parameters>
  static auto bsdf(const Groove& groove, const Facet& facet, const Parameters& parameters) {
    return vcavity::SpreadGrooveBsdf(Narrow::template bsdf<Real>(groove, facet, parameters),
                                     Real(parameters.lobe_width));
  }
};

/// Patches of grooves of many apertures and directions.
struct Rough {
  static constexpr BSDFFlags kind = BSDFFlags::GlossyReflection;

  /// The axis a of light that travels along k, see rough/mean_axes.hpp: the mean normal, as far as it is normal to k.
  template <class Real>
  static vcavity::Vec3<Real> polarization_axis(const vcavity::Vec3<Real>& k) {
    const Real across = std::hypot(k.x, k.y);
    if (!(across > Real(0))) return {Real(1), Real(0), Real(0)};
    return {-k.z * k.x / across, -k.z * k.y / across, across};
  }

  /// @param distribution of the slopes, or a function that makes it
  template <class Real, class Distribution, class Facet, class Parameters>
  static auto bsdf(const Distribution& distribution, const Facet& facet, const Parameters& parameters) {
    if constexpr (std::invocable<Distribution>) {
      return bsdf<Real>(distribution(), facet, parameters);
    } else {
      using Bsdf = vcavity::RoughGrooveBsdf<Distribution, Facet>;
      const int limit = parameters.effects.max_bounces;
      return Bsdf(distribution, facet, limit == vcavity::all_bounces ? Bsdf::default_max_bounces : limit);
    }
  }
};

/// Rough surfaces by the two roughnesses of a distribution.
/// @tparam Make makes the distribution
template <class Make>
struct RoughOf : Rough {
  template <class Real, class Parameters>
  static auto shape(const Parameters& parameters) {
    return Make{}(parameters, Real(parameters.roughness_u->constant()),
                  Real(parameters.roughness_v->constant()));
  }

  template <class Real, class Parameters, class Interaction>
  static auto shape_at(const Parameters& parameters, const Interaction& si) {
    return Make{}(parameters, Real(parameters.roughness_u->at(si)), Real(parameters.roughness_v->at(si)));
  }
};

struct MakeGgx {
  template <class Parameters, class Real>
  auto operator()(const Parameters&, Real u, Real v) const {
    return vcavity::GgxSlopes<Real>(u, v);
  }
};

struct MakeBeckmann {
  template <class Parameters, class Real>
  auto operator()(const Parameters&, Real u, Real v) const {
    return vcavity::BeckmannSlopes<Real>(u, v);
  }
};

struct MakeBrushed {
  template <class Parameters, class Real>
  auto operator()(const Parameters& parameters, Real u, Real) const {
    return vcavity::BrushedSlopes(vcavity::GgxSlopes<Real>(u), Real(parameters.concentration));
  }
};

/// @tparam Effect a `Following`
/// @tparam Variation `Uniform`, `UniformTinted` or `Varying`
/// @tparam Finish `Mirrors`, `TiltedMirrors`, `Spread` of these, or one of the `Rough` ones
template <typename Float, typename Spectrum, class Effect, class Variation, class Finish>
class VGroove final : public BSDF<Float, Spectrum> {
 public:
  MI_IMPORT_BASE(BSDF, m_flags, m_components)
  MI_IMPORT_TYPES(Texture)
  using Parameters = GrooveParameters<Float, Spectrum>;

  VGroove(const Properties& props, const Parameters& parameters)
      : Base(props),
        parameters_(parameters),
        axes_(rotated(parameters.rotation.constant())),
        shape_(shape_of_all(parameters)) {
    m_flags = Finish::kind | BSDFFlags::Anisotropic | BSDFFlags::FrontSide;
    m_components.push_back(m_flags);
    fit();
  }

  std::pair<BSDFSample3f, Spectrum> sample(const BSDFContext& context, const SurfaceInteraction3f& si,
                                           Float u_lobe, const Point2f& u_direction, Mask) const override {
    BSDFSample3f result = dr::zeros<BSDFSample3f>();
    if (!context.is_enabled(Finish::kind)) return {result, 0.f};
    const Axes axes = axes_at(si);
    const Vector wo = axes.to_groove(vector(si.wi));
    const auto drawn = with_bsdf(si, [&](const auto& bsdf) {
      const Real u(u_lobe);
      if constexpr (discrete)
        return bsdf.sample(wo, u, transport(context));
      else
        return bsdf.sample(wo, u, {Real(u_direction.x()), Real(u_direction.y())}, transport(context));
    });
    if (!drawn) return {result, 0.f};
    result.wo = vector(axes.from_groove(drawn->direction));
    result.pdf = static_cast<float>(drawn->probability);
    result.eta = 1.f;
    result.sampled_type = +Finish::kind;
    result.sampled_component = 0;
    return {result, spectrum(drawn->weight, axes, wo, drawn->direction, transport(context))};
  }

  Spectrum eval(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wi,
                Mask) const override {
    if constexpr (discrete) {
      return 0.f;
    } else {
      if (!context.is_enabled(Finish::kind)) return 0.f;
      const Axes axes = axes_at(si);
      const Vector wo_groove = axes.to_groove(vector(si.wi)), wi_groove = axes.to_groove(vector(wi));
      return spectrum(
          with_bsdf(
              si, [&](const auto& bsdf) { return bsdf.evaluate(wo_groove, wi_groove, transport(context)); }),
          axes, wo_groove, wi_groove, transport(context));
    }
  }

  Float pdf(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wi,
            Mask) const override {
    if constexpr (discrete) {
      return 0.f;
    } else {
      if (!context.is_enabled(Finish::kind)) return 0.f;
      const Axes axes = axes_at(si);
      return static_cast<float>(with_bsdf(si, [&](const auto& bsdf) {
        return bsdf.pdf(axes.to_groove(vector(si.wi)), axes.to_groove(vector(wi)));
      }));
    }
  }

  std::pair<Spectrum, Float> eval_pdf(const BSDFContext& context, const SurfaceInteraction3f& si,
                                      const Vector3f& wi, Mask active) const override {
    if constexpr (std::is_base_of_v<Rough, Finish>) {
      if (!context.is_enabled(Finish::kind)) return {0.f, 0.f};
      const Axes axes = axes_at(si);
      const Vector wo_groove = axes.to_groove(vector(si.wi)), wi_groove = axes.to_groove(vector(wi));
      const auto both = with_bsdf(si, [&](const auto& bsdf) {
        return bsdf.evaluate_with_pdf(wo_groove, wi_groove, transport(context));
      });
      return {spectrum(both.value, axes, wo_groove, wi_groove, transport(context)),
              static_cast<float>(both.pdf)};
    } else {
      return {eval(context, si, wi, active), pdf(context, si, wi, active)};
    }
  }

  void traverse(TraversalCallback* callback) override {
    callback->put("eta", parameters_.eta, ParamFlags::NonDifferentiable);
    callback->put("k", parameters_.k, ParamFlags::NonDifferentiable);
  }

  void parameters_changed(const std::vector<std::string>& keys) override {
    Base::parameters_changed(keys);
    fit();
  }

  std::string to_string() const override { return parameters_.in_words(); }

  MI_DECLARE_CLASS(VGroove)

 private:
  using Real = typename Effect::Real;
  using Values = vgroove::Values<Real, UnpolarizedSpectrum>;
  using Vector = vcavity::Vec3<Real>;
  using Axes = GrooveAxes<Real>;
  static constexpr bool discrete = Finish::kind == BSDFFlags::DeltaReflection;

  static vcavity::Transport transport(const BSDFContext& context) {
    return context.mode == TransportMode::Radiance ? vcavity::Transport::radiance
                                                   : vcavity::Transport::importance;
  }

  static Vector vector(const Vector3f& v) { return {Real(v.x()), Real(v.y()), Real(v.z())}; }
  static Vector3f vector(const Vector& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }

  static Axes rotated(float rotation_deg) {
    const Real rotation = vcavity::radians(Real(rotation_deg));
    return {std::cos(rotation), std::sin(rotation)};
  }

  /// The shape of all points, if there is one.
  static auto shape_of_all(const Parameters& parameters) {
    if constexpr (Variation::varies) {
      using Shape = decltype(Finish::template shape<Real>(parameters));
      return parameters.shape_varies() ? std::optional<Shape>()
                                       : std::optional<Shape>(Finish::template shape<Real>(parameters));
    } else {
      return Finish::template shape<Real>(parameters);
    }
  }

  Axes axes_at([[maybe_unused]] const SurfaceInteraction3f& si) const {
    if constexpr (!Variation::varies)
      return axes_;
    else
      return varying_axes_at(si);
  }

  Axes varying_axes_at(const SurfaceInteraction3f& si) const {
    const Axes axes = rotated(parameters_.rotation.at(si));
    if (!parameters_.axis) return axes;
    const Vector3f axis = si.to_local(*parameters_.axis);
    const float length = std::sqrt(axis.x() * axis.x() + axis.y() * axis.y());
    // An axis along the normal marks no direction on the surface; ∂p/∂u serves.
    constexpr float shortest = 1e-6f;
    if (!(length > shortest)) return axes;
    const Real x(axis.x() / length), y(axis.y() / length);
    return {axes.cosine * x - axes.sine * y, axes.sine * x + axes.cosine * y};
  }

  Values tint_at(const SurfaceInteraction3f& si) const {
    const UnpolarizedSpectrum tint = parameters_.tint->eval(si);
    Values values;
    for (std::size_t i = 0; i < dr::size_v<UnpolarizedSpectrum>; ++i)
      values[i] = Real(vgroove::tint_of(tint[i]));
    return values;
  }

  auto facet_at(const SurfaceInteraction3f& si) const {
    const auto conductor = vgroove::conductor<Real>(parameters_.eta->eval(si), parameters_.k->eval(si));
    if constexpr (Variation::tinted)
      return vgroove::Tinted(conductor, tint_at(si));
    else
      return conductor;
  }

  /// The BSDF of a point, whose facets are given.
  template <class Facet>
  auto bsdf_at([[maybe_unused]] const SurfaceInteraction3f& si, const Facet& facet) const {
    if constexpr (Variation::varies) {
      const auto make = [&] { return shape_ ? *shape_ : Finish::template shape_at<Real>(parameters_, si); };
      return Finish::template bsdf<Real>(make, facet, parameters_);
    } else {
      return Finish::template bsdf<Real>(shape_, facet, parameters_);
    }
  }

  using FittedFacet = vcavity::RationalFacet<Values>;

  /// A rough surface whose colours do not depend on the wavelengths of a ray.
  static constexpr bool may_be_fitted = std::is_base_of_v<Rough, Finish> && !Effect::polarization &&
                                        std::is_same_v<UnpolarizedSpectrum, Color<float, 3>>;

  /// Makes Fresnel's formula a rational function once and for all, where that is as exact, and the BSDF with it where
  /// all points have the same.
  void fit() {
    if constexpr (may_be_fitted) {
      fitted_.reset();
      if (parameters_.index_varies()) return;
      const auto si = dr::zeros<SurfaceInteraction3f>();
      const auto facet = vgroove::fitted_conductor(parameters_.eta->eval(si), parameters_.k->eval(si));
      if (!facet) return;
      if constexpr (Variation::varies)
        fitted_.emplace(*facet);
      else if constexpr (Variation::tinted)
        fitted_.emplace(bsdf_at(si, facet->dimmed(tint_at(si))));
      else
        fitted_.emplace(bsdf_at(si, *facet));
    }
  }

  /// What `fit` makes; of no use for other surfaces.
  static auto nothing_fitted() {
    if constexpr (!may_be_fitted)
      return std::nullopt;
    else if constexpr (Variation::varies)
      return std::optional<FittedFacet>();
    else
      return std::optional<decltype(Finish::template bsdf<Real>(
          std::declval<const decltype(shape_of_all(std::declval<const Parameters&>()))&>(),
          std::declval<const FittedFacet&>(), std::declval<const Parameters&>()))>();
  }

  /// Calls `use` with the BSDF at a point.
  template <class Use>
  auto with_bsdf(const SurfaceInteraction3f& si, const Use& use) const {
    if constexpr (may_be_fitted) {
      if (fitted_) {
        if constexpr (Variation::varies)
          return use(bsdf_at(si, parameters_.tinted ? fitted_->dimmed(tint_at(si)) : *fitted_));
        else
          return use(*fitted_);
      }
    }
    if constexpr (Effect::polarization)
      return use(bsdf_at(si, vcavity::polarized(facet_at(si))));
    else
      return use(bsdf_at(si, facet_at(si)));
  }

  /// A weight of unpolarised light.
  static Spectrum spectrum(const Values& weight, const Axes&, const Vector&, const Vector&,
                           vcavity::Transport) {
    return depolarizer<Spectrum>(vgroove::to_spectrum<UnpolarizedSpectrum>(weight));
  }

  /// A Mueller matrix, from the axes of vcavity to those of Mitsuba.
  /// @param wo,wi directions away from the surface, in the frame of the groove
  static Spectrum spectrum(const vcavity::Mueller<Values>& weight, const Axes& axes, const Vector& wo,
                           const Vector& wi, vcavity::Transport transport) {
    if constexpr (is_polarized_v<Spectrum>) {
      const bool towards_wo = transport == vcavity::Transport::radiance;
      const Vector in = towards_wo ? -wi : -wo, out = towards_wo ? wo : wi;
      Spectrum result;
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
          result(row, column) = vgroove::to_spectrum<UnpolarizedSpectrum>(weight(row, column));
      const auto shading = [&axes](const Vector& v) { return vector(axes.from_groove(v)); };
      const Vector3f forward_in = shading(in), forward_out = shading(out);
      return mueller::rotate_mueller_basis(
          result, forward_in, shading(Finish::polarization_axis(in)), mueller::stokes_basis(forward_in),
          forward_out, shading(Finish::polarization_axis(out)), mueller::stokes_basis(forward_out));
    } else {
      return vgroove::to_spectrum<UnpolarizedSpectrum>(unpolarized(weight));
    }
  }

  Parameters parameters_;
  Axes axes_;  // where they are the same everywhere
  decltype(shape_of_all(std::declval<const Parameters&>())) shape_;
  decltype(nothing_fitted()) fitted_ = nothing_fitted();
};

/// Calls `use` with the types of the cheapest BSDF that a scene's parameters allow.
template <typename Float, typename Spectrum, class Use>
auto with_types(const GrooveParameters<Float, Spectrum>& parameters, Use&& use) {
  const auto spread = [&]<class Effect, class Variation, class Narrow>(Effect effect, Variation variation,
                                                                       Narrow narrow) {
    return parameters.lobe_width > 0 ? use(effect, variation, Spread<Narrow>{})
                                     : use(effect, variation, narrow);
  };
  const auto finished = [&](auto effect, auto variation) {
    return parameters.tilted ? spread(effect, variation, TiltedMirrors{})
                             : spread(effect, variation, Mirrors{});
  };
  const auto rough = [&](auto effect, auto variation) {
    if (parameters.distribution == "ggx") return use(effect, variation, RoughOf<MakeGgx>{});
    if (parameters.distribution == "beckmann") return use(effect, variation, RoughOf<MakeBeckmann>{});
    return use(effect, variation, RoughOf<MakeBrushed>{});
  };
  const auto grooved = [&]<class Real>(Real, auto variation) {
    return parameters.effects.polarization ? finished(Following<Real, true>{}, variation)
                                           : finished(Following<Real, false>{}, variation);
  };
  const auto in_precision = [&](auto variation) {
    return parameters.effects.double_precision ? grooved(double{}, variation) : grooved(float{}, variation);
  };
  const bool varying = parameters.varies() || parameters.tint_varies();
  if (!parameters.is_rough())
    return varying || parameters.tinted ? in_precision(Varying{}) : in_precision(Uniform{});
  // Plans of rough surfaces never ask for double precision.
  const auto followed = [&](auto variation) {
    return parameters.effects.polarization ? rough(Following<float, true>{}, variation)
                                           : rough(Following<float, false>{}, variation);
  };
  if (varying) return followed(Varying{});
  return parameters.tinted ? followed(UniformTinted{}) : followed(Uniform{});
}

NAMESPACE_END(mitsuba)
