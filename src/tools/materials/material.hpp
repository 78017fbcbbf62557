// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The complex refractive index of a material as a function of wavelength.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace vcavity::tools {

/// Complex refractive index n + ik, k >= 0 (time dependence e^{-i omega t}).
struct RefractiveIndex {
  double n;
  double k;
};

/// The wavelengths for which there are data, both ends included; in micrometres, like the published tables.
struct WavelengthRange {
  double min_um;
  double max_um;
};

/// One of the two optical constants, n or k, with the place in the file it was read from.
struct OpticalConstant {
  std::function<double(double wavelength_um)> at;  ///< its value inside `range`
  WavelengthRange range;
  std::filesystem::path file;  ///< empty where the index was given as a number
  int line = 0;
};

/// Everything there is to know about a material.
struct MaterialRecord {
  std::string name;
  std::filesystem::path file;  ///< empty where the index was given as a number
  std::string reference;       ///< who measured it, in one line of plain text
  std::string comments;        ///< temperature, sample and the like; may be empty
  OpticalConstant n;
  std::optional<OpticalConstant> k;  ///< absent: the source is silent, k is taken as 0
};

/// What k is at wavelengths where the source gives n and, though it has k elsewhere, no k.
enum class MissingExtinction {
  refused,  ///< unknown: the wavelength is outside the data
  zero  ///< 0: the material is taken as transparent there, as glasses are measured only where they are not
};

/// A material whose refractive index is known over a range of wavelengths.
class Material {
 public:
  /// @throws std::runtime_error "FILE:LINE: ..." if n and k have no wavelength in common.
  explicit Material(MaterialRecord record, MissingExtinction missing = MissingExtinction::refused);

  /// A material of the same index at every wavelength.
  /// @throws UsageError unless n > 0 and k >= 0, both within what the library computes with
  static Material from_index(RefractiveIndex index, std::string name);

  /// "Cu-Johnson" for a file of the collection, the file's name without extension for others, "1.5" for a
  /// number.
  const std::string& name() const { return record_.name; }

  /// The file the data are from; empty for a constant index.
  const std::filesystem::path& file() const { return record_.file; }

  /// The publication the data are from.
  const std::string& reference() const { return record_.reference; }

  /// What the source says about the sample; may be empty.
  const std::string& comments() const { return record_.comments; }

  /// Where both n and k are known, or taken as 0.
  WavelengthRange range() const { return range_; }

  /// Whether the source gives k; if not, k is 0.
  bool extinction_given() const { return record_.k.has_value(); }

  /// Whether the index is the same at every wavelength.
  bool constant() const { return record_.file.empty(); }

  /// The index at a wavelength, linear between the points of a table.
  ///
  /// A negative k down to -2e-5, noise in the measurement of a transparent material, counts as 0.
  /// @throws UsageError outside range(): nothing is extrapolated
  /// @throws std::runtime_error "FILE:LINE: ..." where the data have n <= 0, a more negative k, or a formula has no
  /// value
  RefractiveIndex at(double wavelength_nm) const;

 private:
  MaterialRecord record_;
  MissingExtinction missing_;
  WavelengthRange range_;
};

}  // namespace vcavity::tools
