// SPDX-License-Identifier: BSD-3-Clause

/// `vgroove`: a BSDF plug-in for Mitsuba 3, specular V-grooves with all their bounces.
///
/// Parameters:
///  - `material`     name of one of Mitsuba's metals ("Cu", "Ag", …), or
///  - `eta`, `k`     spectra of the index n + ik; k = 0, the default, reflects like a dielectric
///  - `aperture`     angle between the panels in degrees, in (0, 180]; 60 by default
///  - `rotation`     degrees from ∂p/∂u to the groove, counter-clockwise about the normal; 0 by default
///  - `max_bounces`  light that needs more bounces is lost; −1, the default, follows all
///  - `polarized`    whether fields are followed through the groove, or light counts as unpolarised at
///                   each bounce; true in polarised variants, false, like Mitsuba, in others
///  - `lobe_width`   spread of each mirror direction in degrees (spread_bsdf.hpp); 0 by default
///
/// One-sided, like `conductor`. Built for the scalar variants.

#include <mitsuba/core/plugin.h>
#include <mitsuba/core/properties.h>
#include <mitsuba/render/bsdf.h>
#include <mitsuba/render/ior.h>
#include <mitsuba/render/mueller.h>
#include <mitsuba/render/texture.h>

#include <array>
#include <optional>
#include <vcavity/vcavity.hpp>

NAMESPACE_BEGIN(mitsuba)

template <typename Float, typename Spectrum>
class VGroove final : public BSDF<Float, Spectrum> {
 public:
  MI_IMPORT_BASE(BSDF, m_flags, m_components)
  MI_IMPORT_TYPES(Texture)

  explicit VGroove(const Properties& props)
      : Base(props),
        cavity_(vcavity::radians(props.get<float>("aperture", 60.f))),
        polarized_(props.get<bool>("polarized", is_polarized_v<Spectrum>)),
        lobe_width_(vcavity::radians(props.get<float>("lobe_width", 0.f))) {
    const float rotation = vcavity::radians(props.get<float>("rotation", 0.f));
    cos_rotation_ = std::cos(rotation);
    sin_rotation_ = std::sin(rotation);
    const int max_bounces = props.get<int>("max_bounces", -1);
    if (max_bounces == 0 || max_bounces < -1)
      Throw("vgroove: max_bounces must be positive or -1, not %d", max_bounces);
    most_bounces_ = max_bounces < 0 ? vcavity::all_bounces : max_bounces;
    if (props.has_property("material")) {
      if (props.has_property("eta") || props.has_property("k"))
        Throw("vgroove: give either a material or eta and k");
      std::tie(eta_, k_) = complex_ior_from_file<Spectrum, Texture>(props.get<std::string>("material"));
    } else {
      if (!props.has_property("eta")) Throw("vgroove: give a material, or eta and k");
      eta_ = props.get_unbounded_texture<Texture>("eta");
      k_ = props.get_unbounded_texture<Texture>("k", 0.f);
    }
    if (lobe_width_ != 0) (void)vcavity::VonMisesFisher<float>(lobe_width_);  // refuses what is no width
    const BSDFFlags lobes = lobe_width_ > 0 ? BSDFFlags::GlossyReflection : BSDFFlags::DeltaReflection;
    m_flags = lobes | BSDFFlags::Anisotropic | BSDFFlags::FrontSide;
    m_components.push_back(m_flags);
  }

  std::pair<BSDFSample3f, Spectrum> sample(const BSDFContext& context, const SurfaceInteraction3f& si,
                                           Float u_lobe, const Point2f& u_direction, Mask) const override {
    BSDFSample3f result = dr::zeros<BSDFSample3f>();
    Spectrum weight(0.f);
    if (!context.is_enabled(kind())) return {result, weight};
    with_facet(si, [&](const auto& facet) {
      const auto bsdf = grooves(facet);
      const Vector wo = to_groove(si.wi);
      const auto drawn = lobe_width_ > 0
                             ? vcavity::SpreadGrooveBsdf(bsdf, lobe_width_)
                                   .sample(wo, u_lobe, {u_direction.x(), u_direction.y()}, transport(context))
                             : bsdf.sample(wo, u_lobe, transport(context));
      if (!drawn) return;
      result.wo = from_groove(drawn->direction);
      result.pdf = drawn->probability;
      result.eta = 1.f;
      result.sampled_type = +kind();
      result.sampled_component = 0;
      weight = spectrum(drawn->weight, wo, drawn->direction, transport(context));
    });
    return {result, weight};
  }

  Spectrum eval(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wo,
                Mask) const override {
    Spectrum result(0.f);
    if (!(lobe_width_ > 0) || !context.is_enabled(kind())) return result;
    with_facet(si, [&](const auto& facet) {
      const vcavity::SpreadGrooveBsdf bsdf(grooves(facet), lobe_width_);
      const Vector first = to_groove(si.wi), second = to_groove(wo);
      result = spectrum(bsdf.evaluate(first, second, transport(context)), first, second, transport(context));
    });
    return result;
  }

  Float pdf(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wo,
            Mask) const override {
    Float result = 0.f;
    if (!(lobe_width_ > 0) || !context.is_enabled(kind())) return result;
    with_facet(si, [&](const auto& facet) {
      result = vcavity::SpreadGrooveBsdf(grooves(facet), lobe_width_).pdf(to_groove(si.wi), to_groove(wo));
    });
    return result;
  }

