// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/light.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/support/data_path.hpp"
#include "tools/support/error.hpp"
#include "tools/support/spreadsheet.hpp"
#include "tools/support/text_file.hpp"
#include "tools/support/utf8.hpp"

namespace vcavity::tools {
namespace {

/// Wavelengths in nm unless a heading names another unit.
Light read_light(const std::filesystem::path& file, std::string name) {
  std::vector<LinearTable::Sample> samples;
  bool dark = true;
  bool first = true;
  double um_per_unit = 1e-3;
  for (const CellRow& row : read_spreadsheet(file)) {
    if (row.comment) continue;
    const bool heading = std::exchange(first, false) && !cell_number(row.cells.front());
    if (heading) {
      const auto units = units_per_um(row.cells.front());
      if (!units)
        throw malformed(
            file, row.line,
            "'" + row.cells.front() + "' names no unit of wavelengths, expected such as wavelength_nm,power");
      um_per_unit = 1 / *units;
      continue;
    }
    std::vector<double> numbers;
    for (const std::string& cell : row.cells) {
      const auto number = cell_number(cell);
      if (!number || has_doubtful_comma(cell))
        throw malformed(file, row.line, "'" + cell + "' is not a finite number");
      numbers.push_back(*number);
    }
    if (numbers.size() != 2)
      throw malformed(file, row.line, "expected 2 numbers, found " + std::to_string(numbers.size()));
    if (numbers[1] < 0) throw malformed(file, row.line, "the power of a light must not be negative");
    dark = dark && numbers[1] == 0;
    // Nanometres stay what they are, to the last digit.
    samples.push_back({um_per_unit == 1e-3 ? numbers[0] : 1000 * um_per_unit * numbers[0], numbers[1]});
  }
  if (dark) throw malformed(file, 1, "there is no light: expected lines of wavelength in nm and power");
  return {std::move(name), LinearTable(std::move(samples))};
}

}  // namespace

Light cie_illuminant(Illuminant illuminant) {
  const auto read = [](const char* name, const char* file) {
    return read_light(data_directory() / "cie" / file, name);
  };
  switch (illuminant) {
    case Illuminant::a:
      return read("A", "illuminant_a.csv");
    case Illuminant::d65:
      return read("D65", "illuminant_d65.csv");
    case Illuminant::e:
      break;
  }
  return read("E", "illuminant_e.csv");
}

Light load_light(std::string_view specification) {
  const std::string name = lower_case(specification);
  if (name == "a") return cie_illuminant(Illuminant::a);
  if (name == "d65") return cie_illuminant(Illuminant::d65);
  if (name == "e") return cie_illuminant(Illuminant::e);
  const std::filesystem::path file(specification);
  if (!file.has_parent_path() && !file.has_extension())
    throw UsageError("unknown light '" + file.string() +
                     "', expected D65, E, A or a file such as ./lamp.csv");
  return read_light(file, valid_utf8(file.filename().string()));
}

}  // namespace vcavity::tools
