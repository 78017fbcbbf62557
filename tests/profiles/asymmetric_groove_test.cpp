// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/facet/panel_facets.hpp>
#include <vcavity/groove/reflectance.hpp>
#include <vcavity/hemisphere/asymmetric_bihemispherical.hpp>
#include <vcavity/hemisphere/bihemispherical.hpp>
#include <vcavity/numbers/pack.hpp>
#include <vcavity/polarization/absorbed_fields.hpp>
#include <vcavity/render/bsdf.hpp>

#include "profiles/random_profiles.hpp"
#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

template <class Real>
std::vector<TracedPencil<Real>> traced(const AsymmetricGroove<Real>& groove, const Vec3<Real>& e) {
  using std::tan;
  const Real half = groove.aperture() / Real(2);
  const Vec2<Real> rim1{-tan(half - groove.tilt()), Real(1)}, apex{Real(0), Real(0)},
      rim2{tan(half + groove.tilt()), Real(1)};
  return IntervalTracing<Real>({{rim1, apex, '1'}, {apex, rim2, '2'}})(e);
}

}  // namespace

TEST_CASE("lobes of asymmetric grooves are those of pencils of rays reflected in real space") {
  Dice dice(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const auto groove = dice.groove();
    const Vec3<double> e = dice.light();
    CAPTURE(degrees(groove.aperture()), degrees(groove.tilt()), e.x, e.y, e.z);
    // The pencils lose the digits by which the opening, seen by the light, is smaller than the panels.
    const double width = groove.opening() * e.z;
    const double size = groove.length(Panel::one) + groove.length(Panel::two);
    CHECK(largest_difference(outgoing(groove, e), traced(groove, e)) <= 3e-14 * (1 + size / width));
  }
}

TEST_CASE("lobes of asymmetric grooves agree with real space to 45 of 50 digits") {
  using Real = Digits50;
  Dice dice(2);
  for (int trial = 0; trial < 100; ++trial) {
    const auto groove = dice.groove<Real>();
    const Vec3<Real> e = dice.light<Real>();
    CHECK(largest_difference(outgoing(groove, e), traced(groove, e)) < Real("1e-45"));
  }
}

TEST_CASE("a direction has at most five lobes, six where a wall overhangs") {
  Dice dice(3);
  std::size_t most = 0;
  for (int trial = 0; trial < 300000; ++trial) {
    const auto groove = dice.groove();
    const auto found = lobes(groove, dice.light(), mirror);
    const bool overhangs =
        groove.slope(Panel::one) > pi<double>() / 2 || groove.slope(Panel::two) > pi<double>() / 2;
    CHECK(found.size() <= (overhangs ? 6U : 5U));
    most = std::max(most, found.size());
  }
  CHECK(most >= 5);
}

TEST_CASE("the weights of the lobes of an asymmetric groove add up to 1, also for grazing light") {
  Dice dice(4);
  for (int trial = 0; trial < 20000; ++trial) {
    const auto groove = dice.groove();
    Vec3<double> e = dice.light();
    e.z *= std::pow(10, dice.between(-300, 0));
    double sum = 0;
    for (const auto& lobe : lobes(groove, e, mirror)) sum += lobe.weight;
    CHECK(std::abs(sum - 1) < 1e-15 * 4);
  }
}

TEST_CASE("a groove without tilt is the symmetric one") {
  Dice dice(5);
  const Conductor<double> silver(0.1249, 3.3391);
  for (int trial = 0; trial < 2000; ++trial) {
    const double aperture = radians(dice.between(1, 179));
    const Cavity<double> symmetric(aperture);
    const AsymmetricGroove<double> groove(aperture, 0.0);
    const Vec3<double> e = dice.light(89.9);
    const auto expected = lobes(symmetric, e, silver);
    const auto found = lobes(groove, e, silver);
    REQUIRE(found.size() == expected.size());
    for (const auto& lobe : expected) {
      const auto same = std::find_if(found.begin(), found.end(), [&](const auto& other) {
        return other.first_panel == lobe.first_panel && other.bounces == lobe.bounces;
      });
      REQUIRE(same != found.end());
      CHECK(std::abs(same->weight - lobe.weight) < 1e-13);
      CHECK(same->throughput == lobe.throughput);
      CHECK(same->direction == lobe.direction);
    }
  }
}

