// SPDX-License-Identifier: BSD-3-Clause
/// Energy: where all light goes that falls on a rough surface, and that none is lost or made.

#include <algorithm>
#include <cmath>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/rough_albedo.hpp>
#include <vcavity/rough/rough_bsdf.hpp>
#include <vector>

#include "support/catch.hpp"

using namespace vcavity;

namespace {

const auto white = [](double) { return 1.0; };

/// ∫ BRDF × cosine over the directions to which the grooves of one azimuth lead: dω_o = |h| dψ dθ_o'.
/// @param bounces of light of so many only, or `all_bounces` up to the limit
template <class Bsdf>
double integral_over_exits(const Bsdf& bsdf, const Vec3<double>& e, double azimuth, int bounces) {
  const Vec2<double> y{std::cos(azimuth), std::sin(azimuth)};
  const double along = e.x * y.y - e.y * y.x;
  const double across = e.x * y.x + e.y * y.y;
  const double cos_eta = std::hypot(across, e.z);
  const auto integrand = [&](double theta) {
    const double to_y = cos_eta * std::sin(theta);
    const Vec3<double> o{-along * y.y + to_y * y.x, along * y.x + to_y * y.y, cos_eta * std::cos(theta)};
    const double tilt = std::abs(across + to_y);
    if (!(tilt > 0)) return detail::Quadrature<double>{0, 0, 1};
    const double value = bounces == all_bounces ? bsdf.evaluate(e, o) : bsdf.evaluate_bounces(e, o, bounces);
    return detail::Quadrature<double>{value * tilt, 0, 1};
  };
  // Cut at the mirror direction, at the cone θ_o' = θ_e' and more and more densely towards the horizon, where the
  // terms change within a few times the elevation of the light; the integrator finds the other kinks.
  const double turn = std::abs(std::atan2(across, e.z)), end = pi<double>() / 2;
  std::vector<double> cuts{-end, end, 0};
  for (double below = (end - turn) / 8; below < end; below *= 2) {
    cuts.push_back(end - below);
    cuts.push_back(below - end);
  }
  std::sort(cuts.begin(), cuts.end());
  double sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    sum += detail::integrate<double>(integrand, cuts[i - 1], cuts[i], 1e-13, 40).value;
  return sum;
}

/// The share of the azimuths [ψ, ψ + dψ) of a distribution per dψ, and where its random number lies.
struct Azimuth {
  double angle, density, u;
};

template <class Distribution>
void check_energies(const Distribution& distribution, const std::vector<Azimuth>& azimuths) {
  const RoughGrooveBsdf bsdf(distribution, white);
  for (const double theta : {0.0, 60.0, 89.9})
    for (const Azimuth& azimuth : azimuths) {
      CAPTURE(theta, azimuth.angle);
      const Vec3<double> e = direction(radians(theta), 0.0);
      double below = 0;
      for (int bounces = 1; bounces <= 4; ++bounces) {
        CAPTURE(bounces);
        const double up_to =
            detail::reflectance_of_azimuth(distribution, azimuth.u, e, white, 1e-13, bounces).value;
        const double found = integral_over_exits(bsdf, e, azimuth.angle, bounces) / azimuth.density;
        CHECK(std::abs(found - (up_to - below)) < 1e-10);
        below = up_to;
      }
    }
}

}  // namespace

TEST_CASE(
    "for every azimuth the BRDF carries the light that lobes of single grooves carry, bounce by bounce") {
  // Azimuths of isotropic distributions are uniform, 2πu.
  std::vector<Azimuth> uniform;
  for (const double u : {0.05, 0.2}) uniform.push_back({2 * pi<double>() * u, 1 / pi<double>(), u});
  for (const double roughness : {0.1, 1.0}) {
    CAPTURE(roughness);
    check_energies(GgxSlopes<double>(roughness), uniform);
    check_energies(BeckmannSlopes<double>(roughness), uniform);
  }
}

