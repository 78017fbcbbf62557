// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <random>
#include <vcavity/numbers/elementary.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

template <class Real>
using Eight = Pack<Real, 8>;

/// Any argument up to `largest`, one next to nothing, or one beside a multiple of π/2.
template <class Real>
Eight<Real> arguments(std::mt19937_64& random, double largest) {
  std::uniform_real_distribution<double> any(-largest, largest), unit(0, 1);
  Eight<Real> result;
  for (std::size_t i = 0; i < 8; ++i) {
    const double x = any(random);
    const double multiple = std::floor(x) * 1.5707963267948966;
    result[i] = static_cast<Real>(i % 4 == 0   ? x * std::exp(-30 * unit(random))
                                  : i % 4 == 1 ? multiple * (1 + 1e-7 * unit(random))
                                               : x);
  }
  return result;
}

}  // namespace

TEMPLATE_TEST_CASE("sines, cosines and exponentials of packs are within two rounding errors", "", float,
                   double) {
  using Real = TestType;
  const long double epsilon = std::numeric_limits<Real>::epsilon();
  std::mt19937_64 random(91);
  for (const double largest : {3.0, 60.0, 900.0, 2e6})
    for (int trial = 0; trial < 5000; ++trial) {
      const Eight<Real> x = arguments<Real>(random, largest);
      const auto found = detail::sine_and_cosine(x);
      const Eight<Real> lost = detail::exponential_less_one(Eight<Real>(-magnitude(x)));
      for (std::size_t i = 0; i < 8; ++i) {
        const long double exact = x[i], exponent = -std::abs(exact);
        CHECK(std::abs(found.sine[i] - std::sin(exact)) <= 2 * epsilon);
        CHECK(std::abs(found.cosine[i] - std::cos(exact)) <= 2 * epsilon);
        CHECK(std::abs(lost[i] - std::expm1(exponent)) <= -2 * epsilon * std::expm1(exponent));
        const long double left = std::exp(exponent);
        CHECK((std::abs(detail::exponential(Eight<Real>(-magnitude(x)))[i] - left) <= 2 * epsilon * left ||
               left < 10 * std::numeric_limits<Real>::min()));
      }
    }
}

TEMPLATE_TEST_CASE("functions of packs keep what is exact, and numbers of any size", "", float, double) {
  using Real = TestType;
  const Eight<Real> zero(Real(0));
  CHECK(detail::sine_and_cosine(zero).sine == zero);
  CHECK(detail::sine_and_cosine(zero).cosine == Eight<Real>(Real(1)));
  CHECK(detail::exponential_less_one(zero) == zero);
  CHECK(detail::exponential(zero) == Eight<Real>(Real(1)));
  CHECK(detail::exponential(Eight<Real>(-std::numeric_limits<Real>::max())) == zero);
  CHECK(detail::exponential(Eight<Real>(Real(2)))[3] == std::exp(Real(2)));
  CHECK(detail::exponential_less_one(Eight<Real>(-std::numeric_limits<Real>::max())) ==
        Eight<Real>(Real(-1)));
  // Growing exponentials go through the standard library.
  CHECK(detail::exponential_less_one(Eight<Real>(Real(2)))[3] == std::expm1(Real(2)));
  const Eight<Real> small(Real(1e-20L));
  CHECK(detail::sine_and_cosine(small).sine == small);
  CHECK(detail::exponential_less_one(Eight<Real>(-small)) == -small);
  CHECK(std::isnan(detail::sine_and_cosine(Eight<Real>(std::numeric_limits<Real>::quiet_NaN())).sine[0]));
}
