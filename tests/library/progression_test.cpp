// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

TEST_CASE("the rule for sums is exact for polynomials") {
  // Those that are used: the orders so far take no more than half as many evaluations as there are terms.
  for (const int count : {128, 256, 1024, 8192}) {
    std::size_t evaluations = 0;
    for (const std::size_t order : detail::progression_orders) {
      evaluations += order;
      if (2 * evaluations > static_cast<std::size_t>(count)) break;
      const double middle = 0.5 * (count + 1);
      for (std::size_t degree = 0; degree < 2 * order; ++degree) {
        const auto power = [&](double index) { return std::pow((index - middle) / middle, double(degree)); };
        double exact = 0, sum = 0;
        for (int j = 1; j <= count; ++j) exact += power(j);
        for (std::size_t i = 0; i < order; ++i) {
          const auto [index, weight] = detail::progression_node<double>(count, order, i);
          sum += weight * power(index);
        }
        CAPTURE(count, order, degree);
        CHECK(std::abs(sum - exact) < 1e-13 * count);
      }
    }
  }
}

TEST_CASE("a sum that is not smooth is left to be done term by term") {
  const auto kink = [](double index) { return std::abs(index - 300.3); };
  CHECK_FALSE(progression_sum<double>(kink, 1, 10, 1e-12));
  const auto pole = [](double index) { return std::log(std::max(0.0, index - 300.0)); };
  CHECK_FALSE(progression_sum<double>(pole, 1, 10, 1e-12));
  CHECK(progression_sum<double>([](double index) { return 1 / (500 + index); }, 1, 10, 1e-12));
}

namespace {

/// Reflectance and number of Fresnel evaluations.
template <class Real>
struct Counted {
  Real reflectance;
  long evaluations;
};

template <class Real>
Counted<Real> many_at_once(const Cavity<Real>& cavity, const Vec3<Real>& e, const Conductor<Real>& facet) {
  long evaluations = 0;
  const auto counted = [&](const Real& cos_theta_i) { return ++evaluations, facet(cos_theta_i); };
  const Real reflectance = directional_reflectance(cavity, e, counted);
  return {reflectance, evaluations};
}

/// A facet that wants to know each bounce gets each bounce.
template <class Real>
Counted<Real> one_by_one(const Cavity<Real>& cavity, const Vec3<Real>& e, const Conductor<Real>& facet) {
  long evaluations = 0;
  const auto counted = [&](const Bounce<Real>& bounce) { return ++evaluations, facet(bounce.cosine); };
  const Real reflectance = directional_reflectance(cavity, e, counted);
  return {reflectance, evaluations};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("narrow grooves: many bounces at once give the same reflectance for less", "",
                        HardwareReals) {
  using Real = TestType;
  const Conductor<Real> metals[] = {{Real(0.1249), Real(3.3391)}, {Real(30), Real(90)}, {Real(1.5), Real(0)}};
  for (const double aperture_deg : {0.8, 0.3, 0.1, 0.01})
    for (int metal = 0; metal < 3; ++metal) {
      const Cavity<Real> cavity(radians(Real(aperture_deg)));
      long at_once = 0, apart = 0;
      for (int i = 0; i < 40; ++i) {
        const Vec3<Real> e = direction(Real(0.0392 * i), Real(0.21 * i));
        const Counted<Real> result = many_at_once(cavity, e, metals[metal]);
        const Counted<Real> expected = one_by_one(cavity, e, metals[metal]);
        CAPTURE(aperture_deg, metal, i);
        const Real bound = Real(16 + 8 * cavity.max_bounces()) * epsilon<Real>();
        CHECK(std::abs(result.reflectance - expected.reflectance) <=
              bound * expected.reflectance + 100 * std::numeric_limits<Real>::min());
        at_once += result.evaluations;
        apart += expected.evaluations;
      }
      CAPTURE(aperture_deg, metal, at_once, apart);
      if (metal == 0 && aperture_deg <= 0.1 && sizeof(Real) > 4) CHECK(5 * at_once < apart);
      CHECK(at_once < 3 * apart);  // where nothing is left of the light soon, or sums fail near grazing
    }
}

TEST_CASE("the narrowest grooves take no time, and their weights add up") {
  const double grey = 1 - 1e-9;
  for (const double aperture : {1e-5, 1e-7, 2e-9}) {
    const Cavity<double> cavity(aperture);
    for (const double theta : {0.0, 0.3, 1.2}) {
      long evaluations = 0;
      double sum = 0;
      for_each_lobe(
          cavity, direction(theta, 0.4), [&](double) { return ++evaluations, grey; },
          [&](const UnfoldedRay<double>& last, double weight, double throughput) {
            sum += weight;
            CHECK(throughput == Approx(std::exp(std::log(grey) * last.number())).epsilon(1e-9));
          });
      CAPTURE(aperture, theta);
      CHECK(std::abs(sum - 1) < 1e-15);
      CHECK(evaluations < 2000);
    }
  }
}

TEST_CASE("many bounces at once do not pass the bounce at which rays begin to leave") {
  // Around the apertures at which one block more would fit.
  for (int i = 0; i < 80; ++i) {
    const Cavity<double> cavity(pi<double>() / (250.07 + 0.15 * i));
    const Vec3<double> e = direction(0.0, 0.0);
    const auto at_once = lobes(cavity, e, [](double) { return 0.99; });
    const auto apart = lobes(cavity, e, [](const Bounce<double>&) { return 0.99; });
    CAPTURE(i);
    REQUIRE(at_once.size() == apart.size());
    for (std::size_t lobe = 0; lobe < apart.size(); ++lobe) {
      CHECK(at_once[lobe].bounces == apart[lobe].bounces);
      CHECK(std::abs(at_once[lobe].weight - apart[lobe].weight) < 1e-12);
      CHECK(at_once[lobe].throughput == Approx(apart[lobe].throughput).epsilon(1e-12));
    }
  }
}
