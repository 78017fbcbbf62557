// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Maps as pictures for people: discs and pages of them.

#include <cstddef>
#include <string>
#include <vector>

#include "tools/images/sheet.hpp"
#include "tools/maps/disc_map.hpp"

namespace vcavity::tools {

/// A disc in the colours of a colour bar.
/// @param image with the channels Y and A
/// @param scale what Y is multiplied by to be found on the bar; 100 makes percent
DiscMap scalar_disc(const ExrImage& image, const std::string& label, const ColourBar& bar,
                    double scale = 100);

/// A disc in the colours that people would see on a display.
/// @param image with the channels R, G, B (linear sRGB) and A
/// @param white the value of R, G and B that is drawn white
DiscMap colour_disc(const ExrImage& image, const std::string& label, double white = 1);

/// How a page of maps shows them.
struct PictureStyle {
  enum class Tone {
    natural,      ///< the colour, or a grey of that lightness where there is only one wavelength
    false_colour  ///< a perceptually uniform colour map, with a colour bar
  } tone = Tone::natural;
  enum class Contours { hidden, shown } contours = Contours::hidden;  ///< where the number of bounces changes
};

/// Pixels along one side of a disc that is drawn from a map; a page has no room for more.
inline constexpr int picture_size = 640;

/// As many discs as can still be told apart on a page.
inline constexpr std::size_t most_discs = 24;

/// Computes maps and lays them out on a page with one scale: what they have in common stands in the title and
/// what distinguishes them above each.
/// @param requests one or more that differ only in material, aperture and wavelength, all of one wavelength
///                   or all of the same grid; their `size` and `spectrum` do not matter
/// @param progress advanced by picture_size for each of them
/// Throws UsageError for a grid of wavelengths that has no colour.
Sheet map_sheet(std::vector<MapRequest> requests, const PictureStyle& style, Progress& progress);

}  // namespace vcavity::tools
