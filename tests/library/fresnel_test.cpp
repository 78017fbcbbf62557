// SPDX-License-Identifier: BSD-3-Clause
#include <complex>
#include <glm/vec3.hpp>
#include <random>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/numbers/pack.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

using Wide = Digits50;

/// The textbook amplitudes, (cos θ_i − w)/(cos θ_i + w) and (η² cos θ_i − w)/(η² cos θ_i + w), in 50 digits.
struct Textbook {
  Complex<Wide> r_s, r_p;
  Textbook(const Wide& n, const Wide& k, const Wide& c) {
    const Complex<Wide> eta2{Wide(n * n - k * k), Wide(2 * n * k)};
    const Complex<Wide> w2{Wide(eta2.re - (1 - c * c)), eta2.im};
    const Wide modulus = sqrt(norm(w2));
    const Wide re = sqrt(Wide((modulus + w2.re) / 2));
    const Wide im = sqrt(Wide((modulus - w2.re) / 2));
    const Complex<Wide> w{re, im};
    const Complex<Wide> cosine{c, Wide(0)};
    r_s = (cosine - w) / (cosine + w);
    r_p = (eta2 * cosine - w) / (eta2 * cosine + w);
  }
  Wide reflectance() const { return (norm(r_s) + norm(r_p)) / 2; }
};

/// How much the reflectance changes, in units of ε, when each argument changes by ε: Σ |x ∂R/∂x|.
Wide change_by_rounding_of_arguments(const Wide& n, const Wide& k, const Wide& c) {
  const Wide h("1e-20");
  const Wide exact = Textbook(n, k, c).reflectance();
  const Wide by_n = abs(Wide(Textbook(n * (1 + h), k, c).reflectance() - exact));
  const Wide by_k = abs(Wide(Textbook(n, k * (1 + h), c).reflectance() - exact));
  const Wide by_c = abs(Wide(Textbook(n, k, c * (1 + h)).reflectance() - exact));
  return (by_n + by_k + by_c) / h;
}

}  // namespace

