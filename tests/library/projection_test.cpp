// SPDX-License-Identifier: BSD-3-Clause
#include <vcavity/hemisphere/integral.hpp>
#include <vcavity/numbers/gauss_legendre.hpp>
#include <vcavity/render/projection.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEMPLATE_LIST_TEST_CASE("projecting and back gives the same direction", "", Reals) {
  using Real = TestType;
  for (int theta_deg = 0; theta_deg <= 90; theta_deg += 5)
    for (int phi_deg = 0; phi_deg < 360; phi_deg += 15) {
      const Vec3<Real> e = direction(radians(Real(theta_deg)), radians(Real(phi_deg)));
      Vec2<Real> point = project_to_disc(e);
      if (theta_deg == 90) point *= Real(1) - Real(4) * epsilon<Real>();  // rounding may lead out of the disc
      const auto back = direction_on_disc(point);
      REQUIRE(back.has_value());
      for (glm::length_t i = 0; i < 3; ++i) CHECK(error_in_epsilons((*back)[i], Digits50(e[i]), 1) < 24);
    }
}

TEST_CASE("the projection is the paper's: u = 2 sin(θ/2) cos φ, v = 2 sin(θ/2) sin φ") {
  const double theta = 1.1, phi = 2.3;
  const Vec2<double> point = project_to_disc(direction(theta, phi));
  CHECK(point.x == Approx(2 * std::sin(theta / 2) * std::cos(phi)).epsilon(1e-15));
  CHECK(point.y == Approx(2 * std::sin(theta / 2) * std::sin(phi)).epsilon(1e-15));
}

TEST_CASE("outside the disc there is no direction") {
  CHECK_FALSE(direction_on_disc(Vec2<double>{1.0, 1.0001}).has_value());
  CHECK_FALSE(direction_on_disc(Vec2<double>{std::numeric_limits<double>::quiet_NaN(), 0}).has_value());
  // The rim itself belongs to the disc.
  const auto rim = direction_on_disc(Vec2<double>{1, 1});
  REQUIRE(rim.has_value());
  CHECK(rim->z == 0);
}

TEMPLATE_LIST_TEST_CASE("Gauss-Legendre rules integrate polynomials of degree 2n − 1 exactly", "", Reals) {
  using Real = TestType;
  for (const std::size_t order : {1u, 2u, 3u, 6u, 13u, 64u}) {
    const auto nodes = gauss_legendre<Real>(order);
    for (int degree = 0; degree < 2 * static_cast<int>(order); ++degree) {
      Real sum(0);
      for (const auto& node : nodes) {
        Real power(1);
        for (int i = 0; i < degree; ++i) power *= node.x;
        sum += node.weight * power;
      }
      const Digits50 expected = degree % 2 == 0 ? Digits50(2) / (degree + 1) : Digits50(0);
      CAPTURE(order, degree);
      CHECK(error_in_epsilons(sum, expected, 2) < 40);
    }
  }
}
