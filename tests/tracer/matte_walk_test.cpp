// SPDX-License-Identifier: BSD-3-Clause
/// Matte grooves in closed form against random walks in real geometry. Each test case would raise a false alarm with one
/// seed in a thousand (agreement::false_alarm_rate); the seeds are fixed.

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vcavity/matte/asymmetric_lambertian.hpp>
#include <vcavity/matte/lambertian_cavity.hpp>
#include <vector>

#include "support/catch.hpp"
#include "tracer/matte_walk.hpp"
#include "tracer/statistics.hpp"

using namespace agreement;
using vcavity::AsymmetricLambertianCavity;
using vcavity::Cavity;
using vcavity::LambertianCavity;
using vcavity::Vec3;

namespace {

constexpr double length_of_grooves = 2000;  // in panel widths; walks end long before

using Albedos = std::pair<double, double>;

/// Equal grooves, and where light enters the middle one.
struct Grooves {
  tracer::Relief relief;
  double left, right, top;  // the rims, and their height
};

Grooves symmetric(double aperture) {
  const double half = std::sin(aperture / 2);
  return {tracer::groove_array(aperture, 5, length_of_grooves), -half, half, std::cos(aperture / 2)};
}

/// Grooves of unit depth whose bisector is turned from z towards +y.
Grooves tilted(double aperture, double tilt) {
  const double left = std::tan(tilt - aperture / 2), right = std::tan(tilt + aperture / 2);
  return {tracer::profile_array({{left, 1}, {0, 0}, {right, 1}}, 9, length_of_grooves), left, right, 1};
}

/// Averages values of walks. `start(u, uniform)` gives the direction towards the light.
template <class Start, class Value>
std::vector<ReplicatedMean> average(const Grooves& grooves, int rays, std::uint64_t seed, std::size_t values,
                                    const Start& start, const Value& value) {
  const tracer::MatteWalker walker(grooves.relief);
  Uniform uniform(seed);
  std::vector<ReplicatedMean> means(values);
  for (int replicate = 0; replicate < replicates; ++replicate) {
    for (int ray = 0; ray < rays / replicates; ++ray) {
      const Vec3<double> e = start(uniform);
      const double across = grooves.left + uniform() * (grooves.right - grooves.left);
      const tracer::MatteWalk walk = walker.walk(glm::dvec3(0, across, grooves.top) + 1e-3 * e, -e, uniform);
      for (std::size_t i = 0; i < values; ++i) means[i].add(walk.escaped ? value(i, walk) : 0);
    }
    for (ReplicatedMean& mean : means) mean.end_replicate();
  }
  return means;
}

double remaining(const Albedos& albedos, const tracer::MatteWalk& walk) {
  return std::pow(albedos.first, walk.on_left) * std::pow(albedos.second, walk.on_right);
}

void check_all(const std::vector<MeanComparison>& comparisons, double largest_error) {
  REQUIRE_FALSE(comparisons.empty());
  const double allowed = allowed_sigmas(static_cast<int>(comparisons.size()));
  for (const MeanComparison& c : comparisons) {
    INFO(c.what << ": theory " << c.theory << ", walks " << c.traced << " +- " << c.standard_error);
    CHECK(c.standard_error < largest_error);
    // Where only a black panel is lit no walk brings anything back.
    CHECK(std::abs(c.difference()) <= allowed * c.standard_error + 1e-14);
  }
}

Vec3<double> diffuse(Uniform& uniform) {
  return vcavity::direction(std::asin(std::sqrt(uniform())), 2 * vcavity::pi<double>() * uniform());
}

const std::vector<Albedos> albedos{{0.2, 0.2}, {0.5, 0.5}, {0.9, 0.9}, {1, 1}, {0.9, 0.3}, {0.0, 0.8}};

}  // namespace

TEST_CASE("matte panels lit from one direction reflect what random walks bring back") {
  std::vector<MeanComparison> comparisons;
  for (const double aperture_deg : {20.0, 60.0, 120.0})
    for (const auto& [theta_deg, phi_deg] :
         {std::pair{0.0, 0.0}, {25.0, 20.0}, {70.0, 0.0}, {70.0, 180.0}, {80.0, 60.0}, {88.0, 5.0}}) {
      const double aperture = vcavity::radians(aperture_deg);
      const Vec3<double> e = vcavity::direction(vcavity::radians(theta_deg), vcavity::radians(phi_deg));
      const auto means = average(
          symmetric(aperture), 1 << 17, 7, albedos.size(), [&](Uniform&) { return e; },
          [](std::size_t i, const tracer::MatteWalk& walk) { return remaining(albedos[i], walk); });
      for (std::size_t i = 0; i < albedos.size(); ++i) {
        std::ostringstream what;
        what << "aperture " << aperture_deg << ", theta " << theta_deg << ", phi " << phi_deg << ", albedos "
             << albedos[i].first << ", " << albedos[i].second;
        const LambertianCavity<double> matte(Cavity<double>(aperture), albedos[i].first, albedos[i].second);
        // White panels return all light: nothing to be averaged.
        if (albedos[i] == Albedos{1, 1})
          CHECK(means[i].mean() == Approx(1).epsilon(1e-4));
        else
          comparisons.push_back(
              {what.str(), matte.directional_reflectance(e), means[i].mean(), means[i].standard_error()});
      }
    }
  check_all(comparisons, 2e-3);
}

