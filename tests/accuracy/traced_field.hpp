// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The field of a wave on its way through the groove, as complex vectors in space: at every mirror it is
/// split into its parts across and in the plane of incidence, and put together again. No unfolding, no Jones
/// matrices; a second road to everything that `polarization.hpp`, `jones.hpp` and `mueller.hpp` compute.

#include <algorithm>
#include <array>
#include <cmath>
#include <vcavity/conventions.hpp>

#include "accuracy/textbook_fresnel.hpp"
#include "accuracy/traced_beam.hpp"

namespace vcavity::test {

template <class Wide>
using Space = std::array<Wide, 3>;

template <class Wide>
Wide dot_in_space(const Space<Wide>& a, const Space<Wide>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The unit vector along a × b.
template <class Wide>
Space<Wide> unit_normal(const Space<Wide>& a, const Space<Wide>& b) {
  using std::sqrt;
  const Space<Wide> c{Wide(a[1] * b[2] - a[2] * b[1]), Wide(a[2] * b[0] - a[0] * b[2]),
                      Wide(a[0] * b[1] - a[1] * b[0])};
  const Wide length = sqrt(dot_in_space(c, c));
  return {Wide(c[0] / length), Wide(c[1] / length), Wide(c[2] / length)};
}

/// The axes a, b of light that travels along k, a in the plane of k and the groove; see conventions.hpp.
template <class Wide>
std::array<Space<Wide>, 2> axes_of_light(const Space<Wide>& k) {
  const Space<Wide> groove{Wide(1), Wide(0), Wide(0)};
  const Space<Wide> b = unit_normal(k, groove);
  return {unit_normal(b, k), b};
}

/// Complex amplitudes along two axes normal to the direction of travel.
template <class Wide>
using TwoAmplitudes = std::array<Complex<Wide>, 2>;

/// Two plane waves on the same way, with unit amplitude at first, one along the axis a, one along b.
template <class Wide>
struct TracedWaves {
  Space<Wide> k;                               ///< direction of travel
  std::array<Space<Complex<Wide>>, 2> fields;  ///< amplitudes along x, y, z

  explicit TracedWaves(const Space<Wide>& k_in) : k(k_in) {
    const auto axes = axes_of_light(k);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 3; ++j) fields[i][j] = {axes[i][j], Wide(0)};
  }

  /// Reflects them at an interface.
  /// @param normal its normal
  /// @param smallest_cosine of incidence that counts as such
  void reflect(const Space<Wide>& normal, const Wide& n_minus_1, const Wide& extinction,
               const Wide& smallest_cosine) {
    const Wide cosine = -dot_in_space(k, normal);
    const Space<Wide> k_in = k;
    for (std::size_t j = 0; j < 3; ++j) k[j] += 2 * cosine * normal[j];
    // Along the normal any axis is as good as another; x is normal to both panels.
    const bool along_normal = k_in[0] == 0 && k_in[1] * normal[2] == k_in[2] * normal[1];
    const Space<Wide> s = along_normal ? Space<Wide>{Wide(1), Wide(0), Wide(0)} : unit_normal(k_in, normal);
    const Space<Wide> p_in = unit_normal(k_in, s);
    const Space<Wide> p_out = unit_normal(k, s);
    const TextbookFresnel<Wide> r(n_minus_1, extinction, std::clamp(cosine, smallest_cosine, Wide(1)));
    for (Space<Complex<Wide>>& field : fields) {
      // r_p belongs to −p_out, as at normal incidence, where k × s turns over.
      const Complex<Wide> s_part = r.r_s * along(s, field);
      const Complex<Wide> p_part = r.r_p * along(p_in, field);
      for (std::size_t j = 0; j < 3; ++j) field[j] = s[j] * s_part - p_out[j] * p_part;
    }
  }

  /// Their amplitudes along the axes a, b of their present direction.
  std::array<TwoAmplitudes<Wide>, 2> amplitudes() const {
    const auto [a, b] = axes_of_light(k);
    return {TwoAmplitudes<Wide>{along(a, fields[0]), along(b, fields[0])},
            TwoAmplitudes<Wide>{along(a, fields[1]), along(b, fields[1])}};
  }

 private:
  static Complex<Wide> along(const Space<Wide>& axis, const Space<Complex<Wide>>& field) {
    return axis[0] * field[0] + axis[1] * field[1] + axis[2] * field[2];
  }
};

/// Stokes parameters of two amplitudes; see conventions.hpp.
template <class Wide>
std::array<Wide, 4> traced_stokes(const TwoAmplitudes<Wide>& e) {
  const Wide a = norm(e[0]);
  const Wide b = norm(e[1]);
  const Complex<Wide> mixed = Wide(2) * (e[0] * conj(e[1]));
  return {Wide(a + b), Wide(a - b), mixed.re, mixed.im};
}

/// What a train of mirrors makes of each polarisation.
template <class Wide>
struct TracedPolarization {
  std::array<TwoAmplitudes<Wide>, 2> columns;  ///< what becomes of unit amplitudes along a, and along b

  /// Stokes parameters of what becomes of a wave.
  std::array<Wide, 4> stokes(const TwoAmplitudes<Wide>& wave) const {
    return traced_stokes<Wide>({columns[0][0] * wave[0] + columns[1][0] * wave[1],
                                columns[0][1] * wave[0] + columns[1][1] * wave[1]});
  }

  /// The Mueller matrix, row by row, from what becomes of six polarisations.
  std::array<Wide, 16> mueller() const {
    const Wide one(1), none(0), diagonal = Wide(1) / 2;
    const auto real = [&](const Wide& x) { return Complex<Wide>{x, none}; };
    const auto opposite_pair = [&](const TwoAmplitudes<Wide>& plus, const TwoAmplitudes<Wide>& minus,
                                   const Wide& intensity, int sign) {
      const auto p = stokes(plus), m = stokes(minus);
      std::array<Wide, 4> column;
      for (std::size_t i = 0; i < 4; ++i) column[i] = (p[i] + sign * m[i]) / (2 * intensity);
      return column;
    };
    const TwoAmplitudes<Wide> a{real(one), real(none)}, b{real(none), real(one)};
    const TwoAmplitudes<Wide> up{real(diagonal), real(diagonal)}, down{real(diagonal), real(-diagonal)};
    // U + iV = 2 E_a E_b*: V > 0 where E_b lags behind E_a by −i.
    const TwoAmplitudes<Wide> right{real(diagonal), Complex<Wide>{none, Wide(-diagonal)}};
    const TwoAmplitudes<Wide> left{real(diagonal), Complex<Wide>{none, diagonal}};
    const std::array<std::array<Wide, 4>, 4> by_column{
        opposite_pair(a, b, one, 1), opposite_pair(a, b, one, -1), opposite_pair(up, down, diagonal, -1),
        opposite_pair(right, left, diagonal, -1)};
    std::array<Wide, 16> result;
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column) result[4 * row + column] = by_column[column][row];
    return result;
  }
};

}  // namespace vcavity::test
