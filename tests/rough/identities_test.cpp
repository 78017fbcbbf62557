// SPDX-License-Identifier: BSD-3-Clause
/// What the BRDF of rough surfaces must obey, whatever its numbers.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <stdexcept>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/polarization/polarization.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/mixed_slopes.hpp>
#include <vcavity/rough/rough_bsdf.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

const Conductor<double> metal(0.2, 3);
const auto white = [](double) { return 1.0; };

class Directions {
 public:
  explicit Directions(unsigned seed) : random_(seed) {}
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  Vec3<double> operator()() {
    const double theta = std::acos(uniform());
    return direction(theta, 2 * pi<double>() * uniform());
  }

 private:
  std::mt19937 random_;
};

/// The BRDF, from BRDF × cosine.
template <class Bsdf>
double brdf(const Bsdf& bsdf, const Vec3<double>& e, const Vec3<double>& o, int bounces) {
  return bsdf.evaluate_bounces(e, o, bounces) / o.z;
}

}  // namespace

TEST_CASE("one bounce is the microfacet model with the V-cavities of Torrance and Sparrow") {
  Directions directions(1);
  const auto check = [&](const auto& distribution) {
    const RoughGrooveBsdf bsdf(distribution, metal);
    for (int trial = 0; trial < 2000; ++trial) {
      const Vec3<double> e = directions(), o = directions(), m = glm::normalize(e + o);
      const double e_m = glm::dot(e, m);
      // D G F/(4 cos θ_e cos θ_o) with G = min(1, 2 (N·m)(N·e)/(e·m), 2 (N·m)(N·o)/(e·m)).
      const double g = std::min({1.0, 2 * m.z * e.z / e_m, 2 * m.z * o.z / e_m});
      const double expected = distribution.density(m) * g * metal(e_m) / (4 * e.z * o.z);
      CHECK(brdf(bsdf, e, o, 1) == Approx(expected).epsilon(1e-10));
    }
  };
  check(GgxSlopes<double>(0.3));
  check(BeckmannSlopes<double>(0.6, 0.9));
}

TEST_CASE("light goes both ways alike, for every number of bounces") {
  Directions directions(2);
  const auto check = [&](const auto& distribution) {
    const RoughGrooveBsdf bsdf(distribution, metal);
    int compared = 0;
    for (int trial = 0; trial < 500; ++trial) {
      const Vec3<double> e = directions(), o = directions();
      for (int bounces = 1; bounces <= 6; ++bounces) {
        const double there = brdf(bsdf, e, o, bounces);
        CHECK(brdf(bsdf, o, e, bounces) == Approx(there).epsilon(1e-11).margin(1e-200));
        compared += there > 0;
      }
    }
    CHECK(compared > 800);
  };
  check(GgxSlopes<double>(0.4));
  check(BrushedSlopes(BeckmannSlopes<double>(0.8), 4.0));
}

TEST_CASE("towards the horizon the BRDF keeps its digits, both ways") {
  const RoughGrooveBsdf bsdf(GgxSlopes<double>(0.5), metal);
  for (const double height : {1e-3, 1e-10, 1e-100, 1e-300})
    for (const double azimuth : {0.3, 2.0, 3.0}) {
      const double across = std::sqrt(1 - height * height);
      const Vec3<double> grazing{across * std::sin(azimuth), across * std::cos(azimuth), height};
      const Vec3<double> o = direction(0.7, 0.0);
      const double there = bsdf.evaluate(grazing, o) / o.z;
      const double back = bsdf.evaluate(o, grazing) / std::max(height, 1e-153);
      CAPTURE(height, azimuth);
      CHECK(there > 0);
      CHECK(there == Approx(bsdf.evaluate({grazing.x, grazing.y, 1e-5 * height}, o) / o.z).epsilon(0.02));
      if (height > 1e-153) CHECK(back == Approx(there).epsilon(1e-12));
    }
}

TEST_CASE("reversed light has the reversed Mueller matrix") {
  Directions directions(3);
  const RoughGrooveBsdf bsdf(GgxSlopes<double>(0.3, 0.8), polarized(metal));
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3<double> e = directions(), o = directions();
    const Mueller<double> there = bsdf.evaluate(e, o, Transport::importance);
    const Mueller<double> back = reversed(bsdf.evaluate(o, e, Transport::importance));
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        CHECK(back(i, j) / e.z == Approx(there(i, j) / o.z).margin(1e-10 * there(0, 0) / o.z));
  }
}

TEST_CASE("a facet that reflects r of all light takes r to the power of the bounces") {
  Directions directions(4);
  const RoughGrooveBsdf all(GgxSlopes<double>(0.6), white);
  const RoughGrooveBsdf half(GgxSlopes<double>(0.6), [](double) { return 0.5; });
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3<double> e = directions(), o = directions();
    double sum = 0;
    for (int bounces = 1; bounces <= 32; ++bounces)
      sum += std::ldexp(all.evaluate_bounces(e, o, bounces), -bounces);
    CHECK(half.evaluate(e, o) == Approx(sum).epsilon(1e-12));
    CHECK(all.evaluate(e, o) == Approx(all.pdf(e, o)).epsilon(1e-12));
  }
}

