// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vcavity/vcavity.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_fresnel.hpp"
#include "support/interval_tracing.hpp"

namespace vcavity::test {
namespace {

// The last seven arguments: e_x, e_y, e_z, and n, k of panel one and of all other faces; those before are the shape.
constexpr std::size_t of_facets = 4;

// Slopes and apertures are at least this in radians, which limits the time that references take.
constexpr double least_angle = 0.1;

/// A key for light that meets these faces.
int key_of(const std::string& way) {
  return static_cast<int>(std::hash<std::string>{}(way) >> 34U);
}

template <class T>
Vec3<T> light_of(const std::vector<T>& a, std::size_t parameters) {
  return {a[parameters], a[parameters + 1], a[parameters + 2]};
}

/// A shape under measurement. What its arguments mean, it knows itself.
template <class Real>
struct Sawtooth {
  static constexpr std::size_t parameters = 2;
  static constexpr double bound = unequal_weight_bound;
  static std::vector<std::string> names() { return {"α", "τ"}; }

  static std::vector<Real> sample(Random& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const long double aperture =
        std::clamp(sample_aperture(random, static_cast<long double>(epsilon<Real>()) / 2, least_angle),
                   static_cast<long double>(least_angle), pi<long double>() - 2 * least_angle);
    const long double most = (pi<long double>() - aperture) / 2 - least_angle;
    const bool vertical = random() % 4 == 0 && aperture / 2 < most;
    return {static_cast<Real>(aperture),
            static_cast<Real>(vertical ? aperture / 2 : unit(random) * static_cast<double>(most))};
  }
  static void repair(std::vector<Real>& a) {
    const Real least(static_cast<Real>(least_angle));
    a[0] = std::clamp(a[0], least, pi<Real>() - Real(3) * least);
    const Real most = (pi<Real>() - a[0]) / Real(2) - least;
    a[1] = std::clamp(a[1], Real(-most), most);
  }
  static Land<AsymmetricGroove<Real>> make(const std::vector<Real>& a) {
    return Land(AsymmetricGroove<Real>(a[0], a[1]), Real(0));
  }
  template <class Wide>
  static std::vector<TracedPencil<Wide>> traced(const std::vector<Wide>& a) {
    const Wide mean = (pi<Wide>() - a[0]) / 2;
    return IntervalTracing<Wide>(groove_edges(Wide(mean + a[1]), Wide(mean - a[1]), Wide(0)))(
        light_of(a, parameters));
  }
  static long double aperture(const std::vector<Real>& a) { return static_cast<long double>(a[0]); }
};

template <class Real>
struct Floored {
  static constexpr std::size_t parameters = 4;
  static constexpr double bound = floor_weight_bound;
  static std::vector<std::string> names() { return {"β₁", "β₂", "floor", "land"}; }

  static std::vector<Real> sample(Random& random) {
    std::uniform_real_distribution<double> unit(least_angle, pi<double>() / 2);
    return {random() % 4 == 0 ? pi<Real>() / Real(2) : static_cast<Real>(unit(random)),
            static_cast<Real>(unit(random)), static_cast<Real>(log_uniform(random, 1e-3, 100)),
            static_cast<Real>(log_uniform(random, 1e-3, 0.9))};
  }
  static void repair(std::vector<Real>& a) {
    const Real least(static_cast<Real>(least_angle)), right = pi<Real>() / Real(2);
    a[0] = std::clamp(a[0], least, right);
    a[1] = std::clamp(a[1], least, right);
    if (a[0] + a[1] > pi<Real>() - least) a[1] = right - least;
    a[2] = std::clamp(a[2], static_cast<Real>(1e-3), Real(100));
    a[3] = std::clamp(a[3], static_cast<Real>(1e-3), static_cast<Real>(0.9));
  }
  static Land<TruncatedGroove<Real>> make(const std::vector<Real>& a) {
    return Land(TruncatedGroove<Real>(a[0], a[1], a[2]), a[3]);
  }
  template <class Wide>
  static std::vector<TracedPencil<Wide>> traced(const std::vector<Wide>& a) {
    const Vec3<Wide> e = light_of(a, parameters);
    auto pencils = IntervalTracing<Wide>(groove_edges(a[0], a[1], a[2]))(e);
    for (auto& pencil : pencils) pencil.weight *= 1 - a[3];
    pencils.push_back({"L", a[3], {e.z}, {Wide(-e.x), Wide(-e.y), e.z}});
    return pencils;
  }
  static long double aperture(const std::vector<Real>& a) {
    return pi<long double>() - static_cast<long double>(a[0] + a[1]);
  }
};

template <class Real>
struct Vertical {
  static constexpr std::size_t parameters = 1;
  static constexpr double bound = weight_bound;
  static std::vector<std::string> names() { return {"floor"}; }

