// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The number types over which the library is tested.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <tuple>

namespace vcavity::test {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

using Reals = std::tuple<float, double, long double, Digits50>;
using HardwareReals = std::tuple<float, double, long double>;

template <class Real>
Real epsilon() {
  return std::numeric_limits<Real>::epsilon();
}

/// |actual − expected| in units of ε of `Real`, relative to the larger of |expected| and `scale`.
template <class Real, class Wide>
double error_in_epsilons(const Real& actual, const Wide& expected, double scale = 0) {
  const Digits50 exact(expected);
  const Digits50 difference = abs(Digits50(Digits50(actual) - exact));
  Digits50 unit = abs(exact);
  if (unit < scale) unit = Digits50(scale);
  if (difference == 0) return 0;
  return static_cast<double>(Digits50(difference / unit / Digits50(epsilon<Real>())));
}

}  // namespace vcavity::test
