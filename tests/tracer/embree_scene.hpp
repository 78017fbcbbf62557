// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The one place that knows Embree, version 3 or 4: which panel of a relief does a ray meet first?

#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "relief.hpp"

namespace tracer {

/// A relief held by Embree, one quad per panel. Embree computes in single precision, so it is only asked
/// *which* panel a ray meets; where and under which angle is computed by the caller in double precision.
class EmbreeScene {
 public:
  /// @throws std::runtime_error if Embree reports an error
  explicit EmbreeScene(const Relief& relief);

  /// Only the upper sides of the panels are met. So a ray cannot meet the panel that it has just left,
  /// without the usual offset along the ray, which breaks paths close to an apex; nor the far side of a
  /// narrow peak, which lies so close behind the near one that single precision confuses the two.
  /// @param origin, direction  of the ray, in panel widths
  /// @return the index of the first panel on the ray, or nothing if the ray is free
  std::optional<int> first_panel(glm::dvec3 origin, glm::dvec3 direction) const;

 private:
  std::shared_ptr<void> scene_;  // an RTCScene, released with its last copy
};

}  // namespace tracer
