// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Which effects a groove calls for: the cheapest model whose reflectance lies within a tolerance of the full
/// physics, which is `polarized(facet)` with all bounces.
///
/// Method. Let a lobe of m bounces have the s and p reflectances a_j ≥ b_j. Its exact reflectance for
/// unpolarised light, with any planes of incidence, differs from the unpolarised product by no more than the
/// product of separate polarisations does,
///
///     |½‖J‖² − Π ½(a_j + b_j)|  ≤  ½(Π a_j + Π b_j) − Π ½(a_j + b_j),
///
/// because the intensity I and the polarised part P of the light obey I' ≤ ρ I + δ P and P' ≤ δ I + ρ P with
/// ρ = ½(a + b), δ = ½(a − b), and aligned planes attain equality. So the right-hand side bounds the error of
/// leaving out polarisation, and Σ weight · ½(Π a_j + Π b_j) over the longer lobes that of a cut-off. Both
/// are integrated for diffuse light, and searched on a grid for the worst direction.
///
/// When not to use it: for facets that depend on more than the angle of incidence.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcavity/hemisphere/bihemispherical.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/polarization/polarization.hpp"

namespace vcavity {

/// Where a plan has to hold.
enum class Illumination {
  collimated,  ///< in every direction: directional reflectance, images
  diffuse      ///< on the mean over the hemisphere: bi-hemispherical reflectance
};

/// Bounds on absolute errors of the reflectance.
struct ErrorBounds {
  double polarization;  ///< of leaving out polarisation; 0 if it is kept
  double bounces;       ///< of leaving out long ways; 0 if none is
  double rounding;      ///< of the arithmetic
  double quadrature;    ///< allowed to the quadrature of the bi-hemispherical reflectance; 0 for directions

  double total() const { return polarization + bounces + rounding + quadrature; }
};

/// The cheapest way to a reflectance within a tolerance.
struct EffectsPlan {
  bool polarization;      ///< whether polarisation has to be followed
  int max_bounces;        ///< bounces that count, or `all_bounces`
  bool single_precision;  ///< whether float suffices
  ErrorBounds bounds;     ///< what this leaves out
};

namespace detail {

/// The largest cut-off that is considered, other than all bounces.
inline constexpr std::size_t longest_cutoff = 24;

/// Bounds on the errors of leaving out: [K − 1] for the ways of more than K bounces, and last for
/// polarisation.
using Omissions = Pack<double, longest_cutoff + 1>;

/// A way of light: its bounces, its reflectance in either polarisation and in the paper's model.
struct TriedWay {
  using value_type = double;

  std::size_t bounces;
  double s, p, mean;

  TriedWay() = default;
  TriedWay(std::size_t count, double s_part, double p_part, double unpolarized_part)
      : bounces(count), s(s_part), p(p_part), mean(unpolarized_part) {}
  explicit TriedWay(int light) : bounces(0), s(light), p(light), mean(light) {}

  friend TriedWay operator*(const TriedWay& a, const TriedWay& b) {
    return {a.bounces + b.bounces, a.s * b.s, a.p * b.p, a.mean * b.mean};
  }
  friend double largest(const TriedWay& way) { return at_least(way.s, way.p); }

  /// What is lost with this way.
  friend Omissions power(const TriedWay& way) {
    const double separate = 0.5 * (way.s + way.p);
    Omissions errors(0.0);
    for (std::size_t most = 1; most <= longest_cutoff && most < way.bounces; ++most)
      errors[most - 1] = separate;
    errors[longest_cutoff] = separate - way.mean;
    return errors;
  }
};

/// Facet reflectance for `TriedWay`. As s counts the larger reflectance, whichever polarisation it belongs to: under
/// films that may be p, and of one bounce to the next the other one.
template <FieldReflector<double> Facet>
class TriedFacet {
 public:
  explicit TriedFacet(const Facet& facet) : facet_(facet) {}
  TriedWay operator()(double cos_theta_i) const {
    const auto amplitudes = facet_.amplitudes(cos_theta_i);
    const double s = norm(amplitudes.r_s), p = norm(amplitudes.r_p);
    return {1, at_least(s, p), at_most(s, p), 0.5 * (s + p)};
  }
  double critical_cosine() const { return critical_cosine_of<double>(facet_); }
  auto singular_cosines() const
    requires requires(const Facet& facet) { facet.singular_cosines(); }
  {
    return facet_.singular_cosines();
  }

