// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The BSDF `vgroove` of the vectorised variants: rough surfaces, many directions at once, with derivatives.
///
/// The sums of lockstep_rough_bsdf.hpp as loops of the kernel. Directions are drawn, and densities given, without
/// derivatives; those with respect to the roughness, the index, the tint and the rotation are in the values, which
/// depend smoothly on all of them at every pair of directions.

#include <mitsuba/render/bsdf.h>
#include <mitsuba/render/mueller.h>

#include <optional>
#include <type_traits>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "lanes.hpp"
#include "lanes_bsdf.hpp"
#include "symbolic_sum.hpp"

NAMESPACE_BEGIN(mitsuba)

/// GGX in lanes.
struct GgxLanes {
  explicit GgxLanes(float) {}

  template <class Real>
  vcavity::GgxSlopes<Real> slopes(const Real& along_u, const Real& along_v) const {
    return {along_u, along_v};
  }
};

/// Beckmann in lanes.
struct BeckmannLanes {
  explicit BeckmannLanes(float) {}

  template <class Real>
  vcavity::BeckmannSlopes<Real> slopes(const Real& along_u, const Real& along_v) const {
    return {along_u, along_v};
  }
};

/// Brushed grooves in lanes, all of one concentration.
struct BrushedLanes {
  explicit BrushedLanes(float concentration) : azimuths(concentration) {}

  template <class Real>
  vcavity::BrushedSlopes<vcavity::GgxSlopes<Real>, float> slopes(const Real& roughness, const Real&) const {
    return {vcavity::GgxSlopes<Real>(roughness), azimuths};
  }

  vcavity::AxialVonMises<float> azimuths;
};

/// The index at many points, as the arrays that derivatives are asked for.
/// @tparam Values colours of lanes.hpp
template <class Values>
struct IndexPoints {
  Values eta, k;

  auto facet() const { return vcavity::Conductor<Values>(eta, k); }

  auto fields_() { return dr::tie(eta, k); }
  auto fields_() const { return dr::tie(eta, k); }
};

/// An index that is the same at all points, and with respect to which there are no derivatives: its reflectance as a
/// rational function, without roots.
/// @tparam Values colours of lanes.hpp
template <class Values>
struct FittedIndex {
  vcavity::RationalFacet<Values> reflectance;

  const vcavity::RationalFacet<Values>& facet() const { return reflectance; }

  auto fields_() { return dr::tie(); }
  auto fields_() const { return dr::tie(); }
};

/// A surface at many points, as the arrays that derivatives are asked for.
/// @tparam Finish one of the above
/// @tparam Index one of the above
/// @tparam Real,Values numbers and colours of lanes.hpp
template <class Finish, class Index, class Real, class Values>
struct RoughPoints {
  Finish finish;
  Index index;
  Real along_u, along_v;  ///< roughness
  Values tint;            ///< factor on the reflectance of each bounce

  auto slopes() const { return finish.slopes(along_u, along_v); }
  auto facet() const { return vgroove::Tinted(index.facet(), tint); }

  auto fields_() { return dr::tie(index, along_u, along_v, tint); }
  auto fields_() const { return dr::tie(index, along_u, along_v, tint); }
};

/// @tparam Finish one of the above
template <typename Float, typename Spectrum, class Finish>
class VGrooveRoughLanes final : public LanesBsdf<Float, Spectrum> {
 public:
  MI_IMPORT_BASE(LanesBsdf, parameters_, kind_, axes_at, index_at, tint_at, vector)
  MI_IMPORT_TYPES()
  using typename Base::Axes, typename Base::Parameters;
  using typename Base::Real, typename Base::Values, typename Base::Vector;

  VGrooveRoughLanes(const Properties& props, const Parameters& parameters)
      : Base(props, parameters, BSDFFlags::GlossyReflection), finish_(parameters.concentration) {
    fit();
  }

  std::pair<BSDFSample3f, Spectrum> sample(const BSDFContext& context, const SurfaceInteraction3f& si,
                                           Float u_ray, const Point2f& u_groove, Mask active) const override {
    if (!context.is_enabled(kind_)) return {dr::zeros<BSDFSample3f>(), dr::zeros<Spectrum>()};
    return with_bsdf(si, active,
                     [&](const auto& bsdf) { return drawn_from(bsdf, si, u_ray, u_groove, active); });
  }

  Float pdf(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wi,
            Mask active) const override {
    if (!context.is_enabled(kind_)) return dr::zeros<Float>();
    const Axes axes = axes_at(si, active);
    const Float density = with_bsdf(si, active, [&](const auto& bsdf) {
      return bsdf.pdf(axes.to_groove(vector(si.wi)), axes.to_groove(vector(wi))).array;
    });
    return dr::select(active, dr::detach(density), 0.f);
  }

  std::pair<Spectrum, Float> eval_pdf(const BSDFContext& context, const SurfaceInteraction3f& si,
                                      const Vector3f& wi, Mask active) const override {
    if (!context.is_enabled(kind_)) return {dr::zeros<Spectrum>(), dr::zeros<Float>()};
    const Axes axes = axes_at(si, active);
    const auto both = with_bsdf(si, active, [&](const auto& bsdf) {
      return bsdf.evaluate_with_pdf(axes.to_groove(vector(si.wi)), axes.to_groove(vector(wi)));
    });
    return {dr::select(active, depolarizer<Spectrum>(both.value.array), dr::zeros<Spectrum>()),
            dr::select(active, dr::detach(both.pdf.array), 0.f)};
  }

  void traverse(TraversalCallback* callback) override {
    if (parameters_.anisotropic) {
      callback->put("alpha_u", parameters_.roughness_u->texture(), ParamFlags::Differentiable);
      callback->put("alpha_v", parameters_.roughness_v->texture(), ParamFlags::Differentiable);
    } else {
      callback->put("roughness", parameters_.roughness_u->texture(), ParamFlags::Differentiable);
    }
    Base::traverse(callback);
  }

