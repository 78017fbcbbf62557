// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/colour_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/catch.hpp"

namespace vcavity::tools::testing {
namespace {

const std::vector<double> coarse{400, 420, 440, 460, 480, 500};

TEST_CASE("a grid stays as it is where the reflectance is smooth") {
  const auto smooth = [](double nm) {
    return std::pair(0.5 + 1e-3 * (nm - 400), 0.5 + 0.004 * std::sin(nm / 30));
  };
  CHECK(refined(coarse, smooth) == coarse);
}

TEST_CASE("a line of either reflectance between two wavelengths is not missed, and the rest stays as it is") {
  const auto line = [](double nm) { return std::max(0.0, 1 - std::abs(nm - 453) / 2); };
  for (const bool slanting : {false, true}) {
    const std::vector<double> grid = refined(
        coarse, [&](double nm) { return slanting ? std::pair(0.5, line(nm)) : std::pair(line(nm), 0.5); });
    CHECK(std::is_sorted(grid.begin(), grid.end()));
    for (const double nm : coarse) CHECK(std::binary_search(grid.begin(), grid.end(), nm));
    for (const double nm : {451.0, 453.0, 455.0}) CHECK(std::binary_search(grid.begin(), grid.end(), nm));
    CHECK(grid.size() == coarse.size() + 3);
  }
}

TEST_CASE("between the wavelengths of a refined grid straight lines show the reflectance") {
  const auto fringes = [](double nm) {
    return std::pair(0.5 + 0.4 * std::sin(40000 / nm), 0.5 + 0.4 * std::cos(30000 / nm));
  };
  const std::vector<double> grid = refined(coarse, fringes);
  CHECK(grid.size() > coarse.size());
  for (double nm = 400; nm <= 500; nm += 1) {
    const auto above = std::lower_bound(grid.begin(), grid.end(), nm);
    if (*above == nm) continue;
    const double share = (nm - *(above - 1)) / (*above - *(above - 1));
    const auto [low, low_slanting] = fringes(*(above - 1));
    const auto [high, high_slanting] = fringes(*above);
    CHECK(std::abs(fringes(nm).first - std::lerp(low, high, share)) < 0.0006);
    CHECK(std::abs(fringes(nm).second - std::lerp(low_slanting, high_slanting, share)) < 0.0006);
  }
}

TEST_CASE("nothing is asked for between wavelengths that nobody sees, nor within a nanometre") {
  const auto never = [](double) -> std::pair<double, double> {
    FAIL("the reflectance was asked for");
    return {};
  };
  CHECK(refined({1000, 1100, 1200}, never).size() == 3);
  CHECK(refined({500}, never).size() == 1);
  CHECK(refined({500, 500.5, 501}, never).size() == 3);
}

}  // namespace
}  // namespace vcavity::tools::testing
