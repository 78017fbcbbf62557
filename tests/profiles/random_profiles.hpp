// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Random grooves and directions, and the lobes of the library as the witness of interval_tracing.hpp names them.

#include <map>
#include <random>
#include <string>
#include <vcavity/groove/asymmetric_groove.hpp>
#include <vcavity/groove/lobes.hpp>
#include <vcavity/profiles/profile.hpp>

#include "support/interval_tracing.hpp"

namespace vcavity::test {

/// Reproducible numbers.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

  /// A direction towards the light, up to `most_deg` from the normal.
  template <class Real = double>
  Vec3<Real> light(double most_deg = 89) {
    return direction(radians(Real(between(0, most_deg))), radians(Real(between(0, 360))));
  }

  /// An asymmetric groove of aperture 2° or more, one wall in three overhanging.
  template <class Real = double>
  AsymmetricGroove<Real> groove() {
    const double aperture = between(2, 176);
    const double most_tilt = (180 - aperture) / 2 - 0.5;
    return {radians(Real(aperture)), radians(Real(between(-most_tilt, most_tilt)))};
  }

 private:
  std::mt19937 engine_;
};

/// A facet that reflects everything.
inline constexpr auto mirror = [](const auto& cosine) { return std::remove_cvref_t<decltype(cosine)>(1); };

/// A lobe as far as geometry goes.
template <class Real>
struct Outgoing {
  Real weight;
  Vec3<Real> direction;
};

/// The way over the panels of a V-groove, such as "121".
inline std::string way_of(Panel first, int bounces) {
  return FacePath{first, bounces, false, Panel::one, 0, false}.text();
}

template <class Real>
std::map<std::string, Outgoing<Real>> outgoing(const AsymmetricGroove<Real>& groove, const Vec3<Real>& e) {
  std::map<std::string, Outgoing<Real>> result;
  for (const auto& lobe : lobes(groove, e, mirror))
    result[way_of(lobe.first_panel, lobe.bounces)] = {lobe.weight, lobe.direction};
  return result;
}

template <Profile Shape>
auto outgoing(const Shape& profile, const Vec3<typename Shape::value_type>& e) {
  std::map<std::string, Outgoing<typename Shape::value_type>> result;
  for (const auto& lobe : lobes(profile, e, mirror)) result[lobe.path.text()] = {lobe.weight, lobe.direction};
  return result;
}

/// The largest difference between the lobes of the library and traced pencils; those that only one of them has count
/// with their weight.
template <class Real>
Real largest_difference(std::map<std::string, Outgoing<Real>> found,
                        const std::vector<TracedPencil<Real>>& traced) {
  using std::max;
  Real worst(0);
  for (const TracedPencil<Real>& pencil : traced) {
    const auto lobe = found.find(pencil.way);
    if (lobe == found.end()) {
      worst = max(worst, pencil.weight);
      continue;
    }
    worst = max(worst, magnitude(Real(lobe->second.weight - pencil.weight)));
    // The direction of what is next to nothing is right too.
    for (glm::length_t i = 0; i < 3; ++i)
      worst = max(worst, magnitude(Real(lobe->second.direction[i] - pencil.direction[i])));
    found.erase(lobe);
  }
  for (const auto& [way, lobe] : found) worst = max(worst, lobe.weight);
  return worst;
}

}  // namespace vcavity::test
