// SPDX-License-Identifier: BSD-3-Clause
/// Directional reflectance, beside the time of nothing but its Fresnel evaluations.

#include <algorithm>
#include <type_traits>

#include "benchmarks.hpp"
#include "examples/plain_reflectance.hpp"
#include "scenes.hpp"

namespace vcavity::bench {
namespace {

template <class Real, class Facet>
auto reflectance_of(const Cavity<scalar_t<Real>>& groove, const Facet& facet) {
  return [groove, facet](const Vec3<Real>& e) { return unpolarized_reflectance(groove, e, facet); };
}

/// What is left if the bounces of every direction are known beforehand: evaluations, products and weights.
template <class Real>
std::vector<RecordedDirection<Real>> known_ways(const Cavity<Real>& groove,
                                                const std::vector<Vec3<Real>>& directions) {
  std::vector<RecordedDirection<Real>> result;
  for (const Vec3<Real>& e : directions) result.emplace_back(groove, e);
  return result;
}

/// One groove, number type and number of directions at once, in all models of polarisation. All times are for
/// one direction, those of its Fresnel evaluations alone too.
template <std::size_t lanes, class Real, class Facet>
void add(const std::string& material, const std::string& aperture_deg, const Facet& scalar_facet) {
  const auto directions = packed<lanes>(map_directions<Real>());
  const std::size_t count = directions.size() * lanes;
  using Reals = typename decltype(directions)::value_type::value_type;
  const Cavity<Real> groove(radians(Real(std::stod(aperture_deg))));
  const auto facet = over_directions<lanes>(scalar_facet);
  const auto cosines = recorded_cosines(groove, directions, facet);

  const auto add_over = [&](const char* group, const char* model, const auto& inputs, const auto& compute) {
    const std::string name =
        name_of(group, material, aperture_deg, type_name<Real>, std::to_string(lanes), model);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      run_over(state, inputs, count, compute);
      state.counters["evaluations"] =
          static_cast<double>(cosines.size() * lanes) / static_cast<double>(count);
    });
  };
  add_over("fresnel_of_reflectance", "none", cosines, facet);
  add_over("reflectance", "none", directions, reflectance_of<Reals>(groove, facet));
  add_over("reflectance", "separate", directions, reflectance_of<Reals>(groove, separately_polarized(facet)));
  add_over("reflectance", "full", directions, reflectance_of<Reals>(groove, polarized(facet)));
  if constexpr (lanes == 1)
    add_over("known_ways", "none", known_ways(groove, directions),
             [facet](const RecordedDirection<Real>& way) { return way.reflectance(facet); });
  if constexpr (std::is_same_v<Reals, double> && std::is_same_v<Facet, Conductor<double>>) {
    // What the effects cost that are switched off.
    add_over("plain_loop", "none", directions, examples::PlainReflectance(groove, facet));
  }
}

/// A new groove for every direction, as a renderer makes it that shades points of different facets: from the
/// aperture, from the same by addition, from the normal of its facets, and beside them with a groove that is there.
template <class Real, class Facet>
void add_new_grooves(const std::string& material, const std::string& aperture_deg, const Facet& facet) {
  const std::vector<Vec3<Real>> directions = map_directions<Real>();
  const Cavity<Real> known(radians(Real(std::stod(aperture_deg))));
  const auto add_row = [&](const char* model, const auto& groove_for) {
    const std::string name = name_of("new_groove", material, aperture_deg, type_name<Real>, model);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      // Nobody is to know that they are all the same.
      const volatile Real aperture = known.aperture(), across = known.cos_half(), up = known.sin_half();
      run_over(state, directions, directions.size(), [&](const Vec3<Real>& e) {
        return directional_reflectance(groove_for(aperture, across, up), e, facet);
      });
    });
  };
  add_row("shared", [known](Real, Real, Real) -> const Cavity<Real>& { return known; });
  add_row("from_aperture", [](Real aperture, Real, Real) { return Cavity<Real>(aperture); });
  add_row("by_addition", [](Real aperture, Real, Real) { return Cavity<Real>::by_addition(aperture); });
  add_row("from_normal", [](Real, Real across, Real up) { return Cavity<Real>::from_normal(across, up); });
}

/// Narrow grooves: time and evaluations of the facet.
void add_growth(const std::string& aperture_deg) {
  const Cavity<double> groove(radians(std::stod(aperture_deg)));
  const std::vector<Vec3<double>> directions = map_directions<double>();
  const double evaluations =
      static_cast<double>(recorded_cosines(groove, directions, silver<double>()).size()) /
      static_cast<double>(directions.size());
  benchmark::RegisterBenchmark(name_of("growth/silver", aperture_deg).c_str(), [=](benchmark::State& state) {
    run_over(state, directions, directions.size(), reflectance_of<double>(groove, silver<double>()));
    state.counters["bounces"] = groove.max_bounces();
    state.counters["evaluations"] = evaluations;
  });
}

}  // namespace

void add_reflectance_benchmarks() {
  for (const char* aperture_deg : {"45", "90", "150"}) {
    add<1, double>("silver", aperture_deg, silver<double>());
    add<pack_lanes<double>, double>("silver", aperture_deg, silver<double>());
    add<1, float>("silver", aperture_deg, silver<float>());
    add<pack_lanes<float>, float>("silver", aperture_deg, silver<float>());
    add<1, double>("glass", aperture_deg, glass<double>());
    add<pack_lanes<double>, double>("glass", aperture_deg, glass<double>());
    add_new_grooves<double>("silver", aperture_deg, silver<double>());
    add_new_grooves<float>("silver", aperture_deg, silver<float>());
  }
  for (const char* aperture_deg : {"90", "45", "20", "10", "5", "2", "1", "0.5", "0.2", "0.1"})
    add_growth(aperture_deg);
}

}  // namespace vcavity::bench
