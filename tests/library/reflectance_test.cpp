// SPDX-License-Identifier: BSD-3-Clause
#include <glm/vec3.hpp>
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEMPLATE_LIST_TEST_CASE("a white groove reflects everything: the furnace", "", Reals) {
  using Real = TestType;
  const auto white = [](const Real&) { return Real(1); };
  for (const double aperture_deg : {0.3, 11.0, 45.0, 60.0, 77.7, 120.0, 180.0})
    for (const double theta_deg : {0.0, 20.0, 60.0, 89.0, 89.9999})
      for (const double phi_deg : {0.0, 45.0, 90.0, 200.0}) {
        const Cavity<Real> cavity(radians(Real(aperture_deg)));
        const Vec3<Real> e = direction(radians(Real(theta_deg)), radians(Real(phi_deg)));
        CHECK(error_in_epsilons(directional_reflectance(cavity, e, white), 1) <= 4);
      }
}

TEMPLATE_LIST_TEST_CASE("a flat surface has the Fresnel reflectance", "", Reals) {
  using Real = TestType;
  const Cavity<Real> flat(pi<Real>());
  const Conductor<Real> silver(Real(0.1249), Real(3.3391));
  for (const double theta_deg : {0.0, 30.0, 60.0, 89.0}) {
    const Vec3<Real> e = direction(radians(Real(theta_deg)), radians(Real(33)));
    CHECK(error_in_epsilons(directional_reflectance(flat, e, silver), silver(e.z)) < 24);
  }
}

TEMPLATE_LIST_TEST_CASE("absorptance and reflectance add up to one", "", Reals) {
  using Real = TestType;
  const Conductor<Real> metal(Real(1.17), Real(2.4));
  for (const double aperture_deg : {5.0, 45.0, 100.0})
    for (const double theta_deg : {0.0, 50.0, 88.0}) {
      const Cavity<Real> cavity(radians(Real(aperture_deg)));
      const Vec3<Real> e = direction(radians(Real(theta_deg)), radians(Real(70)));
      const Real sum = directional_reflectance(cavity, e, metal) + directional_absorptance(cavity, e, metal);
      CHECK(error_in_epsilons(sum, 1) < 64);
    }
}

TEST_CASE("the absorptance of a nearly perfect mirror keeps its digits in float") {
  // n = 30, k = 3000: 1 − R is about 1e-5 per bounce.
  const Cavity<float> narrow(radians(45.0f));
  const Cavity<double> reference(static_cast<double>(radians(45.0f)));
  const Vec3<float> e = direction(radians(12.0f), radians(50.0f));
  const Vec3<double> e_reference(e);
  const double exact = directional_absorptance(reference, e_reference, Conductor<double>(30, 3000));
  CHECK(exact < 2e-4);
  CHECK(directional_absorptance(narrow, e, Conductor<float>(30, 3000)) == Approx(exact).epsilon(1e-5));
}

TEST_CASE("colours, packs and numbers of wavelengths give the same as one at a time") {
  const Cavity<float> cavity(radians(50.0f));
  const Vec3<float> e = direction(radians(25.0f), radians(65.0f));
  const glm::vec3 n(0.2f, 0.9f, 1.2f), k(3.9f, 2.5f, 2.3f);
  const glm::vec3 rgb = directional_reflectance(cavity, e, Conductor<glm::vec3>(n, k));
  using Three = Pack<float, 3>;
  const Three pack = directional_reflectance(cavity, e,
                                             Conductor<Three>(Three(std::array<float, 3>{0.2f, 0.9f, 1.2f}),
                                                              Three(std::array<float, 3>{3.9f, 2.5f, 2.3f})));
  for (int i = 0; i < 3; ++i) {
    const float one = directional_reflectance(cavity, e, Conductor<float>(n[i], k[i]));
    CHECK(rgb[i] == Approx(one).epsilon(1e-6));
    CHECK(pack[static_cast<std::size_t>(i)] == Approx(one).epsilon(1e-6));
  }
}

TEMPLATE_LIST_TEST_CASE("light that meets one panel first and light that meets the other make up all", "",
                        Reals) {
  using Real = TestType;
  using std::abs;
  using std::cos;
  using std::sin;
  const Conductor<Real> silver(Real(0.13), Real(3.3));
  const Real psi = radians(Real(25));
  const Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
  for (const double aperture : {1.0, 30.0, 47.0, 90.0, 150.0}) {
    const Cavity<Real> cavity(radians(Real(aperture)));
    for (const double theta : {-70.0, -20.0, -0.4, 0.0, 0.4, 20.0, 70.0}) {
      CAPTURE(aperture, theta);
      const Real across = radians(Real(theta));
      const Vec3<Real> e{sin(psi), cos(psi) * sin(across), cos(psi) * cos(across)};
      const Vec3<Real> mirrored{e.x, -e.y, e.z};
      const Real one = unpolarized_reflectance(cavity, e, silver, all_bounces, Panel::one);
      const Real two = unpolarized_reflectance(cavity, e, silver, all_bounces, Panel::two);
      CHECK(one >= Real(0));
      CHECK(two >= Real(0));
      CHECK(abs(one + two - directional_reflectance(cavity, e, silver)) < rounding);
      CHECK(abs(unpolarized_reflectance(cavity, mirrored, silver, all_bounces, Panel::two) - one) < rounding);
      if (std::abs(theta) > aperture / 2) CHECK((theta > 0 ? two : one) == Real(0));
    }
  }
}

TEST_CASE("thousands of bounces are counted, multiplied and end in time") {
  const Cavity<double> slit(radians(0.01));
  const Vec3<double> e = direction(0.0, 0.0);
  CHECK(mean_bounces(slit, e) == Approx(18000).margin(1));
  CHECK(directional_reflectance(slit, e, Dielectric<double>(1.5)) < std::numeric_limits<double>::min());
  const double nearly_white = directional_reflectance(slit, e, [](double) { return 1 - 1e-5; });
  CHECK(nearly_white == Approx(std::exp(18000 * std::log1p(-1e-5))).epsilon(1e-9));
}

TEST_CASE("averaging single rays over the exact pieces of the opening gives the directional reflectance") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const Conductor<double> metal(2.93, 3.0);
  for (int trial = 0; trial < 500; ++trial) {
    const Cavity<double> cavity(radians(5 + 170 * unit(random)));
    const Vec3<double> e = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
    // Bounce counts change at a few positions only: find them by bisection and add up the pieces.
    const auto same = [](const RayPath& a, const RayPath& b) {
      return a.first_panel == b.first_panel && a.bounces == b.bounces;
    };
    double sum = 0;
    double y = -1;
    while (y < 1) {
      const double inside = std::min(y + 1e-12, 1.0);
      const RayPath path = ray_path(cavity, e, inside);
      double low = inside, high = 1;
      if (!same(path, ray_path(cavity, e, high))) {
        // Along the opening a path never comes back, so bisection finds its end.
        for (int i = 0; i < 60; ++i) {
          const double middle = (low + high) / 2;
          (same(path, ray_path(cavity, e, middle)) ? low : high) = middle;
        }
      }
      sum += (high - y) / 2 * ray_reflectance(cavity, e, path, metal);
      y = high;
    }
    CHECK(sum == Approx(directional_reflectance(cavity, e, metal)).epsilon(1e-9));
  }
}
