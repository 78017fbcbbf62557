// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <random>
#include <utility>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// Apertures and directions around the hard cases, in any number type.
template <class Real>
std::vector<Real> hard_apertures() {
  std::vector<Real> result{radians(Real(0.5)), radians(Real(7.3)), radians(Real(50)), radians(Real(100)),
                           radians(Real(179.9))};
  for (int k = 1; k <= 6; ++k)
    for (const int ulps : {-1, 0})
      result.push_back(pi<Real>() / Real(k) * (Real(1) + Real(ulps) * epsilon<Real>()));
  return result;
}

template <class Real>
std::vector<Vec3<Real>> hard_directions(const Real& aperture) {
  std::vector<Vec3<Real>> result{
      {Real(1), Real(0), Real(0)}, {Real(0), Real(-1), Real(0)}, {Real(0), Real(0), Real(1)}};
  std::vector<Real> angles;
  for (const double deg : {0.0, 1e-6, 10.0, 37.0, 62.0, 85.0, 89.9, 89.999999})
    angles.push_back(radians(Real(deg)));
  for (int k = 0; k <= 4; ++k) angles.push_back(Real(k) * aperture / Real(4));
  for (const Real& theta : angles)
    for (const double phi_deg : {0.0, 30.0, 89.99999, 90.0, 180.0, 271.0}) {
      const Vec3<Real> e = direction(theta, radians(Real(phi_deg)));
      if (e.z >= Real(0)) result.push_back(e);
    }
  return result;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("weights are positive, at most four, and add up to one", "", Reals) {
  using Real = TestType;
  for (const Real& aperture : hard_apertures<Real>()) {
    const Cavity<Real> cavity(aperture);
    for (const Vec3<Real>& e : hard_directions<Real>(aperture)) {
      const auto found = lobes(cavity, e, [](const Real&) { return Real(1); });
      CAPTURE(cavity.aperture(), e.x, e.y, e.z);
      CHECK(found.size() >= 1);
      CHECK(found.size() <= 4);
      Real sum(0);
      for (const auto& lobe : found) {
        CHECK(lobe.weight > Real(0));
        CHECK(lobe.bounces >= 1);
        CHECK(lobe.bounces <= cavity.max_bounces());
        CHECK(lobe.direction.z >= -Real(64) * epsilon<Real>());
        sum += lobe.weight;
      }
      CHECK(error_in_epsilons(sum, 1) <= 4);
    }
  }
}

TEST_CASE("weights are the fractions of the opening that single rays show") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr int rays = 4000;
  for (int trial = 0; trial < 200; ++trial) {
    const Cavity<double> cavity(radians(2 + 178 * unit(random)));
    const Vec3<double> e = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
    const auto found = lobes(cavity, e, [](double) { return 1.0; });
    std::vector<int> counts(found.size(), 0);
    int unmatched = 0;
    for (int i = 0; i < rays; ++i) {
      const RayPath path = ray_path(cavity, e, -1 + (2 * i + 1.0) / rays);
      bool matched = false;
      for (std::size_t j = 0; j < found.size(); ++j)
        if (found[j].first_panel == path.first_panel && found[j].bounces == path.bounces) {
          ++counts[j];
          matched = true;
        }
      if (!matched) ++unmatched;
    }
    CHECK(unmatched == 0);
    // Each lobe is an interval of the opening, so counting midpoints is off by less than one ray.
    for (std::size_t j = 0; j < found.size(); ++j)
      CHECK(std::abs(counts[j] - found[j].weight * rays) <= 1.0 + 1e-9);
  }
}

TEST_CASE("every lobe has its reverse: Helmholtz reciprocity") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const Conductor<double> metal(1.17, 2.4);
  int compared = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Cavity<double> cavity(radians(2 + 178 * unit(random)));
    const Vec3<double> e = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
    for (const auto& lobe : lobes(cavity, e, metal)) {
      if (lobe.weight < 1e-6 || lobe.direction.z < 1e-6) continue;
      for (const auto& reverse : lobes(cavity, lobe.direction, metal)) {
        const Vec3<double> difference = reverse.direction - e;
        if (reverse.bounces != lobe.bounces || std::abs(difference.y) + std::abs(difference.z) > 1e-9)
          continue;
        CHECK(lobe.weight * e.z == Approx(reverse.weight * lobe.direction.z).epsilon(1e-9));
        CHECK(lobe.throughput == Approx(reverse.throughput).epsilon(1e-9));
        ++compared;
      }
    }
  }
  CHECK(compared > 3000);
}

