// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_fresnel.hpp"
#include "accuracy/traced_beam.hpp"

namespace vcavity::test {
namespace {

/// Both the library and the reference leave out light of more bounces.
constexpr int max_bounces = 8;

/// e of unit length and the component of it along a horizontal unit vector.
template <class Wide>
struct UnitDirection {
  Wide x, y, z;

  explicit UnitDirection(const Wide* components) : x(components[0]), y(components[1]), z(components[2]) {
    using std::sqrt;
    const Wide length = sqrt(Wide(x * x + y * y + z * z));
    x /= length;
    y /= length;
    z /= length;
  }
};

/// BRDF × cosine of GGX for arguments a, wo, wi: the apertures that lead from one direction to the other by their
/// angles, and what goes this way by a beam that is traced through each such groove in real space.
/// @param throughput of the cosines of incidence along a way
template <class Wide, class Throughput>
Wide traced_brdf(const std::vector<Wide>& arguments, const Throughput& throughput) {
  using std::atan2;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Wide& a = arguments[0];
  const UnitDirection<Wide> e(&arguments[1]), o(&arguments[4]);
  const Wide h_x = e.x + o.x, h_y = e.y + o.y;
  const Wide h = sqrt(Wide(h_x * h_x + h_y * h_y));
  const Wide e_across = (e.x * h_x + e.y * h_y) / h, o_across = (o.x * h_x + o.y * h_y) / h;
  const Wide theta_e = atan2(e_across, e.z), theta_o = atan2(o_across, o.z);
  const Wide half_sum = (theta_e + theta_o) / 2, half_difference = (theta_e - theta_o) / 2;
  Wide sum(0);
  for (int bounces = 1; bounces <= max_bounces; ++bounces) {
    for (const Panel first : {Panel::one, Panel::two}) {
      if (bounces == 1 && first == Panel::two) continue;
      const Wide beta = bounces % 2 == 1 ? half_sum : half_difference;
      const Wide aperture = (pi<Wide>() - (first == Panel::one ? 2 : -2) * beta) / bounces;
      if (!(aperture > 0) || aperture > pi<Wide>()) continue;
      const Wide m_across = cos(Wide(aperture / 2)), m_z = sin(Wide(aperture / 2));
      const Wide spread = m_across * m_across / (a * a) + m_z * m_z;
      const Wide density = 1 / (pi<Wide>() * a * a * spread * spread);
      for (const TracedLobe<Wide>& lobe : traced_lobes(GrooveSection<Wide>(aperture), e_across, e.z))
        if (lobe.first_panel == first && lobe.bounces == bounces)
          // The grooves per dθ_m dψ have the density 2 D cos θ_m sin θ_m, and dω_o = 2 j |h| dθ_m dψ.
          sum += density * m_across * m_z / (bounces * h) * lobe.weight * throughput(lobe.cosines);
    }
  }
  return sum;
}

/// A direction: any, or grazing.
template <class Real>
std::array<Real, 3> sample_unit(Random& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const long double height = random() % 4 == 0 ? log_uniform(random, 1e-5, 1) : unit(random);
  const long double across = std::sqrt(1 - height * height), azimuth = 2 * pi<double>() * unit(random);
  return {static_cast<Real>(across * std::cos(azimuth)), static_cast<Real>(across * std::sin(azimuth)),
          static_cast<Real>(height)};
}

/// A roughness and two directions: any, close to the mirror direction, to the way back, and to the cone of
/// equal heights, where bounces have no end.
template <class Real>
std::vector<Real> sample_pair(Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const std::array<Real, 3> e = sample_unit<Real>(random);
  std::array<Real, 3> o = sample_unit<Real>(random);
  const Real off = static_cast<Real>(log_uniform(random, 1e-4, 1));
  const auto near = [&](Real turned) {
    for (std::size_t i = 0; i < 3; ++i)
      o[i] = (i < 2 ? turned : Real(1)) * e[i] + off * static_cast<Real>(unit(random)) * e[2];
  };
  switch (random() % 8) {
    case 0:
      near(Real(-1));
      break;
    case 1:
      near(Real(1));
      break;
    case 2:
      o[2] = e[2] * (Real(1) + off);
      break;
    default:
      break;
  }
  const Real roughness = static_cast<Real>(log_uniform(random, 0.01, 3));
  return {roughness, e[0], e[1], e[2], o[0], o[1], o[2]};
}

/// |h|, the horizontal part of the sum of the directions.
template <class Real>
double distance_from_mirror(const std::vector<Real>& a) {
  return std::hypot(static_cast<double>(a[1] + a[4]), static_cast<double>(a[2] + a[5]));
}

template <class Real>
void repair_pair(std::vector<Real>& a) {
  a[0] = std::clamp(a[0], Real(0.01), Real(3));
  const auto normalise = [&](std::size_t first) {
    Real& z = a[first + 2];
    z = std::max(z, Real(1e-6));
    const Real length = std::sqrt(a[first] * a[first] + a[first + 1] * a[first + 1] + z * z);
    for (std::size_t i = first; i < first + 3; ++i) a[i] /= length;
  };
  normalise(1);
  normalise(4);
  // At the mirror direction itself the BRDF has a focus.
  constexpr double focus = 1e-5;
  while (distance_from_mirror(a) < focus) {
    a[4] += static_cast<Real>(2 * focus);
    a[6] += static_cast<Real>(focus);
    normalise(4);
  }
}

template <class Real>
Vec3<Real> direction_at(const std::vector<Real>& a, std::size_t first) {
  return {a[first], a[first + 1], a[first + 2]};
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> rough_subjects() {
  using Arguments = std::vector<Real>;
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject;
  subject.name = "RoughGrooveBsdf: pdf";
  subject.argument_names = {"a", "o_x", "o_y", "o_z", "i_x", "i_y", "i_z"};
  subject.share_of_samples = 0.1;
  subject.sample = [](Random& random) { return sample_pair<Real>(random); };
  subject.repair = [](Arguments& a) { repair_pair(a); };
  subject.bound = [](const Arguments& a) { return rough_pdf_bound(distance_from_mirror(a)); };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const auto white = [](const Real&) { return Real(1); };
    const GgxSlopes<Real> slopes{a[0]};
    const RoughGrooveBsdf bsdf(slopes, white, max_bounces);
    return {{0, bsdf.pdf(direction_at(a, 1), direction_at(a, 4))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide pdf = traced_brdf(a, [](const std::vector<Wide>&) { return Wide(1); });
    return {{0, {pdf, pdf}}};
  });
  subjects.push_back(subject);

  subject = coated(subject);
  subject.name = "RoughGrooveBsdf: evaluate";
  subject.bound = [](const Arguments& a) { return rough_bound(distance_from_mirror(a)); };
  // Metals and dense media: next to total reflection the rounding of a cosine is all that counts.
  subject.repair = [repair = subject.repair](Arguments& a) {
    repair(a);
    a[7] = std::max(a[7], Real(0.1));
    if (a[7] < Real(1)) a[8] = std::max(a[8], Real(0.3));
  };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const GgxSlopes<Real> slopes{a[0]};
    const RoughGrooveBsdf bsdf(slopes, Conductor<Real>(a[7], a[8]), max_bounces);
    return {{0, bsdf.evaluate(direction_at(a, 1), direction_at(a, 4))}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide value = traced_brdf(a, [&](const std::vector<Wide>& cosines) {
      Wide product(1);
      for (const Wide& cosine : cosines)
        product *= TextbookFresnel<Wide>(Wide(a[7] - 1), a[8], cosine).reflectance();
      return product;
    });
    return {{0, {value, value}}};
  });
  subjects.push_back(subject);
  return subjects;
}

template std::vector<Subject<float>> rough_subjects<float>();
template std::vector<Subject<double>> rough_subjects<double>();
template std::vector<Subject<long double>> rough_subjects<long double>();

}  // namespace vcavity::test
