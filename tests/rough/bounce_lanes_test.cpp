// SPDX-License-Identifier: BSD-3-Clause
/// Ways followed side by side against the same ways followed one bounce after the other.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/facet/rational_facet.hpp>
#include <vcavity/polarization/full.hpp>
#include <vcavity/polarization/mueller.hpp>
#include <vcavity/rough/elliptic_slopes.hpp>
#include <vcavity/rough/rough_bsdf.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

/// Compares a facet with itself as a function, which nobody can ask for several directions at once.
template <class Real, class Distribution, class Facet>
void check(const Distribution& distribution, const Facet& facet, double tolerance) {
  const auto one_by_one = [&facet](const Real& cosine) { return facet(cosine); };
  std::mt19937 random(20261126);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto any = [&] {
    return Vec3<Real>(direction(std::acos(unit(random)), 2 * pi<double>() * unit(random)));
  };
  for (const int limit : {1, 2, 3, 4, 5, 8, 9, 32}) {
    const RoughGrooveBsdf lanes(distribution, facet, limit);
    const RoughGrooveBsdf single(distribution, one_by_one, limit);
    for (int trial = 0; trial < 300; ++trial) {
      const Vec3<Real> e = any();
      Vec3<Real> o = any();
      // Every other one near the cone of equal heights, where there are ways of any number of bounces.
      if (trial % 2 == 0) {
        const Real along = std::sqrt((1 - e.z * e.z) / (o.x * o.x + o.y * o.y));
        o = {o.x * along, o.y * along, e.z};
      }
      const auto [value, pdf] = lanes.evaluate_with_pdf(e, o);
      const auto expected = single.evaluate_with_pdf(e, o);
      CAPTURE(limit, e.x, e.y, e.z, o.x, o.y, o.z);
      CHECK(static_cast<double>(pdf) == Approx(static_cast<double>(expected.pdf)).epsilon(tolerance));
      CHECK(largest(value + Real(-1) * expected.value) <= tolerance * largest(expected.value));
    }
  }
}

/// A mirror that cannot be asked beyond grazing incidence.
struct OneSided {
  template <class Cosine>
  Cosine operator()(const Cosine& cosine) const {
    if constexpr (Number<Cosine>) {
      return cosine < Cosine(0) ? std::numeric_limits<Cosine>::infinity() : Cosine(1);
    } else {
      const Cosine infinite(std::numeric_limits<scalar_t<Cosine>>::infinity());
      return select(cosine < scalar_t<Cosine>(0), infinite, Cosine(scalar_t<Cosine>(1)));
    }
  }
  template <std::size_t directions>
  OneSided over_directions(std::size_t) const {
    return {};
  }
};

}  // namespace

TEST_CASE("facets are not asked beyond grazing incidence for ways that do not exist") {
  const RoughGrooveBsdf bsdf(GgxSlopes<float>(1.0f), OneSided(), 32);
  std::mt19937 random(20261127);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto any = [&] {
    return Vec3<float>(direction(std::acos(unit(random)), 2 * pi<double>() * unit(random)));
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const auto [value, pdf] = bsdf.evaluate_with_pdf(any(), any());
    REQUIRE(value == Approx(pdf).epsilon(1e-5));
  }
}

TEST_CASE(
    "next to the mirror direction, where rounding turns the grooves, no facet reflects more than all light") {
  using Rgb = Pack<float, 3>;
  const Conductor<Rgb> metal(Rgb(std::array{0.16f, 0.12f, 0.14f}), Rgb(std::array{4.8f, 3.1f, 2.2f}));
  const RoughGrooveBsdf fitted(GgxSlopes<float>(0.1f), RationalFacet<Rgb>(metal), 32);
  const RoughGrooveBsdf exact(GgxSlopes<float>(0.1f), metal, 32);
  const RoughGrooveBsdf polarised(GgxSlopes<float>(0.1f), polarized(Conductor<float>(0.14f, 2.2f)), 32);
  std::mt19937 random(20261127);
  std::uniform_real_distribution<float> unit(0, 1);
  const auto moved = [&](float x) { return x * (1 + 2e-7f * (2 * unit(random) - 1)); };
  for (int trial = 0; trial < 5000; ++trial) {
    const float height = trial % 2 == 0 ? unit(random) : 1e-3f * unit(random);
    const Vec3<float> e = direction(std::acos(height), 2 * pi<float>() * unit(random));
    const Vec3<float> o{moved(-e.x), moved(-e.y), trial % 3 == 0 ? 0.8f * e.z : moved(e.z)};
    CAPTURE(e.x, e.y, e.z, o.x, o.y, o.z);
    const auto check = [](float light, float white) { REQUIRE(light <= white * (1 + 1e-6f)); };
    const auto of_fit = fitted.evaluate_with_pdf(e, o);
    check(largest(of_fit.value), of_fit.pdf);
    const auto of_facet = exact.evaluate_with_pdf(e, o);
    check(largest(of_facet.value), of_facet.pdf);
    const auto of_fields = polarised.evaluate_with_pdf(e, o);
    check(unpolarized(of_fields.value), of_fields.pdf);
  }
}

TEST_CASE("ways followed side by side reflect what they do one bounce after the other") {
  using Rgb = Pack<float, 3>;
  const Conductor<Rgb> metal(Rgb(std::array{0.2f, 0.9f, 1.2f}), Rgb(std::array{3.4f, 2.6f, 2.3f}));
  check<float>(GgxSlopes<float>(0.4f), metal, 1e-5);
  check<float>(BeckmannSlopes<float>(0.8f), RationalFacet<Rgb>(metal), 1e-5);
  check<float>(GgxSlopes<float>(0.4f), Conductor<float>(0.2f, 3.4f), 1e-5);
  check<float>(GgxSlopes<float>(0.4f), Conductor<Pack<float, 5>>(Pack<float, 5>(0.3f), Pack<float, 5>(3.0f)),
               1e-5);
  check<double>(GgxSlopes<double>(0.4), Conductor<double>(0.2, 3.4), 1e-13);
}
