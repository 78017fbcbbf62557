// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/profiles/bihemispherical.hpp>
#include <vcavity/profiles/land.hpp>
#include <vcavity/profiles/trench.hpp>
#include <vcavity/profiles/truncated_groove.hpp>

#include "profiles/random_profiles.hpp"
#include "support/catch.hpp"
#include "support/reals.hpp"
#include "support/wave.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// A groove with a floor, now and then with a vertical wall.
template <class Real>
TruncatedGroove<Real> random_groove(Dice& dice) {
  const bool vertical = dice.between(0, 1) < 0.1;
  const Real one = vertical ? Real(90) : Real(dice.between(5, 90));
  return {radians(one), radians(Real(dice.between(5, 89))), Real(std::pow(10, dice.between(-2, 1)))};
}

template <class Real>
std::vector<TracedPencil<Real>> traced(const TruncatedGroove<Real>& groove, const Vec3<Real>& e) {
  return IntervalTracing<Real>(
      groove_edges(groove.slope(Panel::one), groove.slope(Panel::two), groove.floor_over_depth()))(e);
}

template <class Real>
std::vector<TracedPencil<Real>> traced(const Trench<Real>& trench, const Vec3<Real>& e) {
  const Real right = pi<Real>() / Real(2);
  return IntervalTracing<Real>(groove_edges(right, right, trench.floor_over_depth()))(e);
}

const Conductor<double> silver(0.1249, 3.3391);
const Conductor<double> weak(3.2, 3.3);
const Dielectric<double> glass(1.5);

/// The sum of the weights of all lobes.
template <class Shape>
double sum_of_weights(const Shape& profile, const Vec3<double>& e) {
  double sum = 0;
  profile.follow(e, mirror, [&](const FacePencil<double>& light, double) { sum += light.weight; });
  return sum;
}

/// Each lobe's reverse one has the same faces backwards, the same flux, and the same throughput.
template <class Shape, class Facets>
void check_helmholtz(const Shape& profile, const Vec3<double>& e, const Facets& facets) {
  for (const auto& lobe : lobes(profile, e, facets)) {
    if (lobe.direction.z < 1e-3) continue;
    std::string way = lobe.path.text();
    std::reverse(way.begin(), way.end());
    double flux = 0;
    for (const auto& back : lobes(profile, lobe.direction, facets)) {
      if (back.path.text() != way) continue;
      flux = back.weight * lobe.direction.z;
      const auto there = reversed(power(lobe.throughput)), again = power(back.throughput);
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
          CHECK(std::abs(there(row, column) - again(row, column)) < 1e-10);
    }
    CHECK(std::abs(flux - lobe.weight * e.z) < 1e-10);
  }
}

}  // namespace

TEST_CASE("lobes of grooves with a floor are those of pencils of rays reflected in real space") {
  Dice dice(11);
  for (int trial = 0; trial < 20000; ++trial) {
    const auto groove = random_groove<double>(dice);
    const Vec3<double> e = dice.light();
    CAPTURE(degrees(groove.slope(Panel::one)), degrees(groove.slope(Panel::two)), groove.floor_over_depth(),
            e.y, e.z);
    // Of a full V that is much deeper than it is wide the offsets of rays lose digits.
    const double full_v = (1 - groove.floor_over_opening()) *
                          (1 / std::tan(groove.slope(Panel::one)) + 1 / std::tan(groove.slope(Panel::two)));
    CHECK(largest_difference(outgoing(groove, e), traced(groove, e)) <
          1e-13 + 1e-14 / (e.z * std::min(full_v, 1.0)));
  }
}

TEST_CASE("lobes of grooves with a floor agree with real space to 45 of 50 digits") {
  using Real = Digits50;
  Dice dice(12);
  for (int trial = 0; trial < 100; ++trial) {
    const auto groove = random_groove<Real>(dice);
    const Vec3<Real> e = dice.light<Real>();
    CHECK(largest_difference(outgoing(groove, e), traced(groove, e)) < Real("1e-45"));
  }
}

TEST_CASE("lobes of trenches are those of pencils of rays reflected in real space") {
  Dice dice(13);
  for (int trial = 0; trial < 20000; ++trial) {
    const Trench<double> trench(std::pow(10, dice.between(-1, 1)));
    const Vec3<double> e = dice.light(85);
    const double way = 2 * std::abs(e.y) / (e.z * trench.floor_over_depth());
    CAPTURE(trench.floor_over_depth(), e.y, e.z);
    CHECK(largest_difference(outgoing(trench, e), traced(trench, e)) < 1e-14 * (10 + 10 * way));
  }
}

