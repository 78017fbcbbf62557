// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The groups of benchmarks, each in a file of its own. Their names, such as
/// `reflectance/silver/90/double/4/none`, are what `scripts/bench_report.py` finds them by.

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vcavity::bench {

void add_fresnel_benchmarks();
void add_reflectance_benchmarks();
void add_profile_benchmarks();
void add_bihemispherical_benchmarks();
void add_kernel_benchmarks();
void add_map_benchmarks();

/// Words with slashes between them.
template <class... Words>
std::string name_of(const std::string& first, const Words&... words) {
  std::string name = first;
  (name.append("/").append(words), ...);
  return name;
}

/// Says how many things one pass over the data has computed, for the throughput in the report.
inline void count_items(benchmark::State& state, std::size_t per_pass) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(per_pass));
}

/// Times `compute` of all inputs, one after the other.
/// @param items how many things that computes
template <class Input, class Compute>
void run_over(benchmark::State& state, const std::vector<Input>& inputs, std::size_t items,
              const Compute& compute) {
  for (auto _ : state)
    for (const Input& input : inputs) {
      auto result = compute(input);
      benchmark::DoNotOptimize(result);
    }
  count_items(state, items);
}

}  // namespace vcavity::bench
