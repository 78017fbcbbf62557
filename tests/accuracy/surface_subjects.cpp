// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <vcavity/vcavity.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/subjects.hpp"

namespace vcavity::test {
namespace {

/// Hottel's crossed strings: W_m = [2 d(m) − d(m−1) − d(m+1)]/d(1) of diffuse light leaves after m bounces,
/// with d(j) = 2 sin(min(jα, π)/2). Facets of reflectance ρ return Σ W_m ρ^m.
template <class Wide>
Wide crossed_strings(const Wide& aperture, const Wide& grey) {
  const auto string = [&](int j) {
    using std::sin;
    return Wide(sin(Wide(std::min(Wide(j * aperture), pi<Wide>()) / 2)));
  };
  Wide sum(0);
  Wide power(1);
  for (int m = 1; (m - 1) * aperture < pi<Wide>(); ++m) {
    power *= grey;
    sum += power * (2 * string(m) - string(m - 1) - string(m + 1)) / string(1);
  }
  return sum;
}

/// Diffuse reflectance of a plane of index n > 1: Walsh's formula, as in Duntley, "The optical properties of
/// diffusing materials", J. Opt. Soc. Am. 32, 61 (1942).
template <class Wide>
Wide walsh(const Wide& n) {
  using std::log;
  const Wide n2 = n * n, n4 = n2 * n2, sum = n + 1;
  return Wide(1) / 2 + (n - 1) * (3 * n + 1) / (6 * sum * sum) +
         n2 * (n2 - 1) * (n2 - 1) / ((n2 + 1) * (n2 + 1) * (n2 + 1)) * log(Wide((n - 1) / sum)) -
         2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * log(n);
}

/// The same for any n: what is not reflected crosses a plane as well in one direction as in the other, and n²
/// is the ratio of the two étendues.
template <class Wide>
Wide diffuse_reflectance_of_plane(const Wide& n) {
  if (n > 1) return walsh(n);
  return 1 - (1 - walsh(Wide(1 / n))) * n * n;
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> surface_subjects() {
  using Arguments = std::vector<Real>;
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject;
  subject.name = "bi-hemispherical reflectance of grey facets";
  subject.argument_names = {"α", "ρ"};
  subject.share_of_samples = 0.001;
  subject.sample = [](Random& random) -> Arguments {
    std::uniform_real_distribution<double> unit(0, 1);
    return {static_cast<Real>(sample_aperture(random, static_cast<long double>(epsilon<Real>()) / 2, 0.1)),
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
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    return {{0, {crossed_strings(a[0], a[1]), a[1]}}};
  });
  subjects.push_back(subject);

  subject.name = "bi-hemispherical reflectance of flat glass";
  subject.argument_names = {"n"};
  subject.sample = [](Random& random) -> Arguments {
    const double n = static_cast<double>(log_uniform(random, 1.05, 4));
    return {static_cast<Real>(random() % 2 ? n : 1 / n)};
  };
  subject.repair = [](Arguments& a) {
    a[0] =
        a[0] > Real(1) ? std::clamp(a[0], Real(1.05), Real(4)) : std::clamp(a[0], Real(0.25), Real(1 / 1.05));
  };
  subject.actual = [tolerance](const Arguments& a) -> Results<Real> {
    return {{0, bihemispherical_reflectance(Cavity<Real>(pi<Real>()), Dielectric<Real>(a[0]),
                                            static_cast<Real>(tolerance))
                    .value}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    return {{0, {diffuse_reflectance_of_plane(a[0]), Wide(1)}}};
  });
  subjects.push_back(subject);

  subject = groove_subject<Real>("project_to_disc");
  subject.bound = [](const Arguments&) { return projection_bound; };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const Vec2<Real> point = project_to_disc(direction_of(a));
    return {{0, point.x}, {1, point.y}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    using std::sqrt;
    const Wide scale = sqrt(Wide(2 / (1 + a[3])));
    const Wide u = a[2] * scale;
    const Wide v = a[1] * scale;
    return {{0, {u, u < 0 ? Wide(-u) : u}}, {1, {v, v < 0 ? Wide(-v) : v}}};
  });
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
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    using std::sqrt;
    const Wide r2 = a[0] * a[0] + a[1] * a[1];
    const Wide scale = sqrt(Wide(std::max(Wide(1 - r2 / 4), Wide(0))));
    return {{0, {Wide(a[1] * scale), Wide(1)}},
            {1, {Wide(a[0] * scale), Wide(1)}},
            {2, {Wide(1 - r2 / 2), Wide(1)}}};
  });
  subjects.push_back(subject);
  return subjects;
}

template std::vector<Subject<float>> surface_subjects<float>();
template std::vector<Subject<double>> surface_subjects<double>();
template std::vector<Subject<long double>> surface_subjects<long double>();

}  // namespace vcavity::test
