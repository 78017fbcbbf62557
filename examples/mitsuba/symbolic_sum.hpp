// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sums of vcavity (`PlainSummation` in lockstep_rough_bsdf.hpp) as loops of Dr.Jit's kernels, with derivatives in both
/// directions.
///
/// A sum is a loop whose iterations know of one another only through the sums, to which each adds. Dr.Jit derives such
/// loops term by term, forwards and backwards, and keeps no intermediate results; told so by −1 iterations. Its own
/// `while_loop` in C++ does not say it, and has no derivatives backwards.

#include <drjit/autodiff.h>
#include <drjit/jit.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <utility>

#include "lanes.hpp"

namespace vgroove {

struct SymbolicSummation {
  /// @tparam Sums what the sums are made of, `Lanes`
  /// @param first, end whole numbers n: those from `first` on and below `end` are summed over, in each entry of the
  ///        arrays as many as it has
  /// @param given what the terms depend on, for Dr.Jit to see: inside the calls of a renderer it finds no derivatives
  ///        with respect to what loops only refer to. It may hold evaluated arrays that are no fields of it.
  /// @param terms called with n, `given` and the sums so far, gives a tuple of terms
  template <class... Sums, class Float, class Given, class Terms>
  static std::tuple<Sums...> over(const Lanes<Float>& first, const Lanes<Float>& end, const Given& given,
                                  const Terms& terms) {
    using Loop = SumLoop<Float, Given, Terms, Sums...>;
    auto loop = std::make_unique<Loop>(
        Loop{{first, fixed(end), given, std::tuple(Sums(0)...)}, terms, typename Loop::Mask()});
    constexpr int choose = -1;
    constexpr long long is_sum = -1;
    const bool is_done =
        ad_loop(Loop::Mask::Backend, choose, choose, is_sum, "vgroove: a sum", loop.get(), &Loop::read,
                &Loop::write, &Loop::condition, &Loop::body, &Loop::release, true);
    std::tuple<Sums...> sums = std::get<3>(loop->state);
    loop->forget();
    if (!is_done) (void)loop.release();  // derivatives need it
    return sums;
  }

  /// What derivatives take as given.
  template <class Array>
  static Lanes<Array> fixed(const Lanes<Array>& value) {
    return Array(drjit::detach(value.array));
  }

 private:
  /// What Dr.Jit reads, replaces and runs.
  template <class Float, class Given, class Terms, class... Sums>
  struct SumLoop {
    using Mask = drjit::mask_t<Float>;

    std::tuple<Lanes<Float>, Lanes<Float>, Given, std::tuple<Sums...>> state;  // n and where it ends first
    Terms terms;
    Mask active;

    static SumLoop& of(void* payload) { return *static_cast<SumLoop*>(payload); }
    static void read(void* payload, drjit::vector<std::uint64_t>& indices) {
      drjit::detail::collect_indices<true>(of(payload).state, indices);
    }
    static void write(void* payload, const drjit::vector<std::uint64_t>& indices, bool) {
      drjit::detail::update_indices(of(payload).state, indices);
    }
    static std::uint32_t condition(void* payload) {
      SumLoop& loop = of(payload);
      loop.active = std::get<0>(loop.state).array < std::get<1>(loop.state).array;
      return loop.active.index();
    }
    static void body(void* payload) {
      SumLoop& loop = of(payload);
      auto& [n, end, given, sums] = loop.state;
      loop.add(loop.terms(n, given, so_far(sums)), std::index_sequence_for<Sums...>());
      n += Lanes<Float>(1);
    }
    static void release(void* payload) { delete static_cast<SumLoop*>(payload); }
    /// Dr.Jit gives the loop another state for each derivative; what it sees of this one would get in its way.
    void forget() {
      drjit::vector<std::uint64_t> indices;
      drjit::detail::collect_indices<false>(state, indices);
      drjit::detail::update_indices(state, drjit::vector<std::uint64_t>(indices.size(), 0));
    }

    static std::tuple<Sums...> so_far(const std::tuple<Sums...>& sums) {
      return std::apply([](const Sums&... sum) { return std::tuple(fixed(sum)...); }, sums);
    }
    template <std::size_t... index>
    void add(const std::tuple<Sums...>& found, std::index_sequence<index...>) {
      std::tuple<Sums...>& sums = std::get<3>(state);
      ((std::get<index>(sums) += std::get<index>(found)), ...);
    }
  };
};

}  // namespace vgroove

/// Numbers of vcavity as Dr.Jit finds the arrays that they are made of.
template <class Array>
struct drjit::detail::traversable<vgroove::Lanes<Array>> {
  static constexpr bool value = true;
  template <class Numbers>
  static auto fields(Numbers& numbers) {
    return drjit::tie(numbers.array);
  }
};

/// The same for how many ways through grooves there are.
template <class Array>
struct drjit::detail::traversable<vcavity::WayCounts<vgroove::Lanes<Array>>> {
  static constexpr bool value = true;
  template <class Counts>
  static auto fields(Counts& counts) {
    return drjit::tie(counts.even_from_one, counts.odd_from_one, counts.even_from_two, counts.all);
  }
};

/// The same for these ways.
template <class Array>
struct drjit::detail::traversable<vcavity::AllWays<vgroove::Lanes<Array>>> {
  static constexpr bool value = true;
  template <class Ways>
  static auto fields(Ways& ways) {
    return drjit::tie(ways.from.angle, ways.from.complement, ways.to.angle, ways.to.complement, ways.across.x,
                      ways.across.y, ways.cos_eta, ways.height, ways.tilt);
  }
};
