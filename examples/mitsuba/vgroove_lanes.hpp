// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The BSDF `vgroove` of the vectorised variants: parallel grooves, many directions at once, with derivatives.
///
/// The same headers of vcavity as in the scalar variants, called with arrays of Dr.Jit (lanes.hpp). Each direction has
/// at most four lobes, or six where panels are not equally steep (lobe_slots.hpp), which are found in as many steps as
/// the narrowest groove of the surface has bounces at most: a bound that is known when a scene is loaded or its
/// parameters change, not a loop in the kernel.
///
/// Derivatives with respect to the aperture, the tilt, the index and the tint pass through weights, throughputs and
/// directions; probabilities are detached, as Mitsuba's are.

#include <mitsuba/render/bsdf.h>
#include <mitsuba/render/mueller.h>

#include <array>
#include <sstream>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "lanes.hpp"
#include "lanes_bsdf.hpp"
#include "spectra.hpp"

NAMESPACE_BEGIN(mitsuba)

template <typename Float, typename Spectrum>
class VGrooveLanes final : public LanesBsdf<Float, Spectrum> {
 public:
  MI_IMPORT_BASE(LanesBsdf, parameters_, kind_, axes_at, index_at, tint_at, vector)
  MI_IMPORT_TYPES()
  using typename Base::Axes, typename Base::Parameters;
  using typename Base::Real, typename Base::Values, typename Base::Vector;

  VGrooveLanes(const Properties& props, const Parameters& parameters)
      : Base(props, parameters,
             parameters.lobe_width > 0 ? BSDFFlags::GlossyReflection : BSDFFlags::DeltaReflection) {
    bound_bounces();
  }

  std::pair<BSDFSample3f, Spectrum> sample(const BSDFContext& context, const SurfaceInteraction3f& si,
                                           Float u_lobe, const Point2f& u_direction,
                                           Mask active) const override {
    return with_facet(si, active, [&](const auto& facet) {
      return with_seen(si, active, [&](const auto& seen) {
        return sample_of(facet, seen, context, si, u_lobe, u_direction, active);
      });
    });
  }

  Float pdf(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wi,
            Mask active) const override {
    return eval_pdf(context, si, wi, active).second;
  }

  std::pair<Spectrum, Float> eval_pdf(const BSDFContext& context, const SurfaceInteraction3f& si,
                                      const Vector3f& wi, Mask active) const override {
    if (is_discrete() || !context.is_enabled(kind_)) return {dr::zeros<Spectrum>(), dr::zeros<Float>()};
    active &= si.wi.z() >= 0.f && wi.z() >= 0.f;
    return with_facet(si, active, [&](const auto& facet) {
      return with_seen(si, active, [&](const auto& seen) {
        const auto slots =
            vcavity::lobe_slots(seen.groove, seen.towards, facet, parameters_.effects.max_bounces);
        const Vector local = seen.mirrored(seen.axes.to_groove(vector(wi)));
        const auto both = spread(slots, odds(slots), local);
        return std::pair<Spectrum, Float>(
            dr::select(active, spectrum(both.first, seen, local, context.mode), dr::zeros<Spectrum>()),
            dr::select(active, both.second.array, 0.f));
      });
    });
  }

  void traverse(TraversalCallback* callback) override {
    // A change of the aperture moves the directions of mirrors, and of what is seen in them.
    callback->put("aperture", parameters_.aperture.texture(), ParamFlags::Differentiable);
    if (parameters_.tilted) callback->put("tilt", parameters_.tilt.texture(), ParamFlags::Differentiable);
    Base::traverse(callback);
  }

  void parameters_changed(const std::vector<std::string>& keys) override {
    Base::parameters_changed(keys);
    bound_bounces();
  }

  MI_DECLARE_CLASS(VGrooveLanes)

 private:
  /// What is seen at a point from a direction.
  template <class Groove>
  struct Seen {
    Groove groove;
    Axes axes;
    Vector towards;  ///< in the frame of the groove; of equal panels mirrored so that panel one faces it
    Float side;      ///< −1 where it is mirrored, else 1

    /// A direction in the frame of the groove, mirrored like `towards`; and back.
    Vector mirrored(const Vector& v) const { return {v.x, Real(side * v.y.array), v.z}; }
  };

