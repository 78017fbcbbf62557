// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Σ wᵢ ln(1 + z cᵢ) for one set of weights and places and many z, at a price that does not grow with their number.
///
/// Method. Only the logarithms of the places near 1/z, within a factor of 8, are taken one by one. Below, where y = zc
/// is less than 1/8, ln(1 + y) = y − y²/2 + …; above, ln(1 + y) = ln y + 1/y − 1/(2y²) + …, and of both series
/// what belongs to the places is summed beforehand, for every place at which the far ones may begin. Places that crowd
/// within an eighth of the greatest, C, share its logarithm: ln(1 + y) = ln(1 + zC) + ln(1 − z(C − c)/(1 + zC)).
/// As long as zC is at most 1 there is one series for all, in r = zC/(1 + √(1 + zC))² with Chebyshev's polynomials,
///
///     ln(1 + y) = 2 Σ (rᵏ/k) (1 − Tₖ(1 − 2c/C)),      y = 2 Σ rᵏ 2kc/C,
///
/// of terms and differences that are all positive.
///
/// When not to use it: for a few z alone, as the sums beforehand cost as much as some ten z.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/small_differences.hpp"

namespace vcavity {

/// A sum of logarithms over fixed places.
template <class Real>
class LogarithmSum {
 public:
  /// @param weights wᵢ > 0, at least one
  /// @param places cᵢ > 0, as many, in ascending order
  LogarithmSum(std::vector<Real> weights, std::vector<Real> places)
      : weights_(std::move(weights)), places_(std::move(places)), upper_(places_.size()) {
    using std::log;
    const std::size_t n = places_.size();
    below_.assign(n * terms, Real(0));
    above_.assign(n * terms, Real(0));
    for (std::size_t i = 0; i < n; ++i)
      gather(&below_[i * terms], i > 0 ? &below_[(i - 1) * terms] : nullptr,
             i > 0 ? Real(places_[i - 1] / places_[i]) : Real(0), weights_[i]);
    for (std::size_t i = n; i-- > 0;) {
      const bool last = i + 1 == n;
      const Real ratio = last ? Real(0) : Real(places_[i] / places_[i + 1]);
      gather(&above_[i * terms], last ? nullptr : &above_[(i + 1) * terms], ratio, weights_[i]);
      upper_[i] = {weights_[i], Real(0), weights_[i] * places_[i]};
      if (last) continue;
      const Upper& next = upper_[i + 1];
      upper_[i].weight += next.weight;
      upper_[i].first_moment += next.first_moment;
      upper_[i].logarithms = next.logarithms - next.weight * log(ratio);
    }
    for (std::size_t i = 0; i < n; ++i) {
      scale_to_series(&below_[i * terms]);
      scale_to_series(&above_[i * terms]);
    }
    gather_crowd();
    gather_polynomials();
  }

  /// From here on `with_all_above` holds: an eighth of the least place.
  Real all_above() const { return places_.front() / far(); }

  /// Σ wᵢ ln(1 + z cᵢ) and Σ wᵢ (z cᵢ − ln(1 + z cᵢ)), both with nearly all their digits.
  /// @param z ≥ 0, finite
  LogarithmAndRest<Real> at(const Real& z) const {
    using std::log;
    if (z * places_.back() <= Real(1)) return of_small(z);
    const auto far_below = [&](const Real& place) { return z * place * far() < Real(1); };
    const auto near_enough = [&](const Real& place) { return z * place < far(); };
    const auto begin = std::partition_point(places_.begin(), places_.end(), far_below);
    const auto end = std::partition_point(begin, places_.end(), near_enough);
    const auto first = static_cast<std::size_t>(begin - places_.begin());
    const auto last = static_cast<std::size_t>(end - places_.begin());
    LogarithmAndRest<Real> result{Real(0), Real(0)};
    if (first > 0) {
      const Real* series = &below_[(first - 1) * terms];
      const Real y = z * places_[first - 1];
      const Real rest = -y * y * horner(series + 1, terms - 1, y);
      result = {y * series[0] - rest, rest};
    }
    const bool crowded = first <= crowd_ && crowd_ < last;
    const std::size_t near_end = crowded ? crowd_ : last;
    for (std::size_t i = first; i < near_end; ++i) {
      const Real y = z * places_[i];
      const Real logarithm = log(Real(1) + y);
      result.logarithm += weights_[i] * logarithm;
      result.rest += weights_[i] * (y - logarithm);
    }
    if (crowded) {
      const Upper& upper = upper_[crowd_];
      const Real whole = Real(1) + z * places_.back();
      const Real lack = z * (places_.back() - places_[crowd_]) / whole;
      const Real logarithm = upper.weight * log(whole) - lack * horner(lacks_.data(), terms, lack);
      result.logarithm += logarithm;
      result.rest += z * upper.first_moment - logarithm;
    } else if (last < places_.size()) {
      const Upper& upper = upper_[last];
      const Real y = z * places_[last];
      const Real inverse = Real(1) / y;
      const Real logarithm =
          upper.weight * log(y) + upper.logarithms + inverse * horner(&above_[last * terms], terms, inverse);
      result.logarithm += logarithm;
      result.rest += z * upper.first_moment - logarithm;
    }
    return result;
  }

