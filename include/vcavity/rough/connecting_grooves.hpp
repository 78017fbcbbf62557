// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// All grooves that lead light from one given direction into another: one for each number of bounces and each panel
/// that may be met first.
///
/// Let e point towards the light and o the way it leaves, h be the horizontal part of e + o and y = h/|h|. Light
/// keeps its component along a groove, so only grooves that run at right angles to y can turn −e into o, whatever
/// the number of bounces. In the plane across such a groove e and o have the elevations k_e = atan2(e_z, ±e_y) and
/// k_o = atan2(o_z, ±o_y) above the panel that is met first, + for panel one, and for k_o the opposite sign after
/// an even number of bounces j. Unfolded, the ray is straight and leaves through the image of the opening that is
/// turned by jα:
///
///     jα = k_e + k_o.
///
/// So each j and first panel have exactly one aperture, and the rays that take this way are a fraction
/// √(e_y² + e_z²) B/(2 sin(α/2) e_z) of those that meet the groove, with
///
///     β = (π − jα)/2,   x = (α − |k_e − k_o|)/2,   B = sin(x + β) + min(0, sin(x − β))   if x > 0 and x + β > 0,
///
/// else none. A term of one bounce is the facet model of Torrance and Sparrow (1967), B cos η being their geometric
/// attenuation G times e · m. The pairs are symmetric in e and o.
///
/// All differences are taken between elevations, which are small where light grazes the surface: so they keep their
/// digits there. Where e + o is vertical, in the mirror direction, every azimuth leads there; any will do for the
/// one bounce of a flat facet, and the others, whose sum grows like 1/|h|, are left out: no light is lost, since
/// they have a finite integral.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// A groove that leads light from e to o, and by which way.
template <class Real>
struct ConnectingGroove {
  Panel first_panel;  ///< the panel met first; the normal of panel one leans towards `across`
  int bounces;        ///< number of reflections
  Real cos_half;      ///< cosine of half the aperture, sin θ_m
  Real sin_half;      ///< sine of half the aperture, cos θ_m
  Real beam;          ///< B, in [0, 2]: the width of the rays that go this way where the panels have width 1
};

/// The grooves that lead light from one direction into another.
template <class Real>
class ConnectingGrooves {
 public:
  /// @param e unit vector towards the light, e.z ≥ 0
  /// @param o unit vector in which the light leaves, o.z ≥ 0
  VCAVITY_INLINE ConnectingGrooves(const Vec3<Real>& e, const Vec3<Real>& o) {
    using std::sqrt;
    const Real h_x = e.x + o.x;
    const Real h_y = e.y + o.y;
    tilt_ = sqrt(h_x * h_x + h_y * h_y);
    // Without a tilt of e + o any azimuth serves.
    across_ = tilt_ > Real(0) ? Vec2<Real>{h_x / tilt_, h_y / tilt_} : Vec2<Real>{Real(0), Real(1)};
    e_ = in_groove(e);
    o_ = in_groove(o);
    cos_eta_ = sqrt(e_.y * e_.y + e_.z * e_.z);
    const Real sum_z = e_.z + o_.z;
    inverse_sum_ = Real(1) / Real(sqrt(tilt_ * tilt_ + sum_z * sum_z));
    const Elevation from = elevation(e_), to = elevation(o_);
    series_[0] = Series(from, to);
    series_[1] = Series(from.turned(), to.turned());
    series_[2] = Series(from, to.turned());
    series_[3] = Series(from.turned(), to);
  }

  /// The unit vector across the grooves, from the side of panel one to that of panel two.
  const Vec2<Real>& across() const { return across_; }

  /// The direction towards the light in the frame of the grooves.
  const Vec3<Real>& to_light() const { return e_; }

  /// The direction in which the light leaves, in the frame of the grooves.
  const Vec3<Real>& leaving() const { return o_; }

  /// The normal of panel one of a groove, in the frame of the surface.
  Vec3<Real> normal(const ConnectingGroove<Real>& groove) const {
    return {groove.cos_half * across_.x, groove.cos_half * across_.y, groove.sin_half};
  }

  /// BRDF × cosine of the light that goes this way, for facets that reflect all light.
  /// @param groove the groove
  /// @param facet_density D(m) of the groove's facets, see slope_distribution.hpp
  Real density(const ConnectingGroove<Real>& groove, const Real& facet_density) const {
    // cos(α/2)/|h| is 1/|e + o| for one bounce; so it has its value in the mirror direction too.
    const Real slope =
        groove.bounces == 1 ? inverse_sum_ : Real(groove.cos_half / (Real(groove.bounces) * tilt_));
    return cos_eta_ / (Real(2) * e_.z) * (facet_density * slope * groove.beam);
  }

  /// Calls `visit` with every groove of at most `max_bounces` bounces, in ascending order of these.
  template <class Visit>
  VCAVITY_INLINE void for_each(int max_bounces, Visit&& visit) const {
    // One facet always does it, though by rounding alone where the light grazes the surface.
    if (max_bounces >= 1) visit(series_[0].groove(Panel::one, 1));
    if (!(tilt_ > Real(0))) return;
    Real most(0);
    for (const Series& series : series_) most = at_least(series.most_bounces(), most);
    const int last = most < Real(max_bounces) ? static_cast<int>(most) : max_bounces;
    for (int bounces = 2; bounces <= last; ++bounces) {
      const Series* pair = bounces % 2 == 1 ? &series_[0] : &series_[2];
      if (pair[0].reaches(bounces)) visit(pair[0].groove(Panel::one, bounces));
      if (pair[1].reaches(bounces)) visit(pair[1].groove(Panel::two, bounces));
    }
  }

