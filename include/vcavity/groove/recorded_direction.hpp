// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The bounces of all lobes of a direction, noted down: for a direction that is asked for many facets or
/// wavelengths, the geometry is then done only once.

#include <vector>

#include "vcavity/groove/lobes.hpp"
#include "vcavity/numbers/compiler.hpp"

namespace vcavity {

/// @tparam Real number type of the direction; facets may return any value
template <class Real>
class RecordedDirection {
 public:
  RecordedDirection() = default;

  /// The same as `follow`.
  RecordedDirection(const Cavity<Real>& cavity, const Vec3<Real>& e, int max_bounces = all_bounces) {
    follow(cavity, e, max_bounces);
  }

  /// Notes down another direction, in the memory of the one before.
  /// @param cavity the groove
  /// @param e direction towards the light, or towards the viewer under diffuse light; e.z ≥ 0
  /// @param max_bounces lobes of more bounces are left out
  void follow(const Cavity<Real>& cavity, const Vec3<Real>& e, int max_bounces = all_bounces) {
    bounces_.clear();
    const auto note = [this](const Bounce<Real>& bounce) {
      bounces_.push_back({bounce.cosine, Real(0), bounce.number});
      return Real(1);
    };
    for_each_lobe(cavity, e, note,
                  [this](const UnfoldedRay<Real>&, const Real& weight, const Real&) {
                    bounces_.back().weight = weight;
                  },
                  {.max_bounces = max_bounces});
  }

  /// The directional reflectance of a facet, the same number as `directional_reflectance`.
  /// @param facet facet reflectance, a function of the cosine of the angle of incidence
  template <class Facet>
    requires std::invocable<const Facet&, const Real&>
  VCAVITY_INLINE value_t<Facet, Real> reflectance(const Facet& facet) const {
    using Value = value_t<Facet, Real>;
    Value reflectance(0);
    Value throughput(1);
    for (const Recorded& bounce : bounces_) {
      if (bounce.number == 1) throughput = Value(1);
      if (!is_dark(throughput, bounce.number)) throughput = throughput * facet(bounce.cosine);
      if (bounce.weight > Real(0)) reflectance = reflectance + scaled(bounce.weight, throughput);
    }
    return reflectance;
  }

 private:
  struct Recorded {
    Real cosine;  // of the angle of incidence
    Real weight;  // of the lobe that ends here
    int number;   // from 1 on, for either first panel
  };

  std::vector<Recorded> bounces_;
};

}  // namespace vcavity
