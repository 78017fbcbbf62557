// SPDX-License-Identifier: BSD-3-Clause
#include "mutants.hpp"

#include "support/catch.hpp"
#include "tracer/comparisons.hpp"

// A check that lets a wrong theory pass is no check: each of them is shown theories with one error.

using namespace agreement;

TEST_CASE("the check of single rays rejects every wrong theory") {
  constexpr std::int64_t rays = 2000;
  for (const double aperture_deg : {20.0, 45.0, 100.0}) {
    INFO("aperture " << aperture_deg << " deg");
    CHECK(compare_rays(closed_form_ray, radians(aperture_deg), rays, 1).holds());
    for (const auto& [error, theory] : ray_mutants()) {
      INFO(error);
      CHECK_FALSE(compare_rays(theory, radians(aperture_deg), rays, 1).holds());
    }
  }
}

TEST_CASE("the check of directional reflectances rejects every wrong theory") {
  const auto traced = trace_directions(radians(45), 65536, 2);
  CHECK(failures(compare(closed_form_directional, traced)).empty());
  for (const auto& [error, theory] : directional_mutants()) {
    INFO(error);
    CHECK_FALSE(failures(compare(theory, traced)).empty());
  }
}

TEST_CASE("the check of diffuse light rejects every wrong theory") {
  std::vector<DiffuseQuantity> quantities;
  for (const Material& material : tracer::example_materials()) {
    quantities.push_back({material});
    quantities.push_back({material, 2});
  }
  const auto traced = trace_hemisphere(radians(60), quantities, 1 << 20, 3);
  CHECK(failures(compare(closed_form_hemispherical, traced)).empty());
  for (const auto& [error, theory] : hemispherical_mutants()) {
    INFO(error);
    // Not one lucky material: each of them shows the error.
    CHECK(failures(compare(theory, traced)).size() == traced.size());
  }
}
