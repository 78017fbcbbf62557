// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A ray in a groove of a rough surface, from where it comes to where it goes.

#include <cmath>
#include <limits>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/rough/connecting_grooves.hpp"

namespace vcavity {

/// The way of one ray; in the terms of connecting_grooves.hpp, of which it is the reverse: groove and ray are given,
/// where the ray leads to is asked for.
template <class Real>
class DrawnRay {
 public:
  /// @param e unit vector towards the light, e.z ≥ 0
  /// @param m unit normal of panel one, m.z ≥ 0
  /// @param u in [0, 1]: where the ray meets the opening, from the side of panel one to that of panel two
  DrawnRay(const Vec3<Real>& e, const Vec3<Real>& m, const Real& u) {
    using std::abs;
    using std::floor;
    using std::sqrt;
    cos_half_ = sqrt(m.x * m.x + m.y * m.y);
    sin_half_ = at_least(m.z, smallest_divisor<Real>());
    const Real aperture = Real(2) * detail::acute_angle(sin_half_, cos_half_);
    const auto is_tilted = cos_half_ > Real(0);
    const Real inverted = select(is_tilted, cos_half_, Real(1));
    const Vec2<Real> y_axis{m.x / inverted, select(is_tilted, Real(m.y / inverted), Real(1))};
    const Real along = e.x * y_axis.y - e.y * y_axis.x;
    const Real across = e.x * y_axis.x + e.y * y_axis.y;
    const Real up = at_least(e.z, smallest_divisor<Real>());

    // The ray passes the apex at the distance |δ|·√(across² + up²), on the side of the panel that it meets first.
    const Real aside = (Real(2) * u - Real(1)) * sin_half_ * up;
    meets_one_ = aside < Real(cos_half_ * across);
    const Real over_first = select(meets_one_, across, Real(-across));
    const Real size = at_least(magnitude(across), up);
    const Real cos_eta = size * Real(sqrt((across / size) * (across / size) + (up / size) * (up / size)));
    // 1 − |δ|, without the difference.
    const Real versine_half = sin_half_ * (sin_half_ / (Real(1) + cos_half_));
    const Real beyond = select(over_first > Real(0), Real(up * (up / (cos_eta + magnitude(over_first)))),
                               Real(cos_eta - over_first));
    const Real rest = at_most(
        at_least(
            Real((beyond + versine_half * over_first + select(meets_one_, aside, Real(-aside))) / cos_eta),
            Real(0)),
        Real(1));
    const Real elevation = detail::elevation_of(over_first, up).angle;
    const Real swept =
        elevation + detail::acute_angle(Real(sqrt(rest * (Real(2) - rest))), Real(Real(1) - rest));
    count_ = at_least(Real(floor(swept / aperture + Real(0.5))), Real(1));

    const Real leaving = count_ * aperture - elevation;
    const Real from_vertical = pi<Real>() / Real(2) - leaving;
    const Real to_side = cos_eta * detail::acute_sine(from_vertical);
    // Away from the panel met first after an even number of bounces.
    const Real after_odd = select(meets_one_, to_side, Real(-to_side));
    const Real to_y = select(is_odd(), after_odd, Real(-after_odd));
    leaving_ = {to_y * y_axis.x - along * y_axis.y, to_y * y_axis.y + along * y_axis.x,
                at_least(Real(cos_eta * detail::acute_cosine(from_vertical)), Real(0))};

    // The ray is one of a beam, so that has a width, whatever is left of it by rounding.
    const Real x = Real(0.5) * (aperture - Real(abs(leaving - elevation)));
    const Real beta = Real(0.5) * (pi<Real>() - count_ * aperture);
    const Real beam = select(x < beta, Real(Real(2) * detail::acute_cosine(beta) * detail::acute_sine(x)),
                             detail::acute_sine(Real(x + beta)));
    beam_ = at_least(beam, std::numeric_limits<Real>::epsilon());
    elevation_ = elevation;
    half_aperture_ = Real(0.5) * aperture;
  }

  /// Groove and way of the ray; the normal m is that of panel one.
  ConnectingGroove<Real> groove() const {
    return {meets_one_ ? Panel::one : Panel::two, bounces(), cos_half_, sin_half_, beam_};
  }

  /// The same of an array of rays.
  GrooveWays<Real> way() const {
    return {count_, Real(1) / count_, elevation_, half_aperture_, cos_half_, sin_half_, beam_};
  }

  /// The direction in which the ray leaves, a unit vector in the frame of the surface, z ≥ 0.
  const Vec3<Real>& leaving() const { return leaving_; }

 private:
  int bounces() const {
    constexpr int most = std::numeric_limits<int>::max() / 2;
    return count_ < Real(most) ? static_cast<int>(count_) : most;
  }

  /// Whether the number of bounces is odd.
  mask_t<Real> is_odd() const {
    if constexpr (Number<Real>) {
      return bounces() % 2 == 1;
    } else {
      const Real half = Real(0.5) * count_;
      return half > Real(floor(half));
    }
  }

  mask_t<Real> meets_one_;
  Real count_;
  Real elevation_, half_aperture_;
  Real cos_half_, sin_half_;
  Real beam_;
  Vec3<Real> leaving_;
};

}  // namespace vcavity
