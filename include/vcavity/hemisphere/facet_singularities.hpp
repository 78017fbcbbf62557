// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What the singularities of a facet reflectance, as a function of a complex cosine, say about integrals over
/// directions: where to cut, in which variable to integrate, and how fast Legendre series fall off.
///
/// In both angles the variable of integration draws nodes to the ends of the range as far as the facet asks
/// for it: towards grazing incidence, near which the reflectance of a metal changes most, and towards
/// critical angles, where reflectances start like a square root. A little absorption moves that branch point
/// off the real axis and blurs the critical angle; nodes are then drawn to it in a variable in which it is smooth on
/// either side (sinh_substitution.hpp), and what stays close to the range are those of other bounces. Blurred over more
/// than the angle between two bounces, it is a singularity like any other.

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/adaptive_quadrature.hpp"
#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/sine_substitution.hpp"
#include "vcavity/numbers/sinh_substitution.hpp"

namespace vcavity::detail {

/// The variable along the groove: ψ itself, or t with sin ψ = tanh t, cos ψ = 1/cosh t, which spreads out grazing
/// light. In narrow grooves reflectances change on the scale of cos ψ ~ α, and as functions of t on the scale 1.
enum class AlongVariable { angle, logarithmic };

/// A direction by the variable along the groove, or a pack of them.
template <class Reals>
struct AlongDirection {
  Reals sine, cosine;  ///< of ψ
  Reals slope;         ///< dψ over that of the variable
};

template <class Reals>
AlongDirection<Reals> along_direction(AlongVariable variable, const Reals& x) {
  using Real = scalar_t<Reals>;
  if (variable == AlongVariable::angle) {
    const auto [sine, cosine] = sine_and_cosine(x);
    return {sine, cosine, Reals(Real(1))};
  }
  const Reals cosine = transformed(x, [](const Real& a) {
    using std::cosh;
    return Real(Real(1) / cosh(a));
  });
  const Reals sine = transformed(x, [](const Real& a) {
    using std::tanh;
    return Real(tanh(a));
  });
  return {sine, cosine, cosine};
}

/// The variable along the groove for a cosine of ψ.
template <class Real>
Real along_of_cosine(AlongVariable variable, const Real& cosine) {
  using std::acos;
  using std::acosh;
  return variable == AlongVariable::angle ? acos(cosine) : acosh(Real(1) / cosine);
}
/// The same for a singularity; most are real.
inline std::complex<double> along_of_cosine(AlongVariable variable, const std::complex<double>& cosine) {
  const bool is_angle = variable == AlongVariable::angle;
  if (cosine.imag() != 0 || !(cosine.real() > 0))
    return is_angle ? std::acos(cosine) : std::acosh(1.0 / cosine);
  const double x = cosine.real();
  if (x <= 1) return along_of_cosine(variable, x);
  return {0, is_angle ? std::acosh(x) : std::acos(1 / x)};
}

/// Where a bounce passes the critical angle.
template <class Real>
struct CriticalAngle {
  Real at;                      ///< the variable along the groove
  double cos_across;            ///< the cosine of incidence of that bounce at ψ = 0
  std::complex<double> branch;  ///< where its square root is 0: off the real axis if there is absorption
};

template <class Real>
class FacetSingularities {
 public:
  /// @param facet that tells its singularities, or does not
  /// @param variable along the groove
  /// @param decay of series along the groove; its rate is not used
  template <class Facet>
  FacetSingularities(const Facet& facet, AlongVariable variable, const SeriesDecay& decay)
      : variable_(variable),
        decay_(decay),
        critical_(critical_cosine_of<Real>(facet)),
        is_cut_(critical_ > Real(0)),
        cosines_(singular_cosines_of(facet)) {
    if (is_cut())
      for (const std::complex<double>& cosine : cosines_)
        if (branch_ == 0.0 ||
            std::abs(cosine - double_of(critical_)) < std::abs(branch_ - double_of(critical_)))
          branch_ = cosine;
    if (branch_ == 0.0) branch_ = double_of(critical_);
    if (branch_.imag() < 0) branch_ = std::conj(branch_);
    brewster_ = 1.0 / std::sqrt(2.0 - branch_ * branch_);
  }

  /// Takes another variable along the groove.
  void take(AlongVariable variable) { variable_ = variable; }

  /// Takes critical angles as no more than singularities off the real axis, from now on.
  void take_as_smooth() { is_cut_ = false; }

