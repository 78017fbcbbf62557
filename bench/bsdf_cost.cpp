// SPDX-License-Identifier: BSD-3-Clause

/// What a call of the BSDF costs: prints a Markdown table of nanoseconds, averaged over directions of the
/// hemisphere, the fastest of several runs.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <random>
#include <vcavity/vcavity.hpp>
#include <vector>

using namespace vcavity;

namespace {

struct Query {
  Vec3<float> wo;
  float u;
};

std::vector<Query> random_queries(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Query> queries(count);
  for (Query& query : queries)
    query = {direction(std::acos(std::sqrt(unit(random))), 2 * pi<float>() * unit(random)), unit(random)};
  return queries;
}

/// Nanoseconds per query. The results are added up and kept, so that no call can be left out.
template <class Call>
double nanoseconds(const std::vector<Query>& queries, Call&& call) {
  static volatile float kept;
  double best = std::numeric_limits<double>::max();
  for (int run = 0; run < 15; ++run) {
    const auto start = std::chrono::steady_clock::now();
    float sum = 0;
    for (const Query& query : queries) sum += call(query);
    kept = sum;
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / static_cast<double>(queries.size()));
  }
  static_cast<void>(kept);
  return best;
}

template <class Facet>
void print_row(const char* facet_name, const Facet& facet, float aperture_deg) {
  static const std::vector<Query> queries = random_queries(20000);
  const Cavity<float> cavity(radians(aperture_deg));
  const GrooveBsdf by_energy(cavity, facet, LobeChoice::by_energy);
  const GrooveBsdf by_weight(cavity, facet, LobeChoice::by_weight);
  const SpreadGrooveBsdf spread(by_energy, 0.02f);
  const auto weight_of = [](const auto& sample) {
    return sample ? largest(unpolarized(sample->weight)) : 0.0f;
  };
  const double energy =
      nanoseconds(queries, [&](const Query& q) { return weight_of(by_energy.sample(q.wo, q.u)); });
  const double weight =
      nanoseconds(queries, [&](const Query& q) { return weight_of(by_weight.sample(q.wo, q.u)); });
  const double albedo =
      nanoseconds(queries, [&](const Query& q) { return largest(unpolarized(by_energy.albedo(q.wo))); });
  const double value = nanoseconds(
      queries, [&](const Query& q) { return largest(unpolarized(spread.evaluate(q.wo, {0, 0, 1}))); });
  const double fresnel = nanoseconds(queries, [&](const Query& q) {
    return largest(unpolarized(power(reflect(facet, UnfoldedRay<float>(cavity, q.wo, Panel::one)))));
  });
  std::printf("| %s | %.0f° | %.0f | %.0f | %.0f | %.0f | %.1f |\n", facet_name, double(aperture_deg), weight,
              energy, albedo, value, fresnel);
}

/// Costs of a rough surface, towards directions of the hemisphere as random as the light's.
template <class Facet>
void print_rough_row(const char* facet_name, const Facet& facet, float roughness, int max_bounces) {
  static const std::vector<Query> queries = random_queries(20000);
  const RoughGrooveBsdf bsdf(GgxSlopes<float>(roughness), facet, max_bounces);
  const auto next = [i = std::size_t(0)]() mutable { return queries[++i % queries.size()].wo; };
  const double evaluate = nanoseconds(queries, [&, other = next](const Query& q) mutable {
    return largest(unpolarized(bsdf.evaluate(q.wo, other())));
  });
  const double pdf =
      nanoseconds(queries, [&, other = next](const Query& q) mutable { return bsdf.pdf(q.wo, other()); });
  const double sample = nanoseconds(queries, [&, other = next](const Query& q) mutable {
    const Vec3<float> u = other();
    const auto drawn = bsdf.sample(q.wo, q.u, {u.z * u.z, std::abs(u.x)});
    return drawn ? largest(unpolarized(drawn->weight)) : 0.0f;
  });
  std::printf("| %s | %.1f | %d | %.0f | %.0f | %.0f |\n", facet_name, double(roughness), max_bounces,
              evaluate, pdf, sample);
}

}  // namespace

int main() {
  std::puts(
      "| facet | aperture | sample by weight | sample by energy | albedo | evaluate, lobes of a width | "
      "Fresnel, once |");
  std::puts("|---|---|---|---|---|---|---|");
  const Pack<float, 8> n8(0.27f), k8(3.4f);
  for (const float aperture_deg : {120.0f, 60.0f, 20.0f}) {
    print_row("one wavelength", Conductor<float>(0.27f, 3.4f), aperture_deg);
    print_row("RGB", Conductor<glm::vec3>({0.27f, 0.91f, 1.19f}, {3.41f, 2.60f, 2.36f}), aperture_deg);
    print_row("RGB, polarised", polarized(Conductor<glm::vec3>({0.27f, 0.91f, 1.19f}, {3.41f, 2.60f, 2.36f})),
              aperture_deg);
    print_row("8 wavelengths", Conductor<Pack<float, 8>>(n8, k8), aperture_deg);
  }

  std::puts("\n| facet | roughness (GGX) | bounce limit | evaluate | pdf | sample, with both |");
  std::puts("|---|---|---|---|---|---|");
  using Rgb = Pack<float, 3>;
  const Conductor<Rgb> rgb(Rgb(std::array{0.27f, 0.91f, 1.19f}), Rgb(std::array{3.41f, 2.60f, 2.36f}));
  for (const float roughness : {0.1f, 0.3f, 1.0f}) {
    for (const int max_bounces : {1, 8, 32}) print_rough_row("RGB", rgb, roughness, max_bounces);
    print_rough_row("one wavelength", Conductor<float>(0.27f, 3.4f), roughness, 32);
    print_rough_row("RGB, polarised", polarized(rgb), roughness, 32);
  }
}
