// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which light of a direction is followed through the groove, and how far.

#include <limits>

#include "vcavity/conventions.hpp"

namespace vcavity {

/// Pass as the largest number of bounces to follow them all.
inline constexpr int all_bounces = std::numeric_limits<int>::max();

/// What to do with light of which nothing is left, its throughput being below the smallest normal number.
enum class DarkLight {
  followed,  ///< to its last bounce, though without any more Fresnel evaluations
  merged     ///< into one lobe that ends where the light does
};

/// The panels that light may meet first.
class FirstPanel {
 public:
  /// Either of them.
  constexpr FirstPanel() = default;

  /// Only one of them.
  /// @param only this one
  constexpr FirstPanel(Panel only) : one_(only == Panel::one), two_(only == Panel::two) {}

  /// Whether a panel is one of them.
  constexpr bool includes(Panel panel) const { return panel == Panel::one ? one_ : two_; }

 private:
  bool one_ = true;
  bool two_ = true;
};

/// Which light is followed.
struct Follow {
  int max_bounces = all_bounces;               ///< lobes of more bounces are left out
  DarkLight dark_light = DarkLight::followed;  ///< see there
  FirstPanel first_panel = {};                 ///< other light is left out
};

}  // namespace vcavity
