// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <map>
#include <vcavity/vcavity.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/groove_reference.hpp"
#include "accuracy/ray_arguments.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_fresnel.hpp"
#include "accuracy/traced_field.hpp"

namespace vcavity::test {
namespace {

/// Fields take long to trace in space.
constexpr double share_of_fields = 0.5;

/// At the critical angle phases change as abruptly as a square root. A cosine is off by as much as its bound:
/// so far one has to look.
const std::vector<int> moves_of_fields{-static_cast<int>(direction_bound), -1, 1,
                                       static_cast<int>(direction_bound)};

/// Waves on their way through a groove.
template <class Real, class Wide>
class TracedWay {
 public:
  /// @param a arguments α, e_x, e_y, e_z, …
  /// @param n where the index n, k stands among them
  TracedWay(const std::vector<Wide>& a, Panel first, std::size_t n)
      : groove_(a[0]),
        waves_({Wide(-a[1]), Wide(-a[2]), Wide(-a[3])}),
        panel_(first),
        n_minus_1_(a[n] - 1),
        extinction_(a[n + 1]) {}

  /// Follows them to that bounce.
  void advance_to(int bounce) {
    for (; bounce_ < bounce; ++bounce_, panel_ = opposite(panel_)) {
      const Across<Wide> normal = groove_.normal(panel_);
      waves_.reflect({Wide(0), normal.y, normal.z}, n_minus_1_, extinction_, facet_cosine<Real>(Wide(0)));
    }
  }

  /// What has become of them.
  TracedPolarization<Wide> polarization() const { return {waves_.amplitudes()}; }

 private:
  GrooveSection<Wide> groove_;
  TracedWaves<Wide> waves_;
  Panel panel_;
  Wide n_minus_1_, extinction_;
  int bounce_ = 0;
};

/// What becomes of the light of a direction.
template <class Wide>
struct TracedMueller {
  std::array<Wide, 16> sum;  ///< Mueller matrix of all lobes, row by row
  Wide brightest;            ///< reflectance of the brightest lobe, were all the light in it
};

/// @param a arguments α, e_x, e_y, e_z, n, k
template <class Real, class Wide>
TracedMueller<Wide> traced_mueller(const std::vector<Wide>& a) {
  TracedMueller<Wide> result;
  result.sum.fill(Wide(0));
  result.brightest = Wide(0);
  std::map<Panel, TracedWay<Real, Wide>> ways;
  for (const TracedLobe<Wide>& lobe : traced<Real>(a)) {
    auto& way = ways.try_emplace(lobe.first_panel, a, lobe.first_panel, 4).first->second;
    way.advance_to(lobe.bounces);
    const auto mueller = way.polarization().mueller();
    for (std::size_t i = 0; i < mueller.size(); ++i) result.sum[i] += lobe.weight * mueller[i];
    result.brightest = std::max(result.brightest, mueller[0]);
  }
  return result;
}

template <class Real>
Mueller<Real> directional_mueller(const std::vector<Real>& a) {
  return directional_reflectance(Cavity<Real>(a[0]), direction_of(a), polarized(Conductor<Real>(a[4], a[5])));
}

/// Real and imaginary parts of all elements, column by column.
template <class T>
std::array<T, 8> parts(const Complex<T>& aa, const Complex<T>& ba, const Complex<T>& ab,
                       const Complex<T>& bb) {
  return {aa.re, aa.im, ba.re, ba.im, ab.re, ab.im, bb.re, bb.im};
}

/// Reflectances of s and p light on their own.
template <class Real>
Subject<Real> separate_polarizations() {
  using Arguments = std::vector<Real>;
  Subject<Real> subject = coated(groove_subject<Real>("directional reflectance of s and p light"));
  subject.bound = [](const Arguments& a) { return squared_product_bound(max_bounces_of(a)); };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const auto reflectance = directional_reflectance(Cavity<Real>(a[0]), direction_of(a),
                                                     separately_polarized(Conductor<Real>(a[4], a[5])));
    return {{0, reflectance.s}, {1, reflectance.p}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const auto [s, p] = traced_reflectances<Real, 2>(a, [&](const Wide& cosine) {
      const TextbookFresnel<Wide> r(Wide(a[4] - 1), a[5], cosine);
      return std::array{norm(r.r_s), norm(r.r_p)};
    });
    return {{0, {s, s}}, {1, {p, p}}};
  });
  return subject;
}

/// The Jones matrix of a ray, in relation to its norm.
template <class Real>
Subject<Real> jones_matrix() {
  using Arguments = std::vector<Real>;
  Subject<Real> subject = coated(ray_subject<Real>("Jones matrix of single rays"));
  subject.is_one_quantity = true;
  subject.moves = moves_of_fields;
  subject.share_of_samples = share_of_fields;
  subject.bound = [](const Arguments& a) { return product_bound(path_of<Real>(a).bounces); };
  subject.actual = [](const Arguments& a) {
    const auto facet = polarized(Conductor<Real>(a[5], a[6]));
    const RayPath path = path_of<Real>(a);
    const Cavity<Real> cavity(a[0]);
    UnfoldedRay<Real> ray(cavity, direction_of(a), path.first_panel);
    Jones<Real> product = reflect(facet, ray);
    while (ray.number() < path.bounces) {
      ray.advance();
      product = product * reflect(facet, ray);
    }
    Results<Real> results;
    for (const Real& part : parts(product.aa, product.ba, product.ab, product.bb))
      results[static_cast<int>(results.size())] = part;
    return results;
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) {
    using std::sqrt;
    const RayPath path = path_of<Real>(a);
    TracedWay<Real, Wide> way(a, path.first_panel, 5);
    way.advance_to(path.bounces);
    const auto [from_a, from_b] = way.polarization().columns;
    const Wide size = sqrt(Wide(norm(from_a[0]) + norm(from_a[1]) + norm(from_b[0]) + norm(from_b[1])));
    ExactResults<Wide> results;
    for (const Wide& part : parts(from_a[0], from_a[1], from_b[0], from_b[1]))
      results[static_cast<int>(results.size())] = {part, size};
    return results;
  });
  return subject;
}

