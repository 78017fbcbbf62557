// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Slopes of a table, such as those of a measured profile.
///
/// The table gives the density p(t) of the mean area over the slope t = tan θ_m, piecewise linear, alike at all
/// azimuths. Isotropic facets have a density in proportion to t at small slopes, so p(0) must be 0; then
/// D(m) = p(t)/(2π sin θ_m cos³θ_m) is finite at m = z.
///
/// When not to use it: a profile measured along a line shows the components of the slopes along that line, not the
/// slopes of an isotropic surface. In brushed metal measured across the brush the two are the same.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/rough/slope_distribution.hpp"

namespace vcavity {

/// A row of a table of slopes.
template <class Real>
struct TabulatedSlope {
  Real slope;    ///< t = tan θ_m ≥ 0
  Real density;  ///< p(t) ≥ 0, in any unit
};

template <class Real>
class TabulatedSlopes {
 public:
  using value_type = Real;

  /// @param rows at least one above slope 0, in ascending order; a row of density 0 at slope 0 is added where
  ///        there is none. The densities need not be normalised, this does it.
  /// @throws std::invalid_argument when slopes do not ascend, a number is negative or not finite, the density at
  ///         slope 0 is not 0, or all densities are
  explicit TabulatedSlopes(std::vector<TabulatedSlope<Real>> rows) : rows_(std::move(rows)) {
    if (rows_.empty() || rows_.front().slope > Real(0)) rows_.insert(rows_.begin(), {Real(0), Real(0)});
    if (!(rows_.front().slope == Real(0) && rows_.front().density == Real(0)))
      refuse("density at the least slope", rows_.front().density, "0 at slope 0");
    share_below_.push_back(Real(0));
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const auto& [slope, density] = rows_[i];
      if (!(slope > rows_[i - 1].slope && slope <= std::numeric_limits<Real>::max()))
        refuse("slope", slope, "more than the one before it");
      if (!(density >= Real(0) && density <= std::numeric_limits<Real>::max()))
        refuse("density", density, "a finite number that is not negative");
      share_below_.push_back(share_below_.back() +
                             (slope - rows_[i - 1].slope) / Real(2) * (density + rows_[i - 1].density));
    }
    const Real all = share_below_.back();
    if (!(all > Real(0))) refuse("area under all densities", all, "positive");
    for (Real& share : share_below_) share /= all;
    for (TabulatedSlope<Real>& row : rows_) row.density /= all;
  }

  /// D(m), per steradian.
  /// @param m unit vector, m.z ≥ 0
  Real density(const Vec3<Real>& m) const {
    using std::sqrt;
    const Real across = sqrt(m.x * m.x + m.y * m.y);
    if (!(across < m.z * rows_.back().slope)) return Real(0);
    const Real slope = across / m.z;
    const auto after = std::upper_bound(rows_.begin() + 1, rows_.end() - 1, slope,
                                        [](const Real& t, const auto& row) { return t < row.slope; });
    const auto before = after - 1;
    const Real rise = (after->density - before->density) / (after->slope - before->slope);
    // p/t; in the first cell, where t may be 0, it is the rise.
    const Real per_slope =
        before == rows_.begin() ? rise : Real((before->density + rise * (slope - before->slope)) / slope);
    const Real cosine2 = m.z * m.z;
    return per_slope / (Real(2) * pi<Real>() * cosine2 * cosine2);
  }

  /// A normal of the density D(m) cos θ_m.
  /// @param u two random numbers, uniform in [0, 1]: of the slope and of the azimuth
  /// @return unit vector, z > 0
  Vec3<Real> sample(const Vec2<Real>& u) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const auto after = std::lower_bound(share_below_.begin() + 1, share_below_.end() - 1, u.x);
    const auto i = static_cast<std::size_t>(after - share_below_.begin()) - 1;
    const Real width = rows_[i + 1].slope - rows_[i].slope;
    const Real low = rows_[i].density;
    const Real rise = (rows_[i + 1].density - low) / width;
    const Real share = at_least(Real(u.x - share_below_[i]), Real(0));
    // The root of low·d + rise·d²/2 = share, without a difference.
    const Real root = sqrt(at_least(Real(low * low + Real(2) * rise * share), Real(0)));
    const Real step = low + root > Real(0) ? at_most(Real(Real(2) * share / (low + root)), width) : Real(0);
    const Real slope = rows_[i].slope + step;
    const Real cosine = Real(1) / Real(sqrt(Real(1) + slope * slope));
    const Real azimuth = Real(2) * pi<Real>() * u.y;
    return {slope * cosine * cos(azimuth), slope * cosine * sin(azimuth), cosine};
  }

 private:
  [[noreturn]] static void refuse(const char* what, const Real& value, const char* expected) {
    throw_invalid_argument("the ", what, " of a table of slopes must be ", expected, ", not ", value);
  }

  std::vector<TabulatedSlope<Real>> rows_;
  std::vector<Real> share_below_;  // of the mean area, at the rows
};

}  // namespace vcavity
