// SPDX-License-Identifier: BSD-3-Clause
/// Whatever the arguments, an answer: an exception at construction, or finite numbers within physical limits.

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/hard_directions.hpp"

using namespace vcavity;
using vcavity::test::hard_directions;

namespace {

using Real = double;

/// Any bit pattern at all, NaN, infinities and denormal numbers among them; often with a common exponent.
Real any_number(std::mt19937_64& random) {
  const std::uint64_t bits = random();
  if (random() % 2) return std::bit_cast<Real>(bits);
  return std::ldexp(static_cast<Real>(bits), -60 - static_cast<int>(random() % 20)) *
         (random() % 8 ? 1.0 : -1.0);
}

/// Numbers at the ends of what is admitted.
template <class T>
std::vector<T> edges(const T& low, const T& high) {
  const T smallest = std::numeric_limits<T>::denorm_min();
  return {low,
          std::nextafter(low, high),
          std::nextafter(low, -std::numeric_limits<T>::infinity()),
          smallest,
          std::numeric_limits<T>::min(),
          T(1),
          std::nextafter(T(1), T(0)),
          std::nextafter(T(1), T(2)),
          high,
          std::nextafter(high, std::numeric_limits<T>::infinity())};
}

bool is_fraction(Real x) {
  return x >= 0 && x <= 1;
}

template <class T>
void require_answers(const Cavity<T>& cavity, const Vec3<T>& e) {
  const Conductor<T> silver(T(0.1249), T(3.3391));
  CAPTURE(cavity.aperture(), e.x, e.y, e.z);
  const T reflectance = directional_reflectance(cavity, e, silver);
  const T absorptance = directional_absorptance(cavity, e, silver);
  REQUIRE((reflectance >= T(0) && reflectance <= T(1) + 4 * std::numeric_limits<T>::epsilon()));
  REQUIRE((absorptance >= T(0) && absorptance <= T(1) + 4 * std::numeric_limits<T>::epsilon()));
  T sum(0);
  for (const auto& lobe : lobes(cavity, e, silver)) {
    REQUIRE(lobe.weight > T(0));
    REQUIRE(lobe.bounces >= 1);
    REQUIRE(lobe.bounces <= cavity.max_bounces());
    sum += lobe.weight;
  }
  REQUIRE(std::abs(sum - T(1)) <= 4 * std::numeric_limits<T>::epsilon());
  for (const T& position : {T(-1), T(0), std::numeric_limits<T>::denorm_min(), T(1)}) {
    const RayPath path = ray_path(cavity, e, position);
    REQUIRE(path.bounces >= 1);
    REQUIRE(path.bounces <= cavity.max_bounces());
    const T ray = ray_reflectance(cavity, e, path, silver);
    REQUIRE((ray >= T(0) && ray <= T(1)));
  }
}

}  // namespace

TEST_CASE("any bit pattern as an aperture is refused or makes a cavity") {
  std::mt19937_64 random(1);
  const Real flat = pi<Real>() * (1 + 4 * std::numeric_limits<Real>::epsilon());
  int refused = 0, made = 0;
  for (int i = 0; i < 200000; ++i) {
    const Real aperture = any_number(random);
    try {
      const Cavity<Real> cavity(aperture);
      REQUIRE((aperture > 0 && aperture <= flat));
      REQUIRE(cavity.aperture() <= pi<Real>());
      REQUIRE(cavity.max_bounces() >= 1);
      REQUIRE(is_fraction(cavity.cos_half()));
      REQUIRE(is_fraction(cavity.sin_half()));
      ++made;
    } catch (const std::invalid_argument&) {
      REQUIRE_FALSE((aperture >= Cavity<Real>::smallest_aperture() && aperture <= flat));
      ++refused;
    }
  }
  CHECK(refused > 1000);
  CHECK(made > 1000);
}