  /// How far from the real axis the angle of incidence of the branch point is: over that a critical angle is blurred.
  double blur() const { return is_cut() ? std::abs(std::acos(branch_).imag()) : 0; }

  /// Whether there is a critical angle to cut at.
  bool is_cut() const { return is_cut_; }

  /// The critical cosine, 0 if there is none.
  const Real& critical() const { return critical_; }

  /// The cosine of incidence below which no light is lost; 0 if there is none.
  Real total_below() const { return is_cut() && is_sharp() ? critical_ : Real(0); }

  /// Where a bounce passes the critical angle.
  /// @param cos_across its cosine at ψ = 0; not above the critical one it passes at none, and next to 0
  CriticalAngle<Real> critical_angle(const Real& cos_across) const {
    const double cosine = double_of(cos_across);
    const bool is_passed = cos_across > critical_;
    const Real at = is_passed ? along_of_cosine(variable_, Real(critical_ / cos_across)) : Real(0);
    if (is_passed && is_sharp()) return {at, cosine, double_of(at)};
    return {at, cosine, along_of_cosine(variable_, branch_ / cosine)};
  }

  /// Whether critical angles are not blurred by absorption.
  bool is_sharp() const { return branch_.imag() == 0; }

  /// Whether they are blurred enough for a variable in which they are smooth on either side; else it pays to cut at them, as
  /// if they were sharp.
  bool is_smooth_on_both_sides() const {
    constexpr double enough = 1e-8;  // by trial: fewest evaluations
    return blur() > enough;
  }

  /// A piece of the range of the variable along the groove.
  /// @param angles at which to beware, in ascending order; none of them inside, unless blurred
  QuadraturePiece<Real> along(const Real& low, const Real& high,
                              const std::vector<CriticalAngle<Real>>& angles) const {
    QuadraturePiece<Real> piece{low, high, low == Real(0) ? Symmetry::even : Symmetry::none,
                                SineSubstitution(1)};
    const bool logarithmic = variable_ == AlongVariable::logarithmic;
    if (cosines_.empty() || (!is_cut() && !logarithmic && low > Real(0))) return piece;
    const bool even = low == Real(0);
    const double middle = even ? 0 : 0.5 * (double_of(low) + double_of(high));
    const double half = double_of(high) - middle;
    std::vector<std::complex<double>> singularities;
    const auto add = [&](const std::complex<double>& x) { singularities.push_back((x - middle) / half); };
    for (const std::complex<double>& cosine : cosines_) {
      if (cosine == 0.0) continue;  // index 1: there is no branch point
      if (is_cut() && std::abs(cosine) == std::abs(branch_))
        continue;  // that of each bounce counts, see below
      const std::complex<double> at = along_of_cosine(variable_, cosine);
      // Bounces across the groove are less upright, which moves singularities towards smaller t.
      add(logarithmic ? std::complex<double>(std::clamp(middle, 0.0, std::max(at.real(), 0.0)), at.imag())
                      : at);
    }
    // Sums over ever more bounces converge as long as light loses by a bounce, Re cos ψ > 0.
    if (logarithmic) add({middle, std::numbers::pi / 2});
    bool ends_at_branch = false;
    std::vector<Blurred> blurred;
    double beyond = std::numeric_limits<double>::infinity();
    const auto near = [&](const Real& end) {
      const std::ptrdiff_t neighbours = is_sharp() ? 2 : 3;
      const auto next = std::lower_bound(angles.begin(), angles.end(), end,
                                         [](const auto& angle, const Real& x) { return angle.at < x; });
      const auto first = next - std::min(neighbours, next - angles.begin());
      const auto last = next + std::min(neighbours, angles.end() - next);
      for (auto angle = first; angle != last; ++angle) {
        const std::complex<double>& at = angle->branch;
        constexpr double coincident = 1e-9;  // of the width
        const bool ends_low = std::abs(at - double_of(low)) < coincident * half;
        const bool ends_high = std::abs(at - double_of(high)) < coincident * half;
        if (!ends_low && !ends_high) {
          const std::complex<double> brewster = along_of_cosine(variable_, brewster_ / angle->cos_across);
          if (is_smooth_on_both_sides())
            blurred.push_back({(at - middle) / half, (brewster - middle) / half});
          add(at);
          continue;
        }
        // The square root is smooth in the variable of integration, which goes on to its other sign beyond the end. There
        // the Brewster angle, at which r_p = 0, is a pole.
        ends_at_branch = true;
        const std::complex<double> brewster = along_of_cosine(variable_, brewster_ / angle->cos_across);
        const std::complex<double> u = SineSubstitution(1).inverse((brewster - middle) / half);
        beyond = std::min(beyond, convergence_rate(half_axis(2.0 - (ends_high ? u : -u))));
      }
    };
    if (is_cut()) {
      near(low);
      near(high);
    }
    const Convergence best =
        ends_at_branch ? convergence_in(SineSubstitution(1), singularities) : best_variable(singularities);
    piece.variable = best.variable;
    piece.decay = decay_;
    piece.decay.rate = std::min(best.rate, beyond);
    if (!even) draw_to_blurred(piece, singularities, blurred);
    return piece;
  }

