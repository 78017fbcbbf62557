// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Reflectance of one mirror and of a path over many, written as in a textbook: complex Snell's law, then
/// Fresnel's two amplitudes with the refracted cosine (Hecht, "Optics", 5th ed., eqs. 4.34 and 4.40). Plain
/// on purpose; the library rearranges these formulas so as to keep its digits, the tracer does not.

#include <algorithm>
#include <complex>
#include <string>
#include <vector>

#include "tracer.hpp"

namespace tracer {

/// What the panels are made of.
struct Material {
  std::string name;
  std::complex<double> index;  ///< n + ik relative to the medium above, k >= 0
};

/// A glass and two metals: the silver of the paper, and a weak metal whose reflectance varies more with the
/// angle.
inline std::vector<Material> example_materials() {
  return {{"dielectric 1.5", {1.5, 0}},
          {"silver 0.1249 + 3.3391i", {0.1249, 3.3391}},
          {"metal 3.2 + 3.3i", {3.2, 3.3}}};
}

/// Reflectance of a mirror for unpolarised light.
/// @param cos_incidence  cosine of the angle of incidence, in [0, 1], or above 1 by rounding
inline double fresnel_reflectance(std::complex<double> index, double cos_incidence) {
  cos_incidence = std::min(cos_incidence, 1.0);  // a traced direction is of unit length but for rounding
  const std::complex<double> sin_refraction = std::sqrt(1 - cos_incidence * cos_incidence) / index;
  const std::complex<double> cos_refraction = std::sqrt(1.0 - sin_refraction * sin_refraction);
  const std::complex<double> perpendicular =
      (cos_incidence - index * cos_refraction) / (cos_incidence + index * cos_refraction);
  const std::complex<double> parallel =
      (index * cos_incidence - cos_refraction) / (index * cos_incidence + cos_refraction);
  return (std::norm(perpendicular) + std::norm(parallel)) / 2;
}

/// Reflectance of a whole path, the light taken as unpolarised before each bounce.
inline double reflectance(const Path& path, const Material& material) {
  double product = 1;
  for (const Bounce& bounce : path.bounces)
    product *= fresnel_reflectance(material.index, bounce.cos_incidence);
  return product;
}

}  // namespace tracer
