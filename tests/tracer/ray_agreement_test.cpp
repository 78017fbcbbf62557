// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <iterator>

#include "support/catch.hpp"
#include "tracer/comparisons.hpp"
#include "tracer/requested_rays.hpp"

using namespace agreement;

namespace {

// Divisors of 180 degrees, where all rays of a direction may bounce equally often, and apertures between
// them.
constexpr double apertures_deg[] = {2, 3, 5, 10, 20, 30, 36, 37.3, 45, 53.7, 60, 72, 90, 100, 120, 150, 175};

}  // namespace

TEST_CASE("every traced ray takes the way that the closed form says") {
  const std::int64_t rays_each = number_of_rays() / std::ssize(apertures_deg) + 1;
  RayAgreement all;
  for (const double aperture_deg : apertures_deg) {
    const RayAgreement agreement = compare_rays(closed_form_ray, radians(aperture_deg), rays_each, 20240601);
    INFO("aperture " << aperture_deg << " deg; first mismatch: " << agreement.first_mismatch);
    CHECK(agreement.mismatches == 0);
    CHECK(agreement.met_another_groove == 0);
    CHECK(agreement.margin_is_narrow());
    all += agreement;
  }
  std::cout << all.rays << " rays: " << all.mismatches << " mismatches; " << all.inside_margin << " within "
            << edge_margin << " of an edge, " << all.mismatches_inside
            << " of them on another way; largest error of a direction " << all.largest_direction_error
            << ", of a product " << all.largest_product_error << '\n';
  CHECK(all.rays >= number_of_rays());
  CHECK(all.fraction_inside() < 1e-6);
}

TEST_CASE("rays that nearly meet an edge take the way that the closed form says") {
  for (const double aperture_deg : apertures_deg) {
    const RayAgreement agreement =
        compare_rays_beside_edges(closed_form_ray, radians(aperture_deg), 10000, 5);
    INFO("aperture " << aperture_deg << " deg; first mismatch: " << agreement.first_mismatch);
    CHECK(agreement.holds());
    CHECK(agreement.fraction_inside() < 1e-3);
  }
}
