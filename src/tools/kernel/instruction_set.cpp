// SPDX-License-Identifier: BSD-3-Clause
/// The kernel for one instruction set. This file is compiled once for each, under the name VCAVITY_KERNEL;
/// what it instantiates depends on `Pack`, whose type tells the instruction sets apart.

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "tools/kernel/kernel.hpp"

// Everything that a function calls becomes part of it: a call would write its packs to memory and read them
// again.
#define VCAVITY_INLINED __attribute__((flatten))

namespace vcavity::tools {
namespace {

template <class Real>
using Lanes = Pack<Real, native_lanes<Real>>;

// Calls `use` with the function that gives the quantity of a job for a direction, or for a pack of them: the
// choices are made here, outside of all loops.
template <class Cavity, class Facet, class Use>
void with_quantity(const KernelJob& job, const Cavity& cavity, const Facet& facet, Use&& use) {
  with_polarization(job.polarization, facet, [&](const auto& model) {
    using Model = std::remove_cvref_t<decltype(model)>;
    if (job.quantity == Quantity::absorptance) {
      use([&](const auto& e)
              VCAVITY_INLINED { return unpolarized(directional_absorptance(cavity, e, model)); });
    } else if (job.quantity == Quantity::degree_of_polarization) {
      if constexpr (!std::is_same_v<Model, Facet>)
        use([&](const auto& e) VCAVITY_INLINED {
          return diattenuation(directional_reflectance(cavity, e, model, job.max_bounces));
        });
    } else {
      use([&](const auto& e)
              VCAVITY_INLINED { return unpolarized_reflectance(cavity, e, model, job.max_bounces); });
    }
  });
}

// Numbers from one on, the last of them repeated to fill a pack.
template <class Real>
[[gnu::always_inline]] inline Lanes<Real> loaded(const std::vector<double>& numbers, std::size_t start) {
  constexpr std::size_t lanes = native_lanes<Real>;
  if (start + lanes <= numbers.size()) return Lanes<Real>::load(&numbers[start]);
  std::array<double, lanes> values;
  values.fill(numbers.back());
  std::copy(numbers.begin() + static_cast<std::ptrdiff_t>(start), numbers.end(), values.begin());
  return Lanes<Real>::load(values.data());
}

// Copies the first values of a pack. All are converted: that takes as long as to convert one.
template <class Real>
[[gnu::always_inline]] inline void copy_first(const Lanes<Real>& values, std::size_t count, double* target) {
  std::array<double, native_lanes<Real>> numbers;
  std::copy(values.begin(), values.end(), numbers.begin());
  std::copy_n(numbers.begin(), count, target);
}

// One wavelength: packs of directions.
template <class Real>
void over_directions(const KernelJob& job, const Cavity<Real>& cavity) {
  constexpr std::size_t lanes = native_lanes<Real>;
  const std::size_t count = job.directions.size();
  const auto fill = [&](const auto& quantity) {
    for (std::size_t start = 0; start < count; start += lanes) {
      const Lanes<Real> values = quantity(Vec3<Lanes<Real>>{loaded<Real>(job.directions.x, start),
                                                            loaded<Real>(job.directions.y, start),
                                                            loaded<Real>(job.directions.z, start)});
      copy_first(values, std::min(lanes, count - start), &job.values[start]);
    }
  };
  const RefractiveIndex& index = job.indices.front();
  const Lanes<Real> n(static_cast<Real>(index.n));
  if (index.k == 0)
    with_quantity(job, cavity, Dielectric<Lanes<Real>>(n), fill);
  else
    with_quantity(job, cavity, Conductor<Lanes<Real>>(n, Lanes<Real>(static_cast<Real>(index.k))), fill);
}

// Many wavelengths: packs of wavelengths.
template <class Real>
void over_wavelengths(const KernelJob& job, const Cavity<Real>& cavity) {
  constexpr std::size_t lanes = native_lanes<Real>;
  std::vector<Conductor<Lanes<Real>>> facets;
  for (std::size_t start = 0; start < job.indices.size(); start += lanes) {
    Lanes<Real> n, k;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const RefractiveIndex& index = job.indices[std::min(start + lane, job.indices.size() - 1)];
      n[lane] = static_cast<Real>(index.n);
      k[lane] = static_cast<Real>(index.k);
    }
    facets.emplace_back(n, k);
  }
  const auto store = [&](std::size_t direction, std::size_t pack, const Lanes<Real>& values) {
    const std::size_t start = pack * lanes;
    copy_first(values, std::min(lanes, job.indices.size() - start),
               &job.values[direction * job.indices.size() + start]);
  };
  if (job.quantity == Quantity::reflectance && job.polarization == Polarization::none) {
    RecordedDirection<Real> recorded;
    for (std::size_t i = 0; i < job.directions.size(); ++i) {
      recorded.follow(cavity, Vec3<Real>(job.directions[i]), job.max_bounces);
      for (std::size_t pack = 0; pack < facets.size(); ++pack)
        store(i, pack, recorded.reflectance(facets[pack]));
    }
  } else {
    for (std::size_t pack = 0; pack < facets.size(); ++pack)
      with_quantity(job, cavity, facets[pack], [&](const auto& quantity) {
        for (std::size_t i = 0; i < job.directions.size(); ++i)
          store(i, pack, quantity(Vec3<Real>(job.directions[i])));
      });
  }
}

template <class Real>
void run(const KernelJob& job) {
  const Cavity<Real> cavity(std::min(static_cast<Real>(job.aperture), pi<Real>()));
  if (job.indices.size() == 1)
    over_directions(job, cavity);
  else
    over_wavelengths(job, cavity);
}

}  // namespace

#define VCAVITY_JOIN(a, b) a##b
#define VCAVITY_NAME(a, b) VCAVITY_JOIN(a, b)

void VCAVITY_NAME(VCAVITY_KERNEL, _in_double)(const KernelJob& job);
void VCAVITY_NAME(VCAVITY_KERNEL, _in_double)(const KernelJob& job) {
  run<double>(job);
}
void VCAVITY_NAME(VCAVITY_KERNEL, _in_single)(const KernelJob& job);
void VCAVITY_NAME(VCAVITY_KERNEL, _in_single)(const KernelJob& job) {
  run<float>(job);
}

}  // namespace vcavity::tools
