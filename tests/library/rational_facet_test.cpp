// SPDX-License-Identifier: BSD-3-Clause
/// Fresnel's formula as a rational function: what the fit is worth, and that it says so.

#include <array>
#include <cmath>
#include <limits>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/facet/rational_facet.hpp>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

struct Index {
  double n, k;
};

/// The largest difference from Fresnel's formula over a fine grid, more of it at grazing incidence.
template <class Real>
double largest_difference(const Index& index) {
  const Conductor<double> exact(index.n, index.k);
  const RationalFacet<Real> fitted(exact);
  double largest = 0;
  for (int i = 0; i <= 20000; ++i) {
    const Real cosine = static_cast<Real>(std::pow(i / 20000.0, 3));
    largest = std::fmax(largest, std::fabs(double(fitted(cosine)) - exact(static_cast<double>(cosine))));
  }
  return largest;
}

// Silver, blue copper, blue gold, aluminium, chromium, tungsten, silicon.
const std::array<Index, 7> opaque{
    {{0.13, 3.1}, {1.19, 2.3}, {1.4, 1.9}, {1.1, 7.0}, {3.1, 3.3}, {3.5, 2.7}, {4.1, 0.04}}};

}  // namespace

TEST_CASE("metals as rational functions differ from Fresnel's formula by rounding, glasses by little more") {
  for (const Index& index : opaque) {
    CAPTURE(index.n, index.k);
    CHECK(largest_difference<float>(index) < 4e-7);
    CHECK(largest_difference<double>(index) < 1e-13);
  }
  // Copper in the green, whose better fits in float have a zero next to a pole.
  const Index copper{0.92, 2.45};
  CHECK(largest_difference<float>(copper) < 1e-6);
  CHECK(largest_difference<double>(copper) < 1e-13);
  for (const double n : {1.33, 1.5, 2.4}) {
    CAPTURE(n);
    CHECK(largest_difference<float>({n, 0}) < 3e-6);
    CHECK(largest_difference<double>({n, 0}) < 1e-11);
  }
}

TEST_CASE("the error that a fit reports is the one that it has, be it small or large") {
  for (const Index& index : {opaque[0], opaque[2], Index{1.5, 0}, Index{1.05, 0}, Index{0.7, 0.05}}) {
    CAPTURE(index.n, index.k);
    const RationalFacet<double> fitted(Conductor<double>(index.n, index.k));
    const double found = largest_difference<double>(index);
    CHECK(found <= 2 * fitted.error() + 1e-15);
    CHECK(fitted.error() <= 1.001 * found + 1e-15);  // the grids are not the same
  }
  // Total reflection has a kink, which no rational function follows.
  CHECK(RationalFacet<double>(Conductor<double>(0.7, 0)).error() > 1e-3);
}

namespace {

/// Silver that has no reflectance at one of the cosines at which fits are checked.
struct Undefined {
  Conductor<double> metal{0.14, 4.1};

  auto permittivity() const { return metal.permittivity(); }
  auto contrast() const { return metal.contrast(); }
  double operator()(const double& cosine) const {
    return cosine == 0.0625 ? std::numeric_limits<double>::quiet_NaN() : metal(cosine);
  }
};

}  // namespace

TEST_CASE("what is no number anywhere has no fit") {
  CHECK(RationalFacet<double>(Undefined().metal).error() < 1e-12);
  CHECK(RationalFacet<double>(Undefined()).error() == std::numeric_limits<double>::infinity());
}

TEST_CASE("every colour of a fit is the fit of that colour, in lanes too") {
  using Rgb = Pack<double, 3>;
  const Rgb n(std::array{opaque[0].n, opaque[1].n, opaque[2].n});
  const Rgb k(std::array{opaque[0].k, opaque[1].k, opaque[2].k});
  const RationalFacet<Rgb> fitted{Conductor<Rgb>(n, k)};
  for (const double cosine : {0.0, 1e-3, 0.4, 1.0}) {
    const Rgb reflectance = fitted(cosine);
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalFacet<double> single(Conductor<double>(n[i], k[i]));
      CHECK(reflectance[i] == Approx(single(cosine)).epsilon(1e-14));
      CHECK(fitted.over_directions<4>(i)(Pack<double, 4>(cosine))[3] ==
            Approx(reflectance[i]).epsilon(1e-14));
    }
  }
}

TEST_CASE("a dimmed fit reflects that part of every colour, in lanes too, with no larger error") {
  using Rgb = Pack<double, 3>;
  const RationalFacet<Rgb> fitted{Conductor<Rgb>(Rgb(opaque[0].n), Rgb(opaque[0].k))};
  const Rgb part(std::array{0.25, 1.0, 0.0});
  const RationalFacet<Rgb> dimmed = fitted.dimmed(part);
  for (const double cosine : {0.0, 1e-3, 0.4, 1.0}) {
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(dimmed(cosine)[i] == Approx(part[i] * fitted(cosine)[i]).epsilon(1e-14));
      CHECK(dimmed.over_directions<4>(i)(Pack<double, 4>(cosine))[1] ==
            Approx(dimmed(cosine)[i]).epsilon(1e-14));
    }
  }
  CHECK(dimmed.error() <= fitted.error());
}