/// The elements of a Mueller matrix, in relation to the reflectance of unpolarised light.
template <class Real>
Subject<Real> mueller_matrix() {
  using Arguments = std::vector<Real>;
  Subject<Real> subject = coated(groove_subject<Real>("Mueller matrix of the directional reflectance"));
  subject.is_one_quantity = true;
  subject.moves = moves_of_fields;
  subject.share_of_samples = share_of_fields;
  subject.bound = [](const Arguments& a) { return squared_product_bound(max_bounces_of(a)); };
  subject.actual = [](const Arguments& a) {
    const Mueller<Real> mueller = directional_mueller(a);
    Results<Real> results;
    for (std::size_t i = 0; i < 16; ++i) results[static_cast<int>(i)] = mueller(i / 4, i % 4);
    return results;
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) {
    const std::array<Wide, 16> mueller = traced_mueller<Real>(a).sum;
    ExactResults<Wide> results;
    for (std::size_t i = 0; i < 16; ++i) results[static_cast<int>(i)] = {mueller[i], mueller[0]};
    return results;
  });
  return subject;
}

/// Polarizance and diattenuation, in relation to 1, or to the brightest lobe over the reflectance.
template <class Real>
Subject<Real> degrees_of_polarization() {
  using Arguments = std::vector<Real>;
  Subject<Real> subject = coated(groove_subject<Real>("polarizance and diattenuation"));
  subject.moves = moves_of_fields;
  subject.share_of_samples = share_of_fields;
  subject.bound = [](const Arguments& a) { return squared_product_bound(max_bounces_of(a)); };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const Mueller<Real> mueller = directional_mueller(a);
    return {{0, polarizance(mueller)}, {1, diattenuation(mueller)}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    using std::sqrt;
    const auto [m, brightest] = traced_mueller<Real>(a);
    const Wide reflectance = m[0];
    const auto degree = [&reflectance](const Wide& q, const Wide& u, const Wide& v) {
      return Wide(reflectance > 0 ? Wide(sqrt(Wide(q * q + u * u + v * v)) / reflectance) : Wide(0));
    };
    // A few ε of the opening may belong to the neighbouring lobe, and be brighter than all the rest. Of light
    // that is hardly a number any more nobody can say how it is polarised.
    const Wide scale = reflectance >= Wide(smallest_relative<Real>())
                           ? std::max(Wide(1), Wide(brightest / reflectance))
                           : 1 / Wide(epsilon<Real>());
    return {{0, {degree(m[4], m[8], m[12]), scale}}, {1, {degree(m[1], m[2], m[3]), scale}}};
  });
  return subject;
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> polarization_subjects() {
  return {separate_polarizations<Real>(), jones_matrix<Real>(), mueller_matrix<Real>(),
          degrees_of_polarization<Real>()};
}

template std::vector<Subject<float>> polarization_subjects<float>();
template std::vector<Subject<double>> polarization_subjects<double>();
template std::vector<Subject<long double>> polarization_subjects<long double>();

}  // namespace vcavity::test
