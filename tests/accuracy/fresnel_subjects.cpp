// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vcavity/facet/fresnel.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_fresnel.hpp"

namespace vcavity::test {
namespace {

/// What identifies an interface: the refractive index, or its contrast to the medium outside.
enum class Given { index, contrast };

/// A subject with arguments n or n − 1, k, cos θ.
template <class Real>
Subject<Real> fresnel_subject(Given given) {
  Subject<Real> subject;
  const bool by_index = given == Given::index;
  subject.argument_names = {by_index ? "n" : "n − 1", "k", "cos θ"};
  subject.sample = [=](Random& random) {
    const long double n_minus_1 = sample_contrast(random);
    return std::vector<Real>{static_cast<Real>(by_index ? 1 + n_minus_1 : n_minus_1),
                             static_cast<Real>(sample_extinction(random)),
                             static_cast<Real>(sample_cosine(random, n_minus_1))};
  };
  subject.repair = [=](std::vector<Real>& arguments) {
    const Real lowest = static_cast<Real>(1e-3L);
    arguments[0] = by_index ? std::clamp(arguments[0], lowest, Real(100))
                            : std::clamp(arguments[0], lowest - Real(1), Real(99));
    arguments[1] = std::clamp(arguments[1], Real(0), Real(1000));
    arguments[2] = std::clamp(arguments[2], static_cast<Real>(1e-9L), Real(1));
  };
  subject.bound = [](const std::vector<Real>&) { return fresnel_bound; };
  return subject;
}

/// Makes the arguments n and cos θ only: k is 0.
template <class Real>
Subject<Real> transparent(Subject<Real> subject) {
  subject.argument_names.erase(subject.argument_names.begin() + 1);
  subject.sample = [draw = subject.sample](Random& random) {
    const std::vector<Real> all = draw(random);
    return std::vector<Real>{all[0], all[2]};
  };
  subject.repair = [repair = subject.repair](std::vector<Real>& arguments) {
    std::vector<Real> all{arguments[0], Real(0), arguments[1]};
    repair(all);
    arguments = {all[0], all[2]};
  };
  return subject;
}

/// Adds reflectance, absorptance and amplitudes of an interface.
/// @param like a subject with the arguments
/// @param interface makes an interface of the library from them
template <class Real, class Interface>
void add_interface(std::vector<Subject<Real>>& subjects, const std::string& name, const Subject<Real>& like,
                   Given given, const Interface& interface) {
  using Arguments = std::vector<Real>;
  const auto textbook = [given]<class Wide>(const std::vector<Wide>& a) {
    const Wide n_minus_1 = given == Given::index ? Wide(a[0] - 1) : a[0];
    return TextbookFresnel<Wide>(n_minus_1, a.size() == 3 ? a[1] : Wide(0), std::min(a.back(), Wide(1)));
  };

  Subject<Real> subject = like;
  subject.name = name + ": reflectance";
  subject.actual = [=](const Arguments& a) -> Results<Real> { return {{0, interface(a)(a.back())}}; };
  subject.refer_to([=]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide reflectance = textbook(a).reflectance();
    return {{0, {reflectance, reflectance}}};
  });
  subjects.push_back(subject);

  subject.name = name + ": absorptance";
  subject.actual = [=](const Arguments& a) -> Results<Real> {
    return {{0, interface(a).absorptance(a.back())}};
  };
  subject.refer_to([=]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide absorptance = rest_of_one(textbook(a).reflectance());
    return {{0, {absorptance, absorptance}}};
  });
  subjects.push_back(subject);

  subject.name = name + ": amplitudes";
  subject.actual = [=](const Arguments& a) -> Results<Real> {
    const Amplitudes<Real> r = interface(a).amplitudes(a.back());
    return {{0, r.r_s.re}, {1, r.r_s.im}, {2, r.r_p.re}, {3, r.r_p.im}};
  };
  subject.refer_to([=]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    using std::sqrt;
    const TextbookFresnel<Wide> r = textbook(a);
    const Wide s = sqrt(norm(r.r_s));
    const Wide p = sqrt(norm(r.r_p));
    return {{0, {r.r_s.re, s}}, {1, {r.r_s.im, s}}, {2, {r.r_p.re, p}}, {3, {r.r_p.im, p}}};
  });
  subjects.push_back(subject);
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> fresnel_subjects() {
  using Arguments = std::vector<Real>;
  std::vector<Subject<Real>> subjects;
  const Subject<Real> by_index = fresnel_subject<Real>(Given::index);
  const Subject<Real> by_contrast = fresnel_subject<Real>(Given::contrast);
  add_interface(subjects, "Conductor", by_index, Given::index,
                [](const Arguments& a) { return Conductor<Real>(a[0], a[1]); });
  add_interface(subjects, "Conductor::from_contrast", by_contrast, Given::contrast,
                [](const Arguments& a) { return Conductor<Real>::from_contrast(a[0], a[1]); });
  add_interface(subjects, "Dielectric", transparent(by_index), Given::index,
                [](const Arguments& a) { return Dielectric<Real>(a[0]); });
  add_interface(subjects, "Dielectric::from_contrast", transparent(by_contrast), Given::contrast,
                [](const Arguments& a) { return Dielectric<Real>::from_contrast(a[0]); });
  return subjects;
}

template std::vector<Subject<float>> fresnel_subjects<float>();
template std::vector<Subject<double>> fresnel_subjects<double>();
template std::vector<Subject<long double>> fresnel_subjects<long double>();

}  // namespace vcavity::test
