// SPDX-License-Identifier: BSD-3-Clause
/// Lobes of many directions at once, against those of one direction after the other.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

constexpr std::size_t lanes = 8;
using Directions = Pack<double, lanes>;

/// Directions that see panel one, uniform on their part of the hemisphere, and some along the axes.
Vec3<Directions> packet(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Vec3<Directions> result;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double z = i == 0 ? 1 : i == 1 ? 0 : uniform(random), r = std::sqrt(1 - z * z);
    const double azimuth = i == 2 ? pi<double>() / 2 : uniform(random) * pi<double>();
    result.x[i] = r * std::cos(azimuth);
    result.y[i] = r * std::sin(azimuth);
    result.z[i] = z;
  }
  return result;
}

Vec3<double> lane(const Vec3<Directions>& v, std::size_t i) {
  return {v.x[i], v.y[i], v.z[i]};
}

constexpr std::array<double, 8> apertures_deg{180, 120, 100, 60, 59.9, 24, 7, 0.5};

}  // namespace

TEST_CASE("The slots of many directions hold the lobes of each") {
  std::mt19937 random(1);
  const Conductor<double> copper(0.24, 3.4);
  for (const double aperture : apertures_deg) {
    const Cavity<double> groove(radians(aperture));
    for (const int max_bounces : {1, 2, all_bounces}) {
      for (int trial = 0; trial < 50; ++trial) {
        const Vec3<Directions> e = packet(random);
        const auto slots = lobe_slots(groove, e, copper.over_directions<lanes>(), max_bounces);
        for (std::size_t i = 0; i < lanes; ++i) {
          CAPTURE(aperture, max_bounces, e.x[i], e.y[i], e.z[i]);
          const auto expected = lobes(groove, lane(e, i), copper, max_bounces);
          std::size_t found = 0;
          for (const auto& slot : slots) found += slot.weight[i] > 0 ? 1 : 0;
          REQUIRE(found == expected.size());
          for (const auto& lobe : expected) {
            const auto& slot = slots[(lobe.first_panel == Panel::one ? 0u : 2u) +
                                     static_cast<std::size_t>(lobe.bounces % 2)];
            CHECK(slot.weight[i] == Approx(lobe.weight).epsilon(1e-12));
            CHECK(slot.light[i] == Approx(lobe.weight * lobe.throughput).epsilon(1e-12));
            const Vec3<double> d = lane(slot.direction, i) - lobe.direction;
            CHECK(std::hypot(d.x, d.y, d.z) < 1e-13);
          }
        }
      }
    }
  }
}

TEST_CASE("The slots of an asymmetric groove hold the lobes of each direction, from either side") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Conductor<double> copper(0.24, 3.4);
  std::size_t most_found = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const double aperture = radians(trial % 3 == 0 ? 1 + 19 * uniform(random) : 1 + 178 * uniform(random));
    const double most_tilt = (pi<double>() - aperture) / 2;
    const AsymmetricGroove<double> groove(aperture, (1.99 * uniform(random) - 0.995) * most_tilt);
    Vec3<Directions> e = packet(random);
    for (std::size_t i = 0; i < lanes; i += 2) e.y[i] = -e.y[i];
    const int max_bounces = trial % 5 == 0 ? 3 : all_bounces;
    const auto slots = lobe_slots(groove, e, copper.over_directions<lanes>(), max_bounces);
    STATIC_REQUIRE(slots.size() == AsymmetricGroove<double>::max_lobes);
    for (std::size_t i = 0; i < lanes; ++i) {
      CAPTURE(aperture, groove.tilt(), e.x[i], e.y[i], e.z[i]);
      const auto expected = lobes(groove, lane(e, i), copper, max_bounces);
      std::size_t found = 0;
      for (const auto& slot : slots) found += slot.weight[i] > 0 ? 1 : 0;
      REQUIRE(found == expected.size());
      most_found = std::max(most_found, found);
      for (const auto& lobe : expected) {
        const auto& slot = slots[slot_of(groove, lobe.first_panel, lobe.bounces)];
        CHECK(std::abs(slot.weight[i] - lobe.weight) < 1e-12);
        CHECK(std::abs(slot.light[i] - lobe.weight * lobe.throughput) < 1e-12);
        const Vec3<double> d = lane(slot.direction, i) - lobe.direction;
        CHECK(std::hypot(d.x, d.y, d.z) < 1e-12);
      }
    }
  }
  CHECK(most_found == 6);
}

TEST_CASE("Slots are drawn as often as they have light, and none without") {
  std::mt19937 random(2);
  const Conductor<double> copper(0.24, 3.4);
  for (const double aperture : apertures_deg) {
    const Cavity<double> groove(radians(aperture));
    const Vec3<Directions> e = packet(random);
    const auto slots = lobe_slots(groove, e, copper.over_directions<lanes>());
    const auto odds = slot_probabilities(slots, [](const Directions& light) { return light; });
    constexpr int draws = 1000;
    std::array<std::array<double, lanes>, 4> drawn{};
    for (int k = 0; k <= draws; ++k) {
      const auto sample = drawn_slot(slots, odds, Directions(k / static_cast<double>(draws)));
      for (std::size_t i = 0; i < lanes; ++i) {
        CAPTURE(aperture, e.x[i], e.y[i], e.z[i], k);
        REQUIRE(sample.probability[i] > 0);
        // BSDF × cosine / probability is the reflectance of the direction, whatever is drawn.
        CHECK(sample.light[i] / sample.probability[i] ==
              Approx(directional_reflectance(groove, lane(e, i), copper)).epsilon(1e-12));
        for (std::size_t slot = 0; slot < 4; ++slot)
          if (slots[slot].light[i] == sample.light[i] && odds[slot][i] > 0) drawn[slot][i] += 1.0 / draws;
      }
    }
    for (std::size_t i = 0; i < lanes; ++i)
      for (std::size_t slot = 0; slot < 4; ++slot) {
        bool same_light_elsewhere = false;
        for (std::size_t other = 0; other < 4; ++other)
          same_light_elsewhere |= other != slot && slots[other].light[i] == slots[slot].light[i];
        if (!same_light_elsewhere) CHECK(std::abs(drawn[slot][i] - odds[slot][i]) < 2.1 / draws);
      }
  }
}

TEST_CASE("Where no light is left no slot is drawn") {
  const Cavity<double> groove(radians(60.0));
  std::mt19937 random(3);
  const auto slots = lobe_slots(groove, packet(random), [](const Directions&) { return Directions(0.0); });
  const auto odds = slot_probabilities(slots, [](const Directions& light) { return light; });
  const auto sample = drawn_slot(slots, odds, Directions(0.5));
  for (std::size_t i = 0; i < lanes; ++i) CHECK(sample.probability[i] == 0);
}