TEST_CASE("a single bounce is the V-groove term of Torrance and Sparrow") {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto dot = [](const Vec3<double>& a, const Vec3<double>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const Cavity<double> cavity(radians(2 + 178 * unit(random)));
    const Vec3<double> e = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
    const auto found = lobes(cavity, e, [](double) { return 1.0; });
    for (const Panel panel : {Panel::one, Panel::two}) {
      const Vec3<double> h = cavity.normal(panel);
      const double cosine = dot(e, h);
      const Vec3<double> l = 2 * cosine * h - e;
      double expected = 0;
      if (cosine > 0 && l.z > 0) {
        const double g = std::max(0.0, std::min({1.0, 2 * h.z * e.z / cosine, 2 * h.z * l.z / cosine}));
        expected = g * cosine / (2 * cavity.sin_half() * e.z);
      }
      double weight = 0;
      for (const auto& lobe : found)
        if (lobe.first_panel == panel && lobe.bounces == 1) weight = lobe.weight;
      CHECK(weight == Approx(expected).margin(1e-12));
    }
  }
}

TEST_CASE("cutting at a number of bounces leaves the other lobes as they are") {
  const Cavity<double> cavity(radians(45.0));
  const Conductor<double> silver(0.1249, 3.3391);
  const Vec3<double> e = direction(radians(15.0), radians(40.0));
  const auto all = lobes(cavity, e, silver);
  const auto some = lobes(cavity, e, silver, 3);
  double expected = 0;
  std::size_t kept = 0;
  for (const auto& lobe : all)
    if (lobe.bounces <= 3) {
      expected += lobe.weight * lobe.throughput;
      ++kept;
    }
  CHECK(kept == some.size());
  CHECK(kept < all.size());
  CHECK(directional_reflectance(cavity, e, silver, 3) == Approx(expected).epsilon(1e-15));
}

TEST_CASE("light along the groove has the lobes that its rays tell of, those of light from straight above") {
  for (const double aperture_deg : {1.0, 37.0, 60.0, 100.0}) {
    const Cavity<double> groove(radians(aperture_deg));
    const Vec3<double> along{1, 0, 0};
    const auto found = lobes(groove, along, [](double) { return 1.0; });
    std::map<std::pair<int, int>, int> rays;
    constexpr int count = 2000;
    for (int i = 0; i < count; ++i) {
      const RayPath path = ray_path(groove, along, (2 * i + 1 - count) / static_cast<double>(count));
      ++rays[{static_cast<int>(path.first_panel), path.bounces}];
    }
    CAPTURE(aperture_deg);
    CHECK(found.size() == rays.size());
    for (const auto& lobe : found)
      CHECK(rays[{static_cast<int>(lobe.first_panel), lobe.bounces}] ==
            Approx(count * lobe.weight).margin(1.001));
  }
}

TEST_CASE("at a change of the bounce count no lobe is made of rounding errors") {
  const Dielectric<double> glass(1.5);
  int lobes_seen = 0;
  for (const double aperture_deg : {20.0, 36.0, 45.0, 60.0, 72.0, 90.0, 100.0, 137.0}) {
    const Cavity<double> cavity(radians(aperture_deg));
    for (const double kink : kinks(cavity))
      for (int off = -4; off <= 4; ++off)
        for (const double psi : {0.0, 0.3, 1.0}) {
          const double theta = kink * (1 + off * std::numeric_limits<double>::epsilon() / 2);
          const Vec3<double> e{std::sin(psi), std::cos(psi) * std::sin(theta),
                               std::cos(psi) * std::cos(theta)};
          if (e.z < 0) continue;
          for (const auto& lobe : lobes(cavity, e, glass)) {
            CAPTURE(aperture_deg, kink, off, psi);
            CHECK(lobe.weight >= negligible_fraction<double>());
            ++lobes_seen;
          }
        }
  }
  CHECK(lobes_seen > 1000);
}
