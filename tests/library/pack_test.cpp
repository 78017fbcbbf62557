// SPDX-License-Identifier: BSD-3-Clause
/// Packs by themselves: every operation in every lane, sizes that fill no register included.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

template <std::size_t size>
struct Size {
  static constexpr std::size_t value = size;
};

/// A pack of different numbers of both signs.
template <class Real, std::size_t size>
Pack<Real, size> numbers(Real seed) {
  Pack<Real, size> result;
  for (std::size_t i = 0; i < size; ++i)
    result[i] = std::sin(seed + Real(static_cast<int>(i))) * Real(static_cast<int>(i) + 1);
  return result;
}

template <class Real, std::size_t size>
void check_every_lane() {
  const auto a = numbers<Real, size>(Real(0.3)), b = numbers<Real, size>(Real(2.1));
  const Pack<Real, size> roots = sqrt(magnitude(a));
  for (std::size_t i = 0; i < size; ++i) {
    CAPTURE(size, i);
    CHECK((a + b)[i] == a[i] + b[i]);
    CHECK((a - b)[i] == a[i] - b[i]);
    CHECK((a * b)[i] == a[i] * b[i]);
    CHECK((a / b)[i] == a[i] / b[i]);
    CHECK((-a)[i] == -a[i]);
    CHECK((Real(3) * a)[i] == Real(3) * a[i]);
    CHECK(magnitude(a)[i] == std::abs(a[i]));
    CHECK(roots[i] == std::sqrt(std::abs(a[i])));
    CHECK(at_least(a, Real(0.5))[i] == std::max(a[i], Real(0.5)));
    CHECK(at_most(a, Real(0.5))[i] == std::min(a[i], Real(0.5)));
    CHECK(at_most(a, b)[i] == std::min(a[i], b[i]));
    CHECK(select(a > b, a, b)[i] == std::max(a[i], b[i]));
    CHECK(select(a >= Real(0), a, b)[i] == (a[i] >= 0 ? a[i] : b[i]));
    CHECK(select(a < Real(0.5), a, b)[i] == (a[i] < Real(0.5) ? a[i] : b[i]));
    CHECK(Pack<Real, size>(Real(7))[i] == Real(7));
    CHECK((Pack<Real, size>::load(a.begin()))[i] == a[i]);
  }
  std::array<double, size> others;
  for (std::size_t i = 0; i < size; ++i) others[i] = 1.5 * static_cast<double>(i);
  const auto loaded = Pack<Real, size>::load(others.data());
  for (std::size_t i = 0; i < size; ++i) CHECK(loaded[i] == static_cast<Real>(others[i]));
}

