// SPDX-License-Identifier: BSD-3-Clause

/// Prints how the closed form agrees with the tracer under diffuse light, as a Markdown table.

#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparisons.hpp"

namespace {

using namespace agreement;

// Fewer rays leave more to chance than the difference allowed between the means; more need too much memory.
constexpr double fewest_rays = 2e5;
constexpr double most_rays = 1e8;

constexpr const char* usage =
    "Usage: vcavity_agreement [RAYS]\n"
    "Traces RAYS rays of diffuse light (2e5 to 1e8, default 1e6) across grooves of each aperture,\n"
    "compares every ray and the mean with the closed form of vcavity, and prints a Markdown table.\n"
    "Exit status: 0 if they agree, 1 if they do not, 2 for a wrong argument.\n";

struct Row {
  Material material;
  RayAgreement rays;
  ReplicatedMean mean;
};

struct Block {
  double aperture;
  std::vector<Row> rows;
  double rays_per_second;
};

// All materials share the rays. Only following the rays is timed, in processor time of the one thread that
// does it.
Block agree(double aperture, int points) {
  Block block{aperture, {}, 0};
  for (const Material& material : tracer::example_materials()) block.rows.push_back({material, {}, {}});

  const tracer::Tracer grooves = tracer::wide_groove_array(aperture);
  std::clock_t tracing = 0;
  for (int replicate = 0; replicate < replicates; ++replicate) {
    const ShiftedLattice lattice(1, replicate);
    std::vector<LightRay> rays;
    std::vector<tracer::Path> paths;
    for (int i = 0; i < points; ++i) rays.push_back(diffuse_ray(aperture, lattice[i]));

    const std::clock_t start = std::clock();
    for (const LightRay& ray : rays) paths.push_back(trace(grooves, ray));
    tracing += std::clock() - start;

    for (auto& [material, agreement, mean] : block.rows) {
      for (std::size_t i = 0; i < rays.size(); ++i) {
        agreement.add(rays[i], material, paths[i], closed_form_ray(rays[i], material));
        mean.add(tracer::reflectance(paths[i], material));
      }
      mean.end_replicate();
    }
  }
  block.rays_per_second =
      static_cast<double>(replicates) * points * CLOCKS_PER_SEC / static_cast<double>(tracing);
  return block;
}

void print_heading() {
  std::puts(
      "| aperture | material | rays | mismatches | inside the margin | refined "
      "| theory | traced | difference / σ | rays per second |\n"
      "|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|");
}

// Prints one line for each material, complains of rays that differ, and returns the means.
std::vector<MeanComparison> print(const Block& block) {
  std::vector<MeanComparison> means;
  for (const auto& [material, rays, mean] : block.rows) {
    const double theory = closed_form_hemispherical(block.aperture, material, every_bounce);
    std::ostringstream what;
    what << material.name << ", aperture " << degrees(block.aperture) << " deg";
    means.push_back({what.str(), theory, mean.mean(), mean.standard_error()});
    std::printf("| %g° | %s | %lld | %lld | %.2g | %.2g | %.8f | %.8f | %+.2f | %.1e |\n",
                degrees(block.aperture), material.name.c_str(), static_cast<long long>(rays.rays),
                static_cast<long long>(rays.mismatches), rays.fraction_inside(), rays.fraction_refined(),
                theory, mean.mean(), means.back().sigmas(), block.rays_per_second);
    if (!rays.holds()) std::cerr << "vcavity_agreement: " << rays.first_mismatch << '\n';
  }
  std::fflush(stdout);
  return means;
}

// Returns whether theory and tracer agree, in every ray and in every mean.
bool print_table(double rays) {
  const int points = static_cast<int>(std::ceil(rays / replicates));
  RayAgreement all_rays;
  std::vector<MeanComparison> all_means;
  print_heading();
  for (const double aperture_deg : {2.0, 5.0, 10.0, 30.0, 45.0, 60.0, 90.0, 120.0, 150.0, 175.0, 180.0}) {
    const Block block = agree(radians(aperture_deg), points);
    const std::vector<MeanComparison> means = print(block);
    all_means.insert(all_means.end(), means.begin(), means.end());
    for (const Row& row : block.rows) all_rays += row.rays;
  }
  std::printf("\nThe margin is %g panel widths. Outside it directions differ by %.1e at most, ", edge_margin,
              all_rays.largest_direction_error);
  std::printf("products by %.1e of their value.\n", all_rays.largest_product_error);
  std::printf("The %zu means may differ by %.2f σ, with a false alarm for one seed in %g, and by %g.\n",
              all_means.size(), allowed_sigmas(static_cast<int>(all_means.size())), 1 / false_alarm_rate,
              mean_tolerance);
  const std::vector<MeanComparison> failed = failures(all_means);
  for (const MeanComparison& mean : failed)
    std::cerr << "vcavity_agreement: " << mean.what << ": the means differ too much\n";
  return all_rays.holds() && failed.empty();
}

double parse_rays(const std::string& text) {
  std::size_t end = 0;
  double rays = 0;
  try {
    rays = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end == 0 || end != text.size() || !(rays >= fewest_rays && rays <= most_rays))
    throw std::invalid_argument("RAYS is '" + text + "', expected a number from 2e5 to 1e8");
  return rays;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string argument = argc > 1 ? argv[1] : "1e6";
  if (argument == "--help") {
    std::cout << usage;
    return 0;
  }
  try {
    if (argc > 2) throw std::invalid_argument("more than one argument\n" + std::string(usage));
    return print_table(parse_rays(argument)) ? 0 : 1;
  } catch (const std::invalid_argument& error) {
    std::cerr << "vcavity_agreement: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "vcavity_agreement: " << error.what() << '\n';
    return 1;
  }
}