TEST_CASE("the same in brushed metal") {
  const AxialVonMises<double> brush(8.0);
  std::vector<Azimuth> azimuths;
  for (const double u : {0.3}) {
    const double angle = brush.quantile(u);
    const double sine = std::sin(angle);
    azimuths.push_back({pi<double>() / 2 - angle, brush.relative_density(sine * sine) / pi<double>(), u});
  }
  check_energies(BrushedSlopes(BeckmannSlopes<double>(0.5), 8.0), azimuths);
}

TEST_CASE("white facets reflect everything") {
  for (const double roughness : {0.1, 0.3, 0.6, 1.0})
    for (const double theta : {0.0, 30.0, 60.0, 85.0, 89.9}) {
      CAPTURE(roughness, theta);
      const auto albedo = [&](const auto& distribution) {
        return directional_albedo(distribution, direction(radians(theta), 0.3), white, 1e-10).value;
      };
      CHECK(std::abs(1 - albedo(GgxSlopes<double>(roughness))) < 1e-10);
      CHECK(std::abs(1 - albedo(BeckmannSlopes<double>(roughness, 0.5))) < 1e-10);
    }
}

TEST_CASE(
    "the BRDF of white facets and what lobes of single grooves send beyond its limit are all of the light") {
  // By quadrature of the BRDF over all directions to which the grooves of an azimuth lead.
  for (const double roughness : {0.1, 0.3, 0.6, 1.0})
    for (const double theta : {0.0, 45.0, 85.0, 89.9}) {
      CAPTURE(roughness, theta);
      const Vec3<double> e = direction(radians(theta), 0.0);
      const double u = 0.11;
      const auto check = [&](const auto& distribution, int limit) {
        const double within = integral_over_exits(RoughGrooveBsdf(distribution, white, limit), e,
                                                  2 * pi<double>() * u, all_bounces) *
                              pi<double>();
        const double up_to = detail::reflectance_of_azimuth(distribution, u, e, white, 1e-13, limit).value;
        CHECK(std::abs(1 - (within + (1 - up_to))) < 1e-10);
        // Most of it is in the BRDF.
        CHECK(1 - up_to < 0.05);
      };
      check(GgxSlopes<double>(roughness), 8);
      check(BeckmannSlopes<double>(roughness), 8);
    }
}

TEST_CASE("GGX at normal incidence reflects a known part of the light after one bounce") {
  const auto single = [](double roughness) {
    return directional_albedo(GgxSlopes<double>(roughness), {0, 0, 1}, white, 1e-12, 1).value;
  };
  for (const double roughness : {0.1, 0.3, 0.6, 2.0}) {
    const double a2 = roughness * roughness, b = 1 - a2;
    const double expected = 1 + a2 / b - 4 * a2 / (b * b) * std::log(2 * (1 + a2) / (1 + 3 * a2));
    CHECK(single(roughness) == Approx(expected).epsilon(1e-10));
  }
  CHECK(single(1) == Approx(0.375).epsilon(1e-12));
}

TEST_CASE("energies by the number of bounces are those found by quadrature of the BRDF") {
  // Energies after one to four bounces, to four digits.
  struct Row {
    double roughness, theta;
    std::vector<double> ggx, beckmann;
  };
  for (const Row& row : {Row{0.6, 85, {0.9611, 0.0308, 0.0042, 0.0016}, {0.9775, 0.0224, 0.0001}},
                         Row{1.0, 0, {0.3750, 0.3296, 0.1290, 0.0606}, {0.4535, 0.4526, 0.0869}}}) {
    CAPTURE(row.roughness, row.theta);
    const auto check = [&](const auto& distribution, const std::vector<double>& energies) {
      double below = 0;
      for (std::size_t j = 0; j < energies.size(); ++j) {
        const double up_to = directional_albedo(distribution, direction(radians(row.theta), 0.0), white, 5e-5,
                                                static_cast<int>(j) + 1)
                                 .value;
        CHECK(std::abs(up_to - below - energies[j]) < 1.2e-4);
        below = up_to;
      }
    };
    check(GgxSlopes<double>(row.roughness), row.ggx);
    check(BeckmannSlopes<double>(row.roughness), row.beckmann);
  }
}
