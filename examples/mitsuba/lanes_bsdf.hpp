// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What parallel and rough grooves have in common in the vectorised variants: parameters and axes.

#include <mitsuba/render/bsdf.h>

#include <string>
#include <utility>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "lanes.hpp"
#include "parameters.hpp"

NAMESPACE_BEGIN(mitsuba)

template <typename Float, typename Spectrum>
class LanesBsdf : public BSDF<Float, Spectrum> {
 public:
  MI_IMPORT_BASE(BSDF, m_flags, m_components)
  MI_IMPORT_TYPES(Texture)
  using Parameters = GrooveParameters<Float, Spectrum>;

  /// @param kind of reflection
  LanesBsdf(const Properties& props, const Parameters& parameters, BSDFFlags kind)
      : Base(props), parameters_(parameters), kind_(kind) {
    m_flags = kind_ | BSDFFlags::Anisotropic | BSDFFlags::FrontSide;
    m_components.push_back(m_flags);
  }

  Spectrum eval(const BSDFContext& context, const SurfaceInteraction3f& si, const Vector3f& wi,
                Mask active) const override {
    return this->eval_pdf(context, si, wi, active).first;
  }

  void traverse(TraversalCallback* callback) override {
    callback->put("rotation", parameters_.rotation.texture(), ParamFlags::Differentiable);
    callback->put("eta", parameters_.eta, ParamFlags::Differentiable);
    callback->put("k", parameters_.k, ParamFlags::Differentiable);
    callback->put("specular_reflectance", parameters_.tint, ParamFlags::Differentiable);
  }

  void parameters_changed(const std::vector<std::string>& keys) override {
    parameters_.look_again();
    Base::parameters_changed(keys);
  }

  std::string to_string() const override { return parameters_.in_words(); }

  MI_DECLARE_CLASS(LanesBsdf)

 protected:
  using Real = vgroove::Lanes<Float>;
  using Values = vgroove::Lanes<UnpolarizedSpectrum>;
  using Vector = vcavity::Vec3<Real>;

  /// Axes of the grooves in the shading frame: x runs along them.
  struct Axes {
    Float cosine, sine;

    Vector to_groove(const Vector& v) const {
      return {Real(cosine * v.x.array + sine * v.y.array), Real(cosine * v.y.array - sine * v.x.array), v.z};
    }
    Vector from_groove(const Vector& v) const {
      return {Real(cosine * v.x.array - sine * v.y.array), Real(cosine * v.y.array + sine * v.x.array), v.z};
    }
  };

  static Vector vector(const Vector3f& v) { return {Real(v.x()), Real(v.y()), Real(v.z())}; }
  static Vector3f vector(const Vector& v) { return {v.x.array, v.y.array, v.z.array}; }

  Axes axes_at(const SurfaceInteraction3f& si, Mask active) const {
    const auto [sine, cosine] = dr::sincos(dr::deg_to_rad(parameters_.rotation.at(si, active)));
    const Axes axes{cosine, sine};
    if (!parameters_.axis) return axes;
    const Vector3f axis = si.to_local(*parameters_.axis);
    const Float length = dr::sqrt(axis.x() * axis.x() + axis.y() * axis.y());
    // An axis along the normal marks no direction on the surface; ∂p/∂u serves.
    constexpr float shortest = 1e-6f;
    const Mask marks = length > shortest;
    const Float x = dr::select(marks, axis.x() / length, 1.f), y = dr::select(marks, axis.y() / length, 0.f);
    return {axes.cosine * x - axes.sine * y, axes.sine * x + axes.cosine * y};
  }

  /// n and k of the facet of a point.
  std::pair<Values, Values> index_at(const SurfaceInteraction3f& si, Mask active) const {
    return vgroove::index_of_lanes<Values>(parameters_.eta->eval(si, active),
                                           parameters_.k->eval(si, active));
  }

  /// The factor on the reflectance of each bounce.
  Values tint_at(const SurfaceInteraction3f& si, Mask active) const {
    return UnpolarizedSpectrum(dr::clip(parameters_.tint->eval(si, active), 0.f, 1.f));
  }

  Parameters parameters_;
  BSDFFlags kind_;
};

NAMESPACE_END(mitsuba)
