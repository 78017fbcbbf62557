// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Diffuse light on a symmetric groove, sorted by the number of its bounces.
///
/// Method. Unfold the groove: rays that bounce m times cross the opening, the chord of the unit circle that
/// spans the aperture α, and leave through the chord m apertures further. Let u be the angle between a ray,
/// seen along the groove, and the line through both middles. Reversing the ray changes the sign of u, and by
/// reciprocity nothing else; so 0 ≤ u < α/2 is enough. The width in which the two chords overlap is
///
///     T_m(u) = cos(β + u) − max(0, cos(β + α − u)),   β = (m − 1) α/2,
///
/// mostly 2 sin(mα/2) sin(α/2 − u), and the ray meets the panels at the angles x_i = u + (i − (m + 1)/2) α,
/// i = 1, …, m, from their normals. With ψ the angle out of the plane across the groove,
///
///     R = 4/(π sin(α/2)) ∫ du ∫ dψ cos²ψ Σ_m T_m(u) Π_i ρ(cos ψ cos x_i)   over [0, α/2] × [0, π/2].
///
/// From m to m + 2 bounces the product gains a factor at either end: so all its terms together cost two
/// facet reflectances each. As a function of u the sum is smooth, however many kinks the reflectance has as a
/// function of the direction; but for the rays of most bounces, N, which end at u = a = (π − (N − 1) α)/2, and where
/// the overlap of those that bounce once less meets the apex, at u = b = (N α − π)/2. For ρ = 1 integration gives the
/// crossed strings of Hottel, W_m.
///
/// Only the overlaps have these kinks, and the product of a number of bounces has none. With T_m = 2 sin(mα/2) sin(α/2 − u)
/// the rays of up to N − 1 bounces are smooth together, as if none met the apex; those of N − 1 are then too many by
/// sin(b − u) for u < b, and those of N bounces are left, with the overlap sin(a − u) for u < a. Each of the three can be
/// integrated by itself.
///
/// When not to use it: for grooves that are not symmetric, and for facets that depend on the panel or on the
/// number of the bounce.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity::detail {

/// The first and the last bounce of a ray.
template <class Real>
struct RayEnds {
  Real cosine_first, sine_first;  ///< of x_1
  Real cosine_last, sine_last;    ///< of x_m
};

/// The rays of a series and their overlaps.
enum class RaysAcross {
  all,         ///< of up to a number of bounces, as they are
  as_if_free,  ///< the same, as if none met the apex
  single       ///< of this number of bounces only, with the overlap 1
};

/// The geometry of the series for one u.
template <class Real>
class BounceSeries {
 public:
  /// Rays of m bounces.
  struct Term {
    RayEnds<Real> ends;
    Real weight;  ///< T_m
    Real rest;    ///< T_(m + 2) + T_(m + 4) + …
  };

  /// @param cavity must outlive the series
  /// @param u in [0, α/2]
  /// @param max_bounces terms of more bounces are left out
  /// @param rays with `as_if_free`, `max_bounces` is less than the groove's; with `single`, rays of that many reach u
  BounceSeries(const Cavity<Real>& cavity, const Real& u, int max_bounces, RaysAcross rays = RaysAcross::all)
      : cavity_(&cavity), u_(u), size_(std::min(max_bounces, cavity.max_bounces())), rays_(rays) {
    // The rays of most bounces may not come to this u at all.
    while (rays == RaysAcross::all && size_ > 0 && !(angle(size_) + u < pi<Real>() / Real(2))) --size_;
    constexpr int usual = 8;
    terms_.reserve(static_cast<std::size_t>(std::min(size_, usual)));
  }

  /// The largest number of bounces.
  int size() const { return size_; }

  /// @param m number of bounces, from 1 to `size()`
  Term operator[](int m) const {
    const auto index = static_cast<std::size_t>(m - 1);
    if (index > terms_.size()) return term(m);  // behind terms that were not asked for
    if (index == terms_.size()) terms_.push_back(term(m));
    return terms_[index];
  }

  /// T for a number of bounces that need not be an integer, below `unclipped()`.
  Real smooth_weight(const Real& m) const {
    using std::sin;
    if (is_single()) return Real(0);
    const Real half = cavity_->aperture() / Real(2);
    return Real(2) * sin(m * half) * sin(half - u_);
  }

  /// Whether there are rays of `size()` bounces only.
  bool is_single() const { return rays_ == RaysAcross::single; }

  /// The bounces at the angles u ∓ kα/2, for a k that need not be an integer.
  RayEnds<Real> ends(const Real& k) const {
    const Real turn = k * (cavity_->aperture() / Real(2));
    return ends_at(u_ - turn, u_ + turn);
  }

  /// α
  Real aperture() const { return cavity_->aperture(); }

  /// The largest number of bounces of rays that lie as far from the apex as those of fewer.
  int unclipped() const {
    int m = is_single() ? size_ - 1 : size_;
    while (m > 0 && is_clipped(m)) --m;
    return m;
  }

  /// T_(m + 2) + T_(m + 4) + …
  /// @param m number of bounces, from −1
  Real rest(int m) const {
    using std::sin;
    if (is_single()) return Real((size_ - m) % 2 == 0 && m < size_ ? 1 : 0);
    const Real half = cavity_->aperture() / Real(2);
    Real sum(0);
    int last = m + (size_ - m) / 2 * 2;
    for (; last > m && is_clipped(last); last -= 2) sum += weight(last);
    const int terms = (last - m) / 2;
    if (terms > 0)
      sum += Real(2) * sin(half - u_) * sin(Real(terms) * half) * sin(Real(m + terms + 1) * half) /
             cavity_->sin_half();
    return sum;
  }

 private:
  /// β
  Real angle(int m) const { return Real(m - 1) * (cavity_->aperture() / Real(2)); }

  /// Whether the overlap meets the apex.
  bool is_clipped(int m) const {
    return rays_ == RaysAcross::all && angle(m) + cavity_->aperture() - u_ > pi<Real>() / Real(2);
  }

  Real weight(int m) const {
    using std::cos;
    using std::sin;
    if (is_single()) return Real(m == size_ ? 1 : 0);
    const Real half = cavity_->aperture() / Real(2);
    return is_clipped(m) ? cos(angle(m) + u_) : Real(2) * sin(Real(m) * half) * sin(half - u_);
  }

  static RayEnds<Real> ends_at(const Real& first, const Real& last) {
    using std::cos;
    using std::sin;
    return {at_least(Real(cos(first)), Real(0)), sin(first), at_least(Real(cos(last)), Real(0)), sin(last)};
  }

  Term term(int m) const {
    return {ends_at(u_ - angle(m), u_ + angle(m)), at_least(weight(m), Real(0)), rest(m)};
  }

  const Cavity<Real>* cavity_;
  Real u_;
  int size_;
  RaysAcross rays_;
  mutable std::vector<Term> terms_;  // as far as asked for
};

}  // namespace vcavity::detail