TEST_CASE("a groove around a bisector that is made already is the one of its aperture and tilt") {
  Dice dice(19);
  const Conductor<double> copper(0.24, 3.4);
  for (int trial = 0; trial < 5000; ++trial) {
    const AsymmetricGroove<double> expected = dice.groove();
    const double half = expected.aperture() / 2;
    const AsymmetricGroove<double> groove(Cavity<double>::from_normal(std::cos(half), std::sin(half)),
                                          expected.tilt());
    const Vec3<double> e = dice.light();
    CAPTURE(degrees(expected.aperture()), degrees(expected.tilt()), e.x, e.y, e.z);
    CHECK(groove.tilt() == expected.tilt());
    CHECK(std::abs(directional_reflectance(groove, e, copper) -
                   directional_reflectance(expected, e, copper)) < 2e-14);
    CHECK(std::abs(groove.developed_area() / expected.developed_area() - 1) < 1e-12);
  }
}

TEST_CASE("every lobe of an asymmetric groove of two materials has a reverse one of the same flux") {
  Dice dice(6);
  const PanelFacets facets{polarized(Conductor<double>(0.1249, 3.3391)),
                           polarized(Conductor<double>(1.5, 0.3))};
  for (int trial = 0; trial < 2000; ++trial) {
    const auto groove = dice.groove();
    const Vec3<double> e = dice.light(80);
    for (const auto& lobe : lobes(groove, e, facets)) {
      // Light that leaves grazing comes back through next to nothing of the opening.
      if (lobe.direction.z < 1e-3) continue;
      const Panel last = lobe.bounces % 2 == 1 ? lobe.first_panel : opposite(lobe.first_panel);
      double flux = 0;
      for (const auto& back : lobes(groove, lobe.direction, facets)) {
        if (back.first_panel != last || back.bounces != lobe.bounces) continue;
        flux = back.weight * lobe.direction.z;
        const auto there = reversed(power(lobe.throughput)), again = power(back.throughput);
        for (std::size_t row = 0; row < 4; ++row)
          for (std::size_t column = 0; column < 4; ++column)
            CHECK(std::abs(there(row, column) - again(row, column)) < 1e-10);
      }
      CHECK(std::abs(flux - lobe.weight * e.z) < 1e-11);
    }
  }
}

TEST_CASE("single rays add up to the lobes of their direction") {
  Dice dice(7);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto groove = dice.groove();
    const Vec3<double> e = dice.light();
    const auto found = lobes(groove, e, mirror);
    const double position = dice.between(-1, 1);
    const RayPath path = ray_path(groove, e, position);
    // The ray's own lobe, and the place of it: those of panel one first, most bounces innermost.
    double before = 0, own = 0;
    for (const auto& lobe : found) {
      const bool same = lobe.first_panel == path.first_panel;
      if (same && lobe.bounces == path.bounces) own = lobe.weight;
      if (path.first_panel == Panel::one ? same && lobe.bounces < path.bounces
                                         : !same || lobe.bounces > path.bounces)
        before += lobe.weight;
    }
    const double fraction = (1 + position) / 2;
    CHECK(fraction >= before - 1e-13);
    CHECK(fraction <= before + own + 1e-13);
  }
}

TEST_CASE("packs of directions and of wavelengths give what single ones give") {
  Dice dice(8);
  const Conductor<double> silver(0.1249, 3.3391);
  using Four = Pack<double, 4>;
  for (int trial = 0; trial < 500; ++trial) {
    const auto groove = dice.groove();
    Vec3<Four> e;
    std::array<double, 4> expected{};
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Vec3<double> single = dice.light();
      e.x[lane] = single.x;
      e.y[lane] = single.y;
      e.z[lane] = single.z;
      expected[lane] = directional_reflectance(groove, single, silver);
    }
    const Four found = directional_reflectance(groove, e, silver.over_directions<4>());
    for (std::size_t lane = 0; lane < 4; ++lane) CHECK(std::abs(found[lane] - expected[lane]) < 1e-13);
  }
}

TEST_CASE("what an asymmetric groove does not reflect it absorbs") {
  Dice dice(9);
  const PanelFacets facets{Conductor<double>(0.1249, 3.3391), Conductor<double>(3.2, 3.3)};
  const PanelFacets fields{polarized(facets.one), polarized(facets.two)};
  for (int trial = 0; trial < 500; ++trial) {
    const auto groove = dice.groove();
    const Vec3<double> e = dice.light();
    CHECK(std::abs(directional_reflectance(groove, e, facets) + directional_absorptance(groove, e, facets) -
                   1) < 1e-13);
    CHECK(std::abs(unpolarized(directional_reflectance(groove, e, fields)) +
                   unpolarized(directional_absorptance(groove, e, fields)) - 1) < 1e-13);
  }
}

TEST_CASE("narrow tilted grooves sum many bounces at once to the same product") {
  const Conductor<double> silver(0.1249, 3.3391);
  for (const double tilt_deg : {-40.0, 0.0, 25.0}) {
    const AsymmetricGroove<double> groove(radians(0.3), radians(tilt_deg));
    Dice dice(10);
    for (int trial = 0; trial < 50; ++trial) {
      const Vec3<double> e = dice.light(60);
      double expected = 0;
      for (const auto& lobe : lobes(groove, e, mirror))
        expected += lobe.weight * ray_reflectance(groove, e, RayPath{lobe.first_panel, lobe.bounces}, silver);
      CHECK(directional_reflectance(groove, e, silver) == Approx(expected).epsilon(1e-11));
    }
  }
}

