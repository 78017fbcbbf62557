// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What is integrated over the hemisphere for a symmetric groove: its bounce series (bounce_series.hpp), with
/// the angle u of the ray as the variable across the groove.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "vcavity/groove/reflectance.hpp"
#include "vcavity/hemisphere/bounce_series.hpp"
#include "vcavity/hemisphere/facet_singularities.hpp"
#include "vcavity/hemisphere/kinks.hpp"
#include "vcavity/hemisphere/series_sum.hpp"
#include "vcavity/numbers/adaptive_quadrature.hpp"

namespace vcavity::detail {

/// The integrand Σ_m T_m(u) Π ρ over [0, α/2] × [0, π/2], of which the reflectance is 4/(π sin(α/2)) times the
/// integral with cos²ψ.
template <class Real, class Facet>
class CavityIntegrand {
 public:
  /// @param cavity, facet must outlive the integrand
  /// @param max_bounces light that needs more is left out
  CavityIntegrand(const Cavity<Real>& cavity, const Facet& facet, int max_bounces)
      : cavity_(&cavity),
        facet_(&facet),
        max_bounces_(max_bounces),
        singularities_(facet, is_narrow(cavity) ? AlongVariable::logarithmic : AlongVariable::angle,
                       decay_along(cavity)) {
    constexpr double enough_blur = 0.125;  // by trial: fewest evaluations
    take_as_smooth_beyond(enough_blur);
    // Grazing light is spread out in vain where it is reflected totally.
    if (singularities_.total_below() > Real(0)) singularities_.take(AlongVariable::angle);
  }

  /// What the integral with cos²ψ is to be multiplied by.
  Real norm() const { return Real(4) / (pi<Real>() * cavity_->sin_half()); }

  /// Whether reflectances change most towards grazing light along the groove.
  static bool is_narrow(const Cavity<Real>& cavity) {
    constexpr int many_bounces = 6;
    return cavity.max_bounces() > many_bounces;
  }

  /// How series along the groove fall off. Near grazing light all bounces of a ray have a pole of r_p² close to the same ψ:
  /// of most rays those that are upright, of some all but the flattest. In narrow grooves waves that interfere after
  /// many bounces show late in a series.
  static SeriesDecay decay_along(const Cavity<Real>& cavity) {
    constexpr bool is_wave = !std::invocable<const Facet&, const Real&>;
    if (is_narrow(cavity)) return {0, 2, is_wave ? 0.1 : 0.6};
    constexpr int many_poles = 5;
    if (cavity.max_bounces() >= many_poles) return {0, 2 * (cavity.max_bounces() - 1), 1};
    constexpr double nearly_upright = 0.9;
    return {0, 2 + 2 * static_cast<int>(nearly_upright / static_cast<double>(cavity.aperture())), 1};
  }

  /// Whether the range along the groove is cut at critical angles, which move with u.
  bool is_cut() const { return singularities_.is_cut(); }

  /// The part of the known rate of series across that the first order relies on. Where two bounces become critical
  /// together series fall off more slowly in the end, the more so the more bounces there are.
  double believed_across() const {
    constexpr int many_bounces = 12;
    if (!is_cut()) return 1;
    return cavity_->max_bounces() > many_bounces ? 0.5 : 0.8;
  }

  /// The highest first order across. What is singular there next to critical angles is weak after integration along the groove.
  std::size_t start_across() const {
    constexpr std::size_t usual = 24, for_few_digits = 12;
    if (is_rough_) return for_few_digits;
    return is_cut() ? usual : max_series_order;
  }

  /// The highest first order along the groove. Between critical angles there is often so little light that a low one will
  /// do, next to whatever singularities.
  std::size_t start_along() const {
    constexpr std::size_t usual = 12;
    return is_rough_ || singularities_.total_below() > Real(0) ? usual : max_series_order;
  }

  /// Cuts the range along the groove at no more places than this and begins with low orders, for a result of few digits.
  void take_cuts(std::size_t most) {
    most_cuts_ = most;
    is_rough_ = true;
    constexpr double enough_blur = 0.03;  // by trial: more directions that few nodes will do for
    take_as_smooth_beyond(enough_blur);
  }

  /// The width of the range of u.
  Real width() const { return cavity_->aperture() / Real(2); }

  /// How much the integral is off because of kinks that `pieces_across` does not cut at.
  Real left_uncut() const { return left_uncut_; }

  /// Whether each part in one piece is sin(width − u) times an even function of u.
  bool even_across() const { return is_narrow(*cavity_) && !is_cut() && !singularities_.cosines().empty(); }

