// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What "error" means here: how far a function of the library is from the exact result for its arguments, in
/// units of ε, beyond what the rounding of the arguments excuses.
///
/// The arguments of a function are themselves rounded. If moving each of them by ε moves the exact result by
/// the sum `change`, then half of that is unavoidable even for a perfect function. The error is therefore
/// counted in units of max(ε, change/2).

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "support/reals.hpp"

#ifdef VCAVITY_HAS_FLOAT128
#include <boost/multiprecision/float128.hpp>
#endif

namespace vcavity::test {

using Random = std::mt19937_64;

/// An exact result, and the size in relation to which its error counts.
template <class Wide>
struct Exact {
  Wide value;
  Wide scale;
};

/// The results of a function, each with a key that tells which is which; a missing one is 0.
template <class T>
using Results = std::map<int, T>;

template <class Wide>
using ExactResults = Results<Exact<Wide>>;

/// 34 digits; as __float128 several times faster.
#ifdef VCAVITY_HAS_FLOAT128
using Digits34 = boost::multiprecision::float128;
#else
using Digits34 = boost::multiprecision::cpp_bin_float_quad;
#endif

/// The number type in which a reference is evaluated first: enough digits to tell which arguments deserve all
/// fifty, and several times faster.
template <class Real>
struct ScreeningType {
  using type = Digits34;
};
template <>
struct ScreeningType<float> {
  using type = long double;
};
template <class Real>
using Screening = typename ScreeningType<Real>::type;

/// A function of the library under measurement.
template <class Real>
struct Subject {
  using Arguments = std::vector<Real>;

  std::string name;
  std::vector<std::string> argument_names;
  /// Draws arguments, near the hard cases more often than chance would have it.
  std::function<Arguments(Random&)> sample;
  /// Moves arguments to the nearest ones that the function admits.
  std::function<void(Arguments&)> repair;
  std::function<Results<Real>(const Arguments&)> actual;
  /// The error that is promised not to be exceeded.
  std::function<double(const Arguments&)> bound;
  /// Whether the results are the components of one quantity: they then share the change of the one that
  /// changes most. A component that is 0 on one side of the critical angle tells nothing of what is near.
  bool is_one_quantity = false;
  /// By how many ε arguments are moved to see how fast the results change. Where they change abruptly, as
  /// fields do at the critical angle, one ε may not tell.
  std::vector<int> moves{-1, 1};
  /// Less than 1 for functions that take long.
  double share_of_samples = 1;

  std::function<ExactResults<Digits50>(const std::vector<Digits50>&)> exact;
  std::function<ExactResults<Screening<Real>>(const std::vector<Screening<Real>>&)> nearly_exact;

  /// Sets the reference, a function of a vector of arguments in any number type.
  template <class Reference>
  void refer_to(const Reference& reference) {
    exact = reference;
    nearly_exact = reference;
  }
};

/// An error, and the promise it is compared with.
struct Error {
  double epsilons = 0;   ///< error in units of max(ε, change/2)
  double bound = 1;      ///< what it may be
  double condition = 0;  ///< change/ε: the factor by which relative errors of the arguments grow

