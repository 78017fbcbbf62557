// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A variable of integration in which a pair of square roots next to the real axis is smooth.
///
/// Method. The branch points of √(x − c ∓ id) are those of x = c + d sinh t at t = ±iπ/2, where x turns back:
/// 1 + i sinh t = 2 sin²(π/4 + it/2), so that either root is an entire function of t. Nodes are drawn to c on the scale d
/// and thin out in proportion to the distance (Johnston & Elliott, "A sinh transformation for evaluating nearly singular
/// boundary element integrals", Int. J. Numer. Methods Eng. 62, 2005, use it for poles).
///
/// When not to use it: for branch points on the real axis; a `SineSubstitution` draws nodes to the end of a range there.

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// x = c + d sinh t, t a linear function of the variable of integration u; x and u both from −1 to 1.
class SinhSubstitution {
 public:
  /// @param centre c, also outside the range
  /// @param width d > 0
  SinhSubstitution(double centre, double width) : centre_(centre), width_(width) {}

  /// The value x and its derivative dx/du.
  /// @param u in [−1, 1], a number or a pack of them
  template <class Reals>
  std::array<Reals, 2> at(const Reals& u) const {
    using Real = scalar_t<Reals>;
    const auto [middle, half] = range<Real>();
    const Reals t = Reals(middle) + half * u;
    const Reals sine = detail::transformed(t, [](const Real& a) {
      using std::sinh;
      return Real(sinh(a));
    });
    const Reals cosine = detail::transformed(t, [](const Real& a) {
      using std::cosh;
      return Real(cosh(a));
    });
    return {Reals(Reals(Real(centre_)) + Real(width_) * sine), Reals((half * Real(width_)) * cosine)};
  }

  /// The point u of a singularity at x.
  std::complex<double> inverse(const std::complex<double>& x) const {
    return of(std::asinh((x - centre_) / width_));
  }

  /// The same where both square roots have changed their signs, as they do beyond t = iπ/2.
  std::complex<double> inverse_on_other_sheet(const std::complex<double>& x) const {
    return of(std::complex<double>(0, std::numbers::pi) - std::asinh((x - centre_) / width_));
  }

  friend bool operator==(const SinhSubstitution&, const SinhSubstitution&) = default;

 private:
  template <class Real>
  struct Range {
    Real middle, half;
  };
  /// Of t.
  template <class Real>
  Range<Real> range() const {
    using std::asinh;
    const Real low = asinh(Real((Real(-1) - Real(centre_)) / Real(width_)));
    const Real high = asinh(Real((Real(1) - Real(centre_)) / Real(width_)));
    return {(low + high) / Real(2), (high - low) / Real(2)};
  }
  std::complex<double> of(const std::complex<double>& t) const {
    const auto [middle, half] = range<double>();
    return (t - middle) / half;
  }

  double centre_, width_;
};

}  // namespace vcavity