  /// How far the singularities of a bounce are from any angle, up to 1.
  double singularity_across() const {
    double distance = 1;
    for (const std::complex<double>& cosine : singularities_.cosines()) {
      const std::complex<double> angle = std::acos(cosine);
      distance = std::min(distance, std::abs(angle - std::clamp(angle.real(), 0.0, std::numbers::pi / 2)));
    }
    return distance;
  }

  /// Upper bound on the integral over ψ at any u, for facets that reflect all light.
  static constexpr double largest_along = 1.6;  // π/4 times T_1 + T_2 + … ≤ 2

  /// A part of the integral across.
  struct Part {
    RaysAcross rays;
    int most_bounces;
    Real width;                                 ///< the range of u is from 0 to this, where the overlap is 0
    Real sign;                                  ///< with which the part is added to the others
    std::vector<QuadraturePiece<Real>> pieces;  ///< of that range
  };

  /// The parts of the integral across (bounce_series.hpp).
  /// @param negligible a part of the integral that may be neglected: kinks of less light are not looked at
  /// @param are_apart whether rays of most bounces make parts of their own, where their kinks would be seen; else all rays
  /// are integrated together from kink to kink
  std::vector<Part> parts_across(const Real& negligible, bool are_apart) {
    const Real half = cavity_->aperture() / Real(2);
    constexpr int few_bounces = 3;  // survived by light that is not negligible
    left_uncut_ = cavity_->max_bounces() > few_bounces ? light_of_longest_rays(negligible) : negligible;
    const bool are_kinks_seen = !(left_uncut_ < negligible);
    const auto [end, apex] = ends_of_rays();
    if (are_kinks_seen) left_uncut_ = Real(0);
    if (!are_kinks_seen || !are_apart || !(end > Real(0) && end < half))
      return {{RaysAcross::all, max_bounces_, half, Real(1), pieces_across(negligible, are_kinks_seen)}};
    const int most = cavity_->max_bounces();
    std::vector<Part> parts;
    const auto add = [&](RaysAcross rays, int bounces, const Real& width, int sign) {
      parts.push_back({rays, bounces, width, Real(sign), pieces_between({Real(0), width})});
    };
    add(RaysAcross::as_if_free, std::min(max_bounces_, most - 1), half, 1);
    if (max_bounces_ >= most) add(RaysAcross::single, most, end, 1);
    if (max_bounces_ >= most - 1) add(RaysAcross::single, most - 1, apex, -1);
    return parts;
  }

  /// The pieces of the range of u for all rays.
  /// @param negligible a part of the integral that may be neglected
  /// @param are_kinks_seen whether there are kinks where the longest rays end
  std::vector<QuadraturePiece<Real>> pieces_across(const Real& negligible, bool are_kinks_seen) {
    using std::acos;
    const Real half = cavity_->aperture() / Real(2);
    std::vector<Real> ends{Real(0), half};
    const auto add = [&](const Real& u) {
      if (u > Real(0) && u < half) ends.push_back(u);
    };
    if (are_kinks_seen)
      for (const Real& u : ends_of_rays()) add(u);
    critical_is_lit_ = singularities_.is_cut() && is_lit_at_critical_angle(negligible);
    if (critical_is_lit_) {
      const Real turns = acos(singularities_.critical()) / half;
      const Real beyond = turns - floor_of(turns);  // cos(u ± kα/2) is critical at either
      add(beyond * half);
      add((Real(1) - beyond) * half);
    }
    sort_angles(ends);
    return pieces_between(ends);
  }

  /// The parts of a piece for which the highest order does not do.
  std::vector<QuadraturePiece<Real>> halves_across(const QuadraturePiece<Real>& piece) const {
    const Real middle = (piece.low + piece.high) / Real(2);
    if (!(piece.low < middle && middle < piece.high)) return {};
    return {piece_across(piece.low, middle), piece_across(middle, piece.high)};
  }

  /// The pieces between ascending ends.
  std::vector<QuadraturePiece<Real>> pieces_between(const std::vector<Real>& ends) const {
    std::vector<QuadraturePiece<Real>> pieces;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) pieces.push_back(piece_across(ends[i], ends[i + 1]));
    return pieces;
  }