  static std::vector<Real> sample(Random& random) {
    return {static_cast<Real>(log_uniform(random, 0.05, 100))};
  }
  static void repair(std::vector<Real>& a) { a[0] = std::clamp(a[0], static_cast<Real>(0.05), Real(100)); }
  static Trench<Real> make(const std::vector<Real>& a) { return Trench<Real>(a[0]); }
  template <class Wide>
  static std::vector<TracedPencil<Wide>> traced(const std::vector<Wide>& a) {
    const Wide right = pi<Wide>() / 2;
    return IntervalTracing<Wide>(groove_edges(right, right, a[0]))(light_of(a, parameters));
  }
  static long double aperture(const std::vector<Real>&) { return 0.5L; }
};

/// Arguments of a shape, a direction and, unless `bare`, of its facets.
template <class Real, class Shape>
std::vector<Real> sample_surface(Random& random, bool bare) {
  std::vector<Real> arguments = Shape::sample(random);
  std::uniform_real_distribution<double> unit(0, 1);
  const long double theta = sample_theta(random, Shape::aperture(arguments));
  long double psi = 0;
  if (random() % 2) psi = unit(random) * pi<long double>() / 2;
  if (random() % 4 == 0) psi = pi<long double>() / 2 - log_uniform(random, 1e-9, 1);
  arguments.push_back(static_cast<Real>(std::sin(psi)));
  arguments.push_back(static_cast<Real>(std::cos(psi) * std::sin(theta)));
  arguments.push_back(static_cast<Real>(std::cos(psi) * std::max(0.0L, std::cos(theta))));
  for (std::size_t i = 0; !bare && i < of_facets; i += 2) {
    arguments.push_back(static_cast<Real>(1 + sample_contrast(random)));
    arguments.push_back(static_cast<Real>(sample_extinction(random)));
  }
  return arguments;
}

template <class Real, class Shape>
void repair_surface(std::vector<Real>& a) {
  Shape::repair(a);
  Real* const e = &a[Shape::parameters];
  // So that light crosses a trench a few hundred times at most.
  const Real least_up = static_cast<Real>(0.1) * std::abs(e[1]);
  e[2] = std::max(e[2], std::max(least_up, static_cast<Real>(1e-9)));
  const Real length = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
  for (std::size_t i = 0; i < 3; ++i) e[i] /= length;
  for (std::size_t i = Shape::parameters + 3; i < a.size(); i += 2) {
    a[i] = std::clamp(a[i], static_cast<Real>(1e-3), Real(100));
    a[i + 1] = std::clamp(a[i + 1], Real(0), Real(1000));
  }
}

template <class Real>
FaceFacets<Conductor<Real>> facets_of(const std::vector<Real>& a, std::size_t parameters) {
  const Conductor<Real> one(a[parameters + 3], a[parameters + 4]), rest(a[parameters + 5], a[parameters + 6]);
  return {one, rest, rest, rest};
}

/// The reflectance of a way.
template <class Real, class Wide>
Wide throughput(const TracedPencil<Wide>& pencil, const std::vector<Wide>& a, std::size_t parameters) {
  Wide product(1);
  for (std::size_t i = 0; i < pencil.way.size(); ++i) {
    const Wide cosine =
        std::clamp(pencil.cosines[i], Wide(vcavity::detail::smallest_cosine<Real>()), Wide(1));
    const std::size_t facet = parameters + 3 + (pencil.way[i] == '1' ? 0 : 2);
    product *= TextbookFresnel<Wide>(Wide(a[facet] - 1), a[facet + 1], cosine).reflectance();
  }
  return product;
}

/// The number of bounces of the longest way.
template <class Shape, class Real>
int longest_way(const std::vector<Real>& a) {
  int most = 1;
  for (const auto& lobe :
       lobes(Shape::make(a), light_of(a, Shape::parameters), [](const Real&) { return Real(1); }))
    most = std::max(most, lobe.path.bounces());
  return most;
}

template <class Real, class Shape>
void add_subjects(std::vector<Subject<Real>>& subjects, const std::string& shape) {
  using Arguments = std::vector<Real>;
  Subject<Real> subject;
  subject.share_of_samples = 0.05;
  subject.argument_names = Shape::names();
  for (const char* name : {"e_x", "e_y", "e_z"}) subject.argument_names.push_back(name);
  subject.repair = repair_surface<Real, Shape>;

  subject.name = "weights of the lobes, " + shape;
  subject.sample = [](Random& random) { return sample_surface<Real, Shape>(random, true); };
  subject.bound = [](const Arguments&) { return Shape::bound; };
  subject.actual = [](const Arguments& a) {
    Results<Real> results;
    for (const auto& lobe :
         lobes(Shape::make(a), light_of(a, Shape::parameters), [](const Real&) { return Real(1); }))
      results[key_of(lobe.path.text())] += lobe.weight;
    return results;
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) {
    ExactResults<Wide> results;
    for (const auto& pencil : Shape::traced(a)) {
      Exact<Wide>& sum = results[key_of(pencil.way)];
      sum = {Wide(sum.value + pencil.weight), Wide(1)};
    }
    return results;
  });
  subjects.push_back(subject);