TEST_CASE("slopes and apertures that make no groove are refused") {
  CHECK_THROWS_AS(AsymmetricGroove<double>(radians(60.0), radians(60.0)), std::invalid_argument);
  CHECK_THROWS_AS(AsymmetricGroove<double>(0.0, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(AsymmetricGroove<double>(pi<double>(), 0.0), std::invalid_argument);
  CHECK_THROWS_AS(AsymmetricGroove<double>(std::nan(""), 0.0), std::invalid_argument);
  CHECK_THROWS_AS(AsymmetricGroove<double>(1.0, std::nan("")), std::invalid_argument);
  const Cavity<double> bisected(radians(60.0));
  for (const double tilt : {radians(60.0), radians(-60.0), 2 * pi<double>(), std::nan("")})
    CHECK_THROWS_AS(AsymmetricGroove<double>(bisected, tilt), std::invalid_argument);
  CHECK_THROWS_AS(AsymmetricGroove<double>(Cavity<double>(pi<double>()), 0.0), std::invalid_argument);
  CHECK_THROWS_AS(AsymmetricGroove<double>::from_slopes(2.0, 1.2), std::invalid_argument);
  CHECK_THROWS_AS(AsymmetricGroove<double>::from_slopes(0.0, 1.2), std::invalid_argument);
  const auto overhang = AsymmetricGroove<double>::from_slopes(radians(108.315), radians(0.315));
  CHECK(degrees(overhang.aperture()) == Approx(71.37));
  CHECK(degrees(overhang.tilt()) == Approx(54.0));
}

TEST_CASE("under diffuse light the number of bounces is distributed as crossed strings say") {
  // Hottel's method: the flux between two openings is the difference of the strings across and along. Nothing is known
  // here of directions, weights or cosines.
  Dice dice(12);
  for (int trial = 0; trial < 6; ++trial) {
    const auto groove = dice.groove();
    double expected = 0, mean_bounces = 0, all = 0;
    const double rho = dice.between(0.1, 0.95);
    for (const Panel first : {Panel::one, Panel::two}) {
      const auto rim = [&](int k) {
        const double length = groove.length(k % 2 != 0 ? first : opposite(first));
        const double angle = k * groove.aperture();
        return Vec2<double>{length * std::cos(angle), length * std::sin(angle)};
      };
      // The string from rim i to rim k, pulled taut around the rims between and, beyond a half turn, the apex.
      const auto string = [&](int i, int k) {
        if ((k - i) * groove.aperture() >= pi<double>()) return glm::length(rim(i)) + glm::length(rim(k));
        // The shortest way that keeps outside of no rim: the lower convex hull as the apex sees it.
        std::vector<Vec2<double>> hull;
        for (int m = i; m <= k; ++m) {
          const Vec2<double> next = rim(m);
          while (hull.size() >= 2) {
            const Vec2<double> a = hull[hull.size() - 2], b = hull.back();
            if ((b.x - a.x) * (next.y - a.y) - (b.y - a.y) * (next.x - a.x) < 0) break;
            hull.pop_back();
          }
          hull.push_back(next);
        }
        double length = 0;
        for (std::size_t m = 1; m < hull.size(); ++m) length += glm::length(hull[m] - hull[m - 1]);
        return length;
      };
      for (int m = 1; m <= groove.max_bounces(); ++m) {
        const double flux =
            (string(0, m) + string(1, m + 1) - string(0, m + 1) - string(1, m)) / (2 * groove.opening());
        expected += flux * std::pow(rho, m);
        mean_bounces += m * flux;
        all += flux;
      }
    }
    CAPTURE(degrees(groove.aperture()), degrees(groove.tilt()));
    CHECK(all == Approx(1).epsilon(1e-12));
    CHECK(mean_bounces == Approx(groove.developed_area()).epsilon(1e-12));
    const auto constant = [rho](const double&) { return rho; };
    const auto result = bihemispherical_reflectance(groove, constant, 1e-13);
    CHECK(std::abs(result.value - expected) < 1e-12);
    CHECK(std::abs(result.value - expected) <= result.error + 1e-14);
  }
}

TEST_CASE(
    "bi-hemispherical reflectance without tilt is that of the symmetric groove, total reflection included") {
  for (const double aperture_deg : {30.0, 80.0, 130.0}) {
    const double aperture = radians(aperture_deg);
    const auto check = [&](const auto& facet, double tolerance) {
      const auto tilted =
          bihemispherical_reflectance(AsymmetricGroove<double>(aperture, 0.0), facet, tolerance);
      const auto symmetric = bihemispherical_reflectance(Cavity<double>(aperture), facet, tolerance);
      CHECK(std::abs(tilted.value - symmetric.value) <= tilted.error + symmetric.error);
      CHECK(tilted.error <= 2 * tolerance);
    };
    check(Conductor<double>(0.1249, 3.3391), 1e-12);
    check(polarized(Dielectric<double>(1.5)), 1e-12);
    check(Dielectric<double>(1 / 1.5), 1e-9);
  }
}

TEST_CASE("eight digits of wide grooves with unequal panels take fewer than 24,000 evaluations") {
  for (const double aperture_deg : {60.0, 90.0, 120.0, 150.0}) {
    const double aperture = radians(aperture_deg);
    const AsymmetricGroove<double> groove(aperture, 0.3 * std::min(aperture, pi<double>() - aperture));
    const auto check = [&](const auto& facet) {
      const auto result = bihemispherical_reflectance(groove, facet, 1e-8);
      CAPTURE(aperture_deg, result.evaluations);
      CHECK(result.error <= 1e-8);
      CHECK(std::abs(result.value - bihemispherical_reflectance(groove, facet, 1e-12).value) <= result.error);
      CHECK(result.evaluations < 24'000);
    };
    check(Conductor<double>(0.1249, 3.3391));
    check(Dielectric<double>(1.5));
  }
}

TEST_CASE("mirrors with unequal panels, which lose light only near grazing, have an honest error estimate") {
  const AsymmetricGroove<double> groove(radians(144.5663), radians(-12.4967));
  const auto metal = polarized(Conductor<double>(0.0771, 79.2742));
  const double exact = bihemispherical_reflectance(groove, metal, 1e-13).value;
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const auto result = bihemispherical_reflectance(groove, metal, tolerance);
    CHECK(std::abs(result.value - exact) <= result.error);
    CHECK(result.error <= tolerance);
  }
}

TEST_CASE("narrow grooves with unequal panels of n < 1 end in bounded work, with some digits") {
  for (const double aperture_deg : {3.0, 1.0}) {
    const double aperture = radians(aperture_deg);
    const Dielectric<double> facet(0.7);
    const auto tilted = bihemispherical_reflectance(AsymmetricGroove<double>(aperture, 0.0), facet, 1e-8);
    const auto symmetric = bihemispherical_reflectance(Cavity<double>(aperture), facet, 1e-8);
    CAPTURE(aperture_deg, tilted.value, symmetric.value, tilted.error);
    CHECK(std::abs(tilted.value - symmetric.value) <= tilted.error + symmetric.error);
    CHECK(tilted.error <= 2e-2);
    CHECK(tilted.evaluations < 51'000'000);
  }
}

TEST_CASE("the BSDF of an asymmetric groove draws its lobes, and its samples add up to the albedo") {
  Dice dice(13);
  const Conductor<double> metal(3.2, 3.3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto groove = dice.groove();
    const GrooveBsdf bsdf(groove, metal, trial % 2 == 0 ? LobeChoice::by_energy : LobeChoice::by_weight);
    const Vec3<double> wo = dice.light();
    CHECK(bsdf.lobes(wo).size() == lobes(groove, wo, metal).size());
    double mean = 0;
    constexpr int samples = 20000;
    for (int i = 0; i < samples; ++i)
      if (const auto sample = bsdf.sample(wo, (i + 0.5) / samples)) mean += sample->weight / samples;
    // Where one lobe ends and the next begins a sample may count for either.
    CHECK(std::abs(mean - bsdf.albedo(wo)) < 20.0 / samples);
    CHECK(bsdf.albedo(wo) == directional_reflectance(groove, wo, metal));
  }
}

TEST_CASE(
    "many bounces at once are those of one after the other, however unequal the panels of a narrow groove") {
  // As functions of all of a bounce, facets are asked bounce by bounce.
  const auto facet = [](const double& cosine) { return 1 - 1e-3 * (1 + cosine) * cosine; };
  const auto one_by_one = [&](const Bounce<double>& bounce) { return facet(bounce.cosine); };
  for (const double tilt_deg : {0.0, 60.0, 89.0, 89.5, -89.5}) {
    const AsymmetricGroove<double> groove(radians(0.5), radians(tilt_deg));
    for (int i = 0; i < 90; ++i) {
      const Vec3<double> e = direction(radians(i + 0.5), radians(i % 2 == 0 ? 10.0 : 190.0));
      CAPTURE(tilt_deg, i);
      CHECK(directional_reflectance(groove, e, facet) ==
            Approx(directional_reflectance(groove, e, one_by_one)).epsilon(1e-11));
    }
  }
}
