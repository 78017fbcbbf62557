// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The rows of a table as curves.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/images/plot.hpp"

namespace vcavity::tools {

/// A value and what it belongs to.
struct PlottedRow {
  nlohmann::ordered_json fields;  ///< material, shape, wavelength: what distinguishes the row from others
  double value;
};

/// The values over the number in the fields that changes most often, a curve for each combination of the others.
/// @param value_label of the vertical axis
/// @throws UsageError when no number changes
Plot plot_of(const std::vector<PlottedRow>& rows, const std::string& value_label);

}  // namespace vcavity::tools