  subject.name = "directional reflectance, " + shape;
  for (const char* name : {"n₁", "k₁", "n", "k"}) subject.argument_names.push_back(name);
  subject.sample = [](Random& random) { return sample_surface<Real, Shape>(random, false); };
  subject.bound = [](const Arguments& a) { return product_bound(longest_way<Shape>(a), Shape::bound); };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, directional_reflectance(Shape::make(a), light_of(a, Shape::parameters),
                                        facets_of(a, Shape::parameters))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    Wide sum(0);
    for (const auto& pencil : Shape::traced(a))
      sum += pencil.weight * throughput<Real>(pencil, a, Shape::parameters);
    return {{0, {sum, sum}}};
  });
  subjects.push_back(subject);

  subject.name = "directional absorptance, " + shape;
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, directional_absorptance(Shape::make(a), light_of(a, Shape::parameters),
                                        facets_of(a, Shape::parameters))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    Wide sum(0);
    for (const auto& pencil : Shape::traced(a))
      sum += pencil.weight * throughput<Real>(pencil, a, Shape::parameters);
    const Wide rest = rest_of_one(sum);
    return {{0, {rest, rest}}};
  });
  subjects.push_back(subject);
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> profile_subjects() {
  std::vector<Subject<Real>> subjects;
  add_subjects<Real, Sawtooth<Real>>(subjects, "unequal panels");
  add_subjects<Real, Floored<Real>>(subjects, "floor and land");
  add_subjects<Real, Vertical<Real>>(subjects, "trench");
  return subjects;
}

template std::vector<Subject<float>> profile_subjects<float>();
template std::vector<Subject<double>> profile_subjects<double>();
template std::vector<Subject<long double>> profile_subjects<long double>();

}  // namespace vcavity::test
