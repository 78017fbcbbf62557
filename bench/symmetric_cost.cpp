// SPDX-License-Identifier: BSD-3-Clause
/// What the symmetric groove of one bare material costs: a program that compiles with this version of the library and with
/// versions before it, to compare them.
///
///     mkdir before && git archive 58d3728 include | tar -x -C before
///     g++ -std=c++20 -O3 -fno-math-errno -I before/include bench/symmetric_cost.cpp -o before/cost
///     g++ -std=c++20 -O3 -fno-math-errno -I include bench/symmetric_cost.cpp -o cost
///     before/cost && ./cost

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <vcavity/vcavity.hpp>
#include <vector>

namespace {

using namespace vcavity;

/// Directions as pixels of a map show them, 32 neighbours at a time.
std::vector<Vec3<double>> map_directions() {
  constexpr int size = 1024;
  const double scale = std::numbers::sqrt2 / size;
  std::vector<Vec3<double>> result;
  for (int row = 64; row < size; row += 128)
    for (int column = size / 2; column < size; ++column)
      if (const auto e =
              direction_on_disc(Vec2<double>{scale * (2 * column + 1 - size), scale * (size - 1 - 2 * row)});
          e && column % 128 < 32)
        result.push_back(*e);
  return result;
}

/// Processor time of this program in nanoseconds.
double time_ns() {
  return 1e9 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Time for a direction: the shortest of many, for other programs can only make it longer.
template <class Facet>
double shortest_ns(const Cavity<double>& groove, const Facet& facet) {
  static const std::vector<Vec3<double>> directions = map_directions();
  constexpr int runs = 200, passes = 20;
  double shortest = 1e9, sum = 0;
  for (int run = 0; run < runs; ++run) {
    const double start = time_ns();
    for (int pass = 0; pass < passes; ++pass)
      for (const Vec3<double>& e : directions) sum += unpolarized(directional_reflectance(groove, e, facet));
    shortest = std::min(shortest, (time_ns() - start) / passes / static_cast<double>(directions.size()));
  }
  if (!(sum > 0)) std::puts("silver does not reflect?");
  return shortest;
}

}  // namespace

int main() {
  const Conductor<double> silver(0.1249, 3.3391);
  std::puts("| aperture | none, ns | separate, ns | full, ns |\n|---|---|---|---|");
  for (const double aperture_deg : {45.0, 90.0, 150.0}) {
    const Cavity<double> groove(radians(aperture_deg));
    std::printf("| %g° | %.1f | %.1f | %.1f |\n", aperture_deg, shortest_ns(groove, silver),
                shortest_ns(groove, separately_polarized(silver)), shortest_ns(groove, polarized(silver)));
  }
}
