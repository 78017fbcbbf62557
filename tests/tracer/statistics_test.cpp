// SPDX-License-Identifier: BSD-3-Clause
#include "statistics.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using namespace agreement;

TEST_CASE("the confidence limit is the normal quantile, corrected for the number of cases") {
  // Two-sided, for a false-alarm rate of 1e-3: a rate of 1e-3 for one case, of 1e-6 for each of a thousand.
  CHECK(allowed_sigmas(1) == Catch::Approx(3.290527).epsilon(1e-5));
  CHECK(allowed_sigmas(1000) == Catch::Approx(4.891533).epsilon(1e-4));
}

TEST_CASE("a mean and its standard error come from the replicates") {
  ReplicatedMean mean;
  for (const double value : {1.0, 2.0, 6.0}) {
    mean.add(value - 1);
    mean.add(value + 1);
    mean.end_replicate();
  }
  CHECK(mean.mean() == Catch::Approx(3));
  // Sample variance 7, of three replicates.
  CHECK(mean.standard_error() == Catch::Approx(std::sqrt(7.0 / 3)));
}

TEST_CASE("shifted lattices fill the unit cube without bias and more evenly than chance") {
  constexpr int points = 1024;
  ReplicatedMean corner;
  for (int replicate = 0; replicate < replicates; ++replicate) {
    const ShiftedLattice lattice(1, replicate);
    for (int i = 0; i < points; ++i) {
      const auto [x, y, z] = lattice[i];
      corner.add(x < 0.5 && y < 0.5 && z < 0.5);
    }
    corner.end_replicate();
  }
  const double error_by_chance = std::sqrt(0.125 * 0.875 / points / replicates);
  CHECK(corner.standard_error() < error_by_chance / 2);
  CHECK(std::abs(corner.mean() - 0.125) < 4 * corner.standard_error());
}

TEST_CASE("a mean fails that is too many standard errors off, or too far off, or not a number") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(failures({{"3 sigma", 0.50003, 0.5, 1e-5}}).empty());
  CHECK(failures({{"4 sigma", 0.50004, 0.5, 1e-5}}).size() == 1);
  CHECK(failures({{"1 sigma of a poor estimate", 0.501, 0.5, 1e-3}}).size() == 1);
  CHECK(failures({{"no spread", 0.5, 0.5, 0}}).empty());
  CHECK(failures({{"no theory", nan, 0.5, 1e-5}}).size() == 1);
}
