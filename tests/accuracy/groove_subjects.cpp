// SPDX-License-Identifier: BSD-3-Clause
#include <vcavity/vcavity.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/groove_reference.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_fresnel.hpp"

namespace vcavity::test {
namespace {

/// The directional reflectance for arguments α, e_x, e_y, e_z, n, k.
template <class Real, class Wide>
Wide traced_reflectance(const std::vector<Wide>& a) {
  return traced_reflectances<Real, 1>(a, [&](const Wide& cosine) {
    return std::array{TextbookFresnel<Wide>(Wide(a[4] - 1), a[5], cosine).reflectance()};
  })[0];
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> groove_subjects() {
  using Arguments = std::vector<Real>;
  const auto white = [](const Real&) { return Real(1); };
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject = groove_subject<Real>("cosines of incidence");
  subject.bound = [](const Arguments&) { return direction_bound; };
  subject.actual = [](const Arguments& a) {
    const Cavity<Real> cavity(a[0]);
    Results<Real> results;
    for (const Panel first : {Panel::one, Panel::two}) {
      UnfoldedRay<Real> ray(cavity, direction_of(a), first);
      for (; ray.number() <= cavity.max_bounces(); ray.advance())
        results[key_of(first, ray.number())] = ray.normal_component();
    }
    return results;
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) {
    const int most = rounded_cavity<Real>(a).max_bounces();
    ExactResults<Wide> results;
    for (const Panel first : {Panel::one, Panel::two}) {
      int bounce = 0;
      for (const Wide& cosine :
           ReflectedRay<Wide>(GrooveSection<Wide>(a[0]), a[2], a[3], first, most).cosines)
        results[key_of(first, ++bounce)] = {cosine, Wide(1)};
    }
    return results;
  });
  subjects.push_back(subject);

  subject = groove_subject<Real>("weights of the lobes");
  subject.bound = [](const Arguments&) { return weight_bound; };
  subject.actual = [white](const Arguments& a) {
    Results<Real> results;
    for (const auto& lobe : lobes(Cavity<Real>(a[0]), direction_of(a), white))
      results[key_of(lobe.first_panel, lobe.bounces)] = lobe.weight;
    return results;
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) { return traced_weights<Real>(a); });
  subjects.push_back(subject);

  subject.name = "sum of the weights";
  subject.bound = [](const Arguments&) { return sum_bound; };
  subject.actual = [white](const Arguments& a) -> Results<Real> {
    Real sum(0);
    for (const auto& lobe : lobes(Cavity<Real>(a[0]), direction_of(a), white)) sum += lobe.weight;
    return {{0, sum}};
  };
  subject.refer_to(
      []<class Wide>(const std::vector<Wide>&) -> ExactResults<Wide> { return {{0, {Wide(1), Wide(1)}}}; });
  subjects.push_back(subject);

  subject.name = "mean number of bounces";
  subject.bound = [](const Arguments&) { return weight_bound; };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, mean_bounces(Cavity<Real>(a[0]), direction_of(a))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    Wide mean(0);
    for (const TracedLobe<Wide>& lobe : traced<Real>(a)) mean += lobe.bounces * lobe.weight;
    return {{0, {mean, mean}}};
  });
  subjects.push_back(subject);

  subject = coated(groove_subject<Real>("directional reflectance"));
  subject.bound = [](const Arguments& a) { return product_bound(max_bounces_of(a)); };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, directional_reflectance(Cavity<Real>(a[0]), direction_of(a), Conductor<Real>(a[4], a[5]))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide reflectance = traced_reflectance<Real>(a);
    return {{0, {reflectance, reflectance}}};
  });
  subjects.push_back(subject);

  subject.name = "directional absorptance";
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, directional_absorptance(Cavity<Real>(a[0]), direction_of(a), Conductor<Real>(a[4], a[5]))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide absorptance = rest_of_one(traced_reflectance<Real>(a));
    return {{0, {absorptance, absorptance}}};
  });
  subjects.push_back(subject);
  return subjects;
}

template std::vector<Subject<float>> groove_subjects<float>();
template std::vector<Subject<double>> groove_subjects<double>();
template std::vector<Subject<long double>> groove_subjects<long double>();

}  // namespace vcavity::test
