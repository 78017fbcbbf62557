// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vcavity/facet/coated.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_stack.hpp"

namespace vcavity::test {
namespace {

/// Arguments: index and thickness of two films, the upper one first, the index of the substrate, the cosine.
constexpr std::size_t films = 2, per_film = 3, substrate = films * per_film, cosine = substrate + 2;

/// Where reflection is abrupt for a medium of the stack: close to its critical angle, among others.
template <class Real>
std::vector<Real> sample_stack(Random& random) {
  std::vector<Real> arguments;
  long double n_minus_1 = 0;
  for (std::size_t i = 0; i < films; ++i) {
    n_minus_1 = std::clamp(sample_contrast(random), -0.8L, 4.0L);
    arguments.push_back(static_cast<Real>(1 + n_minus_1));
    arguments.push_back(static_cast<Real>(std::min(sample_extinction(random), 10.0L)));
    arguments.push_back(static_cast<Real>(random() % 8 == 0 ? 0 : log_uniform(random, 1e-6, 2)));
  }
  if (random() % 2) n_minus_1 = sample_contrast(random);
  arguments.push_back(static_cast<Real>(1 + n_minus_1));
  arguments.push_back(static_cast<Real>(sample_extinction(random)));
  arguments.push_back(static_cast<Real>(sample_cosine(random, n_minus_1)));
  return arguments;
}

template <class Real>
void repair_stack(std::vector<Real>& arguments) {
  for (std::size_t i = 0; i < films; ++i) {
    Real* const film = &arguments[i * per_film];
    film[0] = std::clamp(film[0], Real(0.2L), Real(5));
    film[1] = std::clamp(film[1], Real(0), Real(10));
    film[2] = std::clamp(film[2], Real(0), Real(2));
  }
  arguments[substrate] = std::clamp(arguments[substrate], Real(0.03L), Real(100));
  arguments[substrate + 1] = std::clamp(arguments[substrate + 1], Real(0), Real(1000));
  arguments[cosine] = std::clamp(arguments[cosine], Real(1e-9L), Real(1));
}

template <class Real>
Coated<Conductor<Real>, films> stack_of(const std::vector<Real>& a) {
  return Coated(Conductor<Real>(a[substrate], a[substrate + 1]), Film<Real>(a[0], a[1], a[2]),
                Film<Real>(a[3], a[4], a[5]));
}

template <class Wide>
TextbookStack<Wide> textbook(const std::vector<Wide>& a) {
  std::vector<Layer<Wide>> layers;
  for (std::size_t i = 0; i < films; ++i)
    layers.push_back({{a[i * per_film], a[i * per_film + 1]}, a[i * per_film + 2]});
  return TextbookStack<Wide>(layers, {a[substrate], a[substrate + 1]}, std::min(a[cosine], Wide(1)));
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> coated_subjects() {
  using Arguments = std::vector<Real>;
  std::vector<Subject<Real>> subjects;
  Subject<Real> subject;
  subject.argument_names = {"n₁", "k₁", "d₁", "n₂", "k₂", "d₂", "n", "k", "cos θ"};
  subject.sample = sample_stack<Real>;
  subject.repair = repair_stack<Real>;
  subject.bound = [](const Arguments&) { return coated_bound; };

  subject.name = "Coated: reflectance";
  subject.actual = [](const Arguments& a) -> Results<Real> { return {{0, stack_of(a)(a[cosine])}}; };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide reflectance = textbook(a).reflectance();
    return {{0, {reflectance, reflectance}}};
  });
  subjects.push_back(subject);

  subject.name = "Coated: absorptances";
  subject.bound = [](const Arguments&) { return coated_absorptance_bound; };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const Absorptances<Real> rest = stack_of(a).absorptances(a[cosine]);
    return {{0, rest.s}, {1, rest.p}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const TextbookStack<Wide> stack = textbook(a);
    const Wide s = rest_of_one(Wide(norm(stack.r_s))), p = rest_of_one(Wide(norm(stack.r_p)));
    return {{0, {s, s}}, {1, {p, p}}};
  });
  subjects.push_back(subject);

  subject.name = "Coated: amplitudes";
  subject.bound = [](const Arguments&) { return coated_bound; };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const Amplitudes<Real> r = stack_of(a).amplitudes(a[cosine]);
    return {{0, r.r_s.re}, {1, r.r_s.im}, {2, r.r_p.re}, {3, r.r_p.im}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    using std::sqrt;
    const TextbookStack<Wide> r = textbook(a);
    const Wide s = sqrt(Wide(norm(r.r_s))), p = sqrt(Wide(norm(r.r_p)));
    return {{0, {r.r_s.re, s}}, {1, {r.r_s.im, s}}, {2, {r.r_p.re, p}}, {3, {r.r_p.im, p}}};
  });
  subjects.push_back(subject);
  return subjects;
}

template std::vector<Subject<float>> coated_subjects<float>();
template std::vector<Subject<double>> coated_subjects<double>();
template std::vector<Subject<long double>> coated_subjects<long double>();

}  // namespace vcavity::test
