// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The whole model on one page: the directional reflectance of a specular V-groove, written down as one would
/// explain it at a whiteboard, for numbers only and with no thought of speed.
///
/// To read, not to use. The library computes the same number for colours, packs and polarised light, keeps its
/// digits as e_z → 0, takes no rounding error for a lobe and is fast in narrow grooves (groove/lobes.hpp,
/// groove/lit_opening.hpp). A test holds this page to agree with it to 1e-12 (tests/library/reading_copy_test.cpp),
/// and the benchmarks time it as what a loop written by hand takes.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vcavity/conventions.hpp>
#include <vcavity/groove/cavity.hpp>
#include <vector>

namespace vcavity::examples {

/// @tparam Real number type
/// @tparam Facet reflectance of a panel, a function of the cosine of the angle of incidence
template <class Real, class Facet>
class PlainReflectance {
 public:
  /// @param groove its aperture is all that matters
  /// @param facet what both panels are made of
  PlainReflectance(const Cavity<Real>& groove, const Facet& facet) : groove_(groove), facet_(facet) {
    for (int k = 0; k <= 2 * groove.max_bounces() + 1; ++k) turns_.push_back(groove.multiple(k));
  }

  /// The reflectance for light from a direction, averaged over the opening.
  /// @param e direction towards the light, e.z > 0
  Real operator()(const Vec3<Real>& e) const {
    // The groove is its own mirror image: only the size of e_y matters. The opening is 2 e_z sin(α/2) wide as the
    // light sees it, and the panel that does not face the light takes its share of that, if it sees the light.
    const Real across = std::abs(e.y);
    const Real inverse_width = groove_.inverse_sin_half() / (2 * e.z);
    const Real other = std::max((turn(1).sine * e.z - turn(1).cosine * across) * inverse_width, Real(0));
    if (other > 0) {
      // Light reaches both panels. Of the rays that meet one of them first, those come as far as image j that
      // cross it, and the images are all equally long: their share is c_j over the width.
      const auto reached = [&](int, Real cosine) { return cosine * inverse_width; };
      return panel(e.z, across, 1 - other, reached) + panel(e.z, -across, other, reached);
    }
    // The other panel lies in the shadow of its own rim, and so do the lower parts of the images.
    return panel(e.z, across, 1, [&](int j, Real) {
      return turn(j).sine * groove_.inverse_sin_half() *
             (turn(j - 1).cosine - across / e.z * turn(j - 1).sine);
    });
  }

 private:
  /// What the light of one first panel contributes.
  /// @param up,across components of e along the mean normal, and from this panel towards the other
  /// @param first fraction of the opening whose rays meet this panel first
  /// @param reached reached(j, c_j), the fraction whose rays come as far as bounce j, before it is limited
  template <class Reached>
  Real panel(Real up, Real across, Real first, const Reached& reached) const {
    Real sum = 0, throughput = 1, fraction = first;
    // Instead of the ray the groove is reflected: image j of the panels stands at the angle (j − ½)α.
    Real cosine = turn(1).sine * up + turn(1).cosine * across;
    for (int j = 1; fraction > 0; ++j) {
      throughput *= facet_(cosine);
      cosine = turn(2 * j + 1).sine * up + turn(2 * j + 1).cosine * across;
      const Real next = j < groove_.max_bounces() ? std::clamp(reached(j + 1, cosine), Real(0), fraction) : 0;
      sum += (fraction - next) * throughput;  // the lobe of j bounces
      fraction = next;
    }
    return sum;
  }

  /// Cosine and sine of kα/2.
  const typename Cavity<Real>::Rotation& turn(int k) const { return turns_[static_cast<std::size_t>(k)]; }

  Cavity<Real> groove_;
  Facet facet_;
  std::vector<typename Cavity<Real>::Rotation> turns_;
};

}  // namespace vcavity::examples
