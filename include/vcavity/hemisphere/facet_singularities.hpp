// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What the singularities of a facet reflectance, as a function of a complex cosine, say about integrals over
/// directions: where to cut, in which variable to integrate, and how fast Legendre series fall off.
///
/// In both angles the variable of integration draws nodes to the ends of the range as far as the facet asks
/// for it: towards grazing incidence, near which the reflectance of a metal changes most, and towards
/// critical angles, where reflectances start like a square root. A little absorption moves that branch point
/// off the real axis and blurs the critical angle; it then stays close to the end of two pieces, whose series
/// fall off slowly in the end though they begin as if it were not there.

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/adaptive_quadrature.hpp"
#include "vcavity/numbers/sine_substitution.hpp"

namespace vcavity::detail {

/// An angle ψ at which a bounce passes the critical angle.
template <class Real>
struct CriticalAngle {
  Real psi;
  double cos_across;  ///< the cosine of incidence of that bounce at ψ = 0
};

template <class Real>
class FacetSingularities {
 public:
  /// @param facet that tells its singularities, or does not
  template <class Facet>
  explicit FacetSingularities(const Facet& facet)
      : critical_(critical_cosine_of<Real>(facet)), cosines_(singular_cosines_of(facet)) {
    if (is_cut())
      for (const std::complex<double>& cosine : cosines_)
        if (branch_ == 0.0 || std::abs(cosine - double_of(critical_)) < std::abs(branch_ - double_of(critical_)))
          branch_ = cosine;
    if (branch_ == 0.0) branch_ = double_of(critical_);
    if (branch_.imag() < 0) branch_ = std::conj(branch_);
  }

  /// Whether there is a critical angle.
  bool is_cut() const { return critical_ > Real(0); }

  /// The critical cosine, 0 if there is none.
  const Real& critical() const { return critical_; }

  /// The cosine of incidence below which no light is lost; 0 if there is none.
  Real total_below() const { return is_cut() && branch_.imag() == 0 ? critical_ : Real(0); }

  /// The ψ at which a bounce passes the critical angle.
  /// @param cos_across its cosine at ψ = 0, above the critical one
  CriticalAngle<Real> critical_angle(const Real& cos_across) const {
    using std::acos;
    return {acos(critical_ / cos_across), double_of(cos_across)};
  }

  /// How far off the real axis the branch point of a critical angle lies.
  double blur(const CriticalAngle<Real>& angle) const {
    return std::abs(std::acos(branch_ / angle.cos_across).imag());
  }

  /// A piece of the range of ψ.
  /// @param angles at which to beware, in ascending order; none of them inside, unless blurred
  QuadraturePiece<Real> along(const Real& low, const Real& high,
                              const std::vector<CriticalAngle<Real>>& angles) const {
    QuadraturePiece<Real> piece{low, high, low == Real(0) ? Symmetry::even : Symmetry::none, SineSubstitution(1)};
    if (cosines_.empty() || (!is_cut() && low > Real(0))) return piece;
    const bool even = low == Real(0);
    const double middle = even ? 0 : 0.5 * (double_of(low) + double_of(high));
    const double half = double_of(high) - middle;
    std::vector<std::complex<double>> singularities;
    const auto add = [&](const std::complex<double>& psi) { singularities.push_back((psi - middle) / half); };
    for (const std::complex<double>& cosine : cosines_) add(std::acos(cosine));
    bool ends_at_branch = false;
    const auto near = [&](const Real& end) {
      constexpr std::ptrdiff_t neighbours = 3;
      const auto at = std::lower_bound(angles.begin(), angles.end(), end,
                                       [](const auto& angle, const Real& psi) { return angle.psi < psi; });
      const auto first = at - std::min(neighbours, at - angles.begin());
      const auto last = at + std::min(neighbours, angles.end() - at);
      for (auto angle = first; angle != last; ++angle) {
        const std::complex<double> psi = std::acos(branch_ / angle->cos_across);
        constexpr double coincident = 1e-9;  // of the width
        if (std::abs(psi - double_of(low)) < coincident * half || std::abs(psi - double_of(high)) < coincident * half)
          ends_at_branch = true;
        else
          add(psi);
      }
    };
    if (is_cut()) {
      near(low);
      near(high);
    }
    const Convergence best = ends_at_branch ? convergence_in(SineSubstitution(1), singularities)
                                            : best_variable(singularities);
    piece.variable = best.variable;
    piece.decay = {best.rate, 2, 1};
    return piece;
  }

  /// A piece of the range of an angle across the groove.
  /// @param bounces for each bounce at the angle 0, its angle from the normal of the panel
  /// @param lit whether light is left where bounces pass the critical angle
  QuadraturePiece<Real> across(const Real& low, const Real& high, const std::vector<double>& bounces,
                               bool lit) const {
    QuadraturePiece<Real> piece{low, high, Symmetry::none, SineSubstitution(is_cut() ? 1 : 0)};
    if (cosines_.empty()) return piece;
    const double middle = 0.5 * (double_of(low) + double_of(high));
    const double half = 0.5 * (double_of(high) - double_of(low));
    std::vector<std::complex<double>> singularities;
    const auto add = [&](const std::complex<double>& angle) {
      const std::complex<double> x = (angle - middle) / half;
      constexpr double coincident = 1e-9;
      if (std::abs(x - 1.0) > coincident && std::abs(x + 1.0) > coincident) singularities.push_back(x);
    };
    for (const std::complex<double>& cosine : cosines_) {
      if (!lit && std::abs(cosine) == std::abs(branch_)) continue;
      for (const double bounce : bounces) {
        add(std::acos(cosine) - bounce);
        add(-std::acos(cosine) - bounce);
      }
    }
    // Where two bounces become critical together is a weak singularity at an end.
    const Convergence best =
        is_cut() ? convergence_in(SineSubstitution(1), singularities) : best_variable(singularities);
    piece.variable = best.variable;
    piece.decay = {best.rate, 2, is_cut() ? 0.4 : 1};
    return piece;
  }

  /// The singular cosines; empty if they are not known.
  const std::vector<std::complex<double>>& cosines() const { return cosines_; }

 private:
  static double double_of(const Real& x) { return static_cast<double>(x); }

  Real critical_;
  std::vector<std::complex<double>> cosines_;
  std::complex<double> branch_ = 0.0;  // of the square root at the critical angle
};

}  // namespace vcavity::detail
