// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/map_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vcavity/render/projection.hpp>

#include "tools/colour/colour_difference.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

// The differences between two maps are searched in the directions of this many pixels along one side.
constexpr int searched_size = 64;
// What the directions between them may add.
constexpr double margin = 2;

std::string bound_in_words(double bound) {
  std::string text = "error at most ";
  return text.append(with_digits(bound, 2));
}

MapPlan plan_reflectance(MapRequest request, double tolerance) {
  const EffectsPlan plan = make_surface(request.surface, request.wavelengths_nm.front(),
                                        {request.polarization, request.max_bounces})
                               ->plan(tolerance, Illumination::collimated);
  request.polarization = plan.polarization ? Polarization::full : Polarization::none;
  request.max_bounces = plan.max_bounces;
  request.precision = plan.single_precision ? Precision::single_precision : Precision::double_precision;
  return {std::move(request), in_words(plan), plan.bounds.total()};
}

// Bound on the rounding error in any direction, at the worst of the wavelengths.
double largest_rounding(const MapRequest& request) {
  if (!is_symmetric_groove(request.surface))
    throw UsageError("--tolerance: bounds the rounding of symmetric grooves only, not of this surface");
  if (has_films(request.surface.films) && request.quantity != Quantity::reflectance)
    throw UsageError(
        "--tolerance: bounds the rounding of reflectances only under films, not of absorptances");
  double bound = 0;
  const Cavity<double> cavity(radians(request.surface.aperture_deg));
  for (const double wavelength_nm : request.wavelengths_nm) {
    const RefractiveIndex index = request.surface.material.at(wavelength_nm);
    with_facet(index, request.surface.films, wavelength_nm, [&](const auto& facet) {
      bound = std::max(bound, request.precision == Precision::single_precision
                                  ? rounding_bound<float>(cavity, facet)
                                  : rounding_bound<double>(cavity, facet));
    });
  }
  return bound;
}

std::vector<Vec3<double>> searched_directions() {
  std::vector<Vec3<double>> directions;
  for (int row = 0; row < searched_size; ++row)
    for (int column = 0; column < searched_size / 2; ++column)
      if (const auto e = pixel_direction(column, row, searched_size)) directions.push_back(*e);
  return directions;
}

// The grid with only every `stride`-th wavelength, if that meets its end.
std::vector<double> thinned(const std::vector<double>& wavelengths_nm, std::size_t stride) {
  std::vector<double> result;
  if ((wavelengths_nm.size() - 1) % stride != 0) return result;
  for (std::size_t i = 0; i < wavelengths_nm.size(); i += stride) result.push_back(wavelengths_nm[i]);
  return result;
}

// Time of a map in arbitrary units: following fields costs about three times as much, float half.
double cost(const MapRequest& request) {
  return static_cast<double>(request.wavelengths_nm.size()) *
         (request.polarization == Polarization::full ? 3 : 1) *
         (request.precision == Precision::single_precision ? 0.5 : 1);
}

std::vector<MapRequest> cheaper_maps(const MapRequest& full) {
  std::vector<MapRequest> candidates, refined;
  for (const std::size_t stride : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 10u, 12u})
    for (const Polarization polarization : {Polarization::none, Polarization::full})
      for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
        if (precision == Precision::single_precision && !is_symmetric_groove(full.surface)) continue;
        MapRequest candidate = full;
        candidate.wavelengths_nm = thinned(full.wavelengths_nm, stride);
        candidate.polarization = polarization;
        candidate.precision = precision;
        if (candidate.wavelengths_nm.size() < 2) continue;
        // With the wavelengths that colours take between those of the grid it is the full map unless something else is less.
        const bool is_less = polarization != Polarization::full || precision != Precision::double_precision;
        if (stride == 1 && is_less) refined.push_back(candidate);
        candidate.colour_grid = ColourGrid::as_given;
        candidates.push_back(std::move(candidate));
      }
  const auto is_cheaper = [](const MapRequest& a, const MapRequest& b) { return cost(a) < cost(b); };
  std::stable_sort(candidates.begin(), candidates.end(), is_cheaper);
  std::stable_sort(refined.begin(), refined.end(), is_cheaper);
  candidates.insert(candidates.end(), refined.begin(), refined.end());
  return candidates;
}

