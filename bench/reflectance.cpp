// SPDX-License-Identifier: BSD-3-Clause
/// Directional reflectance, beside the time of nothing but its Fresnel evaluations.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "benchmarks.hpp"
#include "scenes.hpp"

namespace vcavity::bench {
namespace {

template <class Real, class Facet>
auto reflectance_of(const Cavity<scalar_t<Real>>& groove, const Facet& facet) {
  return [groove, facet](const Vec3<Real>& e) { return unpolarized_reflectance(groove, e, facet); };
}

/// The same as one would write it by hand for numbers, with no thought of colour, polarisation or packs: what
/// the effects cost that are switched off.
template <class Real>
class PlainReflectance {
 public:
  PlainReflectance(const Cavity<Real>& groove, const Conductor<Real>& facet)
      : groove_(groove), facet_(facet) {
    for (int k = 0; k <= 2 * groove.max_bounces() + 1; ++k) turns_.push_back(groove.multiple(k));
  }

  Real operator()(const Vec3<Real>& e) const {
    const Real across = std::abs(e.y);
    const Real inverse_width = groove_.inverse_sin_half() / (2 * e.z);
    const Real other = std::max((turn(1).sine * e.z - turn(1).cosine * across) * inverse_width, Real(0));
    Real sum = 0;
    if (other > 0) {  // light reaches both panels directly
      sum = panel(e.z, across, 1 - other, [&](int, Real cosine) { return cosine * inverse_width; }) +
            panel(e.z, -across, other, [&](int, Real cosine) { return cosine * inverse_width; });
    } else {
      sum = panel(e.z, across, 1, [&](int j, Real) {
        return turn(j).sine * groove_.inverse_sin_half() *
               (turn(j - 1).cosine - across / e.z * turn(j - 1).sine);
      });
    }
    return sum;
  }

 private:
  // One panel met first; `reached(j, c_j)` is the fraction of the opening whose rays come as far as bounce j.
  template <class Reached>
  Real panel(Real up, Real across, Real first, const Reached& reached) const {
    Real sum = 0, throughput = 1, fraction = first;
    Real cosine = turn(1).sine * up + turn(1).cosine * across;
    for (int j = 1; fraction > 0; ++j) {
      throughput *= facet_(cosine);
      cosine = turn(2 * j + 1).sine * up + turn(2 * j + 1).cosine * across;
      const Real next = j < groove_.max_bounces() ? std::clamp(reached(j + 1, cosine), Real(0), fraction) : 0;
      sum += (fraction - next) * throughput;
      fraction = next;
    }
    return sum;
  }

  const typename Cavity<Real>::Rotation& turn(int k) const { return turns_[static_cast<std::size_t>(k)]; }

  Cavity<Real> groove_;
  Conductor<Real> facet_;
  std::vector<typename Cavity<Real>::Rotation> turns_;
};

/// Its result may differ from the library's by rounding alone.
void check_plain(const Cavity<double>& groove, const std::vector<Vec3<double>>& directions) {
  const PlainReflectance<double> plain(groove, silver<double>());
  for (const Vec3<double>& e : directions)
    if (std::abs(plain(e) - directional_reflectance(groove, e, silver<double>())) > 1e-12)
      throw std::logic_error("the plain loop differs from the library");
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
    check_plain(groove, directions);
    add_over("plain_loop", "none", directions, PlainReflectance<double>(groove, facet));
  }
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
  }
  for (const char* aperture_deg : {"90", "45", "20", "10", "5", "2", "1", "0.5", "0.2", "0.1"})
    add_growth(aperture_deg);
}

}  // namespace vcavity::bench