TEST_CASE("a trench is the limit of a groove whose walls are almost vertical") {
  using Real = long double;
  const Real steep = radians(Real(90) - Real(1e-7));
  Dice dice(14);
  for (int trial = 0; trial < 200; ++trial) {
    const Real floor = std::pow(10.0L, static_cast<Real>(dice.between(-0.5, 1)));
    const Vec3<Real> e = dice.light<Real>(80);
    const Conductor<Real> facet(0.2L, 3.0L);
    CHECK(std::abs(directional_reflectance(Trench<Real>(floor), e, facet) -
                   directional_reflectance(TruncatedGroove<Real>(steep, steep, floor), e, facet)) < 1e-6L);
    CHECK(std::abs(unpolarized(directional_reflectance(Trench<Real>(floor), e, polarized(facet))) -
                   unpolarized(directional_reflectance(TruncatedGroove<Real>(steep, steep, floor), e,
                                                       polarized(facet)))) < 1e-6L);
  }
}

TEST_CASE("weights add up to 1, also for grazing light") {
  Dice dice(15);
  for (int trial = 0; trial < 5000; ++trial) {
    Vec3<double> e = dice.light(90);
    e.z *= std::pow(10, dice.between(-20, 0));
    CHECK(std::abs(sum_of_weights(random_groove<double>(dice), e) - 1) < 1e-13);
    CHECK(std::abs(sum_of_weights(Trench<double>(dice.between(0.1, 3)), e) - 1) < 1e-15);
    CHECK(std::abs(sum_of_weights(Land(dice.groove(), dice.between(0, 0.99)), e) - 1) < 1e-14);
  }
}

TEST_CASE("a groove without a floor is the asymmetric one") {
  Dice dice(16);
  for (int trial = 0; trial < 1000; ++trial) {
    const double one = radians(dice.between(10, 90)), two = radians(dice.between(10, 89));
    const Vec3<double> e = dice.light();
    CHECK(directional_reflectance(TruncatedGroove<double>(one, two, 0.0), e, silver) ==
          Approx(directional_reflectance(AsymmetricGroove<double>::from_slopes(one, two), e, silver))
              .epsilon(1e-11));
  }
}

TEST_CASE("every lobe over a floor has a reverse one of the same flux and throughput") {
  Dice dice(17);
  const FaceFacets facets{polarized(silver), polarized(weak), polarized(Conductor<double>(1.5, 0.0)),
                          polarized(silver)};
  for (int trial = 0; trial < 1000; ++trial) {
    const TruncatedGroove<double> groove(radians(dice.between(20, 90)), radians(dice.between(20, 85)),
                                         dice.between(0.05, 3));
    check_helmholtz(groove, dice.light(80), facets);
    check_helmholtz(Trench<double>(dice.between(0.3, 3)), dice.light(80), facets);
    check_helmholtz(Land(dice.groove(), 0.3), dice.light(80), facets);
  }
}

TEST_CASE("fields followed over floors are those of waves reflected in space") {
  Dice dice(18);
  const FaceFacets facets{polarized(silver), polarized(weak), polarized(Conductor<double>(1.5, 0.2)),
                          polarized(silver)};
  const std::map<char, std::complex<double>> indices{
      {'1', {0.1249, 3.3391}}, {'2', {3.2, 3.3}}, {'F', {1.5, 0.2}}, {'L', {0.1249, 3.3391}}};
  const auto check = [&](const auto& profile, double slope_one, double slope_two) {
    const Vec3<double> e = dice.light(85);
    for (const auto& lobe : lobes(profile, e, facets)) {
      const Vec3<double> a = polarization_axis(-e);
      Wave wave{-e, along(a, {0.3, 0.4}) + along(glm::cross(-e, a), {-0.7, 0.2})};
      const Stokes<double> light = stokes(wave);
      for (const char face : lobe.path.text()) {
        const Vec3<double> normal = face == '1'   ? Vec3<double>{0, std::sin(slope_one), std::cos(slope_one)}
                                    : face == '2' ? Vec3<double>{0, -std::sin(slope_two), std::cos(slope_two)}
                                                  : Vec3<double>{0, 0, 1};
        wave = reflected(wave, normal, indices.at(face));
      }
      const Stokes<double> expected = stokes(wave), actual = power(lobe.throughput) * light;
      for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(actual[i] - expected[i]) < 1e-12);
      for (glm::length_t i = 0; i < 3; ++i) CHECK(std::abs(wave.k[i] - lobe.direction[i]) < 1e-12);
    }
  };
  for (int trial = 0; trial < 500; ++trial) {
    const double one = radians(dice.between(30, 90)), two = radians(dice.between(30, 85));
    check(Land(TruncatedGroove<double>(one, two, dice.between(0.05, 2)), 0.2), one, two);
    check(Trench<double>(dice.between(0.3, 2)), pi<double>() / 2, pi<double>() / 2);
  }
}

