// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "light_ray.hpp"
#include "support/catch.hpp"
#include "textbook_fresnel.hpp"

// The tracer by itself, on reliefs where everyone knows the answer.

using namespace tracer;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("a flat relief is a mirror") {
  const Path path = trace(wide_groove_array(pi), {pi, 1.0, 0.7, 0.3});
  const glm::dvec3 light = towards_light({pi, 1.0, 0.7, 0.3});
  REQUIRE(path.ending == Ending::upwards);
  REQUIRE(path.bounces.size() == 1);
  CHECK(path.bounces[0].cos_incidence == Catch::Approx(std::cos(1.0)));
  CHECK(glm::distance(path.direction, {-light.x, -light.y, light.z}) < 1e-15);
}

TEST_CASE("two mirrors at a right angle send light back, except for its way along the groove") {
  const LightRay ray{pi / 2, 0.5, 0.7, 0.1};
  const Path path = trace(wide_groove_array(pi / 2), ray);
  const glm::dvec3 light = towards_light(ray);
  REQUIRE(path.ending == Ending::upwards);
  REQUIRE(path.bounces.size() == 2);
  CHECK(path.bounces[0].panel != path.bounces[1].panel);
  CHECK(path.bounces[0].groove == path.bounces[1].groove);
  CHECK(glm::distance(path.direction, {-light.x, light.y, light.z}) < 1e-15);
}

TEST_CASE("the panel at negative y is the left one of its groove") {
  const Tracer grooves = wide_groove_array(pi / 2);
  CHECK(trace(grooves, {pi / 2, 0, 0, -0.5}).bounces.front().panel % 2 == 0);
  CHECK(trace(grooves, {pi / 2, 0, 0, 0.5}).bounces.front().panel % 2 == 1);
}

TEST_CASE("the clearance of a path is its distance from the nearest edge, measured across the ray") {
  const Tracer flat = wide_groove_array(pi);
  CHECK(trace(flat, {pi, 0, 0, 0.25}).clearance == Catch::Approx(0.25));
  CHECK(trace(flat, {pi, 0, 0, -0.9}).clearance == Catch::Approx(0.1));
  CHECK(trace(flat, {pi, pi / 3, 0, 0.25}).clearance == Catch::Approx(0.125));
  CHECK(trace(flat, {pi, pi / 3, pi / 2, 0.25}).clearance == Catch::Approx(0.25));
}

TEST_CASE("a ray that misses the relief has met nothing") {
  const Path path = wide_groove_array(1.0).trace({0, 100, 1}, {0, 0, -1});
  CHECK(path.ending == Ending::missed);
  CHECK(path.bounces.empty());
}

TEST_CASE("a ray that leaves through the end of a groove is told from one that comes out above") {
  const LightRay askew{pi / 4, 1.4, 1.2, 0.2};
  CHECK(trace(Tracer(groove_array(pi / 4, 3, 100)), askew).ending == Ending::upwards);
  CHECK(trace(Tracer(groove_array(pi / 4, 3, 2)), askew).ending == Ending::past_an_end);
}

TEST_CASE("more bounces than can be meant are a trapped ray") {
  const double hairline = 0.02 * pi / 180;
  CHECK(trace(wide_groove_array(hairline), {hairline, 0, 0, 0.4}).ending == Ending::trapped);
}

TEST_CASE("a ray that leaves one groove and meets another is counted") {
  // A flat mirror in the left groove, and a wall that stands above the right one.
  const Tracer relief(Relief{{{-1, 0}, {0, 0}, {1, 0}, {1.1, 2}, {2.1, 2}}, 100});
  const double slant = std::numbers::sqrt2 / 2;
  const Path path = relief.trace({0, -1, 0.5}, {0, slant, -slant});
  REQUIRE(path.bounces.size() == 2);
  CHECK(bounces_in_other_grooves(path) == 1);
  CHECK(bounces_in_other_grooves(relief.trace({0, -0.5, 1}, {0, 0, -1})) == 0);
}

TEST_CASE("light falls on a floor between vertical walls, past an overhang, and on land") {
  // Walls of height 1 one apart, and land twice as wide.
  const Tracer trenches(profile_array({{0, 1}, {0, 0}, {1, 0}, {1, 1}, {3, 1}}, 3, 100));
  const auto panels = [](const Path& path) {
    std::vector<int> result;
    for (const Bounce& bounce : path.bounces) result.push_back(bounce.panel % 4);
    return result;
  };
  CHECK(panels(trenches.trace({0, 0.5, 2}, {0, 0, -1})) == std::vector{1});
  CHECK(panels(trenches.trace({0, 2, 2}, {0, 0, -1})) == std::vector{3});
  const double slant = std::numbers::sqrt2 / 2;
  CHECK(panels(trenches.trace({0, 0.25, 1.5}, {0, slant, -slant})) == std::vector{2, 1, 0});
  // The left wall leans over the right one; light along the normal meets the right one only from the left.
  const Tracer overhang(profile_array({{1, 1}, {0, 0}, {3, 1}}, 3, 100));
  CHECK(overhang.trace({0, 2, 2}, {0, 0, -1}).bounces.front().panel % 2 == 1);
  CHECK(overhang.trace({0, 2, 2}, {0, 0, -1}).bounces.front().groove == 1);
}

TEST_CASE("an array that cannot be built is refused") {
  CHECK_THROWS_AS(profile_array({{0, 1}}, 3, 1), std::invalid_argument);
  CHECK_THROWS_AS(profile_array({{0, 1}, {1, 0}}, 3, 1), std::invalid_argument);
  CHECK_THROWS_AS(profile_array({{0, 1}, {1, 0}, {2, 1}}, 2, 1), std::invalid_argument);
  CHECK_THROWS_AS(groove_array(0, 3, 1), std::invalid_argument);
  CHECK_THROWS_AS(groove_array(3.2, 3, 1), std::invalid_argument);
  CHECK_THROWS_AS(groove_array(1, 4, 1), std::invalid_argument);
  CHECK_THROWS_AS(groove_array(1, 3, -1), std::invalid_argument);
}

TEST_CASE("the tracer's own Fresnel reflectance has the textbook values") {
  // Normal incidence: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
  CHECK(fresnel_reflectance(1.5, 1) == Catch::Approx(0.04));
  CHECK(fresnel_reflectance({0.2, 3.0}, 1) == Catch::Approx((0.64 + 9) / (1.44 + 9)));
  // Grazing incidence: total.
  CHECK(fresnel_reflectance(1.5, 0) == Catch::Approx(1));
  CHECK(fresnel_reflectance({0.2, 3.0}, 0) == Catch::Approx(1));
  // Brewster's angle: only the perpendicular half is reflected, with r_s = (1 - n^2) / (1 + n^2).
  const double r_s = (1 - 1.5 * 1.5) / (1 + 1.5 * 1.5);
  CHECK(fresnel_reflectance(1.5, 1 / std::sqrt(1 + 1.5 * 1.5)) == Catch::Approx(r_s * r_s / 2));
  // Beyond the critical angle: total.
  CHECK(fresnel_reflectance(1 / 1.5, 0.5) == Catch::Approx(1));
}