TEST_CASE("reflectance at normal incidence is the textbook's") {
  // Born & Wolf §1.5.2 for glass; ((n−1)² + k²)/((n+1)² + k²) for metals.
  CHECK(Dielectric<double>(1.5)(1.0) == Approx(0.04).epsilon(1e-15));
  const double n = 0.1249, k = 3.3391;
  CHECK(Conductor<double>(n, k)(1.0) ==
        Approx(((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k)).epsilon(1e-15));
}

TEST_CASE("at Brewster's angle only s light is reflected") {
  const double n = 1.5;
  const double c = 1 / std::sqrt(1 + n * n);
  const Amplitudes<double> r = Dielectric<double>(n).amplitudes(c);
  CHECK(norm(r.r_p) < 1e-31);
  CHECK(Dielectric<double>(n)(c) == Approx(norm(r.r_s) / 2).epsilon(1e-14));
}

TEST_CASE("below the critical angle a thinner medium reflects everything") {
  const Dielectric<double> thinner(0.7);
  CHECK(thinner.critical_cosine() == Approx(std::sqrt(1 - 0.49)).epsilon(1e-15));
  CHECK(thinner(0.9 * thinner.critical_cosine()) == 1);
  CHECK(thinner(1.1 * thinner.critical_cosine()) < 0.2);
  CHECK(thinner.absorptance(0.5) == 0);
  CHECK(Conductor<double>(0.7, 0)(0.5) == Approx(1).epsilon(1e-15));
}

TEMPLATE_LIST_TEST_CASE("an index of exactly one reflects nothing and transmits everything, at any angle", "",
                        Reals) {
  using Real = TestType;
  for (const Real& c : {Real(0), std::numeric_limits<Real>::min(), Real(1e-8), Real(0.3), Real(1)}) {
    CHECK(Dielectric<Real>(Real(1))(c) == Real(0));
    CHECK(Conductor<Real>(Real(1), Real(0))(c) == Real(0));
    CHECK(error_in_epsilons(Dielectric<Real>(Real(1)).absorptance(c), 1) <= 2);
    CHECK(error_in_epsilons(Conductor<Real>(Real(1), Real(0)).absorptance(c), 1) <= 2);
  }
}

TEST_CASE("grazing light is reflected entirely, except without an interface") {
  for (const double n : {1.0003, 1.5, 0.7, 4.0}) CHECK(Dielectric<double>(n)(0) == Approx(1).epsilon(1e-15));
  CHECK(Conductor<double>(0.05, 4.2)(0) == Approx(1).epsilon(1e-15));
}

TEMPLATE_LIST_TEST_CASE(
    "reflectance and absorptance agree with 50-digit textbook formulas over random indices", "",
    HardwareReals) {
  using Real = TestType;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst_reflectance = 0, worst_absorptance = 0;
  for (int i = 0; i < 20000; ++i) {
    const Real n = static_cast<Real>(std::exp(-3 + 7 * unit(random)));
    const Real k = static_cast<Real>(std::exp(-9 + 14 * unit(random)));
    const Real c = std::max(static_cast<Real>(i % 3 == 0 ? std::pow(unit(random), 8) : unit(random)),
                            vcavity::detail::smallest_cosine<Real>());
    const Wide exact = Textbook(Wide(n), Wide(k), Wide(c)).reflectance();
    const Wide rest = 1 - exact;
    const Conductor<Real> metal(n, k);
    const Wide change = change_by_rounding_of_arguments(Wide(n), Wide(k), Wide(c));
    const double condition = static_cast<double>(Wide(change / exact));
    const double absorptance_condition = static_cast<double>(Wide(change / rest));
    worst_reflectance =
        std::max(worst_reflectance, error_in_epsilons(metal(c), exact) / std::max(1.0, condition / 2));
    worst_absorptance = std::max(worst_absorptance, error_in_epsilons(metal.absorptance(c), rest) /
                                                        std::max(1.0, absorptance_condition / 2));
  }
  CAPTURE(worst_reflectance, worst_absorptance);
  CHECK(worst_reflectance < 8);
  CHECK(worst_absorptance < 8);
}

TEMPLATE_LIST_TEST_CASE("weak contrast keeps its digits", "", HardwareReals) {
  using Real = TestType;
  for (const double contrast : {3e-4, 1e-6, -1e-6, 1e-3}) {
    const Real n_minus_1 = static_cast<Real>(contrast);
    for (const double cosine : {1.0, 0.9, 0.5, 0.1}) {
      const Real c = static_cast<Real>(cosine);
      const Wide exact = Textbook(1 + Wide(n_minus_1), Wide(0), Wide(c)).reflectance();
      CHECK(error_in_epsilons(Dielectric<Real>::from_contrast(n_minus_1)(c), exact) < 8);
      CHECK(error_in_epsilons(Conductor<Real>::from_contrast(n_minus_1, Real(0))(c), exact) < 8);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("k → 0 is the dielectric", "", Reals) {
  using Real = TestType;
  for (const double n : {0.7, 1.0003, 1.5, 4.0})
    for (int i = 0; i <= 50; ++i) {
      const Real c = Real(i) / Real(50);
      CHECK(error_in_epsilons(Conductor<Real>(Real(n), Real(0))(c), Dielectric<Real>(Real(n))(c)) < 24);
    }
}

TEST_CASE("powers are the squared amplitudes, and r_p equals r_s at normal incidence") {
  for (const double c : {1.0, 0.8, 0.3, 0.01}) {
    const Conductor<double> metal(1.17, 2.4);
    const Amplitudes<double> r = metal.amplitudes(c);
    CHECK((norm(r.r_s) + norm(r.r_p)) / 2 == Approx(metal(c)).epsilon(1e-14));
    const Textbook exact(1.17, 2.4, c);
    CHECK(r.r_s.re == Approx(static_cast<double>(exact.r_s.re)).epsilon(1e-13));
    CHECK(r.r_s.im == Approx(static_cast<double>(exact.r_s.im)).epsilon(1e-13));
    CHECK(r.r_p.re == Approx(-static_cast<double>(exact.r_p.re)).epsilon(1e-13));
    CHECK(r.r_p.im == Approx(-static_cast<double>(exact.r_p.im)).epsilon(1e-13));
  }
  const Amplitudes<double> normal = Conductor<double>(1.17, 2.4).amplitudes(1);
  CHECK(normal.r_s.re == normal.r_p.re);
  CHECK(normal.r_s.im == normal.r_p.im);
}

TEST_CASE("colours and packs give what single wavelengths give") {
  const Conductor<glm::dvec3> copper(glm::dvec3(0.2, 0.9, 1.2), glm::dvec3(3.9, 2.5, 2.3));
  using Four = Pack<double, 4>;
  const Four n(std::array<double, 4>{0.2, 0.7, 1.5, 4.0});
  const Four k(std::array<double, 4>{3.9, 0.0, 0.0, 0.04});
  const Conductor<Four> metals(n, k);
  const Dielectric<Four> glasses(n);
  for (const double c : {0.0, 0.2, 0.6, 1.0}) {
    CHECK(copper(c).y == Conductor<double>(0.9, 2.5)(c));
    CHECK(copper.absorptance(c).z == Conductor<double>(1.2, 2.3).absorptance(c));
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(metals(c)[i] == Conductor<double>(n[i], k[i])(c));
      CHECK(glasses(c)[i] == Dielectric<double>(n[i])(c));
    }
  }
}

TEST_CASE("an index that is no index is refused with its value") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Conductor<double>(0.1, -3), Catch::Matchers::ContainsSubstring("-3"));
  CHECK_THROWS_AS(Conductor<double>(-0.1, 3), std::invalid_argument);
  CHECK_THROWS_AS(Conductor<double>(nan, 3), std::invalid_argument);
  CHECK_THROWS_AS(Dielectric<double>(nan), std::invalid_argument);
  CHECK_THROWS_AS(Dielectric<double>(std::numeric_limits<double>::infinity()), std::invalid_argument);
  CHECK_THROWS_AS(Conductor<glm::vec3>(glm::vec3(1, -1, 1), glm::vec3(1)), std::invalid_argument);
}
