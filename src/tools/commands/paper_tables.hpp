// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The tables of the paper: the printed numbers, the computed ones, and what to think of the difference.

#include <string>
#include <vector>

#include "tools/support/text_table.hpp"

namespace vcavity::tools {

inline constexpr const char* paper_glass_index = "1.5";
inline constexpr const char* paper_silver_index = "0.1249+3.3391i";  ///< at 550 nm

/// Tables 1 and 2 with printed and computed values side by side, and the further numbers that the report
/// quotes.
struct PaperTables {
  TextTable table1;  ///< bi-hemispherical reflectance of silver and glass for six apertures
  TextTable table2;  ///< silver at 45° with at most 1, 2, 3 and 4 bounces
  std::vector<std::string> provenance;
  double silver_45 = 0;    ///< silver, 45°, all bounces
  double silver_flat = 0;  ///< flat silver, as a single integral over the angle of incidence
  double furnace = 0;      ///< a white groove of 45°: 1 if no light is lost or counted twice
};

/// Computes both tables, to 1e-13.
PaperTables compute_paper_tables();

/// The text that ties figures and tables together, in Markdown.
std::string paper_report(const PaperTables& tables);

}  // namespace vcavity::tools
