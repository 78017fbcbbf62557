// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/spectral_weights.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <utility>

#include "tools/data_path.hpp"
#include "tools/error.hpp"
#include "tools/linear_table.hpp"
#include "tools/text_file.hpp"

namespace vcavity::tools {
namespace {

std::string file_name(Observer observer) {
  return observer == Observer::cie_1931_2deg ? "cie_1931_2deg.csv" : "cie_1964_10deg.csv";
}

std::string file_name(Illuminant illuminant) {
  switch (illuminant) {
    case Illuminant::a:
      return "illuminant_a.csv";
    case Illuminant::d65:
      return "illuminant_d65.csv";
    case Illuminant::e:
      break;
  }
  return "illuminant_e.csv";
}

/// The columns beside the wavelength of a table in data/cie, each as a function of the wavelength in nm.
template <std::size_t Columns>
std::array<LinearTable, Columns> read_columns(const std::string& name) {
  const std::filesystem::path file = data_directory() / "cie" / name;
  const auto rows = parse_rows(read_text(file), 1 + Columns, file);
  if (rows.empty()) throw malformed(file, 1, "the table is empty");
  const auto column = [&rows](std::size_t index) {
    std::vector<LinearTable::Sample> samples;
    for (const NumberRow& row : rows) samples.push_back({row.values[0], row.values[index + 1]});
    return LinearTable(std::move(samples));
  };
  return [&column]<std::size_t... Index>(std::index_sequence<Index...>) {
    return std::array{column(Index)...};
  }
  (std::make_index_sequence<Columns>());
}

double at_or_zero(const LinearTable& table, double wavelength_nm) {
  const bool given = table.min_x() <= wavelength_nm && wavelength_nm <= table.max_x();
  return given ? table.at(wavelength_nm) : 0;
}

void check_equally_spaced(std::span<const double> wavelengths_nm) {
  if (wavelengths_nm.empty()) throw UsageError("a colour needs at least one wavelength");
  const double steps = static_cast<double>(wavelengths_nm.size() - 1);
  const double step = steps > 0 ? (wavelengths_nm.back() - wavelengths_nm.front()) / steps : 1;
  // A grid made by adding a rounded step is off by less than this share of a step.
  constexpr double rounding = 1e-6;
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
    const double expected = wavelengths_nm.front() + static_cast<double>(i) * step;
    if (!(step > 0 && std::abs(wavelengths_nm[i] - expected) <= rounding * step)) {
      throw UsageError("wavelength " + std::to_string(wavelengths_nm[i]) +
                       " nm breaks the grid: a colour needs ascending wavelengths in equal steps");
    }
  }
}

}  // namespace

SpectralWeights::SpectralWeights(std::span<const double> wavelengths_nm, Illuminant illuminant,
                                 Observer observer) {
  check_equally_spaced(wavelengths_nm);
  const auto [x_bar, y_bar, z_bar] = read_columns<3>(file_name(observer));
  const auto [power] = read_columns<1>(file_name(illuminant));

  double perfect_y = 0;
  for (const double nm : wavelengths_nm) {
    const double light = at_or_zero(power, nm);
    weights_.push_back(
        {light * at_or_zero(x_bar, nm), light * at_or_zero(y_bar, nm), light * at_or_zero(z_bar, nm)});
    perfect_y += weights_.back().y;
  }
  if (!(perfect_y > 0)) {
    throw UsageError("no wavelength from " + std::to_string(wavelengths_nm.front()) + " to " +
                     std::to_string(wavelengths_nm.back()) +
                     " nm is visible; colours need some within 360 to 780 nm");
  }
  for (Xyz& weight : weights_) weight = {weight.x / perfect_y, weight.y / perfect_y, weight.z / perfect_y};
  white_ = colour(std::vector<double>(weights_.size(), 1.0));
}

Xyz SpectralWeights::colour(std::span<const double> reflectance) const {
  assert(reflectance.size() == weights_.size());
  Xyz sum{0, 0, 0};
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    sum.x += weights_[i].x * reflectance[i];
    sum.y += weights_[i].y * reflectance[i];
    sum.z += weights_[i].z * reflectance[i];
  }
  return sum;
}

}  // namespace vcavity::tools
