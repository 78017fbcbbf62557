// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A white page for figures: cairo with owned resources, one typeface and the file format chosen by the
/// extension. Internal to the figures; coordinates are in CSS pixels from the upper left corner.

#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "tools/images/atomic_file.hpp"
#include "tools/images/colour_map.hpp"

namespace vcavity::tools {

template <auto release>
struct CairoDeleter {
  void operator()(auto* resource) const { release(resource); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDeleter<cairo_surface_destroy>>;
using CairoContext = std::unique_ptr<cairo_t, CairoDeleter<cairo_destroy>>;

/// An opaque or translucent drawing colour, sRGB-encoded, components in [0, 1].
struct Ink {
  double r, g, b;
  double alpha = 1;
};

/// The ink 0xRRGGBB.
Ink ink(unsigned rgb, double alpha = 1);

inline const Ink black = ink(0x1a1a1a);
inline const Ink dark_grey = ink(0x4d4d4d);
inline const Ink mid_grey = ink(0x8c8c8c);
inline const Ink light_grey = ink(0xe3e3e3);

/// How text looks and which point of its baseline stands at the given position.
struct TextStyle {
  enum class Weight { normal, bold };
  enum class Anchor { left, centre, right };
  double size = 12;
  Ink colour = black;
  Anchor anchor = Anchor::left;
  Weight weight = Weight::normal;
};

/// Width of one line of text. Throws std::invalid_argument for text that is not UTF-8.
double text_width(const std::string& text, const TextStyle& style);

/// Breaks text between words into lines no wider than `width`; a single longer word is left whole.
std::vector<std::string> wrap(const std::string& text, const TextStyle& style, double width);

/// Line spacing of paragraphs, as a multiple of the size of the type.
inline constexpr double leading = 1.4;

/// Height of wrapped text.
double paragraph_height(const std::string& text, const TextStyle& style, double width);

/// A page and the means to draw on it.
class Canvas {
 public:
  /// A white page. PNG or SVG by the extension of the target; throws std::invalid_argument for any other.
  /// `scale` is the number of pixels of a PNG for each CSS pixel.
  Canvas(AtomicFile& file, double width, double height, double scale);

  /// For everything that needs no wrapper.
  cairo_t* cairo() const { return context_.get(); }

  /// The colour of the lines and areas that follow.
  void set_ink(const Ink& colour) const;

  /// One line of text; `turn` rotates it about the position, in radians clockwise.
  void text(double x, double y, const std::string& line, const TextStyle& style, double turn = 0) const;

  /// Wrapped text whose first line starts below `top`. Returns where it ends.
  double paragraph(double x, double top, const std::string& text, const TextStyle& style, double width) const;

  /// A straight line with the current ink and line width.
  void line(double x0, double y0, double x1, double y1) const;

  /// A picture of columns × rows pixels, row by row from the top, stretched to a rectangle.
  void picture(double x, double y, double width, double height, int columns, int rows,
               const std::vector<Rgba8>& pixels) const;

  /// Writes the page into the file. Throws std::runtime_error if that fails.
  void finish();

 private:
  AtomicFile& file_;
  bool svg_;
  CairoSurface surface_;
  CairoContext context_;
};

}  // namespace vcavity::tools
