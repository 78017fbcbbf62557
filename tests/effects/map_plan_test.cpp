// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/map_plan.hpp"

#include <cmath>
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "tools/colour/colour_difference.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/support/error.hpp"

using namespace vcavity;
using namespace vcavity::tools;

namespace {

MapRequest request_for(const char* material, double aperture_deg) {
  std::vector<double> wavelengths_nm;
  for (int nm = 400; nm <= 700; nm += 5) wavelengths_nm.push_back(nm);
  return {{load_material(material), aperture_deg}, wavelengths_nm, 64, all_bounces};
}

}  // namespace

TEST_CASE("a planned colour map keeps its colour difference in directions it was not planned for") {
  std::mt19937_64 random(401);
  std::uniform_real_distribution<double> unit(0, 1);
  int thinned = 0;
  for (const char* material : {"Cu", "Au", "Ag", "Ti", "Si"})
    for (const double aperture_deg : {20.0, 45.0, 75.0, 110.0, 150.0}) {
      MapRequest full = request_for(material, aperture_deg);
      full.polarization = Polarization::full;
      const DiscMapper expected(full);
      for (const double tolerance : {0.1, 1.0, 5.0}) {
        const MapPlan plan = plan_map(request_for(material, aperture_deg), tolerance);
        CAPTURE(material, aperture_deg, tolerance, plan.explanation);
        CHECK(plan.bound <= tolerance);
        const DiscMapper planned(plan.request);
        double worst = 0;
        for (int i = 0; i < 1000; ++i) {
          const Vec3<double> e = direction(std::acos(unit(random)), 2 * pi<double>() * unit(random));
          worst = std::max(worst, delta_e_2000(to_lab(planned.colour(e), expected.white()),
                                               to_lab(expected.colour(e), expected.white())));
        }
        CHECK(worst <= plan.bound + 1e-9);
        thinned += plan.request.wavelengths_nm.size() < full.wavelengths_nm.size();
      }
    }
  CHECK(thinned > 40);
}

TEST_CASE("a looser tolerance takes no more wavelengths, and names what it leaves out") {
  std::size_t wavelengths = 1000;
  for (const double tolerance : {0.01, 0.1, 1.0, 10.0}) {
    const MapPlan plan = plan_map(request_for("Cu", 45), tolerance);
    CHECK(plan.request.wavelengths_nm.size() <= wavelengths);
    CHECK(plan.explanation.find("polarisation") != std::string::npos);
    wavelengths = plan.request.wavelengths_nm.size();
  }
  CHECK(wavelengths < 61);
}

TEST_CASE("a plan for one wavelength is that of the library") {
  MapRequest request = request_for("Ag", 60);
  request.wavelengths_nm = {550};
  const MapPlan plan = plan_map(request, 0.1);
  CHECK(plan.request.polarization == Polarization::none);
  CHECK(plan.request.precision == Precision::single_precision);
  CHECK(plan.bound < 0.1);
}

TEST_CASE("there is no plan for infrared colours") {
  MapRequest request = request_for("Au", 60);
  request.wavelengths_nm = {900, 950, 1000};
  CHECK_THROWS_AS(plan_map(request, 1), UsageError);
}

