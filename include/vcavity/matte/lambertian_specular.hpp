// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Panels that reflect one part of the light by Lambert's law and another like a mirror, the latter alike at every
/// angle.
///
/// Method. The mirror images of a panel stand at multiples of the aperture, and each sends what a panel at that angle
/// would, times the power of the specular reflectance ρ_s: κ̂ becomes Σ_m ρ_s^m κ̂_{(m+1)α} over (m+1)α < π, and H of
/// the diffuse reflectance ρ_d follows as for matte panels.
///
/// When not to use it: for specular reflectance that grows with the angle of incidence, as Fresnel's does; no such
/// reduction is known for it. Only the bi-hemispherical reflectance is offered.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "vcavity/matte/interreflection_kernel.hpp"
#include "vcavity/matte/lambertian_cavity.hpp"

namespace vcavity {

/// The kernels of a groove and of the grooves that its mirror images form, to be shared by all wavelengths.
template <class Real>
class SpecularInterreflectionKernel {
 public:
  explicit SpecularInterreflectionKernel(const Cavity<Real>& cavity)
      : sin_half_(cavity.sin_half()), images_(InterreflectionKernel<Real>::images(cavity)) {}

  /// Bi-hemispherical reflectance, 1 − ((1−ρ_d−ρ_s)/sin(α/2)) [H² − (1−ρ_s)(H²−1)/ρ_d].
  /// @param diffuse,specular ρ_d and ρ_s, both ≥ 0, of sum at most 1
  Real bihemispherical(const Real& diffuse, const Real& specular) const {
    using std::expm1;
    using std::log1p;
    // ln H² = −(2/π) ∫ ln(1 − ρ_d κ̂) dv / cosh v; with ρ_d = 0 what it is per ρ_d.
    Real log_mean(0);
    Real mean_kernel(0);
    for (const auto& node : images_) {
      Real kernel(0);
      for (auto image = node.transforms.rbegin(); image != node.transforms.rend(); ++image)
        kernel = kernel * specular + *image;
      log_mean -= node.weight * log1p(Real(-diffuse * kernel));
      mean_kernel += node.weight * kernel;
    }
    const Real excess = expm1(log_mean);
    const Real excess_per_albedo = diffuse > Real(0) ? Real(excess / diffuse) : mean_kernel;
    return Real(1) - (Real(1) - diffuse - specular) / sin_half_ *
                         (Real(1) + excess - (Real(1) - specular) * excess_per_albedo);
  }

 private:
  Real sin_half_;
  std::vector<typename InterreflectionKernel<Real>::ImageNode> images_;
};

/// Bi-hemispherical reflectance of a groove with panels that reflect `diffuse` by Lambert's law and `specular` like
/// mirrors, to an absolute error of some ε/sin(α/2).
///
/// @param kernel of the groove; it serves all wavelengths
/// @param diffuse,specular numbers, colours or packs of wavelengths, in [0, 1] and of sum at most 1
/// @throws std::invalid_argument when a component is out of range
template <class Real, class Value>
Value bihemispherical_reflectance(const SpecularInterreflectionKernel<Real>& kernel, const Value& diffuse,
                                  const Value& specular) {
  detail::check_albedo(diffuse);
  detail::check_albedo(specular);
  detail::check_albedo(diffuse + specular);
  return value_of_components<Value>([&](std::size_t i) {
    return kernel.bihemispherical(Real(component(diffuse, i)), Real(component(specular, i)));
  });
}

}  // namespace vcavity
