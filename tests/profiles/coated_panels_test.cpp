// SPDX-License-Identifier: BSD-3-Clause
/// Panels of two materials under different films, in all models of polarisation: against waves that are reflected in
/// space, with amplitudes from characteristic matrices.

#include <cmath>
#include <complex>
#include <vcavity/facet/coated.hpp>
#include <vcavity/facet/panel_facets.hpp>
#include <vcavity/hemisphere/asymmetric_bihemispherical.hpp>
#include <vcavity/profiles/bihemispherical.hpp>
#include <vcavity/profiles/land.hpp>
#include <vcavity/profiles/truncated_groove.hpp>
#include <vector>

#include "accuracy/textbook_stack.hpp"
#include "profiles/random_profiles.hpp"
#include "support/catch.hpp"
#include "support/wave.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// A stack as the library and as the textbook take it.
struct Stack {
  Complex<double> substrate;
  std::vector<Layer<double>> films;

  Coated<Conductor<double>> facet() const {
    std::vector<Film<double>> result;
    for (const auto& film : films) result.emplace_back(film.n.re, film.n.im, film.thickness);
    return Coated(Conductor<double>(substrate.re, substrate.im), result);
  }

  Wave reflected(const Wave& wave, const Vec3<double>& normal) const {
    const double cosine = -glm::dot(wave.k, normal);
    const TextbookStack<long double> stack(wide(), {substrate.re, substrate.im}, cosine);
    // The textbook's r_p belongs to the axis p = k × s before and after; the library's is its opposite.
    const std::complex<double> r_s(static_cast<double>(stack.r_s.re), static_cast<double>(stack.r_s.im)),
        r_p(static_cast<double>(-stack.r_p.re), static_cast<double>(-stack.r_p.im));
    const Vec3<double> k = wave.k + 2 * cosine * normal;
    const Vec3<double> s = glm::normalize(glm::cross(wave.k, normal));
    return {k, along(s, r_s * dot(wave.field, s)) +
                   along(glm::cross(k, s), r_p * dot(wave.field, glm::cross(wave.k, s)))};
  }

 private:
  std::vector<Layer<long double>> wide() const {
    std::vector<Layer<long double>> result;
    for (const auto& film : films) result.push_back({{film.n.re, film.n.im}, film.thickness});
    return result;
  }
};

Stack random_stack(Dice& dice) {
  Stack stack{{dice.between(0.1, 4), dice.between(0, 1) < 0.3 ? 0 : dice.between(0.1, 5)}, {}};
  const int films = static_cast<int>(dice.between(0, 3));
  for (int i = 0; i < films; ++i)
    stack.films.push_back({{dice.between(1.2, 2.6), dice.between(0, 1) < 0.5 ? 0 : dice.between(0, 0.5)},
                           dice.between(0, 0.6)});
  return stack;
}

Vec3<double> normal_of(double slope_one, double slope_two, char face) {
  if (face == '1') return {0, std::sin(slope_one), std::cos(slope_one)};
  if (face == '2') return {0, -std::sin(slope_two), std::cos(slope_two)};
  return {0, 0, 1};
}

}  // namespace