TEST_CASE("land is one more lobe, for every groove between") {
  Dice dice(19);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<double> e = dice.light();
    const double flat = silver(e.z), land = dice.between(0, 1);
    const auto check = [&](const auto& groove) {
      CHECK(directional_reflectance(Land(groove, land), e, silver) ==
            Approx((1 - land) * directional_reflectance(groove, e, silver) + land * flat).epsilon(1e-14));
    };
    check(Cavity<double>(radians(dice.between(5, 180))));
    check(dice.groove());
    check(random_groove<double>(dice));
    check(Trench<double>(dice.between(0.1, 3)));
  }
}

TEST_CASE("what profiles do not reflect they absorb") {
  Dice dice(20);
  const FaceFacets facets{silver, weak, Conductor<double>(1.5, 0.2), silver};
  for (int trial = 0; trial < 200; ++trial) {
    const Land profile(random_groove<double>(dice), 0.2);
    const Vec3<double> e = dice.light();
    CHECK(std::abs(directional_reflectance(profile, e, facets) + directional_absorptance(profile, e, facets) -
                   1) < 1e-12);
    CHECK(std::abs(unpolarized(directional_reflectance(profile, e, polarized(facets))) +
                   unpolarized(directional_absorptance(profile, e, polarized(facets))) - 1) < 1e-12);
  }
}

TEST_CASE("under diffuse light a mirrored groove reflects all, whatever its floor") {
  for (const double floor : {0.05, 1.0}) {
    const auto white = bihemispherical_reflectance(
        TruncatedGroove<double>(radians(75.0), radians(50.0), floor), mirror, 1e-9);
    CHECK(std::abs(white.value - 1) <= white.error);
  }
}

TEST_CASE(
    "under diffuse light the mean number of bounces is the area of the faces over that of the opening") {
  // The quadrature of the bi-hemispherical reflectance, with the number of bounces in place of the reflectance.
  Dice dice(21);
  for (int trial = 0; trial < 20; ++trial) {
    const auto groove = random_groove<double>(dice);
    const auto count = [&](const Vec3<double>& e) { return mean_bounces(groove, e); };
    const auto no_cuts = [](const Vec3<double>&, std::vector<double>&) {};
    const long long evaluations = 0;
    detail::AdaptiveHemisphere<double, double, decltype(count), decltype(no_cuts)> quadrature(count, no_cuts,
                                                                                              evaluations);
    const auto ranges = detail::KinkSearch(groove, 1e-9)();
    const auto result = quadrature(ranges.ends, 1e-9);
    CHECK(ranges.overlooked < 1e-9);
    CHECK(result.error < 1e-9);
    CHECK(std::abs(result.value - groove.developed_area()) <= result.error + ranges.overlooked);
  }
}

TEST_CASE("the error estimate for floors holds what it promises") {
  for (const double floor : {0.1, 0.7}) {
    const TruncatedGroove<double> groove(radians(80.0), radians(60.0), floor);
    const double exact = bihemispherical_reflectance(groove, weak, 1e-12).value;
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
      const auto result = bihemispherical_reflectance(groove, weak, tolerance);
      CHECK(result.error <= tolerance);
      CHECK(std::abs(result.value - exact) <= result.error);
    }
  }
}

TEST_CASE("total reflection under diffuse light is found at its critical angles") {
  const Dielectric<double> from_inside(1 / 1.5);
  const auto with_floor = bihemispherical_reflectance(
      TruncatedGroove<double>(radians(60.0), radians(60.0), 0.0), from_inside, 1e-8);
  const auto symmetric = bihemispherical_reflectance(Cavity<double>(radians(60.0)), from_inside, 1e-10);
  CHECK(with_floor.error < 1e-8);
  CHECK(std::abs(with_floor.value - symmetric.value) < 1e-8);
}

