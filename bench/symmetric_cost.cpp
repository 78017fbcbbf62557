// SPDX-License-Identifier: BSD-3-Clause
/// What the symmetric groove of one bare material costs: a program that compiles with this version of the library and with
/// versions before it, to compare them.
/// `scripts/compare_speed.py` does that. Each line that it prints is a quantity and its time in nanoseconds.

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

/// Time of one call: the median of several runs of some milliseconds.
template <class Call>
double median_ns(std::size_t calls, const Call& call) {
  constexpr std::size_t runs = 15;
  const double least_ns = 4e6;
  double times[runs];
  volatile double kept = 0;
  for (double& time : times) {
    const double start = time_ns();
    std::size_t passes = 0;
    double sum = 0, elapsed = 0;
    do {
      sum += call();
      ++passes;
      elapsed = time_ns() - start;
    } while (elapsed < least_ns);
    kept = kept + sum;
    time = elapsed / static_cast<double>(passes * calls);
  }
  std::nth_element(times, times + runs / 2, times + runs);
  return times[runs / 2];
}

template <class Facet>
void print_directional(const char* material, double aperture_deg, const char* model, const Facet& facet) {
  static const std::vector<Vec3<double>> directions = map_directions();
  const Cavity<double> groove(radians(aperture_deg));
  std::printf("directional, %s, %g°, %s\t%.4g\n", material, aperture_deg, model,
              median_ns(directions.size(), [&] {
                double sum = 0;
                for (const Vec3<double>& e : directions)
                  sum += unpolarized(directional_reflectance(groove, e, facet));
                return sum;
              }));
}

template <class Facet>
void print_hemispherical(const char* material, double aperture_deg, const char* model, const Facet& facet) {
  const Cavity<double> groove(radians(aperture_deg));
  std::printf("bi-hemispherical to 1e-10, %s, %g°, %s\t%.5g\n", material, aperture_deg, model,
              median_ns(1, [&] { return bihemispherical_reflectance(groove, facet, 1e-10).value; }));
}

template <class Facet>
void print_all(const char* material, const Facet& facet) {
  for (const double aperture_deg : {2.0, 45.0, 90.0, 150.0}) {
    print_directional(material, aperture_deg, "none", facet);
    print_directional(material, aperture_deg, "separate", separately_polarized(facet));
    print_directional(material, aperture_deg, "full", polarized(facet));
  }
  for (const double aperture_deg : {5.0, 45.0, 90.0, 150.0, 179.0}) {
    print_hemispherical(material, aperture_deg, "none", facet);
    print_hemispherical(material, aperture_deg, "full", polarized(facet));
  }
}

}  // namespace

int main() {
  print_all("silver", Conductor<double>(0.1249, 3.3391));
  print_all("glass", Dielectric<double>(1.5));
}
