// SPDX-License-Identifier: BSD-3-Clause
/// Thin films: reference stacks, limits and identities. Errors in ε, over random stacks: tests/accuracy.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/textbook_stack.hpp"
#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

const std::vector<double> cosines{0.0, 1e-6, 0.05, 0.3, 0.7, 0.95, 1.0};

template <class Value>
bool same(const Amplitudes<Value>& a, const Amplitudes<Value>& b) {
  return a.r_s.re == b.r_s.re && a.r_s.im == b.r_s.im && a.r_p.re == b.r_p.re && a.r_p.im == b.r_p.im;
}

/// |a − b| of both amplitudes, the larger one.
double difference(const Amplitudes<double>& a, const Amplitudes<double>& b) {
  return std::sqrt(std::max(norm(a.r_s - b.r_s), norm(a.r_p - b.r_p)));
}

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A dielectric, absorbing or metal film.
Film<double> random_film(std::mt19937_64& random) {
  const double thickness = std::exp(uniform(random, -7, 1));
  switch (random() % 3) {
    case 0:
      return {uniform(random, 0.5, 3), 0, thickness};
    case 1:
      return {uniform(random, 1, 3), std::exp(uniform(random, -6, 0)), thickness};
    default:
      return {uniform(random, 0.05, 2), uniform(random, 2, 7), thickness};
  }
}

}  // namespace

TEST_CASE("stacks agree with characteristic matrices of 60 digits") {
  const auto rows = nlohmann::json::parse(std::ifstream(VCAVITY_TEST_DATA "/stack_reference.json"));
  REQUIRE(rows.size() == 9);
  for (const auto& row : rows) {
    CAPTURE(row.dump());
    const double ambient = row["ambient"];
    std::vector<Film<double>> films;
    for (const auto& film : row["films_top_down"])
      films.emplace_back(film["n"].get<double>() / ambient, film["k"].get<double>() / ambient,
                         film["thickness_in_wavelengths"].get<double>() * ambient);
    const double n = row["substrate"][0], k = row["substrate"][1], c = row["cos_incidence"];
    const Coated stack(Conductor<double>(n / ambient, k / ambient), films);
    const Amplitudes<double> r = stack.amplitudes(c);
    const Amplitudes<double> expected{{row["r_s"][0], row["r_s"][1]}, {row["r_p"][0], row["r_p"][1]}};
    // Rounding moves the phase of a totally reflecting film of 0.8 wavelengths by 2e-15.
    CHECK(difference(r, expected) < 1e-14 * std::max(std::sqrt(norm(expected.r_s)), 0.2));
    CHECK(stack(c) == Approx(row["R"].get<double>()).epsilon(4e-15));
    const Absorptances<double> rest = stack.absorptances(c);
    CHECK(rest.s == Approx(row["absorbed_or_transmitted_s"].get<double>()).epsilon(4e-15));
    CHECK(rest.p == Approx(row["absorbed_or_transmitted_p"].get<double>()).epsilon(4e-15));
  }
}

TEMPLATE_LIST_TEST_CASE("films of thickness 0 change nothing, bit for bit", "", Reals) {
  using Real = TestType;
  const Conductor<Real> metal(Real(0.2L), Real(3.4L));
  const Film<Real> none(Real(1.4L), Real(0.3L), Real(0)), oxide(Real(2.4L), Real(0), Real(0.12L));
  for (const double cosine : cosines) {
    const Real c = static_cast<Real>(cosine);
    const Coated bare(metal, none, none);
    CHECK(same(bare.amplitudes(c), metal.amplitudes(c)));
    CHECK(bare(c) == metal(c));
    CHECK(bare.absorptance(c) == metal.absorptance(c));
    CHECK(Coated(Dielectric<Real>(Real(1.5L)), none)(c) == Dielectric<Real>(Real(1.5L))(c));
    const Coated coated(metal, oxide);
    const Coated<Conductor<Real>> with_none(metal, std::vector<Film<Real>>{none, oxide, none});
    CHECK(same(with_none.amplitudes(c), coated.amplitudes(c)));
    CHECK(with_none(c) == coated(c));
    CHECK(with_none.absorptance(c) == coated.absorptance(c));
  }
}

