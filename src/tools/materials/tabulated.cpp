// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/tabulated.hpp"

#include <utility>

#include "tools/support/linear_table.hpp"

namespace vcavity::tools {

OpticalConstant tabulated(const std::vector<NumberRow>& rows, std::size_t column, double units_per_um,
                          const std::filesystem::path& file, int line) {
  std::vector<LinearTable::Sample> samples;
  for (const NumberRow& row : rows) {
    if (row.values[0] <= 0) throw malformed(file, row.line, "the wavelength is not above 0");
    samples.push_back({row.values[0] / units_per_um, row.values[column]});
  }
  const LinearTable table(std::move(samples));
  return {.at = [table](double wavelength_um) { return table.at(wavelength_um); },
          .range = {table.min_x(), table.max_x()},
          .file = file,
          .line = line};
}

}  // namespace vcavity::tools
