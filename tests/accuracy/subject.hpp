// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What "error" means here: how far a function of the library is from the exact result for its arguments, in
/// units of ε, beyond what the rounding of the arguments excuses.
///
/// The arguments of a function are themselves rounded. If moving each of them by ε moves the exact result by
/// the sum `change`, then half of that is unavoidable even for a perfect function. The error is therefore
/// counted in units of max(ε, change/2).

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "support/reals.hpp"

namespace vcavity::test {

using Random = std::mt19937_64;

/// An exact result, and the size in relation to which its error counts.
struct Exact {
  Digits50 value;
  Digits50 scale;
};

/// The results of a function, each with a key that tells which is which; a missing one is 0.
template <class T>
using Results = std::map<int, T>;

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
  std::function<Results<Exact>(const std::vector<Digits50>&)> exact;
  /// The error that is promised not to be exceeded.
  std::function<double(const Arguments&)> bound;
  /// Less than 1 for functions that take long.
  double share_of_samples = 1;
};

/// An error, and the promise it is compared with.
struct Error {
  double epsilons = 0;   ///< error in units of max(ε, change/2)
  double bound = 1;      ///< what it may be
  double condition = 0;  ///< change/ε: the factor by which relative errors of the arguments grow

  double share() const { return epsilons / bound; }
};

namespace detail {

/// The result of that key; a missing one is 0, on the scale of the others.
inline Exact find(const Results<Exact>& results, int key) {
  const auto found = results.find(key);
  if (found != results.end()) return found->second;
  return {Digits50(0), results.empty() ? Digits50(0) : results.begin()->second.scale};
}

/// For every key of either argument: a function of both values.
template <class Real, class Visit>
void for_each_key(const Results<Real>& a, const Results<Exact>& b, Visit&& visit) {
  for (const auto& [key, value] : a) visit(key);
  for (const auto& [key, value] : b)
    if (!a.contains(key)) visit(key);
}

/// By how much each exact result changes when every argument moves by ε, whichever way moves it more.
template <class Real>
Results<Digits50> changes_by_rounding(const Subject<Real>& subject, const std::vector<Digits50>& arguments,
                                      const Results<Exact>& exact) {
  Results<Digits50> sum;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    Results<Digits50> largest;
    for (const int direction : {-1, 1}) {
      std::vector<Digits50> moved = arguments;
      moved[i] *= 1 + direction * Digits50(epsilon<Real>());
      const Results<Exact> then = subject.exact(moved);
      const auto compare = [&](int key) {
        const Digits50 change = abs(Digits50(find(then, key).value - find(exact, key).value));
        largest[key] = std::max(largest[key], change);
      };
      for (const auto& [key, value] : exact) compare(key);
      for (const auto& [key, value] : then)
        if (!exact.contains(key)) compare(key);
    }
    for (const auto& [key, change] : largest) sum[key] += change;
  }
  return sum;
}

}  // namespace detail

/// The largest error among the results of a subject.
/// @param of_interest a share of the bound; errors below it are reported without looking at the condition,
/// which could only make them smaller
template <class Real>
Error error_of(const Subject<Real>& subject, const std::vector<Real>& arguments, double of_interest = 0) {
  const std::vector<Digits50> wide(arguments.begin(), arguments.end());
  const Results<Real> actual = subject.actual(arguments);
  const Results<Exact> exact = subject.exact(wide);
  const Digits50 eps(epsilon<Real>());
  // Below the smallest normal number there are no relative errors.
  const Digits50 smallest = Digits50(std::numeric_limits<Real>::min()) / eps;
  const double bound = subject.bound(arguments);

  Results<Digits50> errors;
  Digits50 largest(0);
  detail::for_each_key(actual, exact, [&](int key) {
    const auto found = actual.find(key);
    const Real value = found == actual.end() ? Real(0) : found->second;
    // Neither NaN nor infinity is ever right; 1e30 ε is as wrong as can be.
    Digits50 error("1e30");
    if (abs(value) <= std::numeric_limits<Real>::max()) {
      const Exact& truth = detail::find(exact, key);
      const Digits50 scale = std::max(truth.scale, smallest);
      error = abs(Digits50(Digits50(value) - truth.value)) / scale / eps;
    }
    errors[key] = error;
    largest = std::max(largest, error);
  });
  if (static_cast<double>(largest) <= of_interest * bound) return {static_cast<double>(largest), bound, 0};

  const Results<Digits50> changes = detail::changes_by_rounding(subject, wide, exact);
  Error worst{0, bound, 0};
  for (const auto& [key, error] : errors) {
    const auto change = changes.find(key);
    const Digits50 scale = std::max(detail::find(exact, key).scale, smallest);
    const Digits50 condition = change == changes.end() ? Digits50(0) : Digits50(change->second / scale / eps);
    const double beyond =
        static_cast<double>(Digits50(error / std::max(Digits50(1), Digits50(condition / 2))));
    if (beyond >= worst.epsilons) worst = {beyond, bound, static_cast<double>(condition)};
  }
  return worst;
}

}  // namespace vcavity::test
