// SPDX-License-Identifier: BSD-3-Clause
/// The number type of the vectorised variants of the Mitsuba plug-in, of which nothing here needs Mitsuba: a change of the
/// headers that Dr.Jit's arrays could not follow, a branch on a number for instance, does not compile.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <tuple>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "examples/mitsuba/lanes.hpp"
#include "support/catch.hpp"

using namespace vcavity;

namespace {

constexpr std::size_t count = 4, colours = 3;
using Float = drjit::Array<float, count>;
using Real = vgroove::Lanes<Float>;
using Values = vgroove::Lanes<drjit::Array<Float, colours>>;
constexpr std::array<float, colours> n{0.2f, 0.9f, 1.5f}, k{3.9f, 2.4f, 0.f};

Conductor<Values> facet_in_lanes() {
  drjit::Array<Float, colours> n_values, k_values;
  for (std::size_t c = 0; c < colours; ++c) {
    n_values[c] = Float(n[c]);
    k_values[c] = Float(k[c]);
  }
  return {Values(n_values), Values(k_values)};
}

Conductor<Pack<float, colours>> facet_of_colours() {
  return {Pack<float, colours>(n), Pack<float, colours>(k)};
}

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  Real between(float low, float high) {
    Float result;
    for (float& entry : result.entries) entry = std::uniform_real_distribution<float>(low, high)(engine_);
    return result;
  }

  /// Directions on the side of panel one.
  Vec3<Real> directions() {
    const Real z = between(0.05f, 1), azimuth = between(0, pi<float>());
    const Real r = sqrt(Real(1) - z * z);
    return {r * cos(azimuth), r * sin(azimuth), z};
  }

 private:
  std::mt19937 engine_;
};

float lane(const Real& x, std::size_t i) {
  return x.array[i];
}
float lane(const Values& x, std::size_t i, std::size_t colour) {
  return x.array[colour][i];
}
Vec3<float> lane(const Vec3<Real>& v, std::size_t i) {
  return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
}

constexpr float rounding = 1e-5f;

/// Whether the slots hold the lobes of every direction, whose grooves `groove_of` makes.
template <class Groove, class GrooveOf>
void check_slots(const Groove& groove, const Vec3<Real>& e, const GrooveOf& groove_of) {
  const auto slots = lobe_slots(groove, e, facet_in_lanes());
  const auto fields = lobe_slots(groove, e, polarized(facet_in_lanes()));
  const auto odds = slot_probabilities(slots, [](const Values& light) { return largest(light); });
  const auto drawn = drawn_slot(slots, odds, Real(0.3f));
  for (std::size_t i = 0; i < count; ++i) {
    const auto expected_groove = groove_of(i);
    std::array<float, slots.size()> weights{};
    std::array<std::array<float, colours>, slots.size()> light{}, polarized_light{};
    for (const auto& lobe : lobes(expected_groove, lane(e, i), facet_of_colours())) {
      const std::size_t slot = slot_of(expected_groove, lobe.first_panel, lobe.bounces);
      weights[slot] = lobe.weight;
      for (std::size_t c = 0; c < colours; ++c) light[slot][c] = lobe.weight * lobe.throughput[c];
      if (!(lobe.weight > rounding)) continue;
      const Vec3<float> d = lane(slots[slot].direction, i) - lobe.direction;
      CHECK(std::hypot(d.x, d.y, d.z) < rounding);
    }
    for (const auto& lobe : lobes(expected_groove, lane(e, i), polarized(facet_of_colours())))
      for (std::size_t c = 0; c < colours; ++c)
        polarized_light[slot_of(expected_groove, lobe.first_panel, lobe.bounces)][c] =
            lobe.weight * unpolarized(power(lobe.throughput))[c];
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
      CHECK(std::abs(lane(slots[slot].weight, i) - weights[slot]) < rounding);
      for (std::size_t c = 0; c < colours; ++c) {
        CHECK(std::abs(lane(slots[slot].light, i, c) - light[slot][c]) < rounding);
        CHECK(std::abs(lane(unpolarized(fields[slot].light), i, c) - polarized_light[slot][c]) < rounding);
      }
    }
    CHECK(lane(drawn.probability, i) > 0);
  }
}

/// Sums of lanes: terms are added where there are any left.
struct MaskedSummation {
  template <class... Sums, class Given, class Terms>
  static std::tuple<Sums...> over(const Real& first, const Real& end, const Given& given,
                                  const Terms& terms) {
    std::tuple<Sums...> sums{Sums(0)...};
    const float last = std::max(*std::max_element(end.array.entries.begin(), end.array.entries.end()), 0.f);
    for (Real number = first; lane(number, 0) < last; number += Real(1))
      sums = added(sums, terms(number, given, sums), number < end, std::index_sequence_for<Sums...>());
    return sums;
  }

  template <class Value>
  static const Value& fixed(const Value& value) {
    return value;
  }

 private:
  template <class Sums, class Mask, std::size_t... index>
  static Sums added(const Sums& a, const Sums& b, const Mask& counts, std::index_sequence<index...>) {
    return {std::get<index>(a) +
            select(counts, std::get<index>(b), std::remove_cvref_t<decltype(std::get<index>(a))>(0))...};
  }
};

