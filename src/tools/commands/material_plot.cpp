// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/material_plot.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

#include "tools/materials/facet.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

constexpr int samples = 1200;  // more than the plot has columns

// Values that differ by more than this are too far apart for a linear axis.
constexpr double most_linear_ratio = 12;

// A linear axis shows all of an n and k below this without pressing the smaller one onto the axis.
constexpr double most_linear_index = 20;

Axis::Scale scale_for(bool linear) {
  return linear ? Axis::Scale::linear : Axis::Scale::logarithmic;
}

// A wavelength at a fraction from 0 to 1 of the range, in equal ratios.
double wavelength_um(const WavelengthRange& range, double fraction) {
  const double between = range.min_um * std::pow(range.max_um / range.min_um, fraction);
  return std::clamp(between, range.min_um, range.max_um);
}

struct Sample {
  double n, k;
  double percent;  // reflectance
};

// What a wavelength adds to the curves; not a number where the data are refused.
Sample sample_at(const Material& material, double wavelength_nm) try {
  const RefractiveIndex index = material.at(wavelength_nm);
  return {index.n, index.k, 100 * with_facet(index, [](const auto& facet) { return facet(1.0); })};
} catch (const std::exception&) {
  return {NAN, NAN, NAN};
}

// The axis of n and k: a logarithmic one leaves out what is far too small to matter.
Axis index_axis(const Series& n, const Series& k) {
  Axis axis{"n, k", Axis::Scale::linear, std::nullopt};
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0;
  for (const Series* series : {&n, &k})
    for (const double value : series->y) {
      if (value > 0) lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  axis.scale = scale_for(highest <= most_linear_index);
  if (axis.scale == Axis::Scale::linear) {
    axis.range = {0, highest > 0 ? 1.05 * highest : 1};
  } else {
    axis.range = {std::max(lowest, 1e-5 * highest) / 1.2, 1.2 * highest};
  }
  return axis;
}

}  // namespace

std::vector<Plot> material_plots(const Material& material) {
  if (material.constant())
    throw UsageError("--plot: index '" + material.name() + "' is the same at every wavelength");

  const WavelengthRange range = material.range();
  Series n{"n", {}, {}, Series::Look::line};
  Series k{"k", {}, {}, Series::Look::line};
  Series reflectance{"", {}, {}, Series::Look::line};
  for (int i = 0; i < samples; ++i) {
    const double um = wavelength_um(range, i / (samples - 1.0));
    const Sample sample = sample_at(material, 1000 * um);
    for (const auto& [series, value] :
         {std::pair(&n, sample.n), std::pair(&k, sample.k), std::pair(&reflectance, sample.percent)}) {
      series->x.push_back(um);
      series->y.push_back(value);
    }
  }

  const Axis wavelength{"vacuum wavelength in µm",
                        scale_for(range.max_um <= most_linear_ratio * range.min_um),
                        std::pair(range.min_um, range.max_um)};
  double brightest = 0;
  for (const double percent : reflectance.y) brightest = std::max(brightest, percent);

  Plot constants;
  constants.title = "Refractive index n + ik of " + material.name();
  constants.x = wavelength;
  constants.x.label.clear();
  constants.y = index_axis(n, k);
  constants.series = {n};
  if (material.extinction_given()) {
    constants.series.push_back(k);
  } else {
    constants.title += ", k not given";
  }
  constants.height = 360;

  Plot flat;
  flat.title = "Reflectance of a flat surface at normal incidence";
  flat.x = wavelength;
  flat.y = {"reflectance in %", Axis::Scale::linear, std::pair(0.0, std::min(100.0, 1.2 * brightest + 1e-3))};
  flat.series = {reflectance};
  flat.height = 330;
  flat.footnote = in_one_line(material) + " — " + software() + ", " + command_line();
  return {constants, flat};
}

}  // namespace vcavity::tools