TEST_CASE("a tolerance alone chooses float where its rounding is within it, and nothing else") {
  std::mt19937_64 random(409);
  std::uniform_real_distribution<double> unit(0, 1);
  int in_float = 0;
  for (const char* material : {"Cu", "Ag", "1.5", "1.1", "Si"})
    for (const Quantity quantity : {Quantity::reflectance, Quantity::absorptance})
      for (const double tolerance : {1e-4, 1e-5, 1e-6}) {
        MapRequest request = request_for(material, 10 + 170 * unit(random));
        request.wavelengths_nm = {450, 550, 650};
        request.size = 24;
        request.quantity = quantity;
        request.polarization = unit(random) < 0.5 ? Polarization::none : Polarization::full;
        const MapPlan plan = plan_precision(request, tolerance, ExrNumber::float32);
        CAPTURE(material, request.surface.aperture_deg, tolerance, plan.explanation);
        CHECK(plan.bound <= tolerance);
        CHECK(plan.request.polarization == request.polarization);
        CHECK(plan.request.max_bounces == all_bounces);
        CHECK(plan.request.wavelengths_nm == request.wavelengths_nm);
        const auto expected = DiscMapper(request).rows(0, request.size);
        const auto planned = DiscMapper(plan.request).rows(0, request.size);
        REQUIRE(planned.size() == expected.size());
        double worst = 0;
        for (std::size_t channel = planned.size() - 3; channel < planned.size(); ++channel)
          for (std::size_t i = 0; i < planned[channel].size(); ++i)
            worst = std::max(worst, std::abs(static_cast<double>(planned[channel][i]) -
                                             static_cast<double>(expected[channel][i])));
        CHECK(worst <= plan.bound);
        in_float += plan.request.precision == Precision::single_precision;
      }
  CHECK(in_float > 5);
  CHECK(in_float < 25);
}

TEST_CASE("a tolerance below what storage rounds away is refused, and one for a ratio") {
  MapRequest request = request_for("Ag", 60);
  CHECK_THROWS_AS(plan_precision(request, 1e-9, ExrNumber::float32), UsageError);
  CHECK_THROWS_AS(plan_precision(request, 1e-4, ExrNumber::float16), UsageError);
  CHECK(plan_precision(request, 1e-3, ExrNumber::float16).bound > 2e-4);
  request.quantity = Quantity::degree_of_polarization;
  request.polarization = Polarization::full;
  CHECK_THROWS_AS(plan_precision(request, 1e-3, ExrNumber::float32), UsageError);
}

TEST_CASE("a tolerance alone chooses float under films too, but not for absorptances") {
  std::mt19937_64 random(419);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const char* material : {"Ti", "Si", "1.5"})
    for (const double tolerance : {1e-3, 1e-7}) {
      MapRequest request = request_for(material, 20 + 160 * unit(random));
      request.surface.films = {{load_material("SiO2-Malitson"), 300 * unit(random)},
                               {load_material("TiO2-Siefke"), 200 * unit(random)}};
      request.wavelengths_nm = {450, 550, 650};
      request.size = 24;
      const MapPlan plan = plan_precision(request, tolerance, ExrNumber::float32);
      CAPTURE(material, request.surface.aperture_deg, tolerance, plan.explanation);
      CHECK(plan.request.precision ==
            (tolerance > 1e-4 ? Precision::single_precision : Precision::double_precision));
      const auto expected = DiscMapper(request).rows(0, request.size);
      const auto planned = DiscMapper(plan.request).rows(0, request.size);
      for (std::size_t channel = planned.size() - 3; channel < planned.size(); ++channel)
        for (std::size_t i = 0; i < planned[channel].size(); ++i)
          CHECK(std::abs(static_cast<double>(planned[channel][i]) -
                         static_cast<double>(expected[channel][i])) <= plan.bound);
      request.quantity = Quantity::absorptance;
      CHECK_THROWS_AS(plan_precision(request, tolerance, ExrNumber::float32), UsageError);
    }
}

TEST_CASE("a map of a groove under films is its own mirror image, and that of single directions") {
  MapRequest request = request_for("Ti", 45);
  request.surface.films = {{load_material("TiO2-Siefke"), 60}};
  request.wavelengths_nm = {550};
  request.polarization = Polarization::full;
  request.size = 16;
  const DiscMapper mapper(request);
  const auto planes = mapper.rows(0, request.size);
  const auto surface = make_surface(request.surface, 550, {Polarization::full, all_bounces});
  for (int row = 0; row < request.size; ++row)
    for (int column = 0; column < request.size; ++column) {
      const auto e = pixel_direction(column, row, request.size);
      const std::size_t pixel = static_cast<std::size_t>(row * request.size + column);
      const double expected = e ? surface->reflectance(*e).unpolarized : 0;
      CHECK(std::abs(static_cast<double>(planes[0][pixel]) - expected) < 1e-7);
    }
}