TEST_CASE("matte panels in diffuse light reflect what random walks bring back") {
  std::vector<MeanComparison> comparisons;
  for (const double aperture_deg : {20.0, 45.0, 90.0, 150.0}) {
    const double aperture = vcavity::radians(aperture_deg);
    const auto means =
        average(symmetric(aperture), 1 << 18, 8, albedos.size(), diffuse,
                [](std::size_t i, const tracer::MatteWalk& walk) { return remaining(albedos[i], walk); });
    const vcavity::InterreflectionKernel<double> kernel{Cavity<double>(aperture)};
    for (std::size_t i = 0; i < albedos.size(); ++i) {
      if (albedos[i] == Albedos{1, 1}) continue;
      std::ostringstream what;
      what << "aperture " << aperture_deg << ", albedos " << albedos[i].first << ", " << albedos[i].second;
      comparisons.push_back(
          {what.str(), vcavity::bihemispherical_reflectance(kernel, albedos[i].first, albedos[i].second),
           means[i].mean(), means[i].standard_error()});
    }
  }
  check_all(comparisons, 1e-3);
}

TEST_CASE("the BRDF of matte panels sends light where random walks go") {
  // Angles across the groove between which the walks are counted.
  const std::array<double, 8> ends_deg{-90, -70, -50, -25, 0, 35, 65, 90};
  std::vector<MeanComparison> comparisons;
  for (const double aperture_deg : {30.0, 80.0})
    for (const double theta_deg : {10.0, 60.0, 80.0})
      for (const Albedos& pair : {Albedos{0.8, 0.8}, Albedos{0.9, 0.3}}) {
        const double aperture = vcavity::radians(aperture_deg);
        const Vec3<double> e = vcavity::direction(vcavity::radians(theta_deg), 0.4);
        const auto means = average(
            symmetric(aperture), 1 << 16, 9, ends_deg.size() - 1, [&](Uniform&) { return e; },
            [&](std::size_t i, const tracer::MatteWalk& walk) {
              const double out_deg = vcavity::degrees(std::atan2(walk.direction.y, walk.direction.z));
              return ends_deg[i] < out_deg && out_deg <= ends_deg[i + 1] ? remaining(pair, walk) : 0;
            });
        const LambertianCavity<double> matte(Cavity<double>(aperture), pair.first, pair.second);
        const auto rule = vcavity::gauss_legendre<double>(8);
        for (std::size_t i = 0; i + 1 < ends_deg.size(); ++i) {
          constexpr int pieces = 6;
          const double width = vcavity::radians(ends_deg[i + 1] - ends_deg[i]) / pieces;
          double expected = 0;
          for (int piece = 0; piece < pieces; ++piece)
            for (const auto& node : rule) {
              const double out = vcavity::radians(ends_deg[i]) + width * (piece + (1 + node.x) / 2);
              // ∫ cos²ψ dψ = π/2 over the angles along the groove
              expected += vcavity::pi<double>() / 2 * node.weight * width / 2 * std::cos(out) *
                          matte.brdf(e, {0, std::sin(out), std::cos(out)});
            }
          std::ostringstream what;
          what << "aperture " << aperture_deg << ", theta " << theta_deg << ", albedos " << pair.first << ", "
               << pair.second << ", into " << ends_deg[i] << " to " << ends_deg[i + 1];
          comparisons.push_back({what.str(), expected, means[i].mean(), means[i].standard_error()});
        }
      }
  check_all(comparisons, 2e-3);
}

TEST_CASE("matte panels of unequal slope reflect what random walks bring back") {
  std::vector<MeanComparison> comparisons;
  const std::vector<Albedos> pairs{{0.5, 0.5}, {0.9, 0.3}, {0.0, 0.8}};
  for (const auto& shape_deg : {std::pair{60.0, 20.0}, {60.0, 45.0}, {100.0, -25.0}, {25.0, 40.0}}) {
    const double aperture_deg = shape_deg.first, tilt_deg = shape_deg.second;
    const double aperture = vcavity::radians(aperture_deg), tilt = vcavity::radians(tilt_deg);
    const vcavity::AsymmetricGroove<double> groove(aperture, tilt);
    const auto remains = [&](std::size_t i, const tracer::MatteWalk& walk) {
      return remaining(pairs[i], walk);
    };
    const auto compare = [&](const std::string& light, const auto& theory,
                             const std::vector<ReplicatedMean>& means) {
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        std::ostringstream what;
        what << "aperture " << aperture_deg << ", tilt " << tilt_deg << ", " << light << ", albedos "
             << pairs[i].first << ", " << pairs[i].second;
        const AsymmetricLambertianCavity<double> matte(groove, pairs[i].first, pairs[i].second);
        comparisons.push_back({what.str(), theory(matte), means[i].mean(), means[i].standard_error()});
      }
    };
    compare(
        "diffuse", [](const auto& matte) { return matte.bihemispherical_reflectance(); },
        average(tilted(aperture, tilt), 1 << 17, 10, pairs.size(), diffuse, remains));
    for (const auto& [theta_deg, phi_deg] :
         {std::pair{10.0, 30.0}, {60.0, 0.0}, {60.0, 180.0}, {82.0, 200.0}}) {
      const Vec3<double> e = vcavity::direction(vcavity::radians(theta_deg), vcavity::radians(phi_deg));
      std::ostringstream light;
      light << "theta " << theta_deg << ", phi " << phi_deg;
      compare(
          light.str(), [&](const auto& matte) { return matte.directional_reflectance(e); },
          average(tilted(aperture, tilt), 1 << 16, 11, pairs.size(), [&](Uniform&) { return e; }, remains));
    }
  }
  check_all(comparisons, 3e-3);
}
