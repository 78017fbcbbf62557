// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The inner loop of maps: a quantity for many directions and wavelengths, in the widest vector registers of
/// the processor.
///
/// The kernel is compiled once for each instruction set, and the one to use is chosen at run time. All of
/// them give the same numbers, bit for bit.

#include <cstddef>
#include <span>
#include <string_view>
#include <vcavity/groove/cavity.hpp>
#include <vector>

#include "tools/materials/facet.hpp"

namespace vcavity::tools {

/// What is computed for each direction.
enum class Quantity { reflectance, bounces, degree_of_polarization, absorptance };

/// The numbers it is computed with.
enum class Precision { double_precision, single_precision };

/// Directions, kept component by component, as vector registers want them.
struct Directions {
  std::vector<double> x, y, z;

  std::size_t size() const { return x.size(); }
  Vec3<double> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void push_back(const Vec3<double>& e) {
    x.push_back(e.x);
    y.push_back(e.y);
    z.push_back(e.z);
  }
};

/// A thin film at every wavelength of a job.
struct KernelFilm {
  std::vector<RefractiveIndex> indices;
  std::vector<double> thicknesses;  ///< in wavelengths
};

/// A job for a kernel.
struct KernelJob {
  double aperture;    ///< radians
  Quantity quantity;  ///< not `bounces`
  Polarization polarization;
  int max_bounces;
  std::span<const RefractiveIndex> indices;  ///< one for each wavelength
  const Directions& directions;              ///< all with e.y ≥ 0; the groove is its own mirror image
  std::span<double> values;                  ///< result: those of the first direction, then of the second, …
  std::span<const KernelFilm> films = {};  ///< on every facet, the top one first; then only for reflectances
};

/// A kernel for one instruction set.
struct Kernel {
  std::string_view instruction_set;  ///< "baseline", "AVX2", "AVX-512"
  void (*in_double)(const KernelJob&);
  void (*in_single)(const KernelJob&);
};

/// The kernels that this processor can run, the fastest last.
std::span<const Kernel> kernels();

/// Does a job with the fastest kernel.
void run_kernel(const KernelJob& job, Precision precision);

}  // namespace vcavity::tools
