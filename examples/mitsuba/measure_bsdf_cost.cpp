// SPDX-License-Identifier: BSD-3-Clause

/// What calls of `vgroove` cost against those of Mitsuba's `roughconductor`, of the same roughness and material and
/// through the same interface: prints a Markdown table of nanoseconds and ratios. A second one has parallel grooves whose
/// aperture or tilt is a texture, so that a groove is made for each point, against those that are the same everywhere.
///
///     measure_bsdf_cost <folder of Mitsuba's plug-ins' folder> <folder of vgroove's plug-ins' folder>
///
/// Both BSDFs get the same directions in the same order, alternately, in runs of which the fastest counts. Half of
/// the pairs of directions are random, half were drawn by the BSDF itself, as in a path tracer that combines BSDF
/// sampling with that of lights.

#include <mitsuba/core/fresolver.h>
#include <mitsuba/core/logger.h>
#include <mitsuba/core/plugin.h>
#include <mitsuba/core/properties.h>
#include <mitsuba/core/spectrum.h>
#include <mitsuba/core/thread.h>
#include <mitsuba/render/bsdf.h>
#include <mitsuba/render/interaction.h>
#include <mitsuba/render/texture.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace mitsuba;
using Rgb = Color<float, 3>;
using Bsdf = BSDF<float, Rgb>;
using Interaction = SurfaceInteraction<float, Rgb>;
using Direction = Vector<float, 3>;

struct Query {
  Interaction interaction;
  Direction wo;
  float u;
  Point<float, 2> u2;
};

/// Queries with one direction of the hemisphere, and one that is as random or drawn by the BSDF.
std::vector<Query> queries_of(const Bsdf& bsdf) {
  constexpr std::size_t count = 4096;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  const auto direction = [&] {
    const float size = std::sqrt(unit(random)), turn = 2 * 3.14159265f * unit(random);
    return Direction(size * std::cos(turn), size * std::sin(turn),
                     std::sqrt(std::max(1 - size * size, 1e-4f)));
  };
  std::vector<Query> queries(count);
  for (Query& query : queries) {
    query.interaction = dr::zeros<Interaction>();
    query.interaction.wi = direction();
    query.wo = direction();
    query.u = unit(random);
    query.u2 = {unit(random), unit(random)};
    if (unit(random) < 0.5f) continue;
    const auto [sample, weight] =
        bsdf.sample(BSDFContext(), query.interaction, query.u, {query.u2.y(), query.u2.x()}, true);
    if (weight.x() > 0) query.wo = sample.wo;
  }
  return queries;
}

/// Nanoseconds per call. The results are added up and kept, so that no call can be left out.
template <class Call>
double nanoseconds(const std::vector<Query>& queries, const Call& call) {
  static volatile float kept;
  const auto start = std::chrono::steady_clock::now();
  float sum = 0;
  for (const Query& query : queries) sum += call(query);
  kept = sum;
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  static_cast<void>(kept);
  return time.count() / static_cast<double>(queries.size());
}

struct Costs {
  double evaluate, both, all;
};

/// The calls that are timed: eval; eval_pdf; sample, eval and pdf one after the other.
Costs costs_of(const Bsdf& bsdf, const std::vector<Query>& queries) {
  const BSDFContext context;
  const double evaluate =
      nanoseconds(queries, [&](const Query& q) { return bsdf.eval(context, q.interaction, q.wo, true).x(); });
  const double both = nanoseconds(queries, [&](const Query& q) {
    const auto [value, pdf] = bsdf.eval_pdf(context, q.interaction, q.wo, true);
    return value.x() + pdf;
  });
  const double all = nanoseconds(queries, [&](const Query& q) {
    const auto [sample, weight] = bsdf.sample(context, q.interaction, q.u, q.u2, true);
    return weight.x() + sample.pdf + bsdf.eval(context, q.interaction, q.wo, true).x() +
           bsdf.pdf(context, q.interaction, q.wo, true);
  });
  return {evaluate, both, all};
}

Costs least(const Costs& a, const Costs& b) {
  return {std::min(a.evaluate, b.evaluate), std::min(a.both, b.both), std::min(a.all, b.all)};
}

ref<Bsdf> bsdf_of(const std::string& plug_in, const std::string& distribution, float roughness, int bounces) {
  Properties properties(plug_in);
  properties.set("distribution", distribution);
  properties.set("material", std::string("Ag"));
  if (plug_in == "roughconductor") {
    properties.set("alpha", roughness);
  } else {
    properties.set("roughness", roughness);
    properties.set("max_bounces", bounces);
  }
  return PluginManager::instance()->create_object<Bsdf>(properties);
}