MapPlan plan_colour(MapRequest request, double tolerance) {
  request.spectrum = Spectrum::colour_only;
  request.polarization = Polarization::full;
  const DiscMapper full(request);
  if (full.channels().front() != "R")
    throw UsageError("--effects auto: none of the wavelengths is visible, so there is no colour to plan for");
  std::vector<std::pair<Vec3<double>, Lab>> expected;
  for (const Vec3<double>& e : searched_directions())
    expected.push_back({e, to_lab(full.colour(e), full.white())});

  for (MapRequest& candidate : cheaper_maps(request)) {
    const DiscMapper mapper(candidate);
    double bound = 0;
    for (const auto& [e, lab] : expected) {
      bound = std::max(bound, margin * delta_e_2000(to_lab(mapper.colour(e), full.white()), lab));
      if (bound > tolerance) break;
    }
    if (bound > tolerance) continue;
    const bool follows = candidate.polarization == Polarization::full;
    std::string words = follows ? "polarisation followed" : "polarisation left out";
    words.append(candidate.wavelengths_nm.size() == request.wavelengths_nm.size() ? ", all " : ", only ")
        .append(std::to_string(candidate.wavelengths_nm.size()))
        .append(" wavelengths, all bounces, ")
        .append(candidate.precision == Precision::single_precision ? "float" : "double")
        .append("; CIEDE2000 ")
        .append(bound_in_words(bound));
    return {std::move(candidate), std::move(words), bound};
  }
  return {std::move(request), "everything kept; nothing less is within the tolerance", 0};
}

}  // namespace

std::string in_words(const EffectsPlan& plan) {
  std::string words = "polarisation ";
  words.append(plan.polarization ? "followed" : "left out (" + bound_in_words(plan.bounds.polarization) + ")")
      .append(", ")
      .append(plan.max_bounces == all_bounces ? "all bounces"
                                              : "at most " + std::to_string(plan.max_bounces) + " bounces (" +
                                                    bound_in_words(plan.bounds.bounces) + ")")
      .append(plan.single_precision ? ", float (" : ", double (")
      .append(bound_in_words(plan.bounds.rounding))
      .append(")");
  if (plan.bounds.quadrature > 0)
    words.append(", quadrature (").append(bound_in_words(plan.bounds.quadrature)).append(")");
  return words.append("; together ").append(bound_in_words(plan.bounds.total()));
}

MapPlan plan_precision(MapRequest request, double tolerance, ExrNumber stored) {
  if (request.quantity != Quantity::reflectance && request.quantity != Quantity::absorptance)
    throw UsageError("--tolerance: bounds the error of --quantity reflectance or absorptance, not of others");
  MapPlan plan{std::move(request), "", 0};
  const double stored_rounding = std::ldexp(1, stored == ExrNumber::float16 ? -12 : -25);
  for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
    plan.request.precision = precision;
    plan.bound = stored_rounding + largest_rounding(plan.request);
    if (plan.bound > tolerance) continue;
    plan.explanation = precision == Precision::single_precision ? "float; " : "double; ";
    plan.explanation += bound_in_words(plan.bound);
    return plan;
  }
  throw UsageError("--tolerance: '" + exact(tolerance) + "' is not accepted, expected at least " +
                   with_digits(plan.bound, 2) +
                   ", which rounding of the numbers and their storage may reach");
}

MapPlan plan_map(MapRequest request, double tolerance) {
  if (request.quantity != Quantity::reflectance)
    throw UsageError("--effects auto: plans maps of the reflectance only");
  return request.wavelengths_nm.size() == 1 ? plan_reflectance(std::move(request), tolerance)
                                            : plan_colour(std::move(request), tolerance);
}

}  // namespace vcavity::tools