TEST_CASE("a perfect conductor reflects unpolarised light as white facets do") {
  Directions directions(5);
  const RoughGrooveBsdf white_bsdf(BeckmannSlopes<double>(0.7), white);
  const RoughGrooveBsdf perfect(BeckmannSlopes<double>(0.7), polarized(Conductor<double>(0, 1e8)));
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3<double> e = directions(), o = directions();
    CHECK(unpolarized(perfect.evaluate(e, o)) == Approx(white_bsdf.evaluate(e, o)).epsilon(1e-6));
  }
}

TEST_CASE("light, viewer and surface turned together see the same, and so do their mirror images") {
  Directions directions(6);
  const RoughGrooveBsdf along_x(GgxSlopes<double>(0.2, 0.7), metal),
      along_y(GgxSlopes<double>(0.7, 0.2), metal);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3<double> e = directions(), o = directions();
    const auto turned = [](const Vec3<double>& v) { return Vec3<double>{-v.y, v.x, v.z}; };
    const auto mirrored = [](const Vec3<double>& v) { return Vec3<double>{-v.x, v.y, v.z}; };
    CHECK(along_y.evaluate(turned(e), turned(o)) == Approx(along_x.evaluate(e, o)).epsilon(1e-11));
    CHECK(along_x.evaluate(mirrored(e), mirrored(o)) == Approx(along_x.evaluate(e, o)).epsilon(1e-11));
  }
}

TEST_CASE("polarised light along the normal is described in the axes of the surface, whatever the grooves") {
  // The limit of directions that come close to the normal in the plane of x and z, where a_z is along x.
  const RoughGrooveBsdf bsdf(GgxSlopes<double>(0.5), polarized(metal));
  const Vec3<double> o = direction(0.6, 2.0);
  const Mueller<double> at = bsdf.evaluate({0, 0, 1}, o, Transport::importance);
  const Mueller<double> near = bsdf.evaluate({1e-7, 0, 1}, o, Transport::importance);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(std::abs(std::abs(at(i, j)) - std::abs(near(i, j))) < 1e-5 * at(0, 0));
}

TEST_CASE("two distributions side by side add up") {
  Directions directions(7);
  const GgxSlopes<double> smooth(0.1);
  const BeckmannSlopes<double> rough(0.9);
  const RoughGrooveBsdf mixed(MixedSlopes(smooth, rough, 0.3), metal);
  const RoughGrooveBsdf first(smooth, metal);
  const RoughGrooveBsdf second(rough, metal);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3<double> e = directions(), o = directions();
    CHECK(mixed.evaluate(e, o) == Approx(0.3 * first.evaluate(e, o) + 0.7 * second.evaluate(e, o)));
  }
}

TEST_CASE("white facets need no more bounces than the limit where the rest has a closed form") {
  Directions directions(8);
  const GgxSlopes<double> slopes(1.0);
  const RoughGrooveBsdf all(slopes, white, 4096);
  const RoughGrooveBsdf cut(slopes, white, 32), closed(slopes, white, 32, LongWays::without_loss);
  double worst_cut = 0, worst_closed = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3<double> e = directions();
    // Near the cone θ_o = θ_e, where there are ways of any number of bounces.
    const double azimuth = 2 * pi<double>() * directions.uniform();
    const double theta = std::acos(e.z) + 0.01 * (directions.uniform() - 0.5);
    const Vec3<double> o = direction(std::min(std::max(theta, 0.0), 1.57), azimuth);
    const double exact = all.evaluate(e, o);
    worst_cut = std::max(worst_cut, std::abs(cut.evaluate(e, o) / exact - 1));
    worst_closed = std::max(worst_closed, std::abs(closed.evaluate(e, o) / exact - 1));
  }
  CHECK(worst_cut > 0.02);
  CHECK(worst_closed < 1e-3);
}

TEST_CASE("in the mirror direction the one bounce of flat facets is left, below the horizon nothing") {
  const RoughGrooveBsdf bsdf(GgxSlopes<double>(0.3), white);
  const Vec3<double> e = direction(0.6, 0.4), mirrored{-e.x, -e.y, e.z};
  CHECK(bsdf.evaluate(e, mirrored) == Approx(1 / (pi<double>() * 0.09 * 4 * e.z)));
  CHECK(bsdf.evaluate({0, 0, 1}, {0, 0, 1}) == Approx(1 / (pi<double>() * 0.09 * 4)));
  const double nan = std::nan("");
  for (const Vec3<double>& below :
       {Vec3<double>{0, 0, -1}, Vec3<double>{0.6, 0, -0.8}, Vec3<double>{nan, 0, 1}}) {
    CHECK(bsdf.evaluate(e, below) == 0);
    CHECK(bsdf.evaluate(below, e) == 0);
    CHECK(bsdf.pdf(e, below) == 0);
    CHECK_FALSE(bsdf.sample(below, 0.5, {0.5, 0.5}));
  }
}

TEST_CASE("a bounce limit out of range is refused") {
  for (const int limit : {0, -1, 4097})
    CHECK_THROWS_AS(RoughGrooveBsdf(GgxSlopes<double>(0.3), white, limit), std::invalid_argument);
}
