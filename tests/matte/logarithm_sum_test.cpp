// SPDX-License-Identifier: BSD-3-Clause
/// Sums of logarithms over many places, of which few are taken one by one.

#include <algorithm>
#include <cmath>
#include <vcavity/numbers/logarithm_sum.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// Weights that fall and places that rise, over `decades`, to places that crowd at 1.
template <class Real>
struct Places {
  std::vector<Real> weights, places;

  explicit Places(double decades) {
    for (int i = 0; i < 60; ++i) {
      const double x = std::pow(10.0, decades * (i / 40.0 - 1));
      weights.push_back(Real(1 / (1 + x)));
      places.push_back(Real(x / (1 + x)));
    }
  }
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("a sum of logarithms and what is left of it have nearly all their digits for every z",
                        "", HardwareReals) {
  using Real = TestType;
  double worst = 0;
  for (const double decades : {0.3, 2.0, 9.0}) {
    const Places<Real> far(decades);
    const LogarithmSum<Real> sum(far.weights, far.places);
    for (double exponent = -12; exponent < 12; exponent += 0.25) {
      const Real z = Real(std::pow(10.0, exponent));
      Digits50 logarithm(0), rest(0);
      for (std::size_t i = 0; i < far.places.size(); ++i) {
        const Digits50 y = Digits50(z) * Digits50(far.places[i]);
        logarithm += Digits50(far.weights[i]) * log1p(y);
        rest += Digits50(far.weights[i]) * (y - log1p(y));
      }
      CAPTURE(decades, exponent);
      const LogarithmAndRest<Real> found = sum.at(z);
      const double error = error_in_epsilons(found.logarithm, logarithm);
      const double error_of_rest = error_in_epsilons(found.rest, rest);
      worst = std::max({worst, error, error_of_rest});
      CHECK(error < 8);
      CHECK(error_of_rest < 24);
    }
  }
  CHECK(worst > 0);
}

TEMPLATE_LIST_TEST_CASE("a sum of logarithms keeps its digits where z ends and for z below 0", "",
                        HardwareReals) {
  using Real = TestType;
  const Places<Real> far(3);
  const LogarithmSum<Real> sum(far.weights, far.places);
  for (const Real t : {Real(0), sum.all_above() / Real(100), sum.all_above()}) {
    Digits50 expected(0);
    for (std::size_t i = 0; i < far.places.size(); ++i)
      expected += Digits50(far.weights[i]) * log(Digits50(Digits50(far.places[i]) + Digits50(t)));
    CHECK(error_in_epsilons(sum.with_all_above(t), expected) < 8);
  }
  for (const Real z : {Real(-0.5), Real(-1e-3)}) {
    Digits50 expected(0);
    for (std::size_t i = 0; i < far.places.size(); ++i)
      expected += Digits50(far.weights[i]) * log1p(Digits50(Digits50(z) * Digits50(far.places[i])));
    CHECK(error_in_epsilons(sum.at_negative(z).logarithm, expected) < 8);
  }
}