  double share() const { return epsilons / bound; }
};

/// Numbers below this have no relative precision: they are less than the smallest normal number over ε.
template <class Real>
Real smallest_relative() {
  return std::numeric_limits<Real>::min() / epsilon<Real>();
}

namespace detail {

/// The result of that key; a missing one is 0, on the scale of the others.
template <class Wide>
Exact<Wide> find(const ExactResults<Wide>& results, int key) {
  const auto found = results.find(key);
  if (found != results.end()) return found->second;
  return {Wide(0), results.empty() ? Wide(0) : results.begin()->second.scale};
}

/// For every key of either argument: a function of both values.
template <class A, class B, class Visit>
void for_each_key(const Results<A>& a, const Results<B>& b, Visit&& visit) {
  for (const auto& [key, value] : a) visit(key);
  for (const auto& [key, value] : b)
    if (!a.contains(key)) visit(key);
}

/// By how much each exact result changes for each `eps` by which an argument moves, summed over the
/// arguments; whichever of `moves` moves it more.
template <class Wide, class Reference>
Results<Wide> changes_by_rounding(const Reference& reference, const std::vector<Wide>& arguments,
                                  const ExactResults<Wide>& exact, const std::vector<int>& moves,
                                  const Wide& eps) {
  using std::abs;
  Results<Wide> sum;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    Results<Wide> largest;
    for (const int move : moves) {
      std::vector<Wide> moved = arguments;
      moved[i] *= 1 + move * eps;
      const ExactResults<Wide> then = reference(moved);
      for_each_key(exact, then, [&](int key) {
        const Wide change = abs(Wide(find(then, key).value - find(exact, key).value)) / std::abs(move);
        largest[key] = std::max(largest[key], change);
      });
    }
    for (const auto& [key, change] : largest) sum[key] += change;
  }
  return sum;
}

/// Replaces every value by the largest.
template <class Wide>
void share_largest(Results<Wide>& values) {
  Wide largest(0);
  for (const auto& [key, value] : values) largest = std::max(largest, value);
  for (auto& [key, value] : values) value = largest;
}

/// The largest error among the results of a subject, in relation to a reference in the number type `Wide`.
template <class Wide, class Real, class Reference>
Error error_against(const Reference& reference, const Subject<Real>& subject,
                    const std::vector<Real>& arguments, double of_interest) {
  using std::abs;
  const std::vector<Wide> wide(arguments.begin(), arguments.end());
  const Results<Real> actual = subject.actual(arguments);
  const ExactResults<Wide> exact = reference(wide);
  const Wide eps(epsilon<Real>());
  const Wide smallest(smallest_relative<Real>());
  const double bound = subject.bound(arguments);

  Results<double> errors;
  double largest = 0;
  for_each_key(actual, exact, [&](int key) {
    const auto found = actual.find(key);
    const Real value = found == actual.end() ? Real(0) : found->second;
    // Neither NaN nor infinity is ever right; 1e30 ε is as wrong as can be.
    double error = 1e30;
    if (abs(value) <= std::numeric_limits<Real>::max()) {
      const Exact<Wide> truth = find(exact, key);
      const Wide scale = std::max(truth.scale, smallest);
      const Wide epsilons = abs(Wide(Wide(value) - truth.value)) / scale / eps;
      // A reference without an answer counts as an error, too.
      if (epsilons < 1e30) error = static_cast<double>(epsilons);
    }
    errors[key] = error;
    largest = std::max(largest, error);
  });
  if (largest <= of_interest * bound) return {largest, bound, 0};

  Results<Wide> changes = changes_by_rounding(reference, wide, exact, subject.moves, eps);
  if (subject.is_one_quantity) share_largest(changes);
  Error worst{0, bound, 0};
  for (const auto& [key, error] : errors) {
    const auto change = changes.find(key);
    const Wide scale = std::max(find(exact, key).scale, smallest);
    const double condition =
        change == changes.end() ? 0 : static_cast<double>(Wide(change->second / scale / eps));
    const double beyond = error / std::max(1.0, condition / 2);
    if (!(beyond < worst.epsilons)) worst = {beyond, bound, condition};
  }
  return worst;
}

}  // namespace detail

/// The largest error among the results of a subject.
/// @param of_interest a share of the bound. Errors below it may be estimates, against a reference of fewer
/// digits, and without looking at the condition, which could only make them smaller.
template <class Real>
Error error_of(const Subject<Real>& subject, const std::vector<Real>& arguments, double of_interest = 0) {
  if (of_interest > 0) {
    constexpr double margin = 0.9;  // of what fewer digits may make of an error
    const Error estimate = detail::error_against<Screening<Real>>(subject.nearly_exact, subject, arguments,
                                                                  margin * of_interest);
    if (estimate.share() <= margin * of_interest) return estimate;
  }
  return detail::error_against<Digits50>(subject.exact, subject, arguments, of_interest);
}

}  // namespace vcavity::test