  void parameters_changed(const std::vector<std::string>& keys) override {
    Base::parameters_changed(keys);
    fit();
  }

  MI_DECLARE_CLASS(VGrooveRoughLanes)

 private:
  /// Whether a density is finite, and so is its inverse.
  static Mask is_density(const Float& x) {
    return x >= vcavity::smallest_divisor<float>() && x <= dr::Largest<float>;
  }

  template <class Bsdf>
  std::pair<BSDFSample3f, Spectrum> drawn_from(const Bsdf& bsdf, const SurfaceInteraction3f& si, Float u_ray,
                                               const Point2f& u_groove, Mask active) const {
    BSDFSample3f result = dr::zeros<BSDFSample3f>();
    const Axes axes = axes_at(si, active);
    const Axes fixed_axes{dr::detach(axes.cosine), dr::detach(axes.sine)};
    const auto drawn = bsdf.draw(fixed_axes.to_groove(vector(Vector3f(dr::detach(si.wi)))), Real(u_ray),
                                 {Real(u_groove.x()), Real(u_groove.y())});
    result.wo = dr::detach(vector(fixed_axes.from_groove(drawn.ray.leaving())));
    active &= si.wi.z() >= 0.f && drawn.ray.way().bounces.array <= static_cast<float>(bsdf.max_bounces());
    const Vector wo = axes.to_groove(vector(si.wi)), wi = axes.to_groove(vector(result.wo));
    const auto all = bsdf.evaluate_with_pdf(wo, wi);
    const Mask is_missed = active && !is_density(all.pdf.array);
    const auto alone = bsdf.evaluate_drawn(wo, wi, drawn, vgroove::LaneMask<Mask>{is_missed});
    const Float density = dr::detach(dr::select(is_missed, alone.pdf.array, all.pdf.array));
    const UnpolarizedSpectrum value = dr::select(is_missed, alone.value.array, all.value.array);
    active &= is_density(density);
    result.pdf = dr::select(active, density, 0.f);
    result.eta = 1.f;
    result.sampled_type = +kind_;
    result.sampled_component = 0;
    return {result, dr::select(active, depolarizer<Spectrum>(UnpolarizedSpectrum(value / density)),
                               dr::zeros<Spectrum>())};
  }

  template <class Index>
  auto bsdf_at(const SurfaceInteraction3f& si, Mask active, const Index& index) const {
    constexpr int unless_limited =
        vcavity::RoughGrooveBsdf<vcavity::GgxSlopes<float>, vcavity::Conductor<float>>::default_max_bounces;
    const int limit = parameters_.effects.max_bounces;
    const Float along_u = parameters_.roughness_u->at(si, active);
    const Float along_v = parameters_.anisotropic ? parameters_.roughness_v->at(si, active) : along_u;
    using Points = RoughPoints<Finish, Index, Real, Values>;
    return vcavity::LockstepRoughBsdf<Points, vgroove::SymbolicSummation>(
        Points{finish_, index, Real(at_each(si, along_u)), Real(at_each(si, along_v)),
               Values(at_each(si, tint_at(si, active).array))},
        limit == vcavity::all_bounces ? unless_limited : limit);
  }

  /// Calls `use` with the BSDF of some points.
  template <class Use>
  auto with_bsdf(const SurfaceInteraction3f& si, Mask active, const Use& use) const {
    const auto [eta, k] = index_at(si, active);
    if constexpr (may_be_fitted)
      if (fitted_ && !dr::grad_enabled(eta.array, k.array)) return use(bsdf_at(si, active, *fitted_));
    return use(bsdf_at(si, active, IndexPoints<Values>{at_each(si, eta.array), at_each(si, k.array)}));
  }

  /// Parameters that are the same everywhere come as arrays of one entry. Next to longer ones, loops of Dr.Jit have no
  /// derivatives forwards with respect to them.
  template <class Array>
  static Array at_each(const SurfaceInteraction3f& si, const Array& array) {
    return dr::select(si.wi.z() >= -dr::Largest<float>, array, 0.f);
  }

  /// Colours that do not depend on the wavelengths of a ray.
  static constexpr bool may_be_fitted = std::is_same_v<UnpolarizedSpectrum, Color<Float, 3>>;

  /// Makes Fresnel's formula a rational function once and for all, where that is as exact and all points have the same.
  void fit() {
    if constexpr (may_be_fitted) {
      fitted_.reset();
      const auto si = dr::zeros<SurfaceInteraction3f>();
      const UnpolarizedSpectrum eta = parameters_.eta->eval(si), k = parameters_.k->eval(si);
      if (parameters_.index_varies() || dr::grad_enabled(eta, k)) return;
      using Colour = Color<float, 3>;
      const auto number = [](const UnpolarizedSpectrum& x) {
        return Colour(static_cast<float>(number_of(x[0])), static_cast<float>(number_of(x[1])),
                      static_cast<float>(number_of(x[2])));
      };
      const auto facet = vgroove::fitted_conductor(number(eta), number(k));
      if (!facet) return;
      // Kernels take them as inputs, so that all materials share one.
      fitted_.emplace(facet->template in<Values>([](const vgroove::Values<float, Colour>& of_colours) {
        return Values(UnpolarizedSpectrum(dr::opaque<Float>(of_colours[0]), dr::opaque<Float>(of_colours[1]),
                                          dr::opaque<Float>(of_colours[2])));
      }));
    }
  }

  Finish finish_;
  std::optional<FittedIndex<Values>> fitted_;  // of no use for spectra
};

NAMESPACE_END(mitsuba)
