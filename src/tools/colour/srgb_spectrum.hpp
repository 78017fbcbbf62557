// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// From a colour to a reflectance spectrum that has it.
///
/// Infinitely many spectra do; this is the smooth one of W. Jakob and J. Hanika, "A low-dimensional function space for
/// efficient spectral upsampling", Computer Graphics Forum 38(2), 147-155 (2019): ρ(λ) = ½ + p/(2√(1 + p²)) with p a
/// quadratic polynomial of the wavelength, never outside [0, 1]. Greys are the same at every wavelength.
/// When not to use it: where the spectrum itself is known, measured ones are not as smooth.

#include <array>

#include "tools/colour/colour.hpp"

namespace vcavity::tools {

/// A smooth reflectance spectrum from 360 to 780 nm.
class SrgbSpectrum {
 public:
  /// The spectrum whose colour under D65, for the 2 degree observer, comes closest to a linear sRGB colour.
  /// @param colour components in [0, 1]
  /// @throws std::runtime_error if a table in data/cie cannot be read
  explicit SrgbSpectrum(const LinearRgb& colour);

  /// The reflectance at a wavelength.
  double at(double wavelength_nm) const;

  /// By how much the colour of the spectrum differs from that asked for: the largest difference of a component.
  double error() const { return error_; }

 private:
  bool grey_ = false;
  double grey_reflectance_ = 0;
  std::array<double, 3> coefficients_{};  // of p, ascending powers
  double error_ = 0;
};

}  // namespace vcavity::tools
