// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Fresnel reflectance, absorptance and amplitudes, as subjects of measurement.

#include <algorithm>
#include <cmath>
#include <vcavity/fresnel.hpp>
#include <vector>

#include "accuracy/subject.hpp"
#include "accuracy/textbook_fresnel.hpp"

namespace vcavity::test {

/// Largest error of reflectance, absorptance and amplitudes.
inline constexpr double fresnel_bound = 8;

namespace detail {

/// A number whose logarithm is uniform.
inline long double log_uniform(Random& random, double low, double high) {
  std::uniform_real_distribution<double> unit(0, 1);
  return std::exp(static_cast<long double>(std::log(low) + unit(random) * std::log(high / low)));
}

/// A real part n − 1 of the index: any, or close to 1.
inline long double sample_contrast(Random& random) {
  switch (random() % 4) {
    case 0:
      return log_uniform(random, 1e-9, 1) * (random() % 2 ? 1 : -1);
    case 1:
      return log_uniform(random, 1e-3, 1) - 1;
    default:
      return log_uniform(random, 0.03, 100) - 1;
  }
}

inline long double sample_extinction(Random& random) {
  switch (random() % 4) {
    case 0:
      return 0;
    case 1:
      return log_uniform(random, 1e-12, 1);
    default:
      return log_uniform(random, 1e-3, 1000);
  }
}

/// A cosine: any, small, close to 1, close to Brewster's or to the critical angle.
inline long double sample_cosine(Random& random, long double n_minus_1) {
  std::uniform_real_distribution<double> unit(0, 1);
  const long double n = 1 + n_minus_1;
  const long double off = 1 + log_uniform(random, 1e-12, 0.1) * (random() % 2 ? 1 : -1);
  switch (random() % 8) {
    case 0:
      return log_uniform(random, 1e-12, 1);
    case 1:
      return 1 - log_uniform(random, 1e-9, 1);
    case 2:
      return 1 / std::sqrt(1 + n * n) * off;
    case 3:
      return n < 1 ? std::sqrt(1 - n * n) * off : 1;
    default:
      return unit(random);
  }
}

template <class Real>
Subject<Real> fresnel_subject(const std::string& name) {
  Subject<Real> subject;
  subject.name = name;
  subject.argument_names = {"n", "k", "cos θ"};
  subject.sample = [](Random& random) {
    const long double n_minus_1 = sample_contrast(random);
    return std::vector<Real>{static_cast<Real>(1 + n_minus_1), static_cast<Real>(sample_extinction(random)),
                             static_cast<Real>(sample_cosine(random, n_minus_1))};
  };
  subject.repair = [](std::vector<Real>& arguments) {
    arguments[0] = std::clamp(arguments[0], Real(1e-3), Real(100));
    arguments[1] = std::clamp(arguments[1], Real(0), Real(1000));
    arguments[2] = std::clamp(arguments[2], Real(1e-9), Real(1));
  };
  subject.bound = [](const std::vector<Real>&) { return fresnel_bound; };
  return subject;
}

/// Makes the arguments n and cos θ only: k is 0.
template <class Real>
Subject<Real> transparent(Subject<Real> subject) {
  subject.argument_names = {"n", "cos θ"};
  subject.sample = [draw = subject.sample](Random& random) {
    const std::vector<Real> all = draw(random);
    return std::vector<Real>{all[0], all[2]};
  };
  subject.repair = [](std::vector<Real>& arguments) {
    arguments[0] = std::clamp(arguments[0], Real(1e-3), Real(100));
    arguments[1] = std::clamp(arguments[1], Real(1e-9), Real(1));
  };
  return subject;
}

inline TextbookFresnel textbook(const std::vector<Digits50>& arguments) {
  const Digits50 cosine = std::min(arguments.back(), Digits50(1));
  return {Digits50(arguments[0] - 1), arguments.size() == 3 ? arguments[1] : Digits50(0), cosine};
}

inline Results<Exact> exact_reflectance(const std::vector<Digits50>& arguments) {
  const Digits50 reflectance = textbook(arguments).reflectance();
  return {{0, {reflectance, reflectance}}};
}

inline Results<Exact> exact_absorptance(const std::vector<Digits50>& arguments) {
  Digits50 absorptance = 1 - textbook(arguments).reflectance();
  // Total reflection: what is left is the rounding of 50 digits.
  if (absorptance < Digits50("1e-45")) absorptance = 0;
  return {{0, {absorptance, absorptance}}};
}

inline Results<Exact> exact_amplitudes(const std::vector<Digits50>& arguments) {
  const TextbookFresnel r = textbook(arguments);
  const Digits50 s = sqrt(Digits50(norm(r.r_s)));
  const Digits50 p = sqrt(Digits50(norm(r.r_p)));
  return {{0, {r.r_s.re, s}}, {1, {r.r_s.im, s}}, {2, {r.r_p.re, p}}, {3, {r.r_p.im, p}}};
}

template <class Real>
Results<Real> components(const Amplitudes<Real>& r) {
  return {{0, r.r_s.re}, {1, r.r_s.im}, {2, r.r_p.re}, {3, r.r_p.im}};
}

}  // namespace detail

/// Every public function of fresnel.hpp.
template <class Real>
std::vector<Subject<Real>> fresnel_subjects() {
  using Arguments = std::vector<Real>;
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject = detail::fresnel_subject<Real>("Conductor: reflectance");
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, Conductor<Real>(a[0], a[1])(a[2])}};
  };
  subject.exact = detail::exact_reflectance;
  subjects.push_back(subject);

  subject.name = "Conductor: absorptance";
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, Conductor<Real>(a[0], a[1]).absorptance(a[2])}};
  };
  subject.exact = detail::exact_absorptance;
  subjects.push_back(subject);

  subject.name = "Conductor: amplitudes";
  subject.actual = [](const Arguments& a) {
    return detail::components(Conductor<Real>(a[0], a[1]).amplitudes(a[2]));
  };
  subject.exact = detail::exact_amplitudes;
  subjects.push_back(subject);

  subject = detail::transparent(detail::fresnel_subject<Real>("Dielectric: reflectance"));
  subject.actual = [](const Arguments& a) -> Results<Real> { return {{0, Dielectric<Real>(a[0])(a[1])}}; };
  subject.exact = detail::exact_reflectance;
  subjects.push_back(subject);

  subject.name = "Dielectric: absorptance";
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, Dielectric<Real>(a[0]).absorptance(a[1])}};
  };
  subject.exact = detail::exact_absorptance;
  subjects.push_back(subject);

  subject.name = "Dielectric: amplitudes";
  subject.actual = [](const Arguments& a) {
    return detail::components(Dielectric<Real>(a[0]).amplitudes(a[1]));
  };
  subject.exact = detail::exact_amplitudes;
  subjects.push_back(subject);
  return subjects;
}

}  // namespace vcavity::test