  bool is_discrete() const { return !(parameters_.lobe_width > 0); }

  /// So many bounces are followed as the narrowest groove has at most.
  void bound_bounces() {
    const auto& range = parameters_.aperture.range();
    const double narrowest = range ? range->low : parameters_.aperture.smallest();
    if (!(narrowest >= narrowest_aperture))
      Throw(
          "vgroove: in %s an aperture must not be less than %g, for all bounces are part of the kernel, not "
          "%g",
          Base::Variant, narrowest_aperture, narrowest);
    max_bounces_ = vcavity::Cavity<double>(vcavity::radians(narrowest)).max_bounces();
  }

  /// Calls `use` with what is seen at a point.
  template <class Use>
  auto with_seen(const SurfaceInteraction3f& si, Mask active, Use&& use) const {
    const Float aperture = parameters_.aperture.at(si, active);
    const vcavity::Cavity<Real> groove(Real(dr::minimum(dr::deg_to_rad(aperture), dr::Pi<float>)),
                                       max_bounces_);
    const Axes axes = axes_at(si, active);
    Vector wo = axes.to_groove(vector(si.wi));
    wo.z = at_least(wo.z, Real(0));
    if (parameters_.tilted) {
      const Float most = dr::maximum(90.f - 0.5f * aperture - Parameters::least_slope, 0.f);
      const Float tilt = dr::clip(parameters_.tilt.at(si, active), -most, most);
      const vcavity::AsymmetricGroove<Real> tilted(groove, Real(dr::deg_to_rad(tilt)));
      return use(Seen<vcavity::AsymmetricGroove<Real>>{tilted, axes, wo, Float(1.f)});
    }
    const Float side = dr::select(wo.y.array < 0.f, Float(-1.f), Float(1.f));
    return use(Seen<vcavity::Cavity<Real>>{groove, axes, Vector{wo.x, magnitude(wo.y), wo.z}, side});
  }

  /// Calls `use` with the facet of a point.
  template <class Use>
  auto with_facet(const SurfaceInteraction3f& si, Mask active, Use&& use) const {
    const auto [n, k] = index_at(si, active);
    const vcavity::Conductor<Values> conductor(n, k);
    if (!parameters_.tinted)
      return parameters_.effects.polarization ? use(vcavity::polarized(conductor)) : use(conductor);
    const vgroove::Tinted tinted(conductor, tint_at(si, active));
    return parameters_.effects.polarization ? use(vcavity::polarized(tinted)) : use(tinted);
  }

  /// The probabilities of the lobes.
  template <class Slots>
  static auto odds(const Slots& slots) {
    auto result = vcavity::slot_probabilities(slots, [](const auto& light) {
      using vcavity::unpolarized;
      return largest(unpolarized(light));
    });
    for (Real& probability : result) probability = dr::detach(probability.array);
    return result;
  }

  template <class Facet, class AnySeen>
  std::pair<BSDFSample3f, Spectrum> sample_of(const Facet& facet, const AnySeen& seen,
                                              const BSDFContext& context, const SurfaceInteraction3f& si,
                                              const Float& u_lobe, const Point2f& u_direction,
                                              Mask active) const {
    BSDFSample3f result = dr::zeros<BSDFSample3f>();
    if (!context.is_enabled(kind_)) return {result, dr::zeros<Spectrum>()};
    const auto slots = vcavity::lobe_slots(seen.groove, seen.towards, facet, parameters_.effects.max_bounces);
    const auto probabilities = odds(slots);
    auto drawn = vcavity::drawn_slot(slots, probabilities, Real(u_lobe));
    // Rounding may have put a direction below the horizon.
    drawn.direction.z = at_least(drawn.direction.z, Real(0));
    active &= si.wi.z() >= 0.f && drawn.probability.array > 0.f;
    if (!is_discrete()) {
      const Vector mean{dr::detach(drawn.direction.x.array), dr::detach(drawn.direction.y.array),
                        dr::detach(drawn.direction.z.array)};
      drawn.direction =
          distribution().sample(mean, vcavity::Vec2<Real>{Real(u_direction.x()), Real(u_direction.y())});
      drawn.direction.z = magnitude(drawn.direction.z);
      std::tie(drawn.light, drawn.probability) = spread(slots, probabilities, drawn.direction);
      active &= drawn.probability.array > 0.f;
    }
    result.wo = vector(seen.axes.from_groove(seen.mirrored(drawn.direction)));
    result.pdf = dr::select(active, drawn.probability.array, 0.f);
    result.eta = 1.f;
    result.sampled_type = +kind_;
    result.sampled_component = 0;
    const Spectrum light = spectrum(drawn.light, seen, drawn.direction, context.mode);
    return {result, dr::select(active, light / drawn.probability.array, dr::zeros<Spectrum>())};
  }

