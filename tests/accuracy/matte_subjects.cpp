// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vcavity/matte/lambertian_cavity.hpp>

#include "accuracy/arguments.hpp"
#include "accuracy/bounds.hpp"
#include "accuracy/subjects.hpp"

namespace vcavity::test {
namespace {

/// Apertures from here on; below, the series of the reference is too long.
constexpr double smallest_matte_aperture = 0.5;

/// κ̂(τ) = (π sin²α / 2 cosh πτ) |P'_{−½+iτ}(−cos α)|, the derivative of Legendre's function from its hypergeometric
/// series at cos²(α/2) (DLMF 14.3.6, 15.5.1), of which all terms are positive.
template <class Wide>
Wide kernel_transform(const Wide& aperture, const Wide& tau) {
  using std::cos;
  using std::exp;
  using std::sin;
  const Wide cosine = cos(Wide(aperture / 2)), sine = sin(aperture);
  const Wide z = cosine * cosine, square = tau * tau;
  Wide sum(1), term(1);
  for (int k = 1; term > sum * std::numeric_limits<Wide>::epsilon() / 1024; ++k) {
    const Wide half = Wide(2 * k + 1) / 2;
    term *= (half * half + square) * z / (Wide(k) * Wide(k + 1));
    sum += term;
  }
  const Wide grown = exp(Wide(pi<Wide>() * tau));
  return pi<Wide>() * sine * sine / (grown + 1 / grown) * (square + Wide(1) / 4) * sum / 2;
}

/// What the quadrature for ln H needs, for each node: its weight and κ̂.
template <class Wide>
using TransformNodes = std::vector<std::pair<Wide, Wide>>;

/// The trapezoidal rule in v with τ = ½ sinh v, kept: the same apertures are asked for again and again.
template <class Wide>
const TransformNodes<Wide>& transform_nodes(const Wide& aperture) {
  static std::map<Wide, TransformNodes<Wide>> known;
  if (const auto found = known.find(aperture); found != known.end()) return found->second;
  if (known.size() > 200) known.clear();
  using std::asinh;
  using std::cosh;
  using std::log;
  using std::sinh;
  const Wide digits = 4 - log(std::numeric_limits<Wide>::epsilon());
  const Wide step = pi<Wide>() * pi<Wide>() / digits;
  TransformNodes<Wide>& nodes = known[aperture];
  for (int i = 0; i * step < asinh(Wide(2 * digits / aperture)); ++i) {
    const Wide v = i * step;
    nodes.push_back({(i == 0 ? 1 : 2) * step / (2 * pi<Wide>() * cosh(v)),
                     kernel_transform(aperture, Wide(sinh(v) / 2))});
  }
  return nodes;
}

/// H(ρ) = exp[−(1/π) ∫ ln(1 − ρ κ̂) dv / cosh v], for negative ρ too.
template <class Wide>
Wide gain_at_rim(const Wide& aperture, const Wide& albedo) {
  using std::exp;
  using std::log;
  Wide sum(0);
  for (const auto& [weight, transform] : transform_nodes(aperture))
    sum -= weight * log(Wide(1 - albedo * transform));
  return exp(sum);
}

/// A matte groove as arguments: aperture and albedo, the latter near 0 or 1 half of the time.
template <class Real>
std::vector<Real> sample_matte(Random& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto kind = random() % 4;
  long double albedo = unit(random);
  if (kind == 0) albedo = log_uniform(random, 1e-12, 1);
  if (kind == 1) albedo = 1 - log_uniform(random, 1e-4, 1);
  const double widest = pi<double>() - smallest_matte_aperture;
  const long double off = random() % 4 == 0 ? log_uniform(random, 1e-6, 1) : widest * unit(random);
  return {static_cast<Real>(pi<long double>() - off), static_cast<Real>(albedo)};
}

template <class Real>
void repair_matte(std::vector<Real>& a) {
  a[0] = std::clamp(a[0], Real(smallest_matte_aperture), pi<Real>());
  a[1] = std::clamp(a[1], Real(1e-12), Real(1));
}

/// A direction within the aperture as its components across the groove and upwards.
template <class Real>
Vec3<Real> across(const Real& y, const Real& z) {
  return {Real(0), y, z};
}

}  // namespace

template <class Real>
std::vector<Subject<Real>> matte_subjects() {
  using Arguments = std::vector<Real>;
  std::vector<Subject<Real>> subjects;

  Subject<Real> subject;
  subject.argument_names = {"α", "ρ"};
  subject.share_of_samples = 0.001;
  subject.sample = sample_matte<Real>;
  subject.repair = repair_matte<Real>;
  subject.bound = [](const Arguments&) { return matte_bound; };

  subject.name = "matte: H";
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, InterreflectionKernel<Real>(Cavity<Real>(a[0])).gain(a[1]).rim()}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide gain = gain_at_rim(a[0], a[1]);
    return {{0, {gain, gain}}};
  });
  subjects.push_back(subject);

  subject.name = "matte: directional reflectance";
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const auto gain = InterreflectionKernel<Real>(Cavity<Real>(a[0])).gain(a[1]);
    return {{0, gain.reflectance}, {1, gain.grazing()}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    const Wide gain = gain_at_rim(a[0], a[1]);
    const Wide within = 1 - (1 - a[1]) * gain * gain, grazing = 1 - (1 - a[1]) * gain;
    return {{0, {within, within}}, {1, {grazing, grazing}}};
  });
  subjects.push_back(subject);

  subject.name = "matte: bi-hemispherical reflectance";
  subject.actual = [](const Arguments& a) -> Results<Real> {
    return {{0, InterreflectionKernel<Real>(Cavity<Real>(a[0])).gain(a[1]).bihemispherical}};
  };
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    using std::sin;
    const Wide gain = gain_at_rim(a[0], a[1]);
    const Wide value = 1 - (1 - a[1]) / (a[1] * sin(Wide(a[0] / 2))) * (1 - (1 - a[1]) * gain * gain);
    return {{0, {value, value}}};
  });
  subjects.push_back(subject);

  subject.name = "matte: BRDF";
  subject.argument_names = {"α", "ρ", "y_L", "z_L", "y_V", "z_V"};
  subject.sample = [](Random& random) -> Arguments {
    std::uniform_real_distribution<double> unit(-1, 1);
    Arguments a = sample_matte<Real>(random);
    for (int i = 0; i < 2; ++i) {
      const double theta = unit(random) * static_cast<double>(a[0]) / 2;
      a.push_back(static_cast<Real>(std::sin(theta)));
      a.push_back(static_cast<Real>(std::cos(theta)));
    }
    return a;
  };
  subject.repair = [](Arguments& a) {
    repair_matte(a);
    for (const std::size_t i : {2u, 4u}) {
      // Within the aperture by a little more than rounding, beyond which the closed form does not hold.
      const Real half = a[0] / Real(2);
      const Real most = a[i + 1] * std::sin(half) / std::max(std::cos(half), epsilon<Real>()) *
                        (Real(1) - Real(8) * epsilon<Real>());
      a[i + 1] = std::max(a[i + 1], Real(1e-3));
      a[i] = std::clamp(a[i], -std::abs(most), std::abs(most));
    }
  };
  subject.actual = [](const Arguments& a) -> Results<Real> {
    const LambertianCavity<Real> matte(Cavity<Real>{a[0]}, a[1]);
    return {{0, matte.brdf(across(a[2], a[3]), across(a[4], a[5]))}};
  };
  // Measured relative to what light and viewer straight above would give.
  subject.refer_to([]<class Wide>(const std::vector<Wide>& a) -> ExactResults<Wide> {
    using std::cos;
    using std::sin;
    const Wide even = gain_at_rim(a[0], a[1]), odd = gain_at_rim(a[0], Wide(-a[1]));
    const Wide sine = sin(Wide(a[0] / 2)), cosine = cos(Wide(a[0] / 2));
    const Wide above = a[1] / pi<Wide>() * sine * even * even;
    const Wide aside = a[1] / pi<Wide>() * cosine * cosine / sine * odd * odd;
    return {{0, {Wide(above + aside * (a[2] / a[3]) * (a[4] / a[5])), above}}};
  });
  subjects.push_back(subject);
  return subjects;
}

template std::vector<Subject<float>> matte_subjects<float>();
template std::vector<Subject<double>> matte_subjects<double>();
template std::vector<Subject<long double>> matte_subjects<long double>();

}  // namespace vcavity::test
