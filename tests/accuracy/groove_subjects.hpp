// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What the groove makes of light, as subjects of measurement: cosines of incidence, weights, directional
/// reflectance and absorptance, exit directions and the bounce count of single rays.

#include <algorithm>
#include <cmath>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/fresnel_subjects.hpp"
#include "accuracy/subject.hpp"
#include "accuracy/textbook_fresnel.hpp"
#include "accuracy/traced_beam.hpp"

namespace vcavity::test {

inline constexpr double cosine_bound = 8;
inline constexpr double weight_bound = 16;

/// Largest error of a directional reflectance or absorptance: one facet after the other adds its own.
inline double directional_bound(int bounces) {
  return 16 + 8 * bounces;
}

namespace detail {

/// An aperture: any, small, or a rounding error beside π/k.
inline long double sample_aperture(Random& random, long double rounding, double smallest) {
  const long double turn = pi<long double>();
  switch (random() % 4) {
    case 0:
      return log_uniform(random, smallest, static_cast<double>(turn));
    case 1:
      return turn / static_cast<long double>(1 + random() % 20) *
             (1 + rounding * (static_cast<long double>(random() % 17) - 8));
    case 2:
      return turn - log_uniform(random, 1e-9, 1);
    default: {
      std::uniform_real_distribution<double> unit(0, 1);
      return std::max(smallest, unit(random)) * turn;
    }
  }
}

/// The angle θ' across the groove: any, grazing, or close to a multiple of a quarter of the aperture, where
/// lobes appear and vanish.
inline long double sample_theta(Random& random, long double aperture) {
  std::uniform_real_distribution<double> unit(0, 1);
  const long double right = pi<long double>() / 2;
  const long double off = log_uniform(random, 1e-15, 0.1) * (random() % 2 ? 1 : -1);
  const long double sign = random() % 2 ? 1 : -1;
  switch (random() % 4) {
    case 0:
      return sign * (right - log_uniform(random, 1e-12, 1));
    case 1:
      return sign * std::min(right, static_cast<long double>(random() % 40) * aperture / 4 + off);
    case 2:
      return sign * std::max(0.0L, right - static_cast<long double>(random() % 40) * aperture / 4 + off);
    default:
      return sign * unit(random) * right;
  }
}

/// Arguments α, e_x, e_y, e_z.
template <class Real>
std::vector<Real> sample_direction(Random& random, double smallest_aperture) {
  std::uniform_real_distribution<double> unit(0, 1);
  const long double aperture =
      sample_aperture(random, static_cast<long double>(epsilon<Real>()) / 2, smallest_aperture);
  const long double theta = sample_theta(random, aperture);
  long double psi = 0;
  if (random() % 2) psi = unit(random) * pi<long double>() / 2;
  if (random() % 4 == 0) psi = pi<long double>() / 2 - log_uniform(random, 1e-9, 1);
  return {static_cast<Real>(aperture), static_cast<Real>(std::sin(psi)),
          static_cast<Real>(std::cos(psi) * std::sin(theta)),
          static_cast<Real>(std::cos(psi) * std::max(0.0L, std::cos(theta)))};
}

template <class Real>
void repair_direction(std::vector<Real>& arguments, double smallest_aperture) {
  arguments[0] = std::clamp(arguments[0], static_cast<Real>(smallest_aperture), pi<Real>());
  Real length(0);
  for (std::size_t i = 1; i <= 3; ++i) length += arguments[i] * arguments[i];
  length = std::sqrt(length);
  for (std::size_t i = 1; i <= 3; ++i) arguments[i] /= length;
}

template <class Real>
Vec3<Real> direction_of(const std::vector<Real>& arguments) {
  return {arguments[1], arguments[2], arguments[3]};
}

inline int key_of(Panel first, int bounces) {
  return 2 * bounces + (first == Panel::one ? 0 : 1);
}

/// The lobes of arguments α, e_x, e_y, e_z. By the library's convention an aperture within rounding of π/k
/// has at most k bounces, and the rays that would bounce once more count as bouncing k times.
template <class Real>
std::vector<TracedLobe> traced(const std::vector<Digits50>& arguments) {
  std::vector<TracedLobe> lobes = traced_lobes(arguments[0], arguments[2], arguments[3]);
  const Cavity<Real> cavity(std::min(static_cast<Real>(arguments[0]), pi<Real>()));
  for (TracedLobe& lobe : lobes) {
    lobe.bounces = std::min(lobe.bounces, cavity.max_bounces());
    lobe.cosines.resize(static_cast<std::size_t>(lobe.bounces));
  }
  return lobes;
}

template <class Real>
Results<Exact> traced_weights(const std::vector<Digits50>& arguments) {
  Results<Exact> results;
  for (const TracedLobe& lobe : traced<Real>(arguments)) {
    Exact& sum = results[key_of(lobe.first_panel, lobe.bounces)];
    sum = {Digits50(sum.value + lobe.weight), Digits50(1)};
  }
  return results;
}

/// A subject with arguments α, e_x, e_y, e_z.
/// @param smallest_aperture in radians, which limits the time that the reference takes
template <class Real>
Subject<Real> groove_subject(const std::string& name, double smallest_aperture) {
  Subject<Real> subject;
  subject.name = name;
  subject.argument_names = {"α", "e_x", "e_y", "e_z"};
  subject.sample = [=](Random& random) { return sample_direction<Real>(random, smallest_aperture); };
  subject.repair = [=](std::vector<Real>& arguments) { repair_direction(arguments, smallest_aperture); };
  return subject;
}

/// The same with the refractive index n, k of the facets.
template <class Real>
Subject<Real> coated(Subject<Real> subject) {
  subject.argument_names.insert(subject.argument_names.end(), {"n", "k"});
  subject.sample = [draw = subject.sample](Random& random) {
    std::vector<Real> arguments = draw(random);
    arguments.push_back(static_cast<Real>(1 + sample_contrast(random)));
    arguments.push_back(static_cast<Real>(sample_extinction(random)));
    return arguments;
  };
  subject.repair = [repair = subject.repair](std::vector<Real>& arguments) {
    repair(arguments);
    arguments[4] = std::clamp(arguments[4], Real(1e-3), Real(100));
    arguments[5] = std::clamp(arguments[5], Real(0), Real(1000));
  };
  return subject;
}

/// Sum over the lobes of weight times throughput.
template <class Real>
Digits50 traced_reflectance(const std::vector<Digits50>& arguments) {
  // Smaller cosines count as this one.
  const Digits50 smallest(vcavity::detail::smallest_cosine<Real>());
  Digits50 sum(0);
  for (const TracedLobe& lobe : traced<Real>(arguments)) {
    Digits50 product = lobe.weight;
    for (const Digits50& cosine : lobe.cosines)
      product *=
          TextbookFresnel(Digits50(arguments[4] - 1), arguments[5], std::clamp(cosine, smallest, Digits50(1)))
              .reflectance();
    sum += product;
  }
  return sum;
}

/// How much of the opening `ray_path` gives to each first panel and number of bounces, by bisection. Along
/// the opening a path never comes back.
template <class Real>
Results<Real> fractions_of_single_rays(const Cavity<Real>& cavity, const Vec3<Real>& e) {
  const auto key_at = [&](const Real& position) {
    const RayPath path = ray_path(cavity, e, position);
    return key_of(path.first_panel, path.bounces);
  };
  Results<Real> fractions;
  Real start(-1);
  while (start < Real(1)) {
    const int key = key_at(start);
    Real inside = start;
    Real outside(1);
    if (key_at(outside) == key) {
      fractions[key] += (outside - start) / Real(2);
      break;
    }
    for (Real middle = (inside + outside) / Real(2); middle != inside && middle != outside;
         middle = (inside + outside) / Real(2))
      (key_at(middle) == key ? inside : outside) = middle;
    fractions[key] += (outside - start) / Real(2);
    start = outside;
  }
  return fractions;
}

}  // namespace detail

/// Every public function between a ray and the directional reflectance.
/// @param smallest_aperture in radians
template <class Real>
std::vector<Subject<Real>> groove_subjects(double smallest_aperture = 0.02) {
  using Arguments = std::vector<Real>;
  using Wide = std::vector<Digits50>;
  const auto white = [](const Real&) { return Real(1); };
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject = detail::groove_subject<Real>("cosines of incidence", smallest_aperture);
  subject.bound = [](const Arguments&) { return cosine_bound; };
  subject.actual = [](const Arguments& a) {
    const Cavity<Real> cavity(a[0]);
    Results<Real> results;
    for (const Panel first : {Panel::one, Panel::two}) {
      PanelImages<Real> images(cavity, detail::direction_of(a), first);
      for (; images.bounce() <= cavity.max_bounces(); images.advance())
        results[detail::key_of(first, images.bounce())] = images.normal_component();
    }
    return results;
  };
  subject.exact = [](const Wide& a) {
    const Cavity<Real> cavity(std::min(static_cast<Real>(a[0]), pi<Real>()));
    Results<Exact> results;
    for (const Panel first : {Panel::one, Panel::two}) {
      int bounce = 0;
      for (const Digits50& cosine : reflected_cosines(a[0], a[2], a[3], first, cavity.max_bounces()))
        results[detail::key_of(first, ++bounce)] = {cosine, Digits50(1)};
    }
    return results;
  };
  subjects.push_back(subject);

  subject = detail::groove_subject<Real>("weights of the lobes", smallest_aperture);
  subject.bound = [](const Arguments&) { return weight_bound; };
  subject.actual = [white](const Arguments& a) {
    Results<Real> results;
    for (const auto& lobe : lobes(Cavity<Real>(a[0]), detail::direction_of(a), white))
      results[detail::key_of(lobe.first_panel, lobe.bounces)] = lobe.weight;
    return results;
  };
  subject.exact = detail::traced_weights<Real>;
  subjects.push_back(subject);

  subject.name = "sum of the weights";
  subject.bound = [](const Arguments&) { return 4.0; };
  subject.actual = [white](const Arguments& a) -> Results<Real> {
    Real sum(0);
    for (const auto& lobe : lobes(Cavity<Real>(a[0]), detail::direction_of(a), white)) sum += lobe.weight;
    return {{0, sum}};
  };
  subject.exact = [](const Wide&) -> Results<Exact> { return {{0, {Digits50(1), Digits50(1)}}}; };
  subjects.push_back(subject);

  subject.name = "mean number of bounces";
  subject.bound = [](const Arguments&) { return weight_bound; };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, mean_bounces(Cavity<Real>(a[0]), detail::direction_of(a))}};
  };
  subject.exact = [](const Wide& a) -> Results<Exact> {
    Digits50 mean(0);
    for (const TracedLobe& lobe : detail::traced<Real>(a)) mean += lobe.bounces * lobe.weight;
    return {{0, {mean, mean}}};
  };
  subjects.push_back(subject);

  subject.name = "bounces of single rays, as fractions of the opening";
  subject.share_of_samples = 0.2;
  subject.actual = [](const Arguments& a) {
    return detail::fractions_of_single_rays(Cavity<Real>(a[0]), detail::direction_of(a));
  };
  subject.exact = detail::traced_weights<Real>;
  subjects.push_back(subject);

  subject = detail::coated(detail::groove_subject<Real>("directional reflectance", smallest_aperture));
  subject.bound = [white](const Arguments& a) {
    int bounces = 1;
    for (const auto& lobe : lobes(Cavity<Real>(a[0]), detail::direction_of(a), white))
      bounces = std::max(bounces, lobe.bounces);
    return directional_bound(bounces);
  };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, directional_reflectance(Cavity<Real>(a[0]), detail::direction_of(a),
                                        Conductor<Real>(a[4], a[5]))}};
  };
  subject.exact = [](const Wide& a) -> Results<Exact> {
    const Digits50 reflectance = detail::traced_reflectance<Real>(a);
    return {{0, {reflectance, reflectance}}};
  };
  subjects.push_back(subject);

  subject.name = "directional absorptance";
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, directional_absorptance(Cavity<Real>(a[0]), detail::direction_of(a),
                                        Conductor<Real>(a[4], a[5]))}};
  };
  subject.exact = [](const Wide& a) -> Results<Exact> {
    Digits50 absorptance = 1 - detail::traced_reflectance<Real>(a);
    if (absorptance < Digits50("1e-42")) absorptance = 0;
    return {{0, {absorptance, absorptance}}};
  };
  subjects.push_back(subject);
  return subjects;
}

}  // namespace vcavity::test