TEST_CASE("a film that is absent at some wavelengths of a pack changes nothing there, bit for bit") {
  using Four = Pack<double, 4>;
  const Conductor<Four> metal(Four(0.2), Four(3.4));
  const Film<Four> oxide(Four(2.4), Four(0.0), Four(0.12));
  const Film<Four> some(Four(1.4), Four(0.3), Four(std::array<double, 4>{0, 0.1, 0, 2}));
  for (const double c : cosines) {
    const Four with = Coated(metal, some, oxide)(c), without = Coated(metal, oxide)(c);
    CHECK(with[0] == without[0]);
    CHECK(with[2] == without[2]);
    if (c > 0) CHECK(with[1] != without[1]);
  }
}

TEST_CASE("a film of the index of the medium above it only turns the phase") {
  const double thickness = 0.37;
  const Conductor<double> metal(0.2, 3.4);
  const Coated stack(metal, Film<double>(1, 0, thickness));
  for (const double c : cosines) {
    const double phase = 4 * pi<double>() * thickness * c;
    const Complex<double> turn{std::cos(phase), std::sin(phase)};
    const Amplitudes<double> bare = metal.amplitudes(c);
    CHECK(difference(stack.amplitudes(c), {turn * bare.r_s, turn * bare.r_p}) < 1e-15);
    CHECK(stack(c) == Approx(metal(c)).epsilon(1e-15));
    CHECK(stack.absorptance(c) == Approx(metal.absorptance(c)).epsilon(2e-15));
  }
}

TEST_CASE("a film of the index of the substrate changes nothing") {
  for (const auto& [n, k] : {std::pair{1.5, 0.0}, std::pair{2.0, 0.4}, std::pair{0.2, 3.4}}) {
    const Conductor<double> bare(n, k);
    const Coated stack(bare, Film<double>(n, k, 0.8));
    for (const double c : cosines) {
      CHECK(difference(stack.amplitudes(c), bare.amplitudes(c)) < 2e-15);
      CHECK(stack.absorptance(c) == Approx(bare.absorptance(c)).epsilon(4e-15));
    }
  }
}

TEST_CASE("a quarter wave of index √n extinguishes the reflection, any other leaves the textbook's") {
  // Born & Wolf §1.6.4, Eq. (68): R = ((n_s − n_f²)/(n_s + n_f²))².
  const double glass = 1.52;
  const auto quarter_wave = [&](double n) {
    return Coated(Dielectric<double>(glass), Film<double>(n, 0, 0.25 / n))(1.0);
  };
  CHECK(quarter_wave(std::sqrt(glass)) < 1e-31);
  for (const double n : {1.38, 1.7, 2.3}) {
    const double r = (glass - n * n) / (glass + n * n);
    CHECK(quarter_wave(n) == Approx(r * r).epsilon(1e-14));
  }
}

TEST_CASE("light tunnels through a gap between prisms and loses no digits, however wide the gap is") {
  // The barrier of quantum mechanics: T_s = 1/(1 + ((c² + κ²)/2cκ)² sinh² 2πdκ).
  const double n = 1 / 1.5, c = 0.5;
  const double kappa = std::sqrt(1 - c * c - n * n);
  for (const double gap : {0.1, 1.0, 5.0, 50.0}) {
    const Coated stack(Dielectric<double>(1), Film<double>(n, 0, gap));
    const double sinh = std::sinh(2 * pi<double>() * gap * kappa);
    const double mismatch = (c * c + kappa * kappa) / (2 * c * kappa);
    const double transmitted = 1 / (1 + mismatch * mismatch * sinh * sinh);
    CAPTURE(gap, transmitted);
    CHECK(stack.absorptances(c).s == Approx(transmitted).epsilon(1e-13));
  }
}

TEST_CASE("total reflection below a transparent film is total") {
  const Coated stack(Dielectric<double>(1 / 1.5), Film<double>(1.4, 0, 0.4));
  CHECK(stack.critical_cosine() == Dielectric<double>(1 / 1.5).critical_cosine());
  for (const double c : {0.0, 0.2, 0.5, 0.7}) {
    CHECK(stack.absorptance(c) == 0);
    CHECK(stack(c) == Approx(1).epsilon(2e-15));
  }
}

TEST_CASE("a thick metal film is the bare metal") {
  const Conductor<double> silver(0.1249, 3.3391);
  for (const double thickness : {2.0, 1e3, 1e6})
    for (const double c : cosines) {
      const Coated stack(Dielectric<double>(1.5), Film<double>(0.1249, 3.3391, thickness));
      CHECK(difference(stack.amplitudes(c), silver.amplitudes(c)) < 1e-15);
      // The flux within a metal is Re X out of |X|, 27 times as much.
      CHECK(stack.absorptance(c) == Approx(silver.absorptance(c)).epsilon(1e-13));
    }
}

