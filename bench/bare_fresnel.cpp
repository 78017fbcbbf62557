// SPDX-License-Identifier: BSD-3-Clause
/// The loops for one instruction set. This file is compiled once for each, under the name BARE_LOOPS.

#include "bare_fresnel.hpp"

#include <algorithm>
#include <numeric>
#include <vcavity/facet/fresnel.hpp>

namespace vcavity::bench {
namespace {

using tools::RefractiveIndex;

template <class Real>
using Lanes = Pack<Real, native_lanes<Real>>;

// All calls become part of it, as in the kernel.
template <class Real>
VCAVITY_FLATTEN Real sum_of_reflectances(std::span<const RefractiveIndex> indices,
                                         std::span<const Real> cosines) {
  constexpr std::size_t lanes = native_lanes<Real>;
  Lanes<Real> sum(0);
  for (std::size_t start = 0; start < indices.size(); start += lanes) {
    Lanes<Real> n, k;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const RefractiveIndex& index = indices[std::min(start + lane, indices.size() - 1)];
      n[lane] = static_cast<Real>(index.n);
      k[lane] = static_cast<Real>(index.k);
    }
    const Conductor<Lanes<Real>> facet(n, k);
    if (indices.size() == 1) {
      for (std::size_t i = 0; i + lanes <= cosines.size(); i += lanes)
        sum = sum + facet(Lanes<Real>::load(&cosines[i]));
    } else {
      for (const Real& cosine : cosines) sum = sum + facet(cosine);
    }
  }
  return std::accumulate(sum.begin(), sum.end(), Real(0));
}

}  // namespace

extern const BareLoops BARE_LOOPS = {sum_of_reflectances<double>, sum_of_reflectances<float>};

}  // namespace vcavity::bench
