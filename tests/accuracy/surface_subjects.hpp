// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The projection of the hemisphere, and the bi-hemispherical reflectance where it is known in closed form.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/groove_subjects.hpp"
#include "accuracy/subject.hpp"

namespace vcavity::test {

namespace detail {

/// Hottel's crossed strings: W_m = [2 d(m) − d(m−1) − d(m+1)]/d(1) of diffuse light leaves after m bounces,
/// with d(j) = 2 sin(min(jα, π)/2). Facets of reflectance ρ return Σ W_m ρ^m.
inline Digits50 crossed_strings(const Digits50& aperture, const Digits50& grey) {
  const auto string = [&](int j) {
    return Digits50(2 * sin(Digits50(std::min(Digits50(j * aperture), pi<Digits50>()) / 2)));
  };
  Digits50 sum(0);
  Digits50 power(1);
  for (int m = 1; (m - 1) * aperture < pi<Digits50>(); ++m) {
    power *= grey;
    sum += power * (2 * string(m) - string(m - 1) - string(m + 1)) / string(1);
  }
  return sum;
}

}  // namespace detail

template <class Real>
std::vector<Subject<Real>> surface_subjects() {
  using Arguments = std::vector<Real>;
  using Wide = std::vector<Digits50>;
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject;
  subject.name = "bi-hemispherical reflectance of grey facets";
  subject.argument_names = {"α", "ρ"};
  subject.share_of_samples = 0.001;
  subject.sample = [](Random& random) -> Arguments {
    std::uniform_real_distribution<double> unit(0, 1);
    return {static_cast<Real>(
                detail::sample_aperture(random, static_cast<long double>(epsilon<Real>()) / 2, 0.1)),
            static_cast<Real>(unit(random))};
  };
  subject.repair = [](Arguments& a) {
    a[0] = std::clamp(a[0], Real(0.1), pi<Real>());
    a[1] = std::clamp(a[1], Real(1e-3), Real(1));
  };
  // In long double the requested tolerance is that of double.
  const double tolerance =
      32 * std::max(static_cast<double>(epsilon<Real>()), std::numeric_limits<double>::epsilon());
  subject.bound = [tolerance](const Arguments&) {
    return 8 + tolerance / static_cast<double>(epsilon<Real>());
  };
  subject.actual = [tolerance](const Arguments& a) -> Results<Real> {
    const auto grey = [&](const Real&) { return a[1]; };
    const Real allowed = static_cast<Real>(tolerance) * a[1];
    return {{0, bihemispherical_reflectance(Cavity<Real>(a[0]), grey, allowed).value}};
  };
  subject.exact = [](const Wide& a) -> Results<Exact> {
    const Digits50 sum = detail::crossed_strings(a[0], a[1]);
    return {{0, {sum, a[1]}}};
  };
  subjects.push_back(subject);

  subject = detail::groove_subject<Real>("project_to_disc", 0.02);
  subject.bound = [](const Arguments&) { return 4.0; };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const Vec2<Real> point = project_to_disc(detail::direction_of(a));
    return {{0, point.x}, {1, point.y}};
  };
  subject.exact = [](const Wide& a) -> Results<Exact> {
    const Digits50 scale = sqrt(Digits50(2 / (1 + a[3])));
    const Digits50 u = a[2] * scale;
    const Digits50 v = a[1] * scale;
    return {{0, {u, Digits50(abs(u))}}, {1, {v, Digits50(abs(v))}}};
  };
  subjects.push_back(subject);

  subject.name = "direction_on_disc";
  subject.argument_names = {"u", "v"};
  subject.sample = [](Random& random) -> Arguments {
    std::uniform_real_distribution<double> unit(-1, 1);
    const double radius = random() % 2 ? std::sqrt(2.0) : 1.0;
    const double azimuth = unit(random) * pi<double>();
    const double r = radius * (random() % 2 ? 1.0 : std::abs(unit(random)));
    return {static_cast<Real>(r * std::cos(azimuth)), static_cast<Real>(r * std::sin(azimuth))};
  };
  subject.repair = [](Arguments& a) {
    // First roughly, then to the last digit.
    const Real beyond = std::sqrt((a[0] * a[0] + a[1] * a[1]) / Real(2));
    if (beyond > Real(1))
      for (Real& component : a) component /= beyond;
    while (!(a[0] * a[0] + a[1] * a[1] <= Real(2)))
      for (Real& component : a) component *= Real(1) - epsilon<Real>();
  };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const auto e = direction_on_disc(Vec2<Real>{a[0], a[1]});
    return {{0, e->x}, {1, e->y}, {2, e->z}};
  };
  subject.exact = [](const Wide& a) -> Results<Exact> {
    const Digits50 r2 = a[0] * a[0] + a[1] * a[1];
    const Digits50 scale = sqrt(Digits50(std::max(Digits50(1 - r2 / 4), Digits50(0))));
    return {{0, {Digits50(a[1] * scale), Digits50(1)}},
            {1, {Digits50(a[0] * scale), Digits50(1)}},
            {2, {Digits50(1 - r2 / 2), Digits50(1)}}};
  };
  subjects.push_back(subject);
  return subjects;
}

}  // namespace vcavity::test