 private:
  const Facet& facet_;
};

/// Angles θ' for a search: the kinks of the weights, where these have their extremes, and some between them.
/// @param ends the kinks, ascending, with both ends of the range
inline std::vector<double> angles_across(const std::vector<double>& ends) {
  constexpr double step = 0.015;
  constexpr std::size_t most_kinks = 256;
  const std::size_t stride = 1 + ends.size() / most_kinks;
  std::vector<double> angles{ends.back()};
  for (std::size_t i = 0; i + 1 < ends.size(); i += stride) {
    const double width = ends[std::min(i + stride, ends.size() - 1)] - ends[i];
    const int pieces = 2 + static_cast<int>(width / step);
    for (int j = 0; j < pieces; ++j) angles.push_back(ends[i] + j * width / pieces);
  }
  return angles;
}

/// The largest errors over the directions of a grid, enlarged by a fifth for what lies between its points.
/// Towards grazing reflectances change with the logarithm of cos ψ, and so does the grid.
/// @param groove or another shape with a directional reflectance
/// @param tried its facets, each a `TriedFacet`
/// @param angles θ' of the grid
template <class Groove, class Facets>
Omissions worst_omissions(const Groove& groove, const Facets& tried, const std::vector<double>& angles) {
  constexpr int steps_along = 96;
  constexpr int steps_grazing = 48;
  constexpr double margin = 1.2;
  const double half_pi = pi<double>() / 2;
  Omissions worst(0.0);
  const auto try_direction = [&](double theta, double sin_psi, double cos_psi) {
    const Vec3<double> e{sin_psi, cos_psi * std::sin(theta), cos_psi * std::cos(theta)};
    const Omissions here = margin * directional_reflectance(groove, e, tried);
    worst = select(worst >= here, worst, here);
  };
  for (const double theta : angles) {
    for (int j = 0; j < steps_along; ++j) {
      const double psi = static_cast<double>(j) / steps_along * half_pi;
      try_direction(theta, std::sin(psi), std::cos(psi));
    }
    for (int j = 0; j < steps_grazing; ++j) {
      const double cos_psi = std::exp(-3 - 12.0 * j / steps_grazing);
      try_direction(theta, std::sqrt((1 - cos_psi) * (1 + cos_psi)), cos_psi);
    }
  }
  return worst;
}

/// The errors of diffuse reflectance, to `tolerance`.
template <class Facet>
Omissions mean_omissions(const Cavity<double>& cavity, const Facet& facet, double tolerance) {
  const auto errors = bihemispherical_reflectance(cavity, TriedFacet<Facet>(facet), tolerance);
  return errors.value + Omissions(errors.error);
}

/// Bound on the rounding error of the reflectance at one bounce in arithmetic of a given ε.
///
/// With m the contrast, w² = m + c² and c² + |w|² ≥ |m|: a change of c alone moves r_s by at most 2/√|m|
/// times as much, one of w² alone by 1/(2|w|²) times as much, and r_p at most √(1 + |m|) times further, which
/// it does towards grazing on strong metals. Where w passes 0, at a critical angle, w itself is uncertain by
/// √ε.
inline double rounding_per_bounce(const Complex<double>& contrast, double epsilon) {
  const double modulus = std::sqrt(norm(contrast));
  if (modulus == 0) return 0;  // nothing is reflected, whatever the arithmetic
  // The smallest |w²| over all cosines c.
  const double c2 = at_most(at_least(-contrast.re, 0.0), 1.0);
  const double smallest_w2 = std::hypot(contrast.re + c2, contrast.im);
  constexpr double few = 4;  // c and w² carry some ε each
  const double smooth = epsilon * (1 + 2 * std::sqrt(1 + modulus) + 4 / std::sqrt(modulus));
  const double critical =
      at_most(epsilon * (1 + modulus) / smallest_w2, 2 * std::sqrt(epsilon * (1 + modulus) / modulus));
  return few * (smooth + critical);
}

/// Bound on the part of diffuse light that the facets of a strong mirror absorb in all bounces together, and so on any
/// error of its reflectance. Of Lambertian light a plane surface of large |n| absorbs 16/(3|n|) or less, the mean of
/// 4c/|n| for s and of 4/(c|n|) for p light; and nowhere in the groove is there more light than that of the sky.
inline double mirror_bound(const Cavity<double>& cavity, const Complex<double>& contrast) {
  const double modulus = std::sqrt(std::sqrt(norm(contrast)));  // |n|, but for 1
  constexpr double strong = 1e6;
  if (!(modulus > strong)) return 1;
  constexpr double few = 8;  // rounding of a reflectance near 1
  return at_most((6 / modulus + few * std::numeric_limits<double>::epsilon()) * cavity.inverse_sin_half(),
                 1.0);
}

/// The bound on rounding for a facet without such a formula, measured: the largest difference of its amplitudes to those
/// in long double, on a grid of cosines that is finest at grazing and around the critical angle.
template <class Real, class Facet>
double measured_rounding_per_bounce(const Facet& facet) {
  constexpr int steps = 1024;
  constexpr double few = 4;  // what the grid may have missed
  const auto rounded = facet.template in<Real>();
  const auto exact = facet.template in<long double>();
  double largest = 0;
  const auto measure = [&](double cosine) {
    const Real c = static_cast<Real>(cosine);
    const auto found = rounded.amplitudes(c);
    const auto expected = exact.amplitudes(static_cast<long double>(c));
    const auto difference = [](const Complex<Real>& a, const Complex<long double>& b) {
      return static_cast<double>(norm(Complex<long double>{a.re - b.re, a.im - b.im}));
    };
    largest = std::max({largest, difference(found.r_s, expected.r_s), difference(found.r_p, expected.r_p)});
  };
  const double epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
  for (int i = 1; i <= steps; ++i) {
    const double fraction = static_cast<double>(i) / steps;
    measure(fraction);
    measure(std::pow(fraction, 4));
  }
  const double critical = static_cast<double>(facet.critical_cosine());
  for (int i = -16; i <= 16; ++i) measure(at_most(critical * (1 + i * epsilon), 1.0));
  // A cosine itself carries some ε, and that of a power is twice that of its amplitude.
  const double of_cosine = epsilon + std::sqrt(largest);
  return few * 2 * of_cosine;
}

/// The bound for any facet.
template <class Real, class Facet>
double rounding_per_bounce(const Facet& facet) {
  if constexpr (ContrastingFacet<Facet>)
    return rounding_per_bounce(as_complex(facet.contrast()),
                               static_cast<double>(std::numeric_limits<Real>::epsilon()));
  else
    return measured_rounding_per_bounce<Real>(facet);
}

/// An equal share of a tolerance for each source of error.
/// @throws std::invalid_argument when the tolerance is not a positive number
inline double share_of(double tolerance, Illumination illumination) {
  if (!(tolerance > 0)) {
    throw_invalid_argument("the tolerance of a plan must be positive, not ", tolerance);
  }
  return tolerance / (illumination == Illumination::diffuse ? 4 : 3);
}

/// The cheapest plan of which no error exceeds its share.
/// @param errors of leaving out
/// @param reachable the largest number of bounces of any light
/// @param rounding bound in a number type: rounding(Real())
template <class Rounding>
EffectsPlan plan_within(double share, Illumination illumination, const Omissions& errors, int reachable,
                        const Rounding& rounding) {
  const bool diffuse = illumination == Illumination::diffuse;
  EffectsPlan plan{true, all_bounces, false, {0, 0, 0, diffuse ? share : 0}};
  if (const double error = errors[longest_cutoff]; error <= share) {
    plan.polarization = false;
    plan.bounds.polarization = error;
  }
  for (std::size_t most = 1; most <= longest_cutoff && most < static_cast<std::size_t>(reachable); ++most) {
    if (errors[most - 1] > share) continue;
    plan.max_bounces = static_cast<int>(most);
    plan.bounds.bounces = errors[most - 1];
    break;
  }
  plan.bounds.rounding = rounding(float());
  plan.single_precision = plan.bounds.rounding <= share;
  if (!plan.single_precision) plan.bounds.rounding = rounding(double());
  return plan;
}

}  // namespace detail

/// Bound on the absolute rounding error of a directional reflectance or absorptance, in any direction and any
/// model of polarisation.
/// @tparam Real the number type that it is computed with
/// @param cavity the groove
/// @param facet facet with a contrast, such as `Conductor` or `Dielectric`; or with amplitudes in any number
/// type, such as `Coated`, for which the bound is an estimate
/// @return at most 1; for double some 1e-14, but up to 1e-4 where there is a critical angle
template <class Real, class Facet>
double rounding_bound(const Cavity<double>& cavity, const Facet& facet) {
  return at_most(cavity.max_bounces() * detail::rounding_per_bounce<Real>(facet), 1.0);
}

/// The cheapest plan for a groove of one facet material.
///
/// The tolerance is shared equally among polarisation, bounces, rounding and, for diffuse light, quadrature.
/// So a looser tolerance never asks for more. Where even double precision cannot promise its share, which a
/// critical angle makes up to 1e-4, `bounds` says so.
///
/// @param cavity the groove
/// @param facet facet with amplitudes that `rounding_bound` takes, such as `Conductor`, `Dielectric` or
/// `Coated`
/// @param tolerance largest absolute error of the reflectance, > 0
/// @param illumination of the scene
/// @throws std::invalid_argument when the tolerance is not a positive number
template <FieldReflector<double> Facet>
EffectsPlan plan_effects(const Cavity<double>& cavity, const Facet& facet, double tolerance,
                         Illumination illumination) {
  const bool diffuse = illumination == Illumination::diffuse;
  const double share = detail::share_of(tolerance, illumination);
  const detail::Omissions errors = diffuse ? detail::mean_omissions(cavity, facet, share / 8)
                                           : detail::worst_omissions(cavity, detail::TriedFacet<Facet>(facet),
                                                                     detail::angles_across(kinks(cavity)));
  EffectsPlan plan =
      detail::plan_within(share, illumination, errors, cavity.max_bounces(),
                          [&]<class Real>(Real) { return rounding_bound<Real>(cavity, facet); });
  if constexpr (ContrastingFacet<Facet>)
    if (diffuse && !plan.single_precision)
      plan.bounds.rounding =
          std::min(plan.bounds.rounding, detail::mirror_bound(cavity, detail::as_complex(facet.contrast())));
  return plan;
}

namespace detail {

/// Calls `use` with the groove and the facet of a plan.
/// @param facet_in makes the facet in a number type: facet_in(Real())
template <class FacetIn, class Use>
auto follow_plan(const EffectsPlan& plan, const Cavity<double>& cavity, const FacetIn& facet_in, Use&& use) {
  const auto in_precision = [&]<class Real>(const Cavity<Real>& groove) {
    const auto facet = facet_in(Real());
    return plan.polarization ? use(groove, polarized(facet)) : use(groove, facet);
  };
  return plan.single_precision
             ? in_precision(Cavity<float>(at_most(static_cast<float>(cavity.aperture()), pi<float>())))
             : in_precision(cavity);
}

}  // namespace detail

/// Calls `use` with the groove and the facet of a plan, in its number type and with or without polarisation:
///
///     const double reflectance = with_effects(plan, groove, n, k, [&](const auto& cavity, const auto& facet)
///     {
///       return double{unpolarized(directional_reflectance(cavity, e_in_its_type, facet,
///       plan.max_bounces))};
///     });
///
/// @param plan as from `plan_effects`
/// @param cavity the groove
/// @param n, k complex index of the facets, as `Conductor` takes it
/// @param use what is called
/// @return what `use` returns, of one type for all plans
template <class Use>
auto with_effects(const EffectsPlan& plan, const Cavity<double>& cavity, double n, double k, Use&& use) {
  const auto facet_in = [n, k]<class Real>(Real) {
    return Conductor<Real>::from_contrast(static_cast<Real>(n - 1), static_cast<Real>(k));
  };
  return detail::follow_plan(plan, cavity, facet_in, use);
}

/// The same with a facet that can be had in any number type, such as `Coated`.
template <class Facet, class Use>
auto with_effects(const EffectsPlan& plan, const Cavity<double>& cavity, const Facet& facet, Use&& use) {
  const auto facet_in = [&facet]<class Real>(Real) { return facet.template in<Real>(); };
  return detail::follow_plan(plan, cavity, facet_in, use);
}

}  // namespace vcavity
