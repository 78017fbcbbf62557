// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/spectral_weights.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

#include "tools/support/data_path.hpp"
#include "tools/support/error.hpp"
#include "tools/support/linear_table.hpp"
#include "tools/support/text_file.hpp"

namespace vcavity::tools {
namespace {

std::string file_name(Observer observer) {
  return observer == Observer::cie_1931_2deg ? "cie_1931_2deg.csv" : "cie_1964_10deg.csv";
}

/// Three functions of the wavelength in nm.
using MatchingFunctions = std::array<LinearTable, 3>;

MatchingFunctions read_matching_functions(Observer observer) {
  const std::filesystem::path file = data_directory() / "cie" / file_name(observer);
  const auto rows = parse_rows(read_text(file), 4, file);
  if (rows.empty()) throw malformed(file, 1, "the table is empty");
  const auto column = [&rows](std::size_t index) {
    std::vector<LinearTable::Sample> samples;
    for (const NumberRow& row : rows) samples.push_back({row.values[0], row.values[index]});
    return LinearTable(std::move(samples));
  };
  return {column(1), column(2), column(3)};
}

bool covers(const LinearTable& table, double wavelength_nm) {
  return table.min_x() <= wavelength_nm && wavelength_nm <= table.max_x();
}

std::string text_of(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

double at_or_zero(const LinearTable& table, double wavelength_nm) {
  return covers(table, wavelength_nm) ? table.at(wavelength_nm) : 0;
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
      throw UsageError("wavelength " + text_of(wavelengths_nm[i]) +
                       " nm breaks the grid: a colour needs ascending wavelengths in equal steps");
    }
  }
}

}  // namespace

SpectralWeights::SpectralWeights(std::span<const double> wavelengths_nm, Illuminant illuminant,
                                 Observer observer)
    : SpectralWeights(wavelengths_nm, cie_illuminant(illuminant), observer) {}

SpectralWeights::SpectralWeights(std::span<const double> wavelengths_nm, const Light& light,
                                 Observer observer) {
  check_equally_spaced(wavelengths_nm);
  const auto [x_bar, y_bar, z_bar] = read_matching_functions(observer);

  double perfect_y = 0;
  for (const double nm : wavelengths_nm) {
    if (covers(y_bar, nm) && !covers(light.power, nm))
      throw UsageError("light '" + light.name + "' is given from " + text_of(light.power.min_x()) + " to " +
                       text_of(light.power.max_x()) + " nm, which leaves out " + text_of(nm) + " nm");
    const double power = at_or_zero(light.power, nm);
    weights_.push_back(
        {power * at_or_zero(x_bar, nm), power * at_or_zero(y_bar, nm), power * at_or_zero(z_bar, nm)});
    perfect_y += weights_.back().y;
  }
  if (!(perfect_y > 0)) {
    throw UsageError("no wavelength from " + text_of(wavelengths_nm.front()) + " to " +
                     text_of(wavelengths_nm.back()) +
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
