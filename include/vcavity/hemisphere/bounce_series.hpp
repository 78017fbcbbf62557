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
/// function of the direction; but for the rays of most bounces, which end at (π − (m − 1) α)/2, and where
/// the overlap meets the apex, at ((m + 1) α − π)/2. For ρ = 1 integration gives the crossed strings of
/// Hottel, W_m.
///
/// When not to use it: for grooves that are not symmetric, and for facets that depend on the panel or on the
/// number of the bounce.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <vector>

#include "vcavity/facet/facet.hpp"
#include "vcavity/groove/cavity.hpp"
#include "vcavity/hemisphere/long_series.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/polarization/jones.hpp"

namespace vcavity::detail {

/// Upper bound on the part of unpolarised light that a way leaves over, and so on what any longer way does.
template <class Value>
auto light_left(const Value& throughput) {
  return largest(throughput);
}
template <class Value>
auto light_left(const Jones<Value>& throughput) {
  const auto element = largest(throughput);
  return scalar_t<Value>(4) * element * element;  // ½‖J‖² of eight numbers
}

/// The geometry of the series for one u.
template <class Real>
class BounceSeries {
 public:
  /// Rays of m bounces.
  struct Term {
    Real cosine_first, sine_first;  ///< of x_1
    Real cosine_last, sine_last;    ///< of x_m
    Real weight;                    ///< T_m
    Real rest;                      ///< T_(m + 2) + T_(m + 4) + …
  };

  /// @param cavity must outlive the series
  /// @param u in [0, α/2]
  /// @param max_bounces terms of more bounces are left out
  BounceSeries(const Cavity<Real>& cavity, const Real& u, int max_bounces)
      : cavity_(&cavity), u_(u), size_(std::min(max_bounces, cavity.max_bounces())) {
    // The rays of most bounces may not come to this u at all.
    while (size_ > 0 && !(angle(size_) + u < pi<Real>() / Real(2))) --size_;
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
    const Real half = cavity_->aperture() / Real(2);
    return Real(2) * sin(m * half) * sin(half - u_);
  }

  /// The cosines of u ∓ kα/2.
  std::array<Real, 2> cosines(const Real& k) const {
    using std::cos;
    const Real turn = k * (cavity_->aperture() / Real(2));
    return {at_least(Real(cos(u_ - turn)), Real(0)), at_least(Real(cos(u_ + turn)), Real(0))};
  }

  /// The largest number of bounces of rays that lie as far from the apex as those of fewer.
  int unclipped() const {
    int m = size_;
    while (m > 0 && is_clipped(m)) --m;
    return m;
  }