  /// BRDF × cosine of all light of more than `max_bounces` bounces, for facets that reflect all light: by the
  /// Euler–Maclaurin formula, with a relative error of the whole BRDF of 3e-4 at most for 32, and seldom a fifth of that.
  /// @param steepest_density D of the facets of vertical slope, whose normal is the horizontal vector `across`
  /// @param max_bounces light that needs more bounces is left out
  Real density_beyond(int max_bounces, const Real& steepest_density) const {
    if (!(tilt_ > Real(0)) || !(steepest_density > Real(0))) return Real(0);
    Real sum(0);
    for (std::size_t i = 0; i < 4; ++i) {
      const bool is_odd = i < 2;
      const int first_left_out = (max_bounces % 2 == 1) == is_odd ? max_bounces + 2 : max_bounces + 1;
      sum += series_[i].beyond(Real(first_left_out - 1));
    }
    return cos_eta_ / (Real(2) * tilt_ * e_.z) * (steepest_density * sum);
  }

 private:
  /// An angle above the horizon on one side, and above that on the other: both with all their digits.
  struct Elevation {
    Real angle, complement;  // they add up to π

    Elevation turned() const { return {complement, angle}; }
  };

  /// The elevation of a direction above the side of panel one.
  VCAVITY_INLINE static Elevation elevation(const Vec3<Real>& v) {
    using std::atan2;
    const Real low = atan2(v.z, magnitude(v.y));
    const Real high = pi<Real>() - low;
    return v.y < Real(0) ? Elevation{high, low} : Elevation{low, high};
  }

  /// The ways of one parity of the number of bounces and one first panel.
  class Series {
   public:
    Series() = default;
    VCAVITY_INLINE Series(const Elevation& e, const Elevation& o)
        : lower_(e.angle < o.angle ? e : o), upper_(e.angle < o.angle ? o : e) {
      sum_ = lower_.angle + upper_.angle;
      difference_ =
          is_low() ? Real(upper_.angle - lower_.angle) : Real(lower_.complement - upper_.complement);
      beta_ = Real(0.5) * (upper_.complement - lower_.angle);
      const Real slowest = at_least(Real(difference_ - Real(2) * beta_), difference_);
      most_bounces_ = sum_ / at_least(slowest, std::numeric_limits<Real>::min());
    }

    /// Ways of fewer bounces than this exist.
    Real most_bounces() const { return most_bounces_; }

    bool reaches(int bounces) const { return Real(bounces) < most_bounces_; }

    VCAVITY_INLINE ConnectingGroove<Real> groove(Panel first, int bounces) const {
      using std::cos;
      using std::sin;
      const Real inverse = Real(1) / Real(2 * bounces);
      const Real half_aperture = sum_ * inverse;
      const Real x = (Real(bounces + 1) * lower_.angle - Real(bounces - 1) * upper_.angle) * inverse;
      const Real beam =
          x < beta_ ? Real(Real(2) * cos(beta_) * sin(x)) : Real(sin(x_plus_beta(bounces, inverse)));
      return {first, bounces, cos(half_aperture), sin(half_aperture), at_least(beam, Real(0))};
    }

    /// The integral of the terms cos(α/2) B/j over j from n on, in steps of 2, for D(m) = 1, with
    /// the leading terms of sines and cosines of the small angle α/2.
    Real beyond(const Real& n) const {
      using std::cos;
      using std::log;
      using std::sin;
      if (!(n < most_bounces_)) return Real(0);
      const Real half_sum = Real(0.5) * sum_;
      const Real half_difference = Real(0.5) * difference_;
      const Real cos_beta = cos(beta_);
      const Real both_lit_until = beta_ > Real(0)
                                      ? at_most(Real(sum_ / (difference_ + Real(2) * beta_)), most_bounces_)
                                      : most_bounces_;
      const Real b = at_least(both_lit_until, n);
      const Real both = (sin(beta_) - cos_beta * half_difference) * log(b / n) +
                        cos_beta * half_sum * (Real(1) / n - Real(1) / b);
      const Real one = half_sum * (Real(1) / b - Real(1) / most_bounces_) -
                       (half_difference > Real(0) ? Real(half_difference * log(most_bounces_ / b)) : Real(0));
      return Real(0.5) * both + cos_beta * one;
    }

   private:
    /// Whether both elevations are measured from the near horizon with more digits than from the far one.
    bool is_low() const { return lower_.angle < lower_.complement; }

    Real x_plus_beta(int bounces, const Real& inverse) const {
      const Real upper = Real(2 * bounces - 1) * upper_.complement;
      return (is_low() ? Real(upper + lower_.angle - Real(bounces - 1) * pi<Real>())
                       : Real(upper - lower_.complement - Real(bounces - 2) * pi<Real>())) *
             inverse;
    }

    Elevation lower_, upper_;
    Real sum_;         // jα
    Real difference_;  // |k_e − k_o|
    Real beta_;
    Real most_bounces_;
  };

  /// A direction in the frame of the grooves; its inverse height, and products of two of these, are finite.
  VCAVITY_INLINE Vec3<Real> in_groove(const Vec3<Real>& v) const {
    return {v.x * across_.y - v.y * across_.x, v.x * across_.x + v.y * across_.y,
            at_least(v.z, least_height())};
  }

  static Real least_height() {
    using std::sqrt;
    if constexpr (std::is_floating_point_v<Real>) {
      return sqrt(smallest_divisor<Real>());
    } else {
      static const Real value = sqrt(smallest_divisor<Real>());
      return value;
    }
  }

  Vec2<Real> across_;
  Vec3<Real> e_, o_;  // in the frame of the grooves
  Real tilt_;         // |h|
  Real cos_eta_;
  Real inverse_sum_;  // 1/|e + o|
  // Of odd numbers of bounces, panel one and panel two first; then of even ones.
  std::array<Series, 4> series_;
};

}  // namespace vcavity