/// One lane differs from all others: what asks for any, all or the largest must find it wherever it is.
template <class Real, std::size_t size>
void check_the_lane_that_decides() {
  const Pack<Real, size> zeros(Real(0)), ones(Real(1));
  CHECK_FALSE(any_of(zeros > Real(0)));
  CHECK_FALSE(any_of(-ones > Real(0)));
  CHECK(all_of(ones > Real(0)));
  for (std::size_t lane = 0; lane < size; ++lane) {
    CAPTURE(size, lane);
    Pack<Real, size> one_bright = zeros, one_dark = ones, one_negative = zeros;
    one_bright[lane] = Real(0.25);
    one_dark[lane] = Real(0);
    one_negative[lane] = Real(-3);
    CHECK(any_of(one_bright > Real(0)));
    CHECK(bits_of(one_bright > Real(0)) == std::uint64_t(1) << lane);
    CHECK(bits_of(one_dark > Real(0)) == (std::uint64_t(1) << size) - 1 - (std::uint64_t(1) << lane));
    CHECK_FALSE(all_of(one_dark > Real(0)));
    CHECK(largest(one_bright) == Real(0.25));
    CHECK(largest(one_negative) == Real(3));
    CHECK_FALSE(one_bright == zeros);
    CHECK(one_bright == one_bright);
    int visited = 0;
    for_each_component(one_bright, [&](const Real& x) { visited += x > Real(0) ? 1000 : 1; });
    CHECK(visited == 999 + static_cast<int>(size));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("every operation on packs is that on their components", "", (Size<1>), (Size<2>),
                   (Size<3>), (Size<4>), (Size<5>), (Size<8>), (Size<17>)) {
  check_every_lane<float, TestType::value>();
  check_every_lane<double, TestType::value>();
}

template <class Real>
void check_parts() {
  const Pack<Real, 8> low = numbers<Real, 8>(1), high = numbers<Real, 8>(2);
  const Pack<Real, 16> both(std::array{low, high});
  CHECK(both.template slice<8>(0) == low);
  CHECK(both.template slice<8>(1) == high);
  const Pack<Real, 3> first(low);
  for (std::size_t i = 0; i < 3; ++i) CHECK(first[i] == low[i]);
  constexpr std::array pattern{true, false, false, true, true, true, false, false};
  const auto blended = Pack<Real, 8>::template blended<pattern>(low, high);
  for (std::size_t i = 0; i < 8; ++i) CHECK(blended[i] == (pattern[i] ? low[i] : high[i]));

  const std::array packs{low, high, numbers<Real, 8>(3), numbers<Real, 8>(4), numbers<Real, 8>(5)};
  const auto sums = detail::combined_lanes([](const auto& a, const auto& b) { return a + b; }, packs);
  const auto products = detail::combined_lanes([](const auto& a, const auto& b) { return a * b; }, packs);
  for (std::size_t i = 0; i < packs.size(); ++i) {
    double sum = 0, product = 1;
    for (const Real& x : packs[i]) {
      sum += static_cast<double>(x);
      product *= static_cast<double>(x);
    }
    CHECK(static_cast<double>(sums[i]) == Approx(sum).epsilon(1e-5).margin(1e-5));
    CHECK(static_cast<double>(products[i]) == Approx(product).epsilon(1e-5));
  }
}

TEST_CASE("packs are put together, taken apart and combined over their lanes") {
  check_parts<float>();
  check_parts<double>();
  check_parts<long double>();
}

TEMPLATE_TEST_CASE("a single lane decides, the first and the last included", "", (Size<1>), (Size<2>),
                   (Size<3>), (Size<4>), (Size<5>), (Size<8>), (Size<17>)) {
  check_the_lane_that_decides<float, TestType::value>();
  check_the_lane_that_decides<double, TestType::value>();
}

TEST_CASE("a narrow groove of a dark and a bright wavelength, in either order, is that of each alone") {
  const Cavity<double> cavity(radians(0.5));
  const double n[] = {1.5, 0.05}, k[] = {0, 4};
  for (const double theta : {radians(89.0), radians(89.9)})
    for (const bool bright_first : {false, true}) {
      const std::size_t glass = bright_first ? 1 : 0, metal = 1 - glass;
      Pack<double, 2> pack_n, pack_k;
      pack_n[glass] = n[0];
      pack_k[glass] = k[0];
      pack_n[metal] = n[1];
      pack_k[metal] = k[1];
      const Conductor<Pack<double, 2>> both(pack_n, pack_k);
      for (const double phi : {0.3, 1.2, 1.55}) {
        CAPTURE(theta, bright_first, phi);
        const Vec3<double> e = direction(theta, phi);
        const auto found = directional_reflectance(cavity, e, both);
        CHECK(found[metal] == Approx(directional_reflectance(cavity, e, Conductor<double>(n[1], k[1]))));
        CHECK(found[glass] ==
              Approx(directional_reflectance(cavity, e, Conductor<double>(n[0], k[0]))).margin(1e-300));
      }
    }
  // Light in all directions, where dark lobes are merged.
  const auto together = bihemispherical_reflectance(
      cavity, Conductor<Pack<double, 2>>(Pack<double, 2>({1.5, 0.05}), Pack<double, 2>({0.0, 4.0})), 1e-4);
  const auto alone = bihemispherical_reflectance(cavity, Conductor<double>(0.05, 4.0), 1e-4);
  CHECK(std::abs(together.value[1] - alone.value) < 2e-4);
}