  QuadraturePiece<Real> piece_across(const Real& low, const Real& high) const {
    // Bounces at the angles u + kα/2; those count that come nearest to a singularity.
    const double half = static_cast<double>(cavity_->aperture()) / 2;
    const double middle = static_cast<double>(low + high) / 2;
    const double upright = std::numbers::pi / 2;
    const double most =
        std::min(std::min(max_bounces_, cavity_->max_bounces()) - 1.0, std::floor((upright - middle) / half));
    std::vector<double> bounces;
    for (const std::complex<double>& cosine : singularities_.cosines()) {
      const double nearest = std::abs(std::acos(cosine).real()) / half;
      for (int step = -1; step <= 2; ++step)
        bounces.push_back(std::clamp(std::floor(nearest) + step, 0.0, most) * half);
    }
    std::sort(bounces.begin(), bounces.end());
    bounces.erase(std::unique(bounces.begin(), bounces.end()), bounces.end());
    const std::size_t positive = bounces.size();
    for (std::size_t i = 0; i < positive; ++i) bounces.push_back(-bounces[i]);
    // Light on a flat surface bounces once, and as much of it from either side.
    const bool is_even = cavity_->max_bounces() == 1 && low == Real(0);
    return singularities_.across(low, high, bounces, critical_is_lit_,
                                 is_even ? Symmetry::even : Symmetry::none);
  }

  /// The integrand at one u, as a function of ψ.
  class Along {
   public:
    Along(const CavityIntegrand& integrand, const Part& part, const Real& u, const Real& negligible)
        : integrand_(&integrand),
          series_(*integrand.cavity_, u, part.most_bounces, part.rays),
          weight_(overlap(part, u)),
          negligible_(at_most(Real(negligible / at_least(weight_, negligible)), Real(0.1))) {
      if (integrand_->singularities_.is_cut()) find_critical_angles();
    }

    /// A direction by the variable along the groove, or a pack of them.
    template <class Reals>
    AlongDirection<Reals> direction(const Reals& x) const {
      return along_direction(integrand_->singularities_.variable(), x);
    }

    /// Bound on the integral beyond the last piece, and on what kinks between the cuts do.
    Real beyond() const {
      if (integrand_->singularities_.variable() == AlongVariable::angle) return uncut_;
      const Real cosine = least_cosine();
      return cosine * cosine * cosine * Real(2) / Real(3) + uncut_;  // T_1 + T_2 + … ≤ 2
    }

    /// The factor of the integral over ψ.
    Real weight() const { return weight_; }

    /// The pieces of the range of the variable along the groove.
    std::vector<QuadraturePiece<Real>> pieces() const {
      std::vector<Real> ends{Real(0)};
      const bool is_logarithmic = integrand_->singularities_.variable() == AlongVariable::logarithmic;
      const bool is_split = cuts_.empty() && is_logarithmic;
      if (is_split)
        for (const int part : {8, 4, 2}) ends.push_back(end() / Real(part));
      else if (!integrand_->singularities_.is_smooth_on_both_sides())
        for (const auto& angle : cuts_) ends.push_back(angle.at);
      else
        add_ends_around_cuts(ends, is_logarithmic);
      ends.push_back(end());
      std::vector<QuadraturePiece<Real>> pieces;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (ends[i] < ends[i + 1]) pieces.push_back(piece(ends[i], ends[i + 1]));
      if (is_split) guess_orders(pieces);
      return pieces;
    }

    std::vector<QuadraturePiece<Real>> halves(const QuadraturePiece<Real>& whole) const {
      const Real middle = (whole.low + whole.high) / Real(2);
      if (!(whole.low < middle && middle < whole.high)) return {};
      return {piece(whole.low, middle), piece(middle, whole.high)};
    }

    QuadraturePiece<Real> piece(const Real& low, const Real& high) const {
      QuadraturePiece<Real> result = integrand_->singularities_.along(low, high, angles_);
      // The most upright bounce of all rays is the only one of those that bounce once.
      const Real most_upright = series_[1].ends.cosine_first * direction(low).cosine;
      constexpr std::size_t enough = 8;  // for cos²ψ
      if (most_upright <= integrand_->singularities_.total_below()) result.order = enough;
      return result;
    }

    /// The integrand for one ψ or a pack of them.
    /// @param facet the facet, or the same for packs
    /// @param sine, cosine of ψ
    /// @param max_terms the most bounces followed
    template <class AnyFacet, class Reals>
    auto operator()(const AnyFacet& facet, const Reals& sine, const Reals& cosine, int max_terms) const {
      // Towards grazing light the integrand weighs little.
      const Real most = largest(cosine);
      const Real weight =
          most * most *
          (integrand_->singularities_.variable() == AlongVariable::angle ? Real(1) : Real(8) * most);
      return sum_of_series(series_, facet, sine, cosine,
                           {negligible_ / at_least(weight, negligible_),
                            integrand_->singularities_.total_below(), max_terms, !integrand_->is_cut()});
    }

