// SPDX-License-Identifier: BSD-3-Clause
/// What each effect costs in one directional reflectance, and that an effect that is off costs nothing: the
/// paper's model must take as long as a loop over its bounces that has never heard of polarisation.

#include <benchmark/benchmark.h>

#include <vcavity/vcavity.hpp>
#include <vector>

namespace {

using namespace vcavity;

template <class Real>
std::vector<Vec3<Real>> directions() {
  std::vector<Vec3<Real>> result;
  for (int i = 0; i < 256; ++i) result.push_back(direction(Real(i) * Real(0.006), Real(i) * Real(0.37)));
  return result;
}

template <class Real>
Conductor<Real> silver() {
  return {Real(0.1249), Real(3.3391)};
}

template <class Real, class Reflectance>
void run(benchmark::State& state, Reflectance&& reflectance) {
  const Cavity<Real> groove(radians(Real(45)));
  const auto all = directions<Real>();
  for (auto _ : state)
    for (const Vec3<Real>& e : all) benchmark::DoNotOptimize(reflectance(groove, e));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
}

/// The lobes without any abstraction over values.
template <class Real>
Real bare(const Cavity<Real>& cavity, const Vec3<Real>& e, const Conductor<Real>& facet) {
  const Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
  Real sum(0);
  for (const Panel first : {Panel::one, Panel::two}) {
    PanelImages<Real> images(cavity, e, first);
    ReachedFractions<Real> fractions(cavity, e, images);
    Real throughput(1);
    Real reached = fractions.first();
    while (reached >= rounding) {
      throughput *= facet(images.cos_theta_i());
      images.advance();
      const Real next = images.bounce() <= cavity.max_bounces() ? fractions.advance(images) : Real(0);
      sum += (reached - next) * throughput;
      reached = next;
    }
  }
  return sum;
}

template <class Real>
void bare_loop(benchmark::State& state) {
  run<Real>(state,
            [facet = silver<Real>()](const auto& groove, const auto& e) { return bare(groove, e, facet); });
}

template <class Real>
void paper_model(benchmark::State& state) {
  run<Real>(state, [facet = silver<Real>()](const auto& groove, const auto& e) {
    return directional_reflectance(groove, e, facet);
  });
}

template <class Real>
void separate_polarizations(benchmark::State& state) {
  run<Real>(state, [facet = separately_polarized(silver<Real>())](const auto& groove, const auto& e) {
    return unpolarized(directional_reflectance(groove, e, facet));
  });
}

template <class Real>
void full_polarization(benchmark::State& state) {
  run<Real>(state, [facet = polarized(silver<Real>())](const auto& groove, const auto& e) {
    return unpolarized(directional_reflectance(groove, e, facet));
  });
}

template <class Real>
void mueller_matrix(benchmark::State& state) {
  run<Real>(state, [facet = polarized(silver<Real>())](const auto& groove, const auto& e) {
    return directional_reflectance(groove, e, facet);
  });
}

BENCHMARK_TEMPLATE(bare_loop, float);
BENCHMARK_TEMPLATE(paper_model, float);
BENCHMARK_TEMPLATE(separate_polarizations, float);
BENCHMARK_TEMPLATE(full_polarization, float);
BENCHMARK_TEMPLATE(mueller_matrix, float);
BENCHMARK_TEMPLATE(bare_loop, double);
BENCHMARK_TEMPLATE(paper_model, double);
BENCHMARK_TEMPLATE(separate_polarizations, double);
BENCHMARK_TEMPLATE(full_polarization, double);
BENCHMARK_TEMPLATE(mueller_matrix, double);

}  // namespace