template <class Facet>
struct RoughSurfaceInLanes {
  Real roughness;
  Facet reflectance;

  GgxSlopes<Real> slopes() const { return GgxSlopes<Real>(roughness); }
  const Facet& facet() const { return reflectance; }
};

/// @param facet that of all directions in lanes
/// @param expected_facet that of each
template <class Facet, class ExpectedFacet>
void check_rough(const Facet& facet, const ExpectedFacet& expected_facet, int max_bounces) {
  using Surface = RoughSurfaceInLanes<Facet>;
  Dice dice(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Surface surface{dice.between(0.2f, 1), facet};
    const Vec3<Real> wo = dice.directions(), wi = dice.directions();
    const LockstepRoughBsdf<Surface, MaskedSummation> bsdf(surface, max_bounces);
    const auto both = bsdf.evaluate_with_pdf(wo, wi);
    const Vec3<Real> drawn =
        bsdf.draw(wo, dice.between(0, 1), {dice.between(0, 1), dice.between(0, 1)}).ray.leaving();
    for (std::size_t i = 0; i < count; ++i) {
      const RoughGrooveBsdf expected(GgxSlopes<float>(lane(surface.roughness, i)), expected_facet,
                                     max_bounces);
      const auto value = expected.evaluate_with_pdf(lane(wo, i), lane(wi, i));
      CHECK(lane(both.pdf, i) == Approx(value.pdf).epsilon(1e-4));
      for (std::size_t c = 0; c < colours; ++c)
        CHECK(lane(both.value, i, c) == Approx(value.value[c]).epsilon(1e-4).margin(1e-6));
      const Vec3<float> d = lane(drawn, i);
      CHECK(std::hypot(d.x, d.y, d.z) == Approx(1).epsilon(1e-5));
    }
  }
}

}  // namespace

TEST_CASE("Sines and cosines of arrays of a GPU have the digits of a float through many turns") {
  Dice dice(21);
  constexpr double rounding_of_sines = 2e-7;
  for (const float largest : {1e-3f, 1.6f, 3.2f, 30.f}) {
    for (int trial = 0; trial < 1000; ++trial) {
      const Real angle = dice.between(-largest, largest);
      const Real sine = sin(angle), cosine = cos(angle);
      for (std::size_t i = 0; i < count; ++i) {
        const double x = lane(angle, i);
        CHECK(std::abs(lane(sine, i) - std::sin(x)) < rounding_of_sines * std::min(1.0, std::abs(x)));
        CHECK(std::abs(lane(cosine, i) - std::cos(x)) < rounding_of_sines);
      }
    }
  }
}

TEST_CASE("Arrays of a vectorised renderer have the lobes of each of their grooves") {
  Dice dice(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Real aperture = dice.between(0.3f, 3);
    check_slots(Cavity<Real>(aperture, 11), dice.directions(),
                [&](std::size_t i) { return Cavity<float>(lane(aperture, i)); });
  }
}

TEST_CASE("Arrays of a vectorised renderer have the lobes of each of their tilted grooves") {
  Dice dice(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Real aperture = dice.between(0.3f, 3);
    const Real tilt = Real(0.45f) * (Real(pi<float>()) - aperture) * dice.between(-1, 1);
    check_slots(AsymmetricGroove<Real>(Cavity<Real>(aperture, 11), tilt), dice.directions(),
                [&](std::size_t i) { return AsymmetricGroove<float>(lane(aperture, i), lane(tilt, i)); });
  }
}

TEST_CASE("Arrays of a vectorised renderer have the densities of each of their lobes with a width") {
  Dice dice(3);
  const VonMisesFisher<float> around(0.2f);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<Real> mean = dice.directions(), wi = dice.directions();
    const Vec2<Real> u{dice.between(0, 1), dice.between(0, 1)};
    const Real density = around.density(mean, wi);
    const Vec3<Real> drawn = around.sample(mean, u);
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(lane(density, i) ==
            Approx(around.density(lane(mean, i), lane(wi, i))).epsilon(1e-3).margin(1e-6));
      const Vec3<float> d = lane(drawn, i) - around.sample(lane(mean, i), {lane(u.x, i), lane(u.y, i)});
      CHECK(std::hypot(d.x, d.y, d.z) < 1e-4f);
    }
  }
}

TEST_CASE("Arrays of a vectorised renderer have the values of each of their rough surfaces") {
  for (const int max_bounces : {8, 32}) check_rough(facet_in_lanes(), facet_of_colours(), max_bounces);
}

TEST_CASE("Arrays of a vectorised renderer have the values of rough surfaces whose facets are fits") {
  const RationalFacet<Pack<float, colours>> fitted(facet_of_colours());
  const auto in_lanes = fitted.in<Values>([](const Pack<float, colours>& coefficient) {
    drjit::Array<Float, colours> values;
    for (std::size_t c = 0; c < colours; ++c) values[c] = Float(coefficient[c]);
    return Values(values);
  });
  CHECK(in_lanes.error() == fitted.error());
  for (const int max_bounces : {8, 32}) check_rough(in_lanes, fitted, max_bounces);
}