TEST_CASE("what is not reflected is absorbed or refracted, and powers are the squared amplitudes") {
  std::mt19937_64 random(15);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Film<double>> films(random() % 6);
    for (Film<double>& film : films) film = random_film(random);
    const Coated stack(Conductor<double>(uniform(random, 0.1, 4), i % 2 ? uniform(random, 0, 4) : 0), films);
    const double c = uniform(random, 0, 1);
    const Amplitudes<double> r = stack.amplitudes(c);
    CAPTURE(i, films.size(), c);
    CHECK(stack(c) + stack.absorptance(c) == Approx(1).epsilon(4e-15));
    CHECK(norm(r.r_s) + norm(r.r_p) == Approx(2 * stack(c)).epsilon(4e-15));
    CHECK(norm(r.r_s) + stack.absorptances(c).s == Approx(1).epsilon(4e-15));
  }
}

TEST_CASE("the little that a good mirror with weakly absorbing films absorbs keeps its digits") {
  const double high = 2.4, low = 1.4;
  for (const double k : {1e-2, 1e-6, 1e-12}) {
    std::vector<Film<double>> films;
    std::vector<Layer<Digits50>> layers;
    for (int i = 0; i < 41; ++i) {
      const double n = i % 2 == 0 ? high : low, thickness = 0.25 / n;
      films.emplace_back(n, k, thickness);
      layers.push_back({{Digits50(n), Digits50(k)}, Digits50(thickness)});
    }
    const Coated mirror(Conductor<double>(0.2, 3.4), films);
    for (const double c : {1.0, 0.95}) {
      const TextbookStack<Digits50> exact(layers, {Digits50(0.2), Digits50(3.4)}, Digits50(c));
      const Absorptances<double> rest = mirror.absorptances(c);
      CAPTURE(k, c, rest.s, rest.p);
      CHECK(rest.s < 20 * k + 1e-9);
      CHECK(error_in_epsilons(rest.s, Digits50(1 - norm(exact.r_s))) < 300);
      CHECK(error_in_epsilons(rest.p, Digits50(1 - norm(exact.r_p))) < 300);
    }
  }
}

TEST_CASE("a mirror of many films transmits what the textbook says, in double as in float") {
  // Quarter waves H(LH)^N on glass at normal incidence: admittance n_H^{2N+2}/(n_L^{2N} n_s).
  const double high = 2.4, low = 1.4, glass = 1.5;
  const auto transmitted = [&]<class Real>(std::size_t pairs, Real) {
    std::vector<Film<Real>> films;
    for (std::size_t i = 0; i < 2 * pairs + 1; ++i) {
      const Real n = static_cast<Real>(i % 2 == 0 ? high : low);
      films.emplace_back(n, Real(0), Real(0.25) / n);
    }
    return Coated(Dielectric<Real>(static_cast<Real>(glass)), films).absorptance(Real(1));
  };
  for (const std::size_t pairs : {3u, 20u, 80u, 300u}) {
    const double log_admittance = static_cast<double>(2 * pairs + 2) * std::log(high) -
                                  static_cast<double>(2 * pairs) * std::log(low) - std::log(glass);
    const double exact = std::exp(std::log(4) - log_admittance - 2 * std::log1p(std::exp(-log_admittance)));
    CHECK(transmitted(pairs, 1.0) == Approx(exact).epsilon(1e-11));
    if (pairs <= 80) CHECK(transmitted(pairs, 1.0f) == Approx(exact).epsilon(1e-3));
    CHECK(std::isfinite(transmitted(pairs, 1.0f)));
  }
}

