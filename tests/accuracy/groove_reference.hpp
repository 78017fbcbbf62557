// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Lobes traced in real space, for arguments α, e_x, e_y, e_z, …

#include <algorithm>
#include <array>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/subject.hpp"
#include "accuracy/traced_beam.hpp"

namespace vcavity::test {

/// A key for the lobe with this first panel and number of bounces.
inline int key_of(Panel first, int bounces) {
  return 2 * bounces + (first == Panel::one ? 0 : 1);
}

/// The groove as `Real` knows it.
template <class Real, class Wide>
Cavity<Real> rounded_cavity(const std::vector<Wide>& arguments) {
  return Cavity<Real>(std::min(static_cast<Real>(arguments[0]), pi<Real>()));
}

/// A cosine as facets take it: in [`smallest_cosine`, 1].
template <class Real, class Wide>
Wide facet_cosine(const Wide& cosine) {
  return std::clamp(cosine, Wide(vcavity::detail::smallest_cosine<Real>()), Wide(1));
}

/// The traced lobes. By the library's convention an aperture within rounding of π/k has at most k bounces,
/// and the rays that would bounce once more count as bouncing k times.
template <class Real, class Wide>
std::vector<TracedLobe<Wide>> traced(const std::vector<Wide>& arguments) {
  const GrooveSection<Wide> groove(arguments[0]);
  std::vector<TracedLobe<Wide>> lobes = traced_lobes(groove, arguments[2], arguments[3]);
  const int most = rounded_cavity<Real>(arguments).max_bounces();
  for (TracedLobe<Wide>& lobe : lobes) {
    lobe.bounces = std::min(lobe.bounces, most);
    lobe.cosines.resize(static_cast<std::size_t>(lobe.bounces));
  }
  return lobes;
}

/// Their weights.
template <class Real, class Wide>
ExactResults<Wide> traced_weights(const std::vector<Wide>& arguments) {
  ExactResults<Wide> results;
  for (const TracedLobe<Wide>& lobe : traced<Real>(arguments)) {
    Exact<Wide>& sum = results[key_of(lobe.first_panel, lobe.bounces)];
    sum = {Wide(sum.value + lobe.weight), Wide(1)};
  }
  return results;
}

/// Sums over the lobes of weight times throughput, for facets with several reflectances.
/// @param facet the reflectances as a function of the cosine of incidence
template <class Real, std::size_t count, class Wide, class Facet>
std::array<Wide, count> traced_reflectances(const std::vector<Wide>& arguments, const Facet& facet) {
  std::array<Wide, count> sums, throughputs;
  sums.fill(Wide(0));
  int bounces = 0;
  Panel first_panel = Panel::one;
  for (const TracedLobe<Wide>& lobe : traced<Real>(arguments)) {
    // Lobes with the same first panel begin alike.
    if (bounces == 0 || lobe.first_panel != first_panel) {
      throughputs.fill(Wide(1));
      bounces = 0;
      first_panel = lobe.first_panel;
    }
    for (; bounces < lobe.bounces; ++bounces) {
      const Wide& cosine = lobe.cosines[static_cast<std::size_t>(bounces)];
      const std::array<Wide, count> reflectances = facet(facet_cosine<Real>(cosine));
      for (std::size_t i = 0; i < count; ++i) throughputs[i] *= reflectances[i];
    }
    for (std::size_t i = 0; i < count; ++i) sums[i] += lobe.weight * throughputs[i];
  }
  return sums;
}

/// The largest number of bounces of a lobe of the library.
template <class Real>
int max_bounces_of(const std::vector<Real>& arguments) {
  const auto white = [](const Real&) { return Real(1); };
  int bounces = 1;
  const Vec3<Real> e{arguments[1], arguments[2], arguments[3]};
  for (const auto& lobe : lobes(Cavity<Real>(arguments[0]), e, white))
    bounces = std::max(bounces, lobe.bounces);
  return bounces;
}

}  // namespace vcavity::test
