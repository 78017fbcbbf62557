// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "support/catch.hpp"
#include "tracer/comparisons.hpp"

// Each test case would raise a false alarm with one seed in a thousand (agreement::false_alarm_rate); the
// seeds are fixed.

using namespace agreement;

namespace {

void check_all(const std::vector<MeanComparison>& comparisons) {
  REQUIRE_FALSE(comparisons.empty());
  const double allowed = allowed_sigmas(static_cast<int>(comparisons.size()));
  for (const MeanComparison& comparison : comparisons) {
    INFO(comparison.what << ": enough rays, so that chance alone does not exceed the tolerance");
    CHECK(allowed * comparison.standard_error <= mean_tolerance);
  }
  for (const MeanComparison& failed : failures(comparisons)) {
    FAIL_CHECK(failed.what << ": theory " << failed.theory << ", traced " << failed.traced << " +- "
                           << failed.standard_error << ", " << failed.sigmas() << " sigma apart, " << allowed
                           << " allowed");
  }
}

template <class Traced>
void append(std::vector<Traced>& all, const std::vector<Traced>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

TEST_CASE("the traced mean over the opening is the directional reflectance of the closed form") {
  std::vector<TracedDirection> traced;
  for (const double aperture_deg : {5.0, 20.0, 37.3, 45.0, 60.0, 90.0, 120.0, 150.0})
    append(traced, trace_directions(radians(aperture_deg), 65536, 100));
  check_all(compare(closed_form_directional, traced));
}

TEST_CASE(
    "traced diffuse light gives the bi-hemispherical reflectances of the paper's apertures and cut-offs") {
  const std::vector<Material> materials = tracer::example_materials();
  const Material& glass = materials[0];
  const Material& silver = materials[1];
  constexpr std::int64_t rays = 1 << 20;

  std::vector<TracedHemisphere> traced;
  // Table 1 of the paper.
  const std::vector<DiffuseQuantity> both{{glass}, {silver}};
  for (const double aperture_deg : {60.0, 90.0, 120.0, 150.0, 180.0})
    append(traced, trace_hemisphere(radians(aperture_deg), both, rays, 200));
  // Its row at 45 degrees, and Table 2: silver there, at most 1, 2, 3 or 4 bounces.
  const std::vector<DiffuseQuantity> cut_off{{glass},     {silver},    {silver, 1},
                                             {silver, 2}, {silver, 3}, {silver, 4}};
  append(traced, trace_hemisphere(radians(45), cut_off, rays, 200));
  check_all(compare(closed_form_hemispherical, traced));
}
