// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// From the reflectance at some wavelengths to a colour.

#include <span>
#include <string>
#include <vector>

#include "tools/colour/colour.hpp"
#include "tools/colour/light.hpp"

namespace vcavity::tools {

/// Whose eye sees the colour.
enum class Observer { cie_1931_2deg, cie_1964_10deg };

/// The contribution of every wavelength of a grid to X, Y and Z, so that the colour of a spectrum is three
/// sums of products.
///
/// The sums are those of CIE 15:2018, section 7.1, but at the resolution of what is summed: over all points of the grid,
/// of the light and of the colour-matching functions, each as wide as half its distance from both neighbours. Between
/// their points all three, and the reflectance, are linear. So a lamp with narrow lines gives the same colour on every
/// grid on which the reflectance is smooth, and where all points coincide, as for an illuminant of the CIE on a grid of
/// 5 nm, the sum is the plain one of the standard. Colour-matching functions are given from 360 to 780 nm in steps of
/// 5 nm and are 0 elsewhere. A perfect reflector has Y = 1 on every grid; on one that misses part of the spectrum its X
/// and Z, and with them the white, differ from those of the illuminant.
class SpectralWeights {
 public:
  /// @param wavelengths_nm ascending; one or more
  /// @throws UsageError if they are not, or if none of them is visible; std::runtime_error if a table in
  /// data/cie cannot be read.
  explicit SpectralWeights(std::span<const double> wavelengths_nm, Illuminant illuminant = Illuminant::d65,
                           Observer observer = Observer::cie_1931_2deg);

  /// The same in any light.
  /// @throws UsageError also if the light is not given at a visible wavelength
  SpectralWeights(std::span<const double> wavelengths_nm, const Light& light, Observer observer);

  /// The weights, in the order of the wavelengths.
  const std::vector<Xyz>& weights() const { return weights_; }

  /// The colour of a perfect reflector, Y = 1: the reference white of to_lab().
  const Xyz& white() const { return white_; }

  /// The colour of a reflectance spectrum.
  /// @param reflectance one value for each wavelength of the grid
  Xyz colour(std::span<const double> reflectance) const;

 private:
  std::vector<Xyz> weights_;
  Xyz white_{};
};

}  // namespace vcavity::tools
