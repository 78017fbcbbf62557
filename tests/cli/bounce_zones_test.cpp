// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/bounce_zones.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;
using tools::bounce_zones;

TEST_CASE("zones of a groove of 60 degrees end where a bounce more begins to be possible") {
  const auto zones = bounce_zones(Cavity<double>(radians(60.0)));
  REQUIRE(zones.size() == 3);
  const double precision = 1e-8;
  CHECK(zones[0].low == 0);
  CHECK(zones[0].high == Catch::Approx(radians(30.0)).margin(precision));
  CHECK(zones[1].high == Catch::Approx(radians(60.0)).margin(precision));
  CHECK(zones[2].high == Catch::Approx(radians(90.0)).margin(precision));
  const std::vector<std::pair<int, int>> bounces{{2, 3}, {1, 2}, {1, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(zones[i].least == bounces[i].first);
    CHECK(zones[i].most == bounces[i].second);
  }
}

TEST_CASE("a flat surface is one zone of a single bounce") {
  const auto zones = bounce_zones(Cavity<double>(radians(180.0)));
  REQUIRE(zones.size() == 1);
  CHECK(zones[0].least == 1);
  CHECK(zones[0].most == 1);
}

TEST_CASE("rays bounce as often as their zone says") {
  std::mt19937 random(20191104);
  std::uniform_real_distribution<double> uniform;
  for (const double aperture_deg : {7.0, 33.3, 45.0, 72.0, 100.0, 150.0}) {
    const Cavity<double> cavity(radians(aperture_deg));
    const auto zones = bounce_zones(cavity);
    std::vector<int> least(zones.size(), 1000), most(zones.size(), 0);
    for (int i = 0; i < 200'000; ++i) {
      const double theta_across = std::acos(-1.0) / 2 * uniform(random);
      const double psi = 1.5 * uniform(random);
      const Vec3<double> e{std::sin(psi), std::cos(psi) * std::sin(theta_across),
                           std::cos(psi) * std::cos(theta_across)};
      const int bounces = ray_path(cavity, e, 2 * uniform(random) - 1).bounces;
      const auto zone = static_cast<std::size_t>(
          std::find_if(zones.begin(), zones.end(), [&](const auto& z) { return theta_across < z.high; }) -
          zones.begin());
      REQUIRE(zone < zones.size());
      least[zone] = std::min(least[zone], bounces);
      most[zone] = std::max(most[zone], bounces);
    }
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
      CAPTURE(aperture_deg, zone, zones[zone].low, zones[zone].high);
      CHECK(least[zone] == zones[zone].least);
      CHECK(most[zone] == zones[zone].most);
    }
  }
}

TEST_CASE("all zones of a narrow groove are found, and they end at its kinks") {
  // Between the kinks, multiples of α/2 = 0.01° from grazing, the numbers of bounces differ; the two ends of the lit
  // aperture add less than a handful.
  const Cavity<double> cavity(radians(0.02));
  const auto zones = bounce_zones(cavity);
  CHECK(zones.size() >= 9000);
  CHECK(zones.size() < 9005);
  for (std::size_t i = 1; i < zones.size(); ++i) {
    CHECK(zones[i].low == zones[i - 1].high);
    CHECK(zones[i].low < zones[i].high);
  }
  CHECK(zones.front().low == 0);
  CHECK(zones.back().high == Catch::Approx(radians(90.0)).margin(1e-15));
  CHECK(zones.back().most <= 2);
}
