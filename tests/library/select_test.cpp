// SPDX-License-Identifier: BSD-3-Clause
/// Comparisons make masks, and masks select: the same for numbers, colours and packs of any size.

#include <cstddef>
#include <limits>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

/// Masks in which the last component decides.
template <class Real, std::size_t size>
void check_pack() {
  CAPTURE(size, sizeof(Real));
  Pack<Real, size> a(Real(1));
  const Pack<Real, size> b(Real(2));
  CHECK(all_of(b > a));
  CHECK(all_of(a >= Real(1)));
  CHECK_FALSE(any_of(a >= b));
  CHECK_FALSE(any_of(a > Real(1)));
  CHECK_FALSE(any_of(a < Real(1)));
  CHECK(select(a >= b, a, b) == b);
  a[size - 1] = Real(3);
  CHECK(any_of(a > b));
  CHECK(all_of(a > b) == (size == 1));
  const Pack<Real, size> larger = select(a > b, a, b);
  for (std::size_t i = 0; i < size; ++i) CHECK(larger[i] == (i == size - 1 ? Real(3) : Real(2)));
  CHECK(largest(larger) == Real(3));
  // What is not a number compares with nothing.
  a[size - 1] = std::numeric_limits<Real>::quiet_NaN();
  CHECK_FALSE(any_of(a >= b));
  CHECK_FALSE(all_of(b > a));
  CHECK(select(a >= b, a, b)[size - 1] == Real(2));
}

template <class Real>
void check_sizes() {
  check_pack<Real, 1>();
  check_pack<Real, 2>();
  check_pack<Real, 3>();
  check_pack<Real, 4>();
  check_pack<Real, 5>();
  check_pack<Real, 8>();
  check_pack<Real, 31>();
}

}  // namespace

TEST_CASE("masks of packs of any size are asked for and select component by component") {
  check_sizes<float>();
  check_sizes<double>();
  check_sizes<long double>();
}

TEST_CASE("masks of numbers and of colours select in the same way") {
  CHECK(select(1.0 >= 1.0, 2.0, 3.0) == 2.0);
  CHECK(select(std::numeric_limits<double>::quiet_NaN() >= 0.0, 2.0, 3.0) == 3.0);
  CHECK(any_of(1.0 > 0.5));
  CHECK_FALSE(all_of(0.5 > 1.0));
  const glm::dvec3 a(1, 2, 3), b(2, 2, 2);
  CHECK(select(vcavity::operator>=(a, b), a, b) == glm::dvec3(2, 2, 3));
  CHECK(select(vcavity::operator>(a, 2.0), a, glm::dvec3(0)) == glm::dvec3(0, 0, 3));
}

TEST_CASE("light is followed as long as any wavelength of a pack is bright") {
  // Glass is dark after a few bounces, the metal is not.
  const Cavity<double> groove(radians(0.5));
  const Vec3<double> e = direction(0.3, 0.2);
  for (const int metal : {0, 1}) {
    Pack<double, 2> n(1.5), k(0.0);
    n[static_cast<std::size_t>(metal)] = 0.05;
    k[static_cast<std::size_t>(metal)] = 4;
    const auto both = directional_reflectance(groove, e, Conductor<Pack<double, 2>>(n, k));
    const double expected = directional_reflectance(groove, e, Conductor<double>(0.05, 4));
    CHECK(both[static_cast<std::size_t>(metal)] == Approx(expected).epsilon(1e-11));
    CHECK(expected > 1e-3);
  }
}