  /// A piece of the range of an angle across the groove.
  /// @param bounces for each bounce at the angle 0, its angle from the normal of the panel
  /// @param lit whether light is left where bounces pass the critical angle
  /// @param symmetry about `low`
  QuadraturePiece<Real> across(const Real& low, const Real& high, const std::vector<double>& bounces,
                               bool lit, Symmetry symmetry) const {
    QuadraturePiece<Real> piece{low, high, symmetry, SineSubstitution(is_cut() ? 1 : 0)};
    if (cosines_.empty()) return piece;
    const double start = symmetry == Symmetry::even ? -double_of(high) : double_of(low);
    const double middle = 0.5 * (start + double_of(high));
    const double half = 0.5 * (double_of(high) - start);
    std::vector<std::complex<double>> singularities;
    std::vector<Blurred> blurred;
    for (const std::complex<double>& cosine : cosines_) {
      const bool is_branch = is_cut() && std::abs(cosine) == std::abs(branch_);
      if (!lit && is_branch) continue;
      const std::complex<double> singular = std::acos(cosine);
      for (const double bounce : bounces)
        for (const double side : {1.0, -1.0}) {
          std::complex<double> angle = side * singular - bounce;
          constexpr double coincident = 1e-9;
          if (is_branch && (std::abs(angle - start) < coincident * half ||
                            std::abs(angle - double_of(high)) < coincident * half))
            angle = 2.0 * angle - (side * std::acos(brewster_) - bounce);  // as in `along`
          else if (is_branch && is_smooth_on_both_sides())
            blurred.push_back(
                {(angle - middle) / half, (side * std::acos(brewster_) - bounce - middle) / half});
          singularities.push_back((angle - middle) / half);
        }
    }
    // Where two bounces become critical together is a weak singularity at an end.
    const Convergence best =
        is_cut() ? convergence_in(SineSubstitution(1), singularities) : best_variable(singularities);
    piece.variable = best.variable;
    piece.decay = {best.rate, 2, is_cut() ? 0.4 : 1};
    if (symmetry == Symmetry::none) draw_to_blurred(piece, singularities, blurred);
    return piece;
  }

  /// The variable along the groove.
  AlongVariable variable() const { return variable_; }

  /// The singular cosines; empty if they are not known.
  const std::vector<std::complex<double>>& cosines() const { return cosines_; }

 private:
  /// A branch point next to the range, and the Brewster angle of that bounce.
  struct Blurred {
    std::complex<double> branch, brewster;
  };

  /// Takes the variable in which one of the blurred critical angles is smooth, if that is the best of all.
  static void draw_to_blurred(QuadraturePiece<Real>& piece,
                              const std::vector<std::complex<double>>& singularities,
                              const std::vector<Blurred>& blurred) {
    for (const Blurred& own : blurred) {
      if (own.branch.imag() == 0.0) continue;  // nowhere critical
      const SinhSubstitution variable(own.branch.real(), std::abs(own.branch.imag()));
      double nearest = half_axis(variable.inverse_on_other_sheet(own.brewster));
      for (const std::complex<double>& other : singularities)
        if (other != own.branch) nearest = std::min(nearest, half_axis(variable.inverse(other)));
      const double rate = convergence_rate(nearest);
      if (!(rate > piece.decay.rate)) continue;
      piece.variable = variable;
      piece.decay.rate = rate;
    }
  }

  static double double_of(const Real& x) { return static_cast<double>(x); }

  AlongVariable variable_;
  SeriesDecay decay_;
  Real critical_;
  bool is_cut_;
  std::vector<std::complex<double>> cosines_;
  std::complex<double> branch_ = 0.0;    // of the square root at the critical angle
  std::complex<double> brewster_ = 0.0;  // the cosine at which r_p = 0
};

}  // namespace vcavity::detail