TEST_CASE("any bit patterns as an index are refused or reflect between nothing and everything") {
  std::mt19937_64 random(2);
  int refused = 0, made = 0;
  for (int i = 0; i < 200000; ++i) {
    const Real n = any_number(random), k = random() % 4 ? any_number(random) : 0, c = any_number(random);
    try {
      const Conductor<Real> metal(n, k);
      ++made;
      if (std::isnan(c)) continue;
      CAPTURE(n, k, c);
      REQUIRE(is_fraction(metal(c)));
      REQUIRE(is_fraction(metal.absorptance(c)));
      if (!(n > 1e-70)) continue;
      REQUIRE(is_fraction(Dielectric<Real>(n)(c)));
      REQUIRE(is_fraction(Dielectric<Real>(n).absorptance(c)));
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  CHECK(refused > 1000);
  CHECK(made > 1000);
}

TEMPLATE_TEST_CASE("the ends of the range of indices and cosines have answers", "", float, double,
                   long double) {
  using T = TestType;
  const auto in_range = [](const T& x) { return x >= T(0) && x <= T(1); };
  int made = 0;
  for (const T& n : edges(vcavity::detail::smallest_index<T>(), vcavity::detail::largest_index<T>()))
    for (const T& k : edges(vcavity::detail::smallest_index<T>(), vcavity::detail::largest_index<T>()))
      for (const T& c : edges(T(0), T(1))) {
        CAPTURE(n, k, c);
        try {
          const Conductor<T> metal(n, k);
          ++made;
          REQUIRE(in_range(metal(c)));
          REQUIRE(in_range(metal.absorptance(c)));
          REQUIRE(norm(metal.amplitudes(c).r_s) <= T(1) + T(64) * std::numeric_limits<T>::epsilon());
          REQUIRE(norm(metal.amplitudes(c).r_p) <= T(1) + T(64) * std::numeric_limits<T>::epsilon());
        } catch (const std::invalid_argument&) {
        }
      }
  CHECK(made > 100);
}

TEMPLATE_TEST_CASE("the hardest directions have answers in the hardest grooves", "", float, double,
                   long double) {
  using T = TestType;
  std::vector<T> apertures{T(1e-3), pi<T>(), std::nextafter(pi<T>(), T(0))};
  for (int k = 1; k <= 5; ++k) {
    apertures.push_back(pi<T>() / T(k));
    apertures.push_back(std::nextafter(pi<T>() / T(k), T(0)));
  }
  for (const T& aperture : apertures)
    for (const Vec3<T>& e : hard_directions<T>()) require_answers(Cavity<T>(aperture), e);
}

#ifdef NDEBUG
// Outside their domain directions and positions are the caller's mistake, which assertions catch. Without
// assertions the answer means nothing, but it comes, and nothing is overrun.
TEST_CASE("any bit patterns as direction and position come back with an answer") {
  std::mt19937_64 random(3);
  const Conductor<Real> silver(0.1249, 3.3391);
  for (int i = 0; i < 100000; ++i) {
    const Cavity<Real> cavity(std::uniform_real_distribution<Real>(1e-2, pi<Real>())(random));
    const Vec3<Real> e{any_number(random), any_number(random), any_number(random)};
    REQUIRE(lobes(cavity, e, silver).size() <= 4);
    const RayPath path = ray_path(cavity, e, any_number(random));
    REQUIRE(path.bounces >= 1);
    REQUIRE(path.bounces <= cavity.max_bounces());
  }
}
#endif

TEMPLATE_TEST_CASE("the narrowest grooves and directions that are none run into no undefined behaviour", "",
                   float, double) {
  using T = TestType;
  const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
  const Conductor<T> silver(T(0.1249), T(3.3391));
  for (const T& aperture : {Cavity<T>::smallest_aperture(), T(1e-8), T(1e-6), T(1e-3), T(1)}) {
    const Cavity<T> groove(aperture);
    for (const T& theta : {T(0), T(0.1), T(1), T(1.57)})
      for (const T& phi : {T(0), T(0.5), T(1.5), T(3)}) {
        T sum(0);
        for (const auto& lobe : lobes(groove, direction(theta, phi), silver)) {
          sum += lobe.weight;
          CHECK(lobe.direction.z >= -4 * std::numeric_limits<T>::epsilon());
        }
        CHECK(std::abs(sum - 1) <= 4 * std::numeric_limits<T>::epsilon());
        const RayPath path = ray_path(groove, direction(theta, phi), T(0.3));
        CHECK((path.bounces >= 1 && path.bounces <= groove.max_bounces()));
      }
    const GrooveBsdf bsdf(groove, silver);
    const SpreadGrooveBsdf spread(bsdf, T(0.1));
    for (const Vec3<T>& none : {Vec3<T>{nan, nan, nan}, Vec3<T>{T(0), nan, T(1)}, Vec3<T>{T(0), T(0), nan},
                                Vec3<T>{nan, T(0), T(1)}, Vec3<T>{T(0), T(0), infinity},
                                Vec3<T>{infinity, T(0), T(0)}, Vec3<T>{T(0), -infinity, T(0)}}) {
      CHECK(bsdf.lobes(none).size() == 0);
      CHECK(bsdf.albedo(none) == T(0));
      CHECK_FALSE(bsdf.sample(none, T(0.5)));
      CHECK_FALSE(spread.sample(none, T(0.5), {T(0.5), T(0.5)}));
      CHECK(spread.evaluate(none, {T(0), T(0), T(1)}) == T(0));
      CHECK(spread.pdf({T(0), T(0), T(1)}, none) == T(0));
    }
    // What is not a number has no answer, but does no harm.
    const T reflectance = directional_reflectance(groove, Vec3<T>{nan, nan, nan}, silver);
    CHECK((std::isnan(reflectance) || (reflectance >= T(0) && reflectance <= T(1))));
  }
}
