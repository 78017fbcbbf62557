// SPDX-License-Identifier: BSD-3-Clause

/// What matte grooves cost: prints a Markdown table of the time of the first wavelength, of each further one, and of how
/// many logarithms take as long, over all albedos and for the band of them that takes longest. Every number is the median
/// of several runs, each of which times the logarithm beside it. Exits with 1 if a wavelength takes longer than 40
/// logarithms.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vcavity/matte/lambertian_cavity.hpp>
#include <vector>

using namespace vcavity;

namespace {

constexpr int runs = 31;

/// The price that is promised.
constexpr double most_logarithms = 40;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Nanoseconds per call with an element of `arguments`. The results are added up and kept, so that no call can be left
/// out.
template <class Call>
double nanoseconds(const std::vector<double>& arguments, const Call& call) {
  static volatile double kept;
  const auto start = std::chrono::steady_clock::now();
  double sum = 0;
  for (const double argument : arguments) sum += call(argument);
  kept = sum;
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  static_cast<void>(kept);
  return time.count() / static_cast<double>(arguments.size());
}

struct Price {
  double nanoseconds;
  double logarithms;
};

/// What albedos between two bounds cost.
Price price(const InterreflectionKernel<double>& kernel, double from, double to) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(from, to);
  std::vector<double> albedos(2000);
  for (double& albedo : albedos) albedo = unit(random);
  std::vector<double> times, ratios;
  for (int run = 0; run < runs; ++run) {
    const double logarithm = nanoseconds(albedos, [](double x) { return std::log(x); });
    times.push_back(nanoseconds(albedos, [&](double albedo) {
      const auto gain = kernel.gain(albedo);
      return gain.reflectance + gain.bihemispherical;
    }));
    ratios.push_back(times.back() / logarithm);
  }
  return {median(times), median(ratios)};
}

}  // namespace

int main() {
  bool within = true;
  std::printf(
      "| aperture | nodes | first wavelength (µs) | each further one (ns) | in logarithms | longest albedos "
      "| in "
      "logarithms |\n"
      "|----------|-------|-----------------------|-----------------------|---------------|-----------------|"
      "-------"
      "--------|\n");
  for (const double aperture_deg : {0.001, 0.1, 1.0, 5.0, 20.0, 45.0, 60.0, 90.0, 120.0, 150.0}) {
    const Cavity<double> cavity(radians(aperture_deg));
    const InterreflectionKernel<double> kernel(cavity);
    const Price all = price(kernel, 0, 1);
    double longest_from = 0;
    Price longest{0, 0};
    constexpr double width = 0.05;
    for (double from = 0; from < 1 - width / 2; from += width) {
      const Price found = price(kernel, from, from + width);
      if (found.logarithms > longest.logarithms) longest = found, longest_from = from;
    }
    std::vector<double> firsts;
    for (int run = 0; run < runs; ++run)
      firsts.push_back(nanoseconds({0.5}, [&](double albedo) {
        return InterreflectionKernel<double>(cavity).gain(albedo).bihemispherical;
      }));
    std::printf("| %6g°  | %5zu | %21.1f | %21.1f | %13.1f | %6.2f to %5.2f | %13.1f |\n", aperture_deg,
                kernel.nodes().size(), median(firsts) / 1000, all.nanoseconds, all.logarithms, longest_from,
                longest_from + width, longest.logarithms);
    within = within && longest.logarithms <= most_logarithms;
  }
  return within ? 0 : 1;
}