TEST_CASE("colours, packs of wavelengths and packs of directions give what single ones give") {
  using Four = Pack<double, 4>;
  const std::array<double, 4> n{1.4, 2.3, 0.2, 1.0}, k{0, 0.1, 3, 0}, d{0.1, 2.0, 0.03, 0.5};
  const std::array<double, 4> c{1.0, 0.6, 0.1, 0.0};
  constexpr double rounding = 2e-15;
  const Conductor<Four> metals{Four(n), Four(std::array<double, 4>{3, 0, 2, 1})};
  const Coated stacks(metals, Film<Four>(Four(n), Four(k), Four(d)),
                      Film<Four>(Four(1.5), Four(0.0), Four(0.2)));
  const Coated<Conductor<glm::dvec3>, 1> colours(
      Conductor<glm::dvec3>(glm::dvec3(0.2, 0.9, 1.2), glm::dvec3(3.9, 2.5, 2.3)),
      Film<glm::dvec3>::of_thickness_nm(glm::dvec3(1.5), glm::dvec3(0), 80.0, glm::dvec3(650, 550, 450)));
  for (std::size_t i = 0; i < 4; ++i) {
    const Coated stack(Conductor<double>(n[i], std::array<double, 4>{3, 0, 2, 1}[i]),
                       Film<double>(n[i], k[i], d[i]), Film<double>(1.5, 0, 0.2));
    for (const double cosine : cosines) {
      // Packs have sines and exponentials of their own.
      CHECK(std::abs(stacks(cosine)[i] - stack(cosine)) <= rounding);
      CHECK(stacks.absorptance(cosine)[i] == Approx(stack.absorptance(cosine)).epsilon(rounding));
      CHECK(std::abs(stacks.amplitudes(cosine).r_p.im[i] - stack.amplitudes(cosine).r_p.im) <= rounding);
    }
    const auto directions = stack.over_directions<4>();
    for (std::size_t j = 0; j < 4; ++j) CHECK(std::abs(directions(Four(c))[j] - stack(c[j])) <= rounding);
  }
  const Coated green(Conductor<double>(0.9, 2.5), Film<double>::of_thickness_nm(1.5, 0, 80, 550));
  CHECK(colours(0.4).y == green(0.4));
  CHECK(colours.absorptance(0.4).y == green.absorptance(0.4));
}

TEST_CASE("a coated groove keeps its energy in every model of polarisation") {
  const Cavity<double> groove(radians(50.0));
  const Coated anodised(Conductor<double>(2.54, 3.43), Film<double>::of_thickness_nm(2.4, 0, 60, 550));
  for (const double phi : {0.0, 40.0, 90.0}) {
    const auto e = direction(radians(35.0), radians(phi));
    CHECK(directional_reflectance(groove, e, anodised) + directional_absorptance(groove, e, anodised) ==
          Approx(1).epsilon(4e-15));
    const double with_fields = unpolarized(directional_reflectance(groove, e, polarized(anodised)));
    CHECK(with_fields + unpolarized(directional_absorptance(groove, e, polarized(anodised))) ==
          Approx(1).epsilon(4e-15));
    const double separate = unpolarized(directional_reflectance(groove, e, separately_polarized(anodised)));
    CHECK(separate >= directional_reflectance(groove, e, anodised));
    if (phi == 0) CHECK(with_fields == Approx(separate).epsilon(4e-15));
  }
}

TEST_CASE("the error estimate of the bi-hemispherical reflectance of coated grooves holds") {
  const Cavity<double> groove(radians(60.0));
  const Coated anodised(Conductor<double>(2.54, 3.43), Film<double>(2.4, 0, 0.12));
  const Coated mirror(Dielectric<double>(1.5), Film<double>(2.4, 0, 1.3), Film<double>(0.12, 3.4, 0.01));
  const Coated frustrated(Dielectric<double>(0.9), Film<double>(0.6, 0, 0.3));
  const auto check = [&](const auto& facet) {
    const double exact = bihemispherical_reflectance(groove, facet, 1e-13).value;
    for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
      const Integral<double> found = bihemispherical_reflectance(groove, facet, tolerance);
      CHECK(std::abs(found.value - exact) <= found.error + 1e-13);
      CHECK(found.error <= tolerance);
    }
  };
  check(anodised);
  check(mirror);
  check(frustrated);
}

TEST_CASE("films that are none are refused with their value") {
  const auto contains = [](const char* text) { return Catch::Matchers::ContainsSubstring(text); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Film<double>(1.4, 0, -0.1), contains("-0.1") && contains("thickness"));
  CHECK_THROWS_WITH(Film<double>(1.4, -2, 0.1), contains("-2") && contains("extinction"));
  CHECK_THROWS_WITH(Film<double>(1e5, 0, 0.1), contains("100000") && contains("0.0001"));
  CHECK_THROWS_AS(Film<double>(nan, 0, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(Film<double>(1.4, 0, nan), std::invalid_argument);
  CHECK_THROWS_WITH(Film<double>::of_thickness_nm(1.4, 0, -3, 550), contains("-3") && contains("nm"));
  CHECK_THROWS_WITH(Film<double>::of_thickness_nm(1.4, 0, 3, 0), contains("wavelength"));
  const std::vector<Film<double>> two(2, Film<double>(1.4, 0, 0.1));
  CHECK_THROWS_WITH((Coated<Dielectric<double>, 1>(Dielectric<double>(1.5), two)),
                    contains("room for, which is 1"));
  CHECK_THROWS_AS(Coated(Conductor<double>(1e6, 0), two), std::invalid_argument);
}