  vcavity::VonMisesFisher<float> distribution() const {
    return vcavity::VonMisesFisher<float>(parameters_.lobe_width);
  }

  /// The light that lobes of a width send in a direction per steradian, and the density of drawing it; as in
  /// `SpreadGrooveBsdf`.
  template <class Slots, class Probabilities>
  auto spread(const Slots& slots, const Probabilities& probabilities, const Vector& wi) const {
    using Power = std::remove_cvref_t<decltype(slots[0].light)>;
    if (is_discrete()) return std::pair<Power, Real>(Power(0), Real(0));
    const vcavity::VonMisesFisher<float> around = distribution();
    const Vector below{wi.x, wi.y, -wi.z};
    std::pair<Power, Real> result(Power(0), Real(0));
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const Vector mean{slots[i].direction.x, slots[i].direction.y, at_least(slots[i].direction.z, Real(0))};
      const Real density = around.density(mean, wi) + around.density(mean, below);
      result.first = result.first + vcavity::scaled(density, slots[i].light);
      result.second = result.second + probabilities[i] * Real(dr::detach(density.array));
    }
    return result;
  }

  template <class AnySeen>
  static Spectrum spectrum(const Values& light, const AnySeen&, const Vector&, TransportMode) {
    return depolarizer<Spectrum>(light.array);
  }

  /// A Mueller matrix, from the mirrored axes of vcavity to those of Mitsuba.
  /// @param wi where the light comes from or goes to, mirrored like `seen.towards`
  template <class AnySeen>
  static Spectrum spectrum(const vcavity::Mueller<Values>& from_wo, const AnySeen& seen, const Vector& wi,
                           TransportMode mode) {
    const bool towards_wo = mode == TransportMode::Radiance;
    const vcavity::Mueller<Values> light = towards_wo ? reversed(from_wo) : from_wo;
    if constexpr (is_polarized_v<Spectrum>) {
      Spectrum result;
      for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
          // A mirror image turns the other way: U and V change sign.
          const UnpolarizedSpectrum element = light(row, column).array;
          result(row, column) = (row < 2) == (column < 2) ? element : element * seen.side;
        }
      }
      const Vector wo_groove = seen.mirrored(seen.towards), wi_groove = seen.mirrored(wi);
      const Vector out = towards_wo ? wo_groove : wi_groove;
      const Vector to_source = towards_wo ? wi_groove : wo_groove;
      const Vector in{-to_source.x, -to_source.y, -to_source.z};
      const auto shading = [&seen](const Vector& v) { return vector(seen.axes.from_groove(v)); };
      const Vector3f forward_in = shading(in), forward_out = shading(out);
      return mueller::rotate_mueller_basis(
          result, forward_in, shading(polarization_axis(in)), mueller::stokes_basis(forward_in), forward_out,
          shading(polarization_axis(out)), mueller::stokes_basis(forward_out));
    } else {
      return unpolarized(light).array;
    }
  }

  /// As vcavity::polarization_axis, with masks in place of branches.
  static Vector polarization_axis(const Vector& k) {
    const Real size = at_least(at_least(magnitude(k.y), magnitude(k.z)), vcavity::smallest_divisor<Real>());
    const Real y = k.y / size, z = k.z / size;
    const Real across = sqrt(at_least(y * y + z * z, vcavity::smallest_divisor<Real>()));
    const auto is_along = vcavity::smallest_divisor<Real>() >= size;
    return {select(is_along, Real(0), across * size), select(is_along, Real(0), -k.x * y / across),
            select(is_along, Real(1), -k.x * z / across)};
  }

  /// More bounces make kernels that take long to compile.
  static constexpr double narrowest_aperture = 2;  // degrees

  int max_bounces_;
};

NAMESPACE_END(mitsuba)
