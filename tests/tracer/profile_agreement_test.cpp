// SPDX-License-Identifier: BSD-3-Clause
#include "profile_agreement.hpp"

#include <iostream>

#include "ray_agreement.hpp"
#include "requested_rays.hpp"
#include "support/catch.hpp"

using namespace agreement;

namespace {

ProfileAgreement check(ShapeKind kind, double part, std::uint64_t seed) {
  constexpr std::int64_t rays_each = 2000;
  const auto shapes = static_cast<int>(part * static_cast<double>(number_of_rays()) / rays_each) + 1;
  const ProfileAgreement agreement =
      compare_profile_rays(closed_form_profile_ray, kind, shapes, rays_each, seed);
  INFO("first mismatch: " << agreement.first_mismatch);
  CHECK(agreement.mismatches == 0);
  CHECK(agreement.met_another_groove == 0);
  CHECK(static_cast<double>(agreement.inside_margin) <= 1 + 1e-6 * static_cast<double>(agreement.rays));
  std::cout << agreement.rays << " rays over " << shapes << " shapes: " << agreement.mismatches
            << " mismatches, " << agreement.inside_margin << " within " << edge_margin << " of an edge, "
            << agreement.met_another_groove << " met another groove, up to " << agreement.max_bounces
            << " bounces; largest error of a direction " << agreement.largest_direction_error
            << ", of a product " << agreement.largest_product_error << '\n';
  return agreement;
}

}  // namespace

TEST_CASE("every traced ray meets the faces of an asymmetric groove that the closed form says") {
  check(ShapeKind::asymmetric, 0.4, 20260101);
}

TEST_CASE("every traced ray meets the faces of a groove with a floor that the closed form says") {
  check(ShapeKind::floor, 0.4, 20260102);
}

TEST_CASE("every traced ray meets the faces of a trench that the closed form says") {
  check(ShapeKind::trench, 0.2, 20260103);
}

TEST_CASE("the check of profiles rejects every wrong theory") {
  CHECK(compare_profile_rays(plain_series_ray, ShapeKind::asymmetric, 20, 200, 3).holds());
  for (const auto& [error, kind, theory] : profile_mutants()) {
    INFO(error);
    CHECK(compare_profile_rays(closed_form_profile_ray, kind, 20, 200, 3).holds());
    CHECK_FALSE(compare_profile_rays(theory, kind, 20, 200, 3).holds());
  }
}
