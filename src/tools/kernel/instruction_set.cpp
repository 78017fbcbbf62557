// SPDX-License-Identifier: BSD-3-Clause
/// The kernel for one instruction set. This file is compiled once for each, under the name VCAVITY_KERNEL;
/// what it instantiates depends on `Pack`, whose type tells the instruction sets apart.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "tools/kernel/kernel.hpp"

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
              VCAVITY_FLATTEN { return unpolarized(directional_absorptance(cavity, e, model)); });
    } else if (job.quantity == Quantity::degree_of_polarization) {
      if constexpr (!std::is_same_v<Model, Facet>)
        use([&](const auto& e) VCAVITY_FLATTEN {
          return diattenuation(directional_reflectance(cavity, e, model, job.max_bounces));
        });
    } else {
      use([&](const auto& e)
              VCAVITY_FLATTEN { return unpolarized_reflectance(cavity, e, model, job.max_bounces); });
    }
  });
}

// Numbers from one on, the last of them repeated to fill a pack.
template <class Real>
VCAVITY_INLINE Lanes<Real> loaded(const std::vector<double>& numbers, std::size_t start) {
  constexpr std::size_t lanes = native_lanes<Real>;
  if (start + lanes <= numbers.size()) return Lanes<Real>::load(&numbers[start]);
  std::array<double, lanes> values;
  values.fill(numbers.back());
  std::copy(numbers.begin() + static_cast<std::ptrdiff_t>(start), numbers.end(), values.begin());
  return Lanes<Real>::load(values.data());
}

// Copies the first values of a pack. All are converted: that takes as long as to convert one.
template <class Real>
VCAVITY_INLINE void copy_first(const Lanes<Real>& values, std::size_t count, double* target) {
  std::array<double, native_lanes<Real>> numbers;
  std::copy(values.begin(), values.end(), numbers.begin());
  std::copy_n(numbers.begin(), count, target);
}

// The same under films, for reflectances alone: with the flux through films the code would be several times larger.
template <class Cavity, class Facet, class Use>
void with_reflectance(const KernelJob& job, const Cavity& cavity, const Facet& facet, Use&& use) {
  with_polarization(job.polarization, facet, [&](const auto& model) {
    use([&](const auto& e)
            VCAVITY_FLATTEN { return unpolarized_reflectance(cavity, e, model, job.max_bounces); });
  });
}

template <class Real>
using CoatedFacet = Coated<Conductor<Lanes<Real>>>;

// A facet under films; `wavelength(lane)` says for which wavelength each of its components stands.
template <class Real, class Wavelength>
CoatedFacet<Real> coated_facet(const KernelJob& job, const Wavelength& wavelength) {
  const auto index_of = [&](std::span<const RefractiveIndex> indices) {
    Complex<Lanes<Real>> index;
    for (std::size_t lane = 0; lane < native_lanes<Real>; ++lane) {
      index.re[lane] = static_cast<Real>(indices[wavelength(lane)].n);
      index.im[lane] = static_cast<Real>(indices[wavelength(lane)].k);
    }
    return index;
  };
  std::vector<Film<Lanes<Real>>> films;
  for (const KernelFilm& film : job.films) {
    const Complex<Lanes<Real>> index = index_of(film.indices);
    Lanes<Real> thickness;
    for (std::size_t lane = 0; lane < native_lanes<Real>; ++lane)
      thickness[lane] = static_cast<Real>(film.thicknesses[wavelength(lane)]);
    films.emplace_back(index.re, index.im, thickness);
  }
  const Complex<Lanes<Real>> substrate = index_of(job.indices);
  return CoatedFacet<Real>(Conductor<Lanes<Real>>(substrate.re, substrate.im), films);
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
  if (!job.films.empty()) {
    with_reflectance(job, cavity, coated_facet<Real>(job, [](std::size_t) { return std::size_t{0}; }), fill);
    return;
  }
  const RefractiveIndex& index = job.indices.front();
  const Lanes<Real> n(static_cast<Real>(index.n));
  if (index.k == 0)
    with_quantity(job, cavity, Dielectric<Lanes<Real>>(n), fill);
  else
    with_quantity(job, cavity, Conductor<Lanes<Real>>(n, Lanes<Real>(static_cast<Real>(index.k))), fill);
}

// Many wavelengths: packs of wavelengths.
// @param facets one for each pack
template <class Real, class Facet>
void over_wavelengths(const KernelJob& job, const Cavity<Real>& cavity, const std::vector<Facet>& facets) {
  constexpr std::size_t lanes = native_lanes<Real>;
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
    for (std::size_t pack = 0; pack < facets.size(); ++pack) {
      const auto fill = [&](const auto& quantity) {
        for (std::size_t i = 0; i < job.directions.size(); ++i)
          store(i, pack, quantity(Vec3<Real>(job.directions[i])));
      };
      if constexpr (std::is_same_v<Facet, CoatedFacet<Real>>)
        with_reflectance(job, cavity, facets[pack], fill);
      else
        with_quantity(job, cavity, facets[pack], fill);
    }
  }
}

// The facets of all wavelengths. `facet_at(wavelength)` makes one of a pack; `wavelength(lane)` says which they are.
template <class Real, class FacetAt>
auto packed_facets(const KernelJob& job, const FacetAt& facet_at) {
  const auto make = [&](std::size_t start) {
    return facet_at([&, start](std::size_t lane) { return std::min(start + lane, job.indices.size() - 1); });
  };
  std::vector<decltype(make(0))> facets;
  for (std::size_t start = 0; start < job.indices.size(); start += native_lanes<Real>)
    facets.push_back(make(start));
  return facets;
}

template <class Real>
void over_wavelengths(const KernelJob& job, const Cavity<Real>& cavity) {
  if (!job.films.empty()) {
    over_wavelengths(job, cavity, packed_facets<Real>(job, [&](const auto& wavelength) {
                       return coated_facet<Real>(job, wavelength);
                     }));
    return;
  }
  over_wavelengths(job, cavity, packed_facets<Real>(job, [&](const auto& wavelength) {
                     Lanes<Real> n, k;
                     for (std::size_t lane = 0; lane < native_lanes<Real>; ++lane) {
                       const RefractiveIndex& index = job.indices[wavelength(lane)];
                       n[lane] = static_cast<Real>(index.n);
                       k[lane] = static_cast<Real>(index.k);
                     }
                     return Conductor<Lanes<Real>>(n, k);
                   }));
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
