// SPDX-License-Identifier: BSD-3-Clause

/// What matte grooves cost: prints a Markdown table of the time of the first wavelength, of each further one, and of how
/// many logarithms take as long; the fastest of several runs.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <vcavity/matte/lambertian_cavity.hpp>
#include <vector>

using namespace vcavity;

namespace {

/// Nanoseconds per call with an element of `arguments`. The results are added up and kept, so that no call can be left
/// out.
template <class Call>
double nanoseconds(const std::vector<double>& arguments, const Call& call) {
  static volatile double kept;
  double best = std::numeric_limits<double>::max();
  for (int run = 0; run < 40; ++run) {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0;
    for (const double argument : arguments) sum += call(argument);
    kept = sum;
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / static_cast<double>(arguments.size()));
  }
  static_cast<void>(kept);
  return best;
}

}  // namespace

int main() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> albedos(2000);
  for (double& albedo : albedos) albedo = unit(random);
  const double logarithm = nanoseconds(albedos, [](double x) { return std::log(x); });
  std::printf("| aperture | nodes | first wavelength (µs) | each further one (ns) | in logarithms |\n");
  std::printf("|----------|-------|-----------------------|-----------------------|---------------|\n");
  for (const double aperture_deg : {1.0, 5.0, 20.0, 45.0, 60.0, 90.0, 120.0, 150.0}) {
    const Cavity<double> cavity(radians(aperture_deg));
    const InterreflectionKernel<double> kernel(cavity);
    const double further = nanoseconds(albedos, [&](double albedo) {
      const auto gain = kernel.gain(albedo);
      return gain.reflectance + gain.bihemispherical;
    });
    const double first = nanoseconds({0.5}, [&](double albedo) {
      return InterreflectionKernel<double>(cavity).gain(albedo).bihemispherical;
    });
    std::printf("| %6g°  | %5zu | %21.1f | %21.1f | %13.1f |\n", aperture_deg, kernel.nodes().size(),
                first / 1000, further, further / logarithm);
  }
}
