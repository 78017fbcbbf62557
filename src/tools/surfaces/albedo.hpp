// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The albedo of panels as a function of wavelength, from what a user writes: a number, a colour, a table.

#include <functional>
#include <string>
#include <string_view>

namespace vcavity::tools {

/// Reflectance of a panel, the same from all directions, as a function of wavelength.
class Albedo {
 public:
  /// @param specification a number from 0 to 1; an sRGB colour `#rrggbb`; or a table with a heading such as
  ///        wavelength_nm,reflectance, see spreadsheet.hpp; percentages where it says so
  /// @param option the words were given to, for messages
  /// @throws UsageError for anything else; std::runtime_error "FILE:LINE: ..." where a file is malformed
  Albedo(const std::string& specification, const std::string& option);

  /// The words it was made from; of a file its name without folder and extension.
  const std::string& name() const { return name_; }

  /// What the numbers are from, in a line.
  const std::string& source() const { return source_; }

  /// The albedo at a wavelength, linear between the rows of a table.
  /// @throws UsageError where a table has no data or a colour is not visible: nothing is extrapolated
  double at(double wavelength_nm) const { return at_(wavelength_nm); }

 private:
  std::string name_;
  std::string source_;
  std::function<double(double wavelength_nm)> at_;
};

/// The albedos of panel one and two.
struct PanelAlbedos {
  Albedo one;
  Albedo two;
  bool differ;  ///< whether two were given

  /// "0.5", "0.9/0.3"
  std::string name() const { return differ ? one.name() + "/" + two.name() : one.name(); }
};

/// The albedos that a user's words stand for: one for both panels, or two, ONE/TWO.
/// @throws as `Albedo`
PanelAlbedos load_albedos(std::string_view specification);

}  // namespace vcavity::tools