TEST_CASE("floors, slopes and lands that make no surface are refused") {
  CHECK_THROWS_AS(TruncatedGroove<double>(radians(90.0), radians(90.0), 1.0), std::invalid_argument);
  CHECK_THROWS_AS(TruncatedGroove<double>(radians(91.0), radians(45.0), 1.0), std::invalid_argument);
  CHECK_THROWS_AS(TruncatedGroove<double>(radians(0.0), radians(45.0), 1.0), std::invalid_argument);
  CHECK_THROWS_AS(TruncatedGroove<double>(radians(45.0), radians(45.0), -0.1), std::invalid_argument);
  CHECK_THROWS_AS(Trench<double>(0.0), std::invalid_argument);
  CHECK_THROWS_AS(Trench<double>(std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(Land(Trench<double>(1.0), 1.0), std::invalid_argument);
  CHECK_THROWS_AS(Land(Trench<double>(1.0), -0.1), std::invalid_argument);
}

TEST_CASE("bi-hemispherical reflectance of floors takes no tolerance for more than rounding allows") {
  const TruncatedGroove<double> groove(radians(60.0), radians(70.0), 0.5);
  const auto coarse = bihemispherical_reflectance(groove, silver, 1e-9);
  const auto fine = bihemispherical_reflectance(groove, silver, 1e-15);
  CHECK(std::abs(fine.value - coarse.value) <= coarse.error);
  CHECK(fine.error < 1e-13);
}

TEST_CASE("light that needs too many bounces is left out of floors and land, in every function") {
  Dice dice(431);
  const FaceFacets facets{Conductor(0.1249, 3.3391), Conductor(1.5, 0.0), Conductor(2.5, 3.4),
                          Conductor(0.2, 2.0)};
  const auto check = [&](const auto& profile) {
    for (int most = 1; most <= 8; ++most) {
      const Vec3<double> e = dice.light();
      double expected = 0;
      std::size_t count = 0;
      for (const auto& lobe : lobes(profile, e, facets)) {
        if (lobe.path.bounces() > most) continue;
        expected += lobe.weight * lobe.throughput;
        ++count;
      }
      CHECK(lobes(profile, e, facets, most).size() == count);
      CHECK(std::abs(directional_reflectance(profile, e, facets, most) - expected) < 1e-13);
      CHECK(std::abs(unpolarized_reflectance(profile, e, facets, most) - expected) < 1e-13);
    }
  };
  for (int trial = 0; trial < 50; ++trial) {
    const double slope_one = radians(dice.between(20, 88)), slope_two = radians(dice.between(20, 88));
    check(TruncatedGroove<double>(slope_one, slope_two, dice.between(0.01, 3)));
    check(Land(Trench<double>(dice.between(0.2, 3)), 0.3));
    check(Land(dice.groove(), 0.2));
  }
}

TEST_CASE("diffuse reflectance by the number of bounces adds up to all of it over floors") {
  const auto mirror_of = [](const auto&) { return 1.0; };
  const TruncatedGroove<double> groove(radians(60.0), radians(70.0), 0.5);
  double mean_bounces = 0, last = 0;
  for (int most = 1; most <= 5; ++most) {
    const double flux = bihemispherical_reflectance(groove, mirror_of, 1e-10, most).value;
    mean_bounces += most * (flux - last);
    last = flux;
  }
  CHECK(std::abs(last - 1) < 1e-10);
  CHECK(std::abs(mean_bounces - groove.developed_area()) < 1e-9);
  CHECK(bihemispherical_reflectance(groove, silver, 1e-9, 2).value <
        bihemispherical_reflectance(groove, silver, 1e-9, 3).value);
}

TEST_CASE("land lies between symmetric grooves of two materials as between others") {
  const FaceFacets facets{Conductor(0.1249, 3.3391), Conductor(1.5, 0.0), Conductor(0.1249, 3.3391),
                          Conductor(1.5, 0.0)};
  const Land symmetric(Cavity<double>(1.0), 0.2);
  const Land general(AsymmetricGroove<double>(1.0, 0.0), 0.2);
  CHECK(std::abs(bihemispherical_reflectance(symmetric, facets, 1e-10).value -
                 bihemispherical_reflectance(general, facets, 1e-10).value) < 1e-10);
}

TEST_CASE("two materials meet in the middle of a plane") {
  const Conductor<double> clear(1.5, 0.0);
  const Cavity<double> plane(pi<double>());
  const double silver_alone = bihemispherical_reflectance(plane, silver, 1e-12).value;
  const double clear_alone = bihemispherical_reflectance(plane, clear, 1e-12).value;
  const auto both =
      bihemispherical_reflectance(Land(plane, 0.2), FaceFacets{silver, clear, silver, clear}, 1e-12);
  CHECK(std::abs(both.value - (0.4 * silver_alone + 0.6 * clear_alone)) < 1e-12);
}

TEST_CASE("between walls a few minutes of arc from vertical the weights over a floor keep eleven digits") {
  Dice dice(433);
  for (const double one_deg : {85.0, 89.9, 90.0})
    for (const double two_deg : {60.0, 89.0, 89.9})
      for (const double floor : {0.01, 0.5, 50.0}) {
        const double one = radians(one_deg), two = radians(two_deg);
        const TruncatedGroove<double> groove(one, two, floor);
        for (int trial = 0; trial < 20; ++trial) {
          const Vec3<double> e = dice.light(85);
          std::map<std::string, long double> weights;
          for (const auto& pencil :
               IntervalTracing<long double>(groove_edges<long double>(one, two, floor))(Vec3<long double>(e)))
            weights[pencil.way] += pencil.weight;
          CAPTURE(one_deg, two_deg, floor);
          for (const auto& lobe : lobes(groove, e, mirror))
            CHECK(std::abs(static_cast<long double>(lobe.weight) - weights[lobe.path.text()]) < 5e-12L);
        }
      }
}