  void traverse(TraversalCallback* callback) override {
    callback->put("eta", eta_, ParamFlags::NonDifferentiable);
    callback->put("k", k_, ParamFlags::NonDifferentiable);
  }

  std::string to_string() const override {
    std::ostringstream text;
    text << "VGroove[" << std::endl
         << "  aperture = " << vcavity::degrees(cavity_.aperture()) << "," << std::endl
         << "  polarized = " << polarized_ << "," << std::endl
         << "  lobe_width = " << vcavity::degrees(lobe_width_) << "," << std::endl
         << "  eta = " << string::indent(eta_) << "," << std::endl
         << "  k = " << string::indent(k_) << std::endl
         << "]";
    return text.str();
  }

  MI_DECLARE_CLASS(VGroove)

 private:
  /// One component per colour or wavelength.
  using Wavelengths = vcavity::Pack<float, dr::size_v<UnpolarizedSpectrum>>;
  using Vector = vcavity::Vec3<float>;

  BSDFFlags kind() const {
    return lobe_width_ > 0 ? BSDFFlags::GlossyReflection : BSDFFlags::DeltaReflection;
  }

  static vcavity::Transport transport(const BSDFContext& context) {
    return context.mode == TransportMode::Radiance ? vcavity::Transport::radiance
                                                   : vcavity::Transport::importance;
  }

  static Wavelengths wavelengths(const UnpolarizedSpectrum& spectrum) {
    Wavelengths result;
    // Colours of an index may leave the gamut of their colour space; an index below 0 has no meaning.
    for (std::size_t i = 0; i < dr::size_v<UnpolarizedSpectrum>; ++i) result[i] = std::max(spectrum[i], 0.f);
    return result;
  }

  /// Calls `use` with the facet at a point, whose type says whether it follows polarisation.
  template <class Use>
  void with_facet(const SurfaceInteraction3f& si, Use&& use) const {
    const vcavity::Conductor<Wavelengths> facet(wavelengths(eta_->eval(si, true)),
                                                wavelengths(k_->eval(si, true)));
    if (polarized_)
      use(vcavity::polarized(facet));
    else
      use(facet);
  }

  template <class Facet>
  vcavity::GrooveBsdf<float, Facet> grooves(const Facet& facet) const {
    return {cavity_, facet, vcavity::LobeChoice::by_energy, most_bounces_};
  }

  static UnpolarizedSpectrum unpolarized_spectrum(const Wavelengths& wavelengths) {
    UnpolarizedSpectrum result;
    for (std::size_t i = 0; i < dr::size_v<UnpolarizedSpectrum>; ++i) result[i] = wavelengths[i];
    return result;
  }

  /// A weight of unpolarised light.
  static Spectrum spectrum(const Wavelengths& weight, const Vector&, const Vector&, vcavity::Transport) {
    return depolarizer<Spectrum>(unpolarized_spectrum(weight));
  }

  /// A Mueller matrix, from the axes of vcavity to those of Mitsuba.
  /// @param wo,wi directions away from the surface, in the frame of the groove
  Spectrum spectrum(const vcavity::Mueller<Wavelengths>& weight, const Vector& wo, const Vector& wi,
                    vcavity::Transport transport) const {
    if constexpr (is_polarized_v<Spectrum>) {
      const bool towards_wo = transport == vcavity::Transport::radiance;
      const Vector in = towards_wo ? -wi : -wo, out = towards_wo ? wo : wi;
      Spectrum result;
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
          result(row, column) = unpolarized_spectrum(weight(row, column));
      const Vector3f forward_in = from_groove(in), forward_out = from_groove(out);
      return mueller::rotate_mueller_basis(
          result, forward_in, from_groove(vcavity::polarization_axis(in)), mueller::stokes_basis(forward_in),
          forward_out, from_groove(vcavity::polarization_axis(out)), mueller::stokes_basis(forward_out));
    } else {
      return unpolarized_spectrum(unpolarized(weight));
    }
  }

  /// From the shading frame to the frame of the groove, and back.
  Vector to_groove(const Vector3f& v) const {
    return {cos_rotation_ * v.x() + sin_rotation_ * v.y(), cos_rotation_ * v.y() - sin_rotation_ * v.x(),
            v.z()};
  }
  Vector3f from_groove(const Vector& v) const {
    return {cos_rotation_ * v.x - sin_rotation_ * v.y, cos_rotation_ * v.y + sin_rotation_ * v.x, v.z};
  }

  vcavity::Cavity<float> cavity_;
  bool polarized_;
  float lobe_width_;
  float cos_rotation_;
  float sin_rotation_;
  int most_bounces_;
  ref<Texture> eta_;
  ref<Texture> k_;
};

NAMESPACE_END(mitsuba)

/// Registers the scalar variants; Mitsuba calls it when it loads the plug-in.
extern "C" MI_EXPORT void init_plugin(std::string_view name, mitsuba::PluginRegisterFn register_plugin) {
  using namespace mitsuba;
  const auto add = [&]<class Plugin>(std::type_identity<Plugin>) {
    register_plugin(name, Plugin::Variant, Plugin::Type,
                    [](void*, const Properties& props) -> ref<Object> { return new Plugin(props); });
  };
  using Wavelengths = Spectrum<float, 4>;
  add(std::type_identity<VGroove<float, Color<float, 3>>>());
  add(std::type_identity<VGroove<float, Wavelengths>>());
  add(std::type_identity<VGroove<float, MuellerMatrix<Wavelengths>>>());
}
