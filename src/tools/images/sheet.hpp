// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A page of disc maps: hemispheres side by side, with labels, a colour bar and where the numbers come from.
///
/// A disc is the Lambert azimuthal equal-area projection of the hemisphere,
/// (u, v) = 2 sin(θ/2) (cos φ, sin φ), so u (to the right) crosses the groove and v (upwards) runs along it.

#include <optional>
#include <string>
#include <vector>

#include "tools/images/atomic_file.hpp"
#include "tools/images/colour_map.hpp"

namespace vcavity::tools {

/// A point of a disc whose rim has radius 1; u to the right, v upwards.
struct DiscPoint {
  double u, v;
};

/// A line across a disc.
using DiscLine = std::vector<DiscPoint>;

/// A few letters on a disc, centred on a point.
struct DiscNote {
  DiscPoint at;
  std::string text;
  double room;  ///< drawn only if no wider than this, in radii
};

/// A hemisphere as a square picture that the disc just fills; pixels outside the disc are transparent.
struct DiscMap {
  std::string label;
  int size = 0;               ///< pixels along one side
  std::vector<Rgba8> pixels;  ///< size × size, row by row from the top
  std::vector<DiscLine> contours = {};
  std::vector<DiscNote> notes = {};
};

/// What the colours of a sheet mean.
struct ColourBar {
  ColourMap map = ColourMap::viridis;
  double low = 0;   ///< value of the first colour
  double high = 1;  ///< value of the last colour
  std::string label;
};

/// Lines of equal θ and φ over each disc.
enum class AngleGrid { hidden, shown };

/// A page of disc maps.
struct Sheet {
  std::string title;
  std::vector<std::string> subtitle;  ///< one paragraph each
  std::vector<DiscMap> discs;
  std::optional<ColourBar> colour_bar;
  AngleGrid grid = AngleGrid::hidden;
  std::string footnote;
  int columns = 0;      ///< discs in a row; 0 chooses
  double width = 1200;  ///< of the page in CSS pixels; the height follows
  double scale = 1;     ///< pixels of a PNG for each CSS pixel
};

/// Draws a sheet as PNG or SVG, by the extension of the target. The caller commits the file.
/// Throws std::invalid_argument for a sheet without discs, a disc whose pixels are not size × size, a colour
/// bar unless low < high, text that is not UTF-8, or another extension.
void write_sheet(AtomicFile& file, const Sheet& sheet);

}  // namespace vcavity::tools
