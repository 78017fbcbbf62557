// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The BSDF `vgroove`, of one type for each set of effects, so that no sample asks what a scene calls for.

#include <mitsuba/render/bsdf.h>
#include <mitsuba/render/mueller.h>

#include <sstream>
#include <utility>
#include <vcavity/vcavity.hpp>

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

/// Grooves that are the same all over a surface, of untinted facets.
struct Uniform {
  static constexpr bool varies = false;
};

/// Grooves and tints that depend on the point.
struct Varying {
  static constexpr bool varies = true;
};

/// The groove at a point, and its direction in the shading frame.
template <class Real>
struct GrooveAt {
  vcavity::Cavity<Real> cavity;
  Real cosine, sine;

  vcavity::Vec3<Real> to_groove(const vcavity::Vec3<Real>& v) const {
    return {cosine * v.x + sine * v.y, cosine * v.y - sine * v.x, v.z};
  }
  vcavity::Vec3<Real> from_groove(const vcavity::Vec3<Real>& v) const {
    return {cosine * v.x - sine * v.y, cosine * v.y + sine * v.x, v.z};
  }
};

/// Mirror directions.
struct Mirrors {
  static constexpr BSDFFlags kind = BSDFFlags::DeltaReflection;
};

/// Directions spread around the mirror directions.
struct SpreadLobes {
  static constexpr BSDFFlags kind = BSDFFlags::GlossyReflection;
};

/// @tparam Effect a `Following`
/// @tparam Variation `Uniform` or `Varying`
/// @tparam Finish `Mirrors` or `SpreadLobes`
template <typename Float, typename Spectrum, class Effect, class Variation, class Finish>
class VGroove final : public BSDF<Float, Spectrum> {
 public:
  MI_IMPORT_BASE(BSDF, m_flags, m_components)
  MI_IMPORT_TYPES(Texture)
  using Parameters = GrooveParameters<Float, Spectrum>;

  VGroove(const Properties& props, const Parameters& parameters)
      : Base(props), parameters_(parameters), uniform_(uniform_groove(parameters)) {
    m_flags = Finish::kind | BSDFFlags::Anisotropic | BSDFFlags::FrontSide;
    m_components.push_back(m_flags);
  }

  std::pair<BSDFSample3f, Spectrum> sample(const BSDFContext& context, const SurfaceInteraction3f& si,
                                           Float u_lobe, const Point2f& u_direction, Mask) const override {
    BSDFSample3f result = dr::zeros<BSDFSample3f>();
    if (!context.is_enabled(Finish::kind)) return {result, 0.f};
    decltype(auto) groove = groove_at(si);
    const auto bsdf = bsdf_at(si, groove);
    const Vector wo = groove.to_groove(vector(si.wi));
    const auto drawn = [&] {
      const Real u(u_lobe);
      if constexpr (discrete)
        return bsdf.sample(wo, u, transport(context));
      else
        return bsdf.sample(wo, u, {Real(u_direction.x()), Real(u_direction.y())}, transport(context));
    }();
    if (!drawn) return {result, 0.f};
    result.wo = vector(groove.from_groove(drawn->direction));
    result.pdf = static_cast<float>(drawn->probability);
    result.eta = 1.f;
    result.sampled_type = +Finish::kind;
    result.sampled_component = 0;
    return {result, spectrum(drawn->weight, groove, wo, drawn->direction, transport(context))};
  }

  Spectrum eval(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wi,
                Mask) const override {
    if constexpr (discrete) {
      return 0.f;
    } else {
      if (!context.is_enabled(Finish::kind)) return 0.f;
      decltype(auto) groove = groove_at(si);
      const Vector wo_groove = groove.to_groove(vector(si.wi)), wi_groove = groove.to_groove(vector(wi));
      return spectrum(bsdf_at(si, groove).evaluate(wo_groove, wi_groove, transport(context)), groove,
                      wo_groove, wi_groove, transport(context));
    }
  }

  Float pdf(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wi,
            Mask) const override {
    if constexpr (discrete) {
      return 0.f;
    } else {
      if (!context.is_enabled(Finish::kind)) return 0.f;
      decltype(auto) groove = groove_at(si);
      return static_cast<float>(
          bsdf_at(si, groove).pdf(groove.to_groove(vector(si.wi)), groove.to_groove(vector(wi))));
    }
  }

  void traverse(TraversalCallback* callback) override {
    callback->put("eta", parameters_.eta, ParamFlags::NonDifferentiable);
    callback->put("k", parameters_.k, ParamFlags::NonDifferentiable);
  }

  std::string to_string() const override {
    std::ostringstream text;
    text << "VGroove[" << std::endl
         << "  aperture = " << string::indent(parameters_.aperture.texture()) << "," << std::endl
         << "  rotation = " << string::indent(parameters_.rotation.texture()) << "," << std::endl
         << "  effects = " << vgroove::described(parameters_.effects) << "," << std::endl
         << "  lobe_width = " << vcavity::degrees(parameters_.lobe_width) << "," << std::endl
         << "  eta = " << string::indent(parameters_.eta) << "," << std::endl
         << "  k = " << string::indent(parameters_.k) << std::endl
         << "]";
    return text.str();
  }

  MI_DECLARE_CLASS(VGroove)

 private:
  using Real = typename Effect::Real;
  using Values = vgroove::Values<Real, UnpolarizedSpectrum>;
  using Vector = vcavity::Vec3<Real>;
  using Groove = GrooveAt<Real>;
  static constexpr bool discrete = std::is_same_v<Finish, Mirrors>;

