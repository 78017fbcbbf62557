// SPDX-License-Identifier: BSD-3-Clause
#include "tools/kernel/kernel.hpp"

#include <cmath>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "support/catch.hpp"

using namespace vcavity;
using namespace vcavity::tools;

namespace {

Directions directions_to_the_right() {
  const double half = std::sqrt(0.5);
  Directions result{{0, 0, 1, half}, {0, 1, 0, 0}, {1, 0, 0, half}};
  for (int i = 0; i < 203; ++i) result.push_back(direction(0.0077 * i, -1.5 + 0.0149 * i));
  return result;
}

/// Metals and dielectrics.
std::vector<RefractiveIndex> indices(int count) {
  std::vector<RefractiveIndex> result;
  for (int i = 0; i < count; ++i) result.push_back({0.1 + 0.2 * i, i % 3 == 2 ? 0.0 : 4 - 0.3 * i});
  return result;
}

const std::vector<double> apertures_deg{3, 45, 60, 107, 180};

template <class Check>
void for_each_job(const std::vector<RefractiveIndex>& indices, Check&& check) {
  const Directions directions = directions_to_the_right();
  std::vector<double> values(directions.size() * indices.size());
  for (const double aperture_deg : apertures_deg)
    for (const Polarization polarization : {Polarization::none, Polarization::separate, Polarization::full})
      for (const Quantity quantity :
           {Quantity::reflectance, Quantity::absorptance, Quantity::degree_of_polarization})
        for (const int max_bounces : {2, all_bounces}) {
          if (quantity == Quantity::degree_of_polarization && polarization == Polarization::none) continue;
          CAPTURE(aperture_deg, indices.size(), static_cast<int>(polarization), static_cast<int>(quantity));
          check(KernelJob{radians(aperture_deg), quantity, polarization, max_bounces, indices, directions,
                          values});
        }
}

/// The same by the library, a direction and a wavelength at a time.
double expected(const KernelJob& job, const Vec3<double>& e, const RefractiveIndex& index) {
  const Cavity<double> cavity(job.aperture);
  return with_facet(index, [&](const auto& facet) {
    return with_polarization(job.polarization, facet, [&](const auto& model) -> double {
      if (job.quantity == Quantity::absorptance)
        return unpolarized(directional_absorptance(cavity, e, model));
      const auto reflectance = directional_reflectance(cavity, e, model, job.max_bounces);
      if constexpr (requires { diattenuation(reflectance); })
        if (job.quantity == Quantity::degree_of_polarization) return diattenuation(reflectance);
      return unpolarized(reflectance);
    });
  });
}

/// All instruction sets give the numbers of the first, bit for bit.
void check_that_kernels_agree(const KernelJob& job) {
  for (const auto which : {&Kernel::in_double, &Kernel::in_single}) {
    (kernels().front().*which)(job);
    const std::vector<double> baseline(job.values.begin(), job.values.end());
    for (const Kernel& kernel : kernels()) {
      (kernel.*which)(job);
      CAPTURE(std::string(kernel.instruction_set));
      CHECK(std::equal(baseline.begin(), baseline.end(), job.values.begin()));
    }
  }
}

}  // namespace

TEST_CASE("kernels compute what the library does, in packs of directions and of wavelengths") {
  for (const int wavelengths : {1, 11})
    for_each_job(indices(wavelengths), [&](const KernelJob& job) {
      double worst = 0, worst_in_single = 0;
      const auto largest_error = [&] {
        double result = 0;
        for (std::size_t i = 0; i < job.values.size(); ++i)
          result =
              std::max(result, std::abs(job.values[i] - expected(job, job.directions[i / job.indices.size()],
                                                                 job.indices[i % job.indices.size()])));
        return result;
      };
      run_kernel(job, Precision::double_precision);
      worst = largest_error();
      run_kernel(job, Precision::single_precision);
      worst_in_single = largest_error();
      CHECK(worst < 1e-11);
      // Of light below the smallest float, in the narrowest groove, the degree of polarisation is lost.
      if (job.quantity != Quantity::degree_of_polarization || job.aperture > 0.5)
        CHECK(worst_in_single < 2e-3);
    });
}

TEST_CASE("the kernels of all instruction sets give the same numbers, bit for bit") {
  REQUIRE(!kernels().empty());
  for (const int wavelengths : {1, 11}) for_each_job(indices(wavelengths), check_that_kernels_agree);
}

namespace {

/// A film that some wavelengths do not see, and one of metal.
std::vector<KernelFilm> two_films(std::size_t wavelengths) {
  std::vector<KernelFilm> films(2);
  for (std::size_t i = 0; i < wavelengths; ++i) {
    const double x = static_cast<double>(i);
    films[0].indices.push_back({2.4 - 0.02 * x, i % 2 == 0 ? 0 : 0.01 * x});
    films[0].thicknesses.push_back(i % 4 == 3 ? 0 : 0.05 + 0.11 * x);
    films[1].indices.push_back({0.2, 3.4});
    films[1].thicknesses.push_back(0.01);
  }
  return films;
}

Coated<Conductor<double>> facet_under(const std::vector<KernelFilm>& films, const RefractiveIndex& substrate,
                                      std::size_t wavelength) {
  std::vector<Film<double>> layers;
  for (const KernelFilm& film : films)
    layers.emplace_back(film.indices[wavelength].n, film.indices[wavelength].k, film.thicknesses[wavelength]);
  return Coated(Conductor<double>(substrate.n, substrate.k), layers);
}

template <class Check>
void for_each_job_under_films(Check&& check) {
  for (const int wavelengths : {1, 11}) {
    const std::vector<RefractiveIndex> substrates = indices(wavelengths);
    const std::vector<KernelFilm> films = two_films(substrates.size());
    const Directions directions = directions_to_the_right();
    std::vector<double> values(directions.size() * substrates.size());
    for (const double aperture_deg : apertures_deg)
      for (const Polarization polarization : {Polarization::none, Polarization::separate, Polarization::full})
        for (const int max_bounces : {2, all_bounces}) {
          CAPTURE(aperture_deg, wavelengths, static_cast<int>(polarization), max_bounces);
          check(KernelJob{radians(aperture_deg), Quantity::reflectance, polarization, max_bounces, substrates,
                          directions, values, films},
                films);
        }
  }
}

}  // namespace

TEST_CASE("kernels compute films as the library does, in packs of directions and of wavelengths") {
  for_each_job_under_films([](const KernelJob& job, const std::vector<KernelFilm>& films) {
    const Cavity<double> cavity(job.aperture);
    std::vector<double> expected;
    for (std::size_t i = 0; i < job.directions.size(); ++i)
      for (std::size_t j = 0; j < job.indices.size(); ++j)
        with_polarization(job.polarization, facet_under(films, job.indices[j], j), [&](const auto& model) {
          expected.push_back(
              unpolarized(directional_reflectance(cavity, job.directions[i], model, job.max_bounces)));
        });
    const auto largest_error = [&](Precision precision) {
      run_kernel(job, precision);
      double result = 0;
      for (std::size_t i = 0; i < expected.size(); ++i)
        result = std::max(result, std::abs(job.values[i] - expected[i]));
      return result;
    };
    CHECK(largest_error(Precision::double_precision) < 1e-11);
    CHECK(largest_error(Precision::single_precision) < 2e-3);
  });
}

TEST_CASE("the kernels of all instruction sets give the same numbers under films, bit for bit") {
  for_each_job_under_films(
      [](const KernelJob& job, const std::vector<KernelFilm>&) { check_that_kernels_agree(job); });
}
