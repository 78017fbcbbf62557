// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/material.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tools/materials/facet.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_file.hpp"
#include "tools/support/utf8.hpp"

namespace vcavity::tools {
namespace {

/// The most negative k that is still taken for the noise of a transparent material.
constexpr double extinction_noise = 2e-5;

constexpr std::string_view how_to_take_k_as_0 = "--missing-k zero takes k as 0 where only n is given";

std::string text_of(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string text_of(const WavelengthRange& range) {
  return text_of(1000 * range.min_um) + " to " + text_of(1000 * range.max_um) + " nm";
}

}  // namespace

Material::Material(MaterialRecord record, MissingExtinction missing)
    : record_(std::move(record)), missing_(missing), range_(record_.n.range) {
  for (std::string* text : {&record_.name, &record_.reference, &record_.comments}) *text = valid_utf8(*text);
  if (!record_.k) return;
  if (missing_ == MissingExtinction::zero) {
    record_.reference += " (k taken as 0 where it is not given)";
    return;
  }
  const OpticalConstant& k = *record_.k;
  range_ = {std::max(range_.min_um, k.range.min_um), std::min(range_.max_um, k.range.max_um)};
  if (range_.min_um > range_.max_um) {
    throw malformed(k.file, k.line,
                    "n is given from " + text_of(record_.n.range) + " but k from " + text_of(k.range) +
                        ": no wavelength has both; " + std::string(how_to_take_k_as_0));
  }
}

Material Material::from_index(RefractiveIndex index, std::string name) {
  if (!(index.n > 0 && index.k >= 0))
    throw UsageError("refractive index '" + name +
                     "': n must be above 0 and k, in n + ik, must not be negative");
  try {
    with_facet(index, [](const auto&) {});
  } catch (const std::invalid_argument& beyond_the_library) {
    throw UsageError("refractive index '" + name + "': " + beyond_the_library.what());
  }
  const WavelengthRange everywhere{0, std::numeric_limits<double>::infinity()};
  const auto always = [&everywhere](double value) {
    return OpticalConstant{.at = [value](double) { return value; }, .range = everywhere, .file = {}};
  };
  return Material({.name = std::move(name),
                   .file = {},
                   .reference = "constant index",
                   .comments = {},
                   .n = always(index.n),
                   .k = always(index.k)});
}

RefractiveIndex Material::at(double wavelength_nm) const {
  // The division is correctly rounded, so that 380 nm is the very 0.38 um of a table. Ends of a range that
  // are no whole number of nanometres can be off by an ulp.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const double asked_um = wavelength_nm / 1000;
  const double wavelength_um = std::clamp(asked_um, range_.min_um, range_.max_um);
  if (!(std::abs(asked_um - wavelength_um) <= rounding * wavelength_um)) {
    const WavelengthRange& n_range = record_.n.range;
    if (record_.k && n_range.min_um <= asked_um && asked_um <= n_range.max_um)
      throw UsageError("wavelength " + text_of(wavelength_nm) + " nm is outside the data of k of " +
                       record_.name + ", " + text_of(record_.k->range) + ", though n is " +
                       text_of(record_.n.at(asked_um)) + " there; " + std::string(how_to_take_k_as_0));
    throw UsageError("wavelength " + text_of(wavelength_nm) + " nm is outside the data of " + record_.name +
                     ", " + text_of(range_));
  }

  const double n = record_.n.at(wavelength_um);
  if (!(n > 0 && std::isfinite(n))) {
    throw malformed(
        record_.file, record_.n.line,
        "n is " + text_of(n) + " at " + text_of(wavelength_nm) + " nm; it must be above 0 and finite");
  }
  const auto has_k = [&] {
    return record_.k->range.min_um <= wavelength_um && wavelength_um <= record_.k->range.max_um;
  };
  if (!record_.k || (missing_ == MissingExtinction::zero && !has_k())) return {n, 0};
  const double k = record_.k->at(wavelength_um);
  if (!(k >= -extinction_noise && std::isfinite(k))) {
    throw malformed(record_.k->file, record_.k->line,
                    "k is " + text_of(k) + " at " + text_of(wavelength_nm) + " nm; it must not be negative");
  }
  return {n, std::max(k, 0.0)};
}

}  // namespace vcavity::tools