  /// The same where no logarithm can be spared: for z below 0, with z cᵢ > −1.
  LogarithmAndRest<Real> at_negative(const Real& z) const {
    LogarithmAndRest<Real> result{Real(0), Real(0)};
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const LogarithmAndRest<Real> term = logarithm_and_rest(Real(z * places_[i]));
      result.logarithm += weights_[i] * term.logarithm;
      result.rest += weights_[i] * term.rest;
    }
    return result;
  }

  /// Σ wᵢ ln(cᵢ + t), which has a limit as t tends to 0.
  /// @param t in [0, `all_above()`]
  Real with_all_above(const Real& t) const {
    using std::log;
    const Upper& upper = upper_.front();
    const Real inverse = t / places_.front();
    return upper.weight * log(places_.front()) + upper.logarithms +
           inverse * horner(above_.data(), terms, inverse);
  }

 private:
  /// How far from 1/z a place is far.
  static Real far() { return Real(8); }

  /// Of the series: three bits each.
  static constexpr std::size_t terms = std::numeric_limits<Real>::digits / 3 + 1;

  /// Of the series where zC ≤ 1: r ≤ 0.172, two and a half bits each.
  static constexpr std::size_t terms_of_small = std::numeric_limits<Real>::digits * 2 / 5 + 3;

  /// What the places from one on have in common.
  struct Upper {
    Real weight;        ///< Σ wⱼ
    Real logarithms;    ///< Σ wⱼ ln(cⱼ/cᵢ)
    Real first_moment;  ///< Σ wⱼcⱼ
  };

  /// Sums of powers of the ratio of the places to a new one, from those to its neighbour.
  static void gather(Real* powers, const Real* neighbour, const Real& ratio, const Real& weight) {
    Real power(1);
    for (std::size_t k = 0; k < terms; ++k) {
      power *= ratio;
      powers[k] = weight + (neighbour ? Real(neighbour[k] * power) : Real(0));
    }
  }

  /// Sums of powers to coefficients of ln(1 + y)/y.
  static void scale_to_series(Real* powers) {
    for (std::size_t k = 0; k < terms; ++k)
      powers[k] /= Real(k % 2 == 0 ? static_cast<int>(k) + 1 : -static_cast<int>(k) - 1);
  }

  void gather_crowd() {
    const Real greatest = places_.back();
    while (places_[crowd_] * far() < greatest * (far() - Real(1))) ++crowd_;
    lacks_.assign(terms, Real(0));
    for (std::size_t i = crowd_; i + 1 < places_.size(); ++i) {
      const Real ratio = (greatest - places_[i]) / (greatest - places_[crowd_]);
      Real power(1);
      for (std::size_t k = 0; k < terms; ++k) {
        power *= ratio;
        lacks_[k] += weights_[i] * power / Real(static_cast<int>(k) + 1);
      }
    }
  }

  void gather_polynomials() {
    logarithms_of_small_.assign(terms_of_small, Real(0));
    rests_of_small_.assign(terms_of_small, Real(0));
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Real place = places_[i] / places_.back();
      Real before(0), lack = Real(2) * place;  // 1 − T of the orders k − 1 and k
      for (std::size_t k = 1; k <= terms_of_small; ++k) {
        const Real order = Real(static_cast<int>(k));
        logarithms_of_small_[k - 1] += Real(2) * weights_[i] * lack / order;
        if (k > 1) rests_of_small_[k - 1] += Real(2) * weights_[i] * (Real(2) * order * place - lack / order);
        const Real next = Real(2) * (Real(1) - Real(2) * place) * lack - before + Real(4) * place;
        before = lack;
        lack = next;
      }
    }
  }

  /// The sums for z times the greatest place at most 1.
  LogarithmAndRest<Real> of_small(const Real& z) const {
    using std::sqrt;
    const Real y = z * places_.back();
    const Real root = Real(1) + sqrt(Real(1) + y);
    const Real r = y / (root * root);
    return {r * horner(logarithms_of_small_.data(), terms_of_small, r),
            r * r * horner(rests_of_small_.data() + 1, terms_of_small - 1, r)};
  }

  static Real horner(const Real* coefficients, std::size_t count, const Real& x) {
    Real sum = coefficients[count - 1];
    for (std::size_t k = count - 1; k-- > 0;) sum = sum * x + coefficients[k];
    return sum;
  }

  std::vector<Real> weights_, places_;
  std::vector<Upper> upper_;
  std::vector<Real> below_;  // for the places up to each
  std::vector<Real> above_;  // for those from each on
  std::size_t crowd_ = 0;    // the first that crowds below the greatest
  std::vector<Real> lacks_;  // for what the crowd lacks of it
  std::vector<Real> logarithms_of_small_, rests_of_small_;
};

}  // namespace vcavity