   private:
    /// What the series leaves out of the overlap: single rays are as many at any u.
    static Real overlap(const Part& part, const Real& u) {
      using std::sin;
      return part.rays == RaysAcross::single ? Real(sin(part.width - u)) : Real(1);
    }

    /// Blurred critical angles lie within pieces, each in the middle of its own: there is a variable in which it is smooth on
    /// either side (sinh_substitution.hpp).
    void add_ends_around_cuts(std::vector<Real>& ends, bool is_logarithmic) const {
      Real last(0);
      for (const auto& angle : cuts_) {
        ends.push_back((last + angle.at) / Real(2));
        last = angle.at;
      }
      const Real beyond = last + (last - ends.back());
      if (!cuts_.empty() && beyond < end()) ends.push_back(beyond);
      // Towards grazing light there is more to see.
      const Real grazing = end() / Real(2);
      if (is_logarithmic && ends.back() < grazing) ends.push_back(grazing);
    }

    Real least_cosine() const {
      using std::cbrt;
      return at_most(Real(cbrt(negligible_)), Real(0.5));
    }
    Real end() const {
      return integrand_->singularities_.variable() == AlongVariable::angle
                 ? Real(pi<Real>() / Real(2))
                 : along_of_cosine(AlongVariable::logarithmic, least_cosine());
    }

    /// Orders that usually suffice for fields, whose interference singularities of the facet do not tell.
    void guess_orders(std::vector<QuadraturePiece<Real>>& pieces) const {
      if constexpr (!std::invocable<const Facet&, const Real&>) {
        const double digits = -std::log10(static_cast<double>(negligible_));
        for (auto& piece : pieces)
          piece.order = static_cast<std::size_t>((piece.low == Real(0) ? 2.2 : 1.8) * digits) / 4 * 4;
      }
    }

    /// The critical angles of all bounces, as far as light comes there.
    void find_critical_angles() {
      const FacetSingularities<Real>& facet = integrand_->singularities_;
      std::vector<CriticalAngle<Real>> descending, nearly;
      const auto add = [&](const Real& cos_across) {
        if (!(cos_across > facet.critical())) {
          // Not critical at any ψ, but next to it at ψ = 0. Where critical angles are sharp nothing is lost there, nor
          // do phases matter: such bounces are the first and the last ones of a ray, and their Jones matrices unitary.
          if (cos_across > Real(0) && !facet.is_sharp()) nearly.push_back(facet.critical_angle(cos_across));
          return false;
        }
        descending.push_back(facet.critical_angle(cos_across));
        return true;
      };
      for (int m = 1; m <= series_.size(); ++m) {
        const auto& term = series_[m];
        const bool first_is_critical = add(term.ends.cosine_first);
        const bool last_is_critical = m > 1 && add(term.ends.cosine_last);
        if (!first_is_critical && !last_is_critical && m > 1) break;
        constexpr int seldom = 8;
        if (m % seldom == 0 && !descending.empty() &&
            integrand_->light_after(series_, m, direction(descending.back().at).cosine, negligible_) <
                negligible_)
          break;
      }
      std::sort(descending.begin(), descending.end(),
                [](const auto& a, const auto& b) { return a.at < b.at; });
      angles_ = descending;
      // Nearer to each other than they are sharp, or than the tolerance can tell, one cut does for several.
      const Real indistinct = negligible_ / Real(4);
      for (const auto& angle : angles_) {
        if (!(angle.at < end())) continue;
        const Real apart = cuts_.empty() ? end() : Real(angle.at - cuts_.back().at);
        if (apart > indistinct && static_cast<double>(apart) > 2 * std::abs(angle.branch.imag()))
          cuts_.push_back(angle);
        if (!(apart > indistinct)) uncut_ = Real(4) * indistinct;  // of an integrand from 0 to 2, and back
      }
      // Where there are more than are wanted, pieces that need it are halved.
      const std::size_t stride = cuts_.size() / integrand_->most_cuts_ + 1;
      if (stride > 1) {
        std::size_t kept = 0;
        for (std::size_t i = stride - 1; i < cuts_.size(); i += stride) cuts_[kept++] = cuts_[i];
        cuts_.resize(kept);
      }
      angles_.insert(angles_.begin(), nearly.begin(), nearly.end());
    }

    const CavityIntegrand* integrand_;
    BounceSeries<Real> series_;
    Real weight_;
    Real negligible_;
    Real uncut_{0};                                   // error from kinks between the cuts
    std::vector<CriticalAngle<Real>> angles_, cuts_;  // ascending
  };

