// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/light.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "tools/support/data_path.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_file.hpp"

namespace vcavity::tools {
namespace {

Light read_light(const std::filesystem::path& file, std::string name) {
  const auto rows = parse_rows(read_text(file), 2, file);
  std::vector<LinearTable::Sample> samples;
  bool dark = true;
  for (const auto& [line, values] : rows) {
    if (values[1] < 0) throw malformed(file, line, "the power of a light must not be negative");
    dark = dark && values[1] == 0;
    samples.push_back({values[0], values[1]});
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
  return read_light(file, file.filename().string());
}

}  // namespace vcavity::tools
