// SPDX-License-Identifier: BSD-3-Clause
#include <vcavity/vcavity.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/groove_reference.hpp"
#include "accuracy/ray_arguments.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_fresnel.hpp"

namespace vcavity::test {
namespace {

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

}  // namespace

template <class Real>
std::vector<Subject<Real>> ray_subjects() {
  using Arguments = std::vector<Real>;
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject = groove_subject<Real>("bounces of single rays, as fractions of the opening");
  subject.bound = [](const Arguments&) { return weight_bound; };
  subject.share_of_samples = 0.2;
  subject.actual = [](const Arguments& a) {
    return fractions_of_single_rays(Cavity<Real>(a[0]), direction_of(a));
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) { return traced_weights<Real>(a); });
  subjects.push_back(subject);

  subject = ray_subject<Real>("exit direction of single rays");
  subject.bound = [](const Arguments&) { return direction_bound; };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const Vec3<Real> out = ray_exit_direction(Cavity<Real>(a[0]), direction_of(a), path_of<Real>(a));
    return {{0, out.x}, {1, out.y}, {2, out.z}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const RayPath path = path_of<Real>(a);
    const auto out =
        ReflectedRay<Wide>(GrooveSection<Wide>(a[0]), a[2], a[3], path.first_panel, path.bounces).direction;
    return {{0, {Wide(-a[1]), Wide(1)}}, {1, {out.y, Wide(1)}}, {2, {out.z, Wide(1)}}};
  });
  subjects.push_back(subject);

  subject = coated(ray_subject<Real>("reflectance of single rays"));
  subject.bound = [](const Arguments& a) { return product_bound(path_of<Real>(a).bounces); };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, ray_reflectance(Cavity<Real>(a[0]), direction_of(a), path_of<Real>(a),
                                Conductor<Real>(a[5], a[6]))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const RayPath path = path_of<Real>(a);
    const ReflectedRay<Wide> ray(GrooveSection<Wide>{a[0]}, a[2], a[3], path.first_panel, path.bounces);
    Wide product(1);
    for (const Wide& cosine : ray.cosines)
      product *= TextbookFresnel<Wide>(Wide(a[5] - 1), a[6], facet_cosine<Real>(cosine)).reflectance();
    return {{0, {product, product}}};
  });
  subjects.push_back(subject);
  return subjects;
}

template std::vector<Subject<float>> ray_subjects<float>();
template std::vector<Subject<double>> ray_subjects<double>();
template std::vector<Subject<long double>> ray_subjects<long double>();

}  // namespace vcavity::test
