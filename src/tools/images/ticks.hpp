// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Round numbers for the axes of figures.

#include <string>
#include <vector>

namespace vcavity::tools {

/// A mark on an axis; marks between the labelled ones have no label.
struct Tick {
  double value;
  std::string label;
};

/// Ticks at multiples of 1, 2 or 5 times a power of ten within [low, high], as dense as `most` (at least 2)
/// allows. Throws std::invalid_argument unless low < high and both are finite.
std::vector<Tick> linear_ticks(double low, double high, int most);

/// Ticks for a logarithmic axis within [low, high], at most `most` (at least 2) of them with a label: powers
/// of ten, with minor ticks between neighbouring ones; 1, 2 and 5 times powers of ten, or linear ticks, where
/// the range is short. Throws std::invalid_argument unless 0 < low < high < infinity.
std::vector<Tick> log_ticks(double low, double high, int most);

}  // namespace vcavity::tools