  /// @param part that this u belongs to
  /// @param negligible part of the integral over ψ
  Along at(const Part& part, const Real& u, const Real& negligible) const {
    return Along(*this, part, u, negligible);
  }

 private:
  /// Cuts at no critical angle, if they are blurred over more than this part of the angle between two bounces: then all is
  /// smooth across.
  void take_as_smooth_beyond(double part) {
    if (singularities_.blur() > part * static_cast<double>(cavity_->aperture()))
      singularities_.take_as_smooth();
  }

  /// Where the rays of most bounces end, and where the overlap meets the apex.
  std::array<Real, 2> ends_of_rays() const {
    const Real half = cavity_->aperture() / Real(2);
    const Real longest = Real(cavity_->max_bounces());
    return {pi<Real>() / Real(2) - (longest - Real(1)) * half, longest * half - pi<Real>() / Real(2)};
  }

  /// Upper bound on what is off where the kinks of the two largest numbers of bounces are not looked at; there are no
  /// others in u. It is their part of the integral or, with a kink next to an end of the range, the part beyond it. Such
  /// light survives almost along the groove, or where facets reflect nearly all of it; how much does is looked up for a few
  /// directions beyond those where it is negligible, because metals reflect least in between.
  Real light_of_longest_rays(const Real& negligible) const {
    using std::cbrt;
    using std::sqrt;
    const Real aperture = cavity_->aperture();
    const auto [end, apex] = ends_of_rays();
    const Real beyond = at_least(at_most(end, apex), Real(0));
    const Real width = aperture * at_most(aperture, Real(2) * beyond);  // of both: ∫ T du, or a node times T
    if (!(width > Real(0))) return Real(0);
    const Real cosine = cbrt(Real(negligible / width));
    const BounceSeries<Real> series(*cavity_, Real(0), max_bounces_);
    if (series.size() < cavity_->max_bounces() - 1) return Real(0);
    if (!(cosine < Real(1))) return width;
    Real left(0);
    const Real apart = Real(4);
    for (Real along = cosine; along < Real(1); along *= apart)
      left = at_least(left, light_after(series, series.size() - 1, along, negligible));
    left = at_least(left, light_after(series, series.size() - 1, Real(1), negligible));
    return width * (cosine * cosine * cosine / Real(3) + left);
  }

  static Real floor_of(const Real& x) {
    using std::floor;
    return floor(x);
  }

  /// What is left of light after m bounces, or less than is negligible.
  /// @param cosine of ψ
  Real light_after(const BounceSeries<Real>& series, int m, const Real& cosine,
                   const Real& negligible) const {
    using std::sqrt;
    const Real sine = sqrt(at_least(Real((Real(1) - cosine) * (Real(1) + cosine)), Real(0)));
    const auto at = [&](const Real& cos_across, const Real& sin_across, int parity) {
      return reflect(*facet_, Bounce<Real>{cos_across * cosine, -sin_across * cosine, sine,
                                           parity % 2 == 0 ? Panel::one : Panel::two, 1});
    };
    value_t<Facet, Real> product(1);
    Real left(1);
    for (int i = 2 - m % 2; i <= m && !(left < negligible); i += 2) {
      const auto& term = series[i];
      product = at(term.ends.cosine_first, term.ends.sine_first, i / 2) * product;
      if (i > 1) product = product * at(term.ends.cosine_last, term.ends.sine_last, i / 2 + i - 1);
      left = static_cast<Real>(light_left(product));
    }
    return left;
  }

  /// Whether light is left where a bounce passes the critical angle at ψ = 0.
  bool is_lit_at_critical_angle(const Real& negligible) const {
    using std::acos;
    const Real turns = acos(singularities_.critical()) / (cavity_->aperture() / Real(2));
    constexpr int too_many = 100'000;
    if (turns > Real(too_many)) return false;
    const BounceSeries<Real> series(*cavity_, Real(0), max_bounces_);
    const int bounces = std::min(static_cast<int>(turns), series.size());
    return !(light_after(series, bounces, Real(1), negligible) < negligible);
  }

  const Cavity<Real>* cavity_;
  const Facet* facet_;
  int max_bounces_;
  FacetSingularities<Real> singularities_;
  Real left_uncut_{0};
  bool critical_is_lit_ = false, is_rough_ = false;
  std::size_t most_cuts_ = std::numeric_limits<std::size_t>::max() / 2;
};

}  // namespace vcavity::detail