TEST_CASE(
    "fields between two coated panels, vertical and overhanging ones too, are those of waves in space") {
  Dice dice(61);
  for (int trial = 0; trial < 600; ++trial) {
    const Stack one = random_stack(dice), two = random_stack(dice);
    const PanelFacets facets{one.facet(), two.facet()};
    const PanelFacets fields = polarized(facets);
    const double aperture = dice.between(12, 150), most = (180 - aperture) / 2;
    // Vertical, close to the limit, and any.
    const double tilt = trial % 3 == 0 && aperture < 89 ? aperture / 2
                        : trial % 3 == 1                ? most - dice.between(1, 3)
                                                        : dice.between(-most + 1, most - 1);
    const AsymmetricGroove<double> groove(radians(aperture), radians(tilt));
    const Vec3<double> e = dice.light(85);
    double sum = 0;
    for (const auto& lobe : lobes(groove, e, fields)) {
      const Vec3<double> a = polarization_axis(-e);
      Wave wave{-e, along(a, {0.3, 0.4}) + along(glm::cross(-e, a), {-0.7, 0.2})};
      const Stokes<double> light = stokes(wave);
      for (const char face : way_of(lobe.first_panel, lobe.bounces))
        wave = (face == '1' ? one : two)
                   .reflected(wave, normal_of(groove.slope(Panel::one), groove.slope(Panel::two), face));
      const Stokes<double> expected = stokes(wave), actual = power(lobe.throughput) * light;
      CAPTURE(aperture, tilt, lobe.bounces);
      for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(actual[i] - expected[i]) < 1e-12);
      for (glm::length_t i = 0; i < 3; ++i) CHECK(std::abs(wave.k[i] - lobe.direction[i]) < 1e-12);
      sum += lobe.weight * unpolarized(power(lobe.throughput));
    }
    CHECK(std::abs(sum - unpolarized(directional_reflectance(groove, e, fields))) < 1e-14);
  }
}

TEST_CASE("floors next to nothing and floors next to the opening are followed as well, every face coated") {
  Dice dice(62);
  for (int trial = 0; trial < 300; ++trial) {
    const Stack one = random_stack(dice), two = random_stack(dice), flat = random_stack(dice);
    const FaceFacets facets{one.facet(), two.facet(), flat.facet(), flat.facet()};
    const double slope_one = radians(dice.between(20, 88)), slope_two = radians(dice.between(20, 88));
    const double floor =
        trial % 2 == 0 ? std::pow(10, dice.between(-6, -3)) : std::pow(10, dice.between(1, 3));
    const Land profile(TruncatedGroove<double>(slope_one, slope_two, floor), 0.1);
    const Vec3<double> e = dice.light(80);
    const auto traced = IntervalTracing<long double>(groove_edges<long double>(slope_one, slope_two, floor))(
        Vec3<long double>(e));
    for (const auto& lobe : lobes(profile, e, polarized(facets))) {
      CAPTURE(lobe.path.text(), floor);
      if (!lobe.path.meets_land) {
        long double weight = 0;
        for (const auto& pencil : traced)
          if (pencil.way == lobe.path.text()) weight += pencil.weight;
        CHECK(std::abs(lobe.weight - 0.9 * static_cast<double>(weight)) < 1e-12);
      }
      const Vec3<double> a = polarization_axis(-e);
      Wave wave{-e, along(a, {0.3, 0.4}) + along(glm::cross(-e, a), {-0.7, 0.2})};
      const Stokes<double> light = stokes(wave);
      for (const char face : lobe.path.text())
        wave = (face == '1'   ? one
                : face == '2' ? two
                              : flat)
                   .reflected(wave, normal_of(slope_one, slope_two, face));
      const Stokes<double> expected = stokes(wave), actual = power(lobe.throughput) * light;
      for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(actual[i] - expected[i]) < 1e-12);
    }
  }
}

TEST_CASE("diffuse light between two coated panels is known to its error estimate") {
  Dice dice(63);
  for (int trial = 0; trial < 8; ++trial) {
    const PanelFacets fields = polarized(PanelFacets{random_stack(dice).facet(), random_stack(dice).facet()});
    const double aperture = dice.between(20, 140), most = (180 - aperture) / 2;
    const AsymmetricGroove<double> groove(radians(aperture), radians(dice.between(-most + 1, most - 1)));
    const auto coarse = bihemispherical_reflectance(groove, fields, 1e-8);
    const auto fine = bihemispherical_reflectance(groove, fields, 1e-13);
    CHECK(fine.error < 1e-12);
    CHECK(std::abs(coarse.value - fine.value) <= coarse.error);
  }
}
