// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What all benchmarks look at: two materials, and directions as neighbouring pixels of a map show them.

#include <cstddef>
#include <numbers>
#include <vcavity/vcavity.hpp>
#include <vector>

namespace vcavity::bench {

/// Silver at 550 nm.
template <class Real>
Conductor<Real> silver() {
  return {Real(0.1249), Real(3.3391)};
}

/// Glass.
template <class Real>
Dielectric<Real> glass() {
  return Dielectric<Real>(Real(1.5));
}

/// Directions with e.y ≥ 0: runs of 32 neighbouring pixels, spread over a map of 1024 × 1024. Neighbours
/// share a pack in a map, and most of them also share the number of bounces.
template <class Real>
std::vector<Vec3<Real>> map_directions() {
  constexpr int size = 1024, row_step = 128, run = 32, run_step = 128;
  const Real scale = std::numbers::sqrt2_v<Real> / Real(size);
  std::vector<Vec3<Real>> result;
  for (int row = row_step / 2; row < size; row += row_step)
    for (int column = size / 2; column < size; ++column) {
      if (column % run_step >= run) continue;
      const auto e = direction_on_disc(
          Vec2<Real>{scale * Real(2 * column + 1 - size), scale * Real(size - 1 - 2 * row)});
      if (e) result.push_back(*e);
    }
  return result;
}

/// Consecutive numbers in packs; a last incomplete pack is left out. One by one they stay numbers.
template <std::size_t lanes, Number Real>
auto packed(const std::vector<Real>& numbers) {
  if constexpr (lanes == 1) {
    return numbers;
  } else {
    std::vector<Pack<Real, lanes>> result;
    for (std::size_t i = 0; i + lanes <= numbers.size(); i += lanes)
      result.push_back(Pack<Real, lanes>::load(&numbers[i]));
    return result;
  }
}

/// The same for directions.
template <std::size_t lanes, class Real>
auto packed(const std::vector<Vec3<Real>>& directions) {
  if constexpr (lanes == 1) {
    return directions;
  } else {
    std::vector<Vec3<Pack<Real, lanes>>> result(directions.size() / lanes);
    for (std::size_t i = 0; i < result.size() * lanes; ++i)
      for (int axis = 0; axis < 3; ++axis) result[i / lanes][axis][i % lanes] = directions[i][axis];
    return result;
  }
}

/// The cosines of incidence, in the order in which the reflectance of these directions asks for them.
/// @tparam Real a number or a `Pack`
template <class Real, class Facet>
std::vector<Real> recorded_cosines(const Cavity<scalar_t<Real>>& cavity,
                                   const std::vector<Vec3<Real>>& directions, const Facet& facet) {
  std::vector<Real> cosines;
  const auto recorder = [&](const Real& cos_theta_i) {
    cosines.push_back(cos_theta_i);
    return facet(cos_theta_i);
  };
  for (const Vec3<Real>& e : directions) directional_reflectance(cavity, e, recorder);
  return cosines;
}

/// The facet for directions in packs of `lanes`; for one lane the facet itself.
template <std::size_t lanes, class Facet>
auto over_directions(const Facet& facet) {
  if constexpr (lanes == 1)
    return facet;
  else
    return facet.template over_directions<lanes>();
}

/// Two vector registers: with one, the latency of one operation delays the next.
template <class Real>
constexpr std::size_t pack_lanes = 2 * native_lanes<Real>;

template <class Real>
constexpr const char* type_name = sizeof(Real) == sizeof(float) ? "float" : "double";

}  // namespace vcavity::bench