  static vcavity::Transport transport(const BSDFContext& context) {
    return context.mode == TransportMode::Radiance ? vcavity::Transport::radiance
                                                   : vcavity::Transport::importance;
  }

  static Vector vector(const Vector3f& v) { return {Real(v.x()), Real(v.y()), Real(v.z())}; }
  static Vector3f vector(const Vector& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }

  static vcavity::Cavity<Real> cavity(float aperture_deg) {
    return vcavity::Cavity<Real>(std::min(vcavity::radians(Real(aperture_deg)), vcavity::pi<Real>()));
  }

  static Groove uniform_groove(const Parameters& parameters) {
    const Real rotation = vcavity::radians(Real(parameters.rotation.constant()));
    return {cavity(parameters.aperture.constant()), std::cos(rotation), std::sin(rotation)};
  }

  decltype(auto) groove_at(const SurfaceInteraction3f& si) const {
    if constexpr (Variation::varies) {
      const float rotation = vcavity::radians(parameters_.rotation.at(si));
      Groove groove{cavity(parameters_.aperture.at(si)), std::cos(rotation), std::sin(rotation)};
      if (parameters_.axis) {
        const Vector3f axis = si.to_local(*parameters_.axis);
        const float length = std::sqrt(axis.x() * axis.x() + axis.y() * axis.y());
        // An axis along the normal marks no direction on the surface; ∂p/∂u serves.
        if (length > 1e-6f) {
          const float x = axis.x() / length, y = axis.y() / length;
          groove = {groove.cavity, groove.cosine * x - groove.sine * y, groove.sine * x + groove.cosine * y};
        }
      }
      return groove;
    } else {
      return static_cast<const Groove&>(uniform_);
    }
  }

  auto facet_at(const SurfaceInteraction3f& si) const {
    const auto conductor = vgroove::conductor<Real>(parameters_.eta->eval(si), parameters_.k->eval(si));
    if constexpr (Variation::varies) {
      const UnpolarizedSpectrum tint = parameters_.tint->eval(si);
      Values values;
      for (std::size_t i = 0; i < dr::size_v<UnpolarizedSpectrum>; ++i)
        values[i] = std::max(Real(tint[i]), Real(0));
      return vgroove::Tinted(conductor, values);
    } else {
      return conductor;
    }
  }

  auto bsdf_at(const SurfaceInteraction3f& si, const Groove& groove) const {
    if constexpr (Effect::polarization)
      return finished(groove, vcavity::polarized(facet_at(si)));
    else
      return finished(groove, facet_at(si));
  }

  template <class Facet>
  auto finished(const Groove& groove, const Facet& facet) const {
    const vcavity::GrooveBsdf<Real, Facet> mirrors(groove.cavity, facet, vcavity::LobeChoice::by_energy,
                                                   parameters_.effects.max_bounces);
    if constexpr (discrete)
      return mirrors;
    else
      return vcavity::SpreadGrooveBsdf(mirrors, Real(parameters_.lobe_width));
  }

  /// A weight of unpolarised light.
  static Spectrum spectrum(const Values& weight, const Groove&, const Vector&, const Vector&,
                           vcavity::Transport) {
    return depolarizer<Spectrum>(vgroove::to_spectrum<UnpolarizedSpectrum>(weight));
  }

  /// A Mueller matrix, from the axes of vcavity to those of Mitsuba.
  /// @param wo,wi directions away from the surface, in the frame of the groove
  static Spectrum spectrum(const vcavity::Mueller<Values>& weight, const Groove& groove, const Vector& wo,
                           const Vector& wi, vcavity::Transport transport) {
    if constexpr (is_polarized_v<Spectrum>) {
      const bool towards_wo = transport == vcavity::Transport::radiance;
      const Vector in = towards_wo ? -wi : -wo, out = towards_wo ? wo : wi;
      Spectrum result;
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
          result(row, column) = vgroove::to_spectrum<UnpolarizedSpectrum>(weight(row, column));
      const auto shading = [&groove](const Vector& v) { return vector(groove.from_groove(v)); };
      const Vector3f forward_in = shading(in), forward_out = shading(out);
      return mueller::rotate_mueller_basis(
          result, forward_in, shading(vcavity::polarization_axis(in)), mueller::stokes_basis(forward_in),
          forward_out, shading(vcavity::polarization_axis(out)), mueller::stokes_basis(forward_out));
    } else {
      return vgroove::to_spectrum<UnpolarizedSpectrum>(unpolarized(weight));
    }
  }

  Parameters parameters_;
  Groove uniform_;
};

/// Calls `use` with the types of the cheapest BSDF that a scene's parameters allow.
template <typename Float, typename Spectrum, class Use>
auto with_types(const GrooveParameters<Float, Spectrum>& parameters, Use&& use) {
  const auto finished = [&]<class Effect, class Variation>(Effect effect, Variation variation) {
    return parameters.lobe_width > 0 ? use(effect, variation, SpreadLobes{})
                                     : use(effect, variation, Mirrors{});
  };
  const auto in_precision = [&]<class Real, class Variation>(Real, Variation variation) {
    return parameters.effects.polarization ? finished(Following<Real, true>{}, variation)
                                           : finished(Following<Real, false>{}, variation);
  };
  if (parameters.varies() || parameters.tinted) return in_precision(float{}, Varying{});
  return parameters.effects.double_precision ? in_precision(double{}, Uniform{})
                                             : in_precision(float{}, Uniform{});
}

NAMESPACE_END(mitsuba)