void print_row(const std::string& distribution, float roughness, int bounces) {
  const ref<Bsdf> theirs = bsdf_of("roughconductor", distribution, roughness, 0);
  const ref<Bsdf> ours = bsdf_of("vgroove", distribution, roughness, bounces);
  const std::vector<Query> queries = queries_of(*ours);
  constexpr double never = std::numeric_limits<double>::max();
  Costs their_costs{never, never, never}, our_costs = their_costs;
  for (int run = 0; run < 60; ++run) {
    their_costs = least(their_costs, costs_of(*theirs, queries));
    our_costs = least(our_costs, costs_of(*ours, queries));
  }
  std::printf("| %s | %.1f | %d | %.0f / %.0f = %.2f | %.0f / %.0f = %.2f | %.0f / %.0f = %.2f |\n",
              distribution.c_str(), double(roughness), bounces, our_costs.evaluate, their_costs.evaluate,
              our_costs.evaluate / their_costs.evaluate, our_costs.both, their_costs.both,
              our_costs.both / their_costs.both, our_costs.all, their_costs.all,
              our_costs.all / their_costs.all);
}

/// Parallel grooves; two values for one of their numbers make a texture of it.
ref<Bsdf> grooves_of(float aperture, bool tilted, const char* textured) {
  Properties properties("vgroove");
  properties.set("material", std::string("Ag"));
  const auto set = [&](const std::string& name, float value) {
    if (name != textured) {
      properties.set(name, value);
      return;
    }
    Properties checks("checkerboard");
    checks.set("color0", value - 5);
    checks.set("color1", value + 5);
    auto texture = PluginManager::instance()->create_object<Texture<float, Rgb>>(checks);
    properties.set(name, ref<Object>(texture.get()));
  };
  set("aperture", aperture);
  if (tilted) set("tilt", 15.f);
  set("rotation", 30.f);
  return PluginManager::instance()->create_object<Bsdf>(properties);
}

void print_texture_row(float aperture, bool tilted, const char* textured) {
  const ref<Bsdf> constant = grooves_of(aperture, tilted, ""),
                  varying = grooves_of(aperture, tilted, textured);
  std::vector<Query> queries = queries_of(*constant);
  std::mt19937 random(2);
  std::uniform_real_distribution<float> unit(0, 1);
  for (Query& query : queries) query.interaction.uv = {unit(random), unit(random)};
  const BSDFContext context;
  const auto cost_of = [&](const Bsdf& bsdf) {
    return nanoseconds(queries, [&](const Query& q) {
      const auto [sample, weight] = bsdf.sample(context, q.interaction, q.u, q.u2, true);
      return weight.x() + sample.pdf;
    });
  };
  double once = std::numeric_limits<double>::max(), each = once;
  for (int run = 0; run < 200; ++run) {
    once = std::min(once, cost_of(*constant));
    each = std::min(each, cost_of(*varying));
  }
  std::printf("| %.0f°%s | %s | %.0f / %.0f = %.2f |\n", double(aperture), tilted ? ", tilted" : "", textured,
              each, once, each / once);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::fprintf(
        stderr,
        "usage: measure_bsdf_cost <folder with Mitsuba's plugins/> <folder with vgroove's plugins/>\n");
    return 2;
  }
  Thread::static_initialization();
  Logger::static_initialization();
  logger()->set_log_level(Warn);
  color_management_static_initialization(false, false);
  for (int i = 1; i < argument_count; ++i) file_resolver()->append(arguments[i]);

  // That of the wheel, or calls into it would find their arguments in the wrong place; the plug-in has the same.
#if defined(__AVX2__) && defined(__FMA__)
  std::puts("Mitsuba and the plug-in are compiled for AVX2 and FMA.\n");
#else
  std::puts("Mitsuba and the plug-in are compiled for the least that processors of this kind have.\n");
#endif
  std::puts("| distribution | roughness | bounce limit | eval | eval_pdf | sample, eval and pdf |");
  std::puts("|---|---|---|---|---|---|");
  for (const char* distribution : {"ggx", "beckmann"})
    for (const float roughness : {0.1f, 0.3f, 1.0f})
      for (const int bounces : {1, 2, 4, 5, 8, 13, 32}) print_row(distribution, roughness, bounces);

  std::puts("\n| grooves | texture | sample |");
  std::puts("|---|---|---|");
  for (const float aperture : {25.f, 45.f, 60.f, 90.f}) print_texture_row(aperture, false, "aperture");
  print_texture_row(60, false, "rotation");
  print_texture_row(60, true, "aperture");
  print_texture_row(60, true, "tilt");
}