  /// T_(m + 2) + T_(m + 4) + …
  /// @param m number of bounces, from −1
  Real rest(int m) const {
    using std::sin;
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
  bool is_clipped(int m) const { return angle(m) + cavity_->aperture() - u_ > pi<Real>() / Real(2); }

  Real weight(int m) const {
    using std::cos;
    using std::sin;
    const Real half = cavity_->aperture() / Real(2);
    return is_clipped(m) ? cos(angle(m) + u_) : Real(2) * sin(Real(m) * half) * sin(half - u_);
  }

  Term term(int m) const {
    using std::cos;
    using std::sin;
    const Real first = u_ - angle(m);
    const Real last = u_ + angle(m);
    return {at_least(Real(cos(first)), Real(0)), sin(first), at_least(Real(cos(last)), Real(0)), sin(last),
            at_least(weight(m), Real(0)),        rest(m)};
  }

  const Cavity<Real>* cavity_;
  Real u_;
  int size_;
  mutable std::vector<Term> terms_;  // as far as asked for
};

/// The sum of a series for one ψ, or a pack of them.
template <class Value, class Real>
struct SeriesValue {
  Value value;
  Real left_out;  ///< bound on the error of what has been left out
};

/// What of a series need not be followed.
template <class Real>
struct SeriesLimits {
  Real negligible;   ///< the last part, when less light than this is left
  Real total_below;  ///< bounces whose cosine of incidence is below: they reflect all light
  int max_terms;     ///< what comes after as many bounces as this
};

/// How many terms can be done at once after m bounces: the logarithm of half of them, or less than `min_block_log2`.
/// @param most the last term of the block at most
/// @param growth factor from m − 2 to m bounces
/// @param product of m bounces
/// @param negligible lanes with less light do not matter
template <class Value, class Real>
int block_after(int m, int most, Value growth, Value product, const Real& negligible) {
  using std::log;
  int count = std::min(m, most - m) / 2;
  constexpr Real largest_fall = Real(8);  // of the logarithm; the rules for sums are good for that
  for (std::size_t lane = 0; lane < PlainNumbers<Value>::count; ++lane) {
    if (PlainNumbers<Value>::at(product, lane) < negligible) continue;
    const Real fall = -log(at_least(PlainNumbers<Value>::at(growth, lane), std::numeric_limits<Real>::min()));
    if (fall * Real(count) > largest_fall) count = static_cast<int>(largest_fall / fall);
  }
  int log2 = 0;
  while (log2 < max_block_log2 && 2 << log2 <= count) ++log2;
  return log2;
}

/// A value that knows how many bounces it is the product of: bounces that reflect all light change it all the same.
template <class Throughput>
concept CountsBounces = requires(const Throughput& throughput) { throughput.bounces; };

/// Σ_m T_m Π_i ρ(cos ψ cos x_i)
/// @param sine, cosine of ψ
template <class Real, class Facet, class Reals>
auto sum_of_series(const BounceSeries<Real>& series, const Facet& facet, const Reals& sine,
                   const Reals& cosine, const SeriesLimits<Real>& limits) {
  using Throughput = value_t<Facet, Reals>;
  using Sum = unpolarized_t<Facet, Reals>;
  // Bounces alternate between the panels; by symmetry it does not matter on which they begin.
  const auto at = [&](const Real& cos_across, const Real& sin_across, int parity) {
    return reflect(facet, Bounce<Reals>{cos_across * cosine, -sin_across * cosine, sine,
                                        parity % 2 == 0 ? Panel::one : Panel::two, 1});
  };
  const auto light = [](const Throughput& throughput) { return unpolarized(power(throughput)); };
  const Real total_below = limits.total_below / largest(cosine);
  SeriesValue<Sum, Real> result{Sum(0), Real(0)};
  int next_block = 64;               // when it pays to do many bounces at once
  Throughput of_odd(1), of_even(1);  // products of an odd and of an even number of bounces
  for (int m = 1; m <= series.size(); ++m) {
    const auto term = series[m];
    Throughput& product = m % 2 == 1 ? of_odd : of_even;
    const Throughput first = at(term.cosine_first, term.sine_first, m / 2);
    const Throughput last = m == 1 ? Throughput(1) : at(term.cosine_last, term.sine_last, m / 2 + m - 1);
    product = first * product * last;
    result.value = result.value + scaled(term.weight, light(product));
    if (m % 2 == 0 && m < series.size()) {
      const Real odd_rest = series[m - 1].rest;
      const Real left = Real(light_left(of_odd)) * odd_rest + Real(light_left(of_even)) * term.rest;
      const bool is_total = !CountsBounces<Throughput> && series[m - 1].cosine_first <= total_below;
      if (is_total || left <= limits.negligible || m >= limits.max_terms) {
        result.value = result.value + scaled(odd_rest, light(of_odd)) + scaled(term.rest, light(of_even));
        if (!is_total) result.left_out += left;
        break;
      }
      if constexpr (PlainNumbers<Throughput>::count > 0 && std::is_floating_point_v<Real> &&
                    std::invocable<const Facet&, const Reals&>) {
        if (m < next_block) continue;
        const int log2 = block_after(m, series.unclipped(), first * last, product, limits.negligible);
        next_block = m + 16;
        if (log2 < min_block_log2) continue;
        const auto block = sum_of_block<Real>(
            m, log2,
            [&](const Real& k) {
              const auto [before, after] = series.cosines(k);
              return facet(Reals(before * cosine)) * facet(Reals(after * cosine));
            },
            [&](const Real& bounces) { return series.smooth_weight(bounces); },
            SeriesProducts<Throughput>{of_odd, of_even});
        const Real error = block.uncertain * left;
        constexpr Real small = Real(0.01);
        if (!(error <= small * limits.negligible)) {
          next_block = m + (2 << log2);
          continue;
        }
        result.value = result.value + block.value;
        result.left_out += error;
        of_odd = block.products.of_odd;
        of_even = block.products.of_even;
        m += 2 << log2;
        next_block = m + 2;
      }
    }
  }
  return result;
}

}  // namespace vcavity::detail
