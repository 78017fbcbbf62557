// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Line plots: error against time, indices against wavelength.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/images/atomic_file.hpp"

namespace vcavity::tools {

/// One axis of a plot.
struct Axis {
  enum class Scale { linear, logarithmic };
  std::string label;
  Scale scale = Scale::linear;
  std::optional<std::pair<double, double>> range;  ///< fits the data if absent
};

/// Points that belong together. Points that an axis cannot show (not finite, or not positive on a logarithmic
/// axis) interrupt the line.
struct Series {
  enum class Look { line, markers, line_and_markers };
  std::string name;  ///< in the legend, unless empty
  std::vector<double> x, y;
  Look look = Look::line_and_markers;
};

/// A plot with any number of series.
struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  std::string footnote;
  double width = 800;   ///< in CSS pixels
  double height = 500;  ///< in CSS pixels
  double scale = 1;     ///< pixels of a PNG for each CSS pixel
};

/// Draws a plot as PNG or SVG, by the extension of the target. The caller commits the file.
/// Throws std::invalid_argument for a series with unequal numbers of x and y, a range that an axis cannot
/// show, or another extension.
void write_plot(AtomicFile& file, const Plot& plot);

/// Draws plots below each other, their frames aligned, on a page of the width and scale of the first one.
/// Otherwise as write_plot(). Throws std::invalid_argument if there is none.
void write_plots(AtomicFile& file, const std::vector<Plot>& plots);

}  // namespace vcavity::tools
