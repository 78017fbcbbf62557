// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/spectral_weights.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <initializer_list>
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

void check_ascending(std::span<const double> wavelengths_nm) {
  if (wavelengths_nm.empty()) throw UsageError("a colour needs at least one wavelength");
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
    if (!std::isfinite(wavelengths_nm[i]) || (i > 0 && !(wavelengths_nm[i] > wavelengths_nm[i - 1])))
      throw UsageError("wavelength " + text_of(wavelengths_nm[i]) +
                       " nm breaks the grid: a colour needs ascending wavelengths");
}

/// All points of the grid, and those of the tables between its ends; ascending.
std::vector<double> points_of_sum(std::span<const double> grid_nm,
                                  std::initializer_list<const LinearTable*> tables) {
  std::vector<double> points(grid_nm.begin(), grid_nm.end());
  for (const LinearTable* table : tables)
    for (const double nm : table->nodes())
      if (grid_nm.front() < nm && nm < grid_nm.back()) points.push_back(nm);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// How much of the spectrum a point stands for: half of the distance to either neighbour. The first and the last stand
/// for as much beyond the end, as in the plain sum.
double width_of_point(const std::vector<double>& points, std::size_t i) {
  if (points.size() == 1) return 1;
  if (i == 0) return points[1] - points[0];
  if (i + 1 == points.size()) return points[i] - points[i - 1];
  return (points[i + 1] - points[i - 1]) / 2;
}

}  // namespace

SpectralWeights::SpectralWeights(std::span<const double> wavelengths_nm, Illuminant illuminant,
                                 Observer observer)
    : SpectralWeights(wavelengths_nm, cie_illuminant(illuminant), observer) {}

SpectralWeights::SpectralWeights(std::span<const double> wavelengths_nm, const Light& light,
                                 Observer observer) {
  check_ascending(wavelengths_nm);
  const auto [x_bar, y_bar, z_bar] = read_matching_functions(observer);
  const std::vector<double> points = points_of_sum(wavelengths_nm, {&light.power, &x_bar, &y_bar, &z_bar});

  weights_.assign(wavelengths_nm.size(), Xyz{0, 0, 0});
  double perfect_y = 0;
  std::size_t above = 0;  // the first wavelength of the grid at the point or above it
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double nm = points[i];
    if (covers(y_bar, nm) && !covers(light.power, nm))
      throw UsageError("light '" + light.name + "' is given from " + text_of(light.power.min_x()) + " to " +
                       text_of(light.power.max_x()) + " nm, which leaves out " + text_of(nm) + " nm");
    const double power = width_of_point(points, i) * at_or_zero(light.power, nm);
    const Xyz seen{power * at_or_zero(x_bar, nm), power * at_or_zero(y_bar, nm),
                   power * at_or_zero(z_bar, nm)};
    perfect_y += seen.y;
    // The reflectance at the point is the mean of those of the grid around it, by their distances.
    while (wavelengths_nm[above] < nm) ++above;
    const auto add = [&seen, this](std::size_t wavelength, double share) {
      weights_[wavelength].x += share * seen.x;
      weights_[wavelength].y += share * seen.y;
      weights_[wavelength].z += share * seen.z;
    };
    if (wavelengths_nm[above] == nm) {
      add(above, 1);
    } else {
      const double below_nm = wavelengths_nm[above - 1];
      const double share = (nm - below_nm) / (wavelengths_nm[above] - below_nm);
      add(above - 1, 1 - share);
      add(above, share);
    }
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
