// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sums and products over the lanes of packs, of four packs together.
///
/// Method. What is left of each pack after folding it in halves are four lanes; four packs of four lanes are a square, of
/// which rows and columns are exchanged while the lanes are combined. So four packs take as many instructions as two
/// that are folded to the end one by one.
///
/// When not to use it: in loops. Combine packs lane by lane there, and the lanes at the end.

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/pack.hpp"

namespace vcavity::detail {

/// Packs of so many components that any number of them, in fours, has a lane.
template <class Real, std::size_t count>
using Quadruples = Pack<Real, (count + 3) / 4 * 4>;

#if defined(__GNUC__)
/// What the lanes of each of four packs of four lanes combine to.
template <class Operation, class Quad>
VCAVITY_INLINE Quad combined_rows(const Operation& combine, const Quad& a, const Quad& b, const Quad& c,
                                  const Quad& d) {
  const Quad a_b = combine(Quad{a[0], b[0], a[2], b[2]}, Quad{a[1], b[1], a[3], b[3]});
  const Quad c_d = combine(Quad{c[0], d[0], c[2], d[2]}, Quad{c[1], d[1], c[3], d[3]});
  return combine(Quad{a_b[0], a_b[1], c_d[0], c_d[1]}, Quad{a_b[2], a_b[3], c_d[2], c_d[3]});
}

/// Four lanes that eight combine to.
template <class Quad, class Operation, class Lanes>
VCAVITY_INLINE Quad combined_halves(const Operation& combine, const Lanes& lanes) {
  Quad low, high;
  std::memcpy(&low, lanes.begin(), sizeof low);
  std::memcpy(&high, lanes.begin() + 4, sizeof high);
  return combine(low, high);
}
#endif

/// What the lanes of each of several packs combine to: one component for each pack.
/// @param combine associative and commutative, such as a sum, of vectors and numbers
template <class Operation, class Real, std::size_t lanes, std::size_t count>
  requires(lanes == 8)
VCAVITY_INLINE Quadruples<Real, count> combined_lanes(const Operation& combine,
                                                      const std::array<Pack<Real, lanes>, count>& packs) {
  Quadruples<Real, count> result;
#if defined(__GNUC__)
  constexpr bool has_registers = std::is_same_v<Real, float> || std::is_same_v<Real, double>;
  if constexpr (has_registers && 4 * sizeof(Real) <= register_bytes) {
    typedef Real Quad VCAVITY_VECTOR(4 * sizeof(Real));
    for (std::size_t i = 0; i < count; i += 4) {
      const auto half = [&](std::size_t k) {
        return combined_halves<Quad>(combine, packs[i + k < count ? i + k : count - 1]);
      };
      const Quad rows = combined_rows(combine, half(0), half(1), half(2), half(3));
      std::memcpy(result.begin() + i, &rows, sizeof rows);
    }
    return result;
  }
#endif
  for (std::size_t i = 0; i < (count + 3) / 4 * 4; ++i) {
    const Pack<Real, lanes>& pack = packs[i < count ? i : count - 1];
    Real all = pack[0];
    for (std::size_t lane = 1; lane < lanes; ++lane) all = combine(all, pack[lane]);
    result[i] = all;
  }
  return result;
}

}  // namespace vcavity::detail
