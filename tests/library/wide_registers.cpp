// SPDX-License-Identifier: BSD-3-Clause
// What of the library depends on the width of registers, to be compiled for wide ones.

#include <array>
#include <vcavity/vcavity.hpp>

using Rgb = vcavity::Pack<float, 3>;

Rgb rough_metal(const vcavity::Vec3<float>& wo, const vcavity::Vec3<float>& wi);

Rgb rough_metal(const vcavity::Vec3<float>& wo, const vcavity::Vec3<float>& wi) {
  const vcavity::Conductor<Rgb> metal(Rgb(std::array{0.2f, 0.9f, 1.2f}), Rgb(std::array{3.4f, 2.6f, 2.3f}));
  return vcavity::RoughGrooveBsdf(vcavity::GgxSlopes<float>(0.3f), metal).evaluate(wo, wi);
}
