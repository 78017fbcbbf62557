// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Plane waves with a complex field in three dimensions, and mirrors for them: the independent witness of
/// everything the library says about polarisation.

#include <complex>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vcavity/conventions.hpp>
#include <vcavity/polarization/mueller.hpp>

namespace vcavity::test {

using Field = glm::vec<3, std::complex<double>>;

inline std::complex<double> dot(const Field& field, const Vec3<double>& axis) {
  return field.x * axis.x + field.y * axis.y + field.z * axis.z;
}

inline Field along(const Vec3<double>& axis, const std::complex<double>& amplitude) {
  return {amplitude * axis.x, amplitude * axis.y, amplitude * axis.z};
}

/// A wave in space.
struct Wave {
  Vec3<double> k;  ///< direction of travel
  Field field;
};

/// Reflection of a wave by a plane mirror, from the boundary conditions alone: the tangential fields on both
/// sides of the interface agree. (The textbook r_p belongs to the axis p = k × s before and after.)
inline Wave reflected(const Wave& wave, const Vec3<double>& normal, const std::complex<double>& index) {
  const double cosine = -glm::dot(wave.k, normal);
  const Vec3<double> k = wave.k + 2 * cosine * normal;
  const Vec3<double> s = glm::normalize(glm::cross(wave.k, normal));
  const std::complex<double> refracted = std::sqrt(index * index - (1 - cosine * cosine));
  const std::complex<double> r_s = (cosine - refracted) / (cosine + refracted);
  const std::complex<double> r_p =
      (index * index * cosine - refracted) / (index * index * cosine + refracted);
  return {k, along(s, r_s * dot(wave.field, s)) +
                 along(glm::cross(k, s), r_p * dot(wave.field, glm::cross(wave.k, s)))};
}

/// Stokes parameters of a wave in the axes of conventions.hpp.
inline Stokes<double> stokes(const Wave& wave) {
  const Vec3<double> a = polarization_axis(wave.k);
  const std::complex<double> e_a = dot(wave.field, a), e_b = dot(wave.field, glm::cross(wave.k, a));
  const std::complex<double> mixed = 2.0 * e_a * std::conj(e_b);
  return {std::norm(e_a) + std::norm(e_b), std::norm(e_a) - std::norm(e_b), mixed.real(), mixed.imag()};
}

}  // namespace vcavity::test
