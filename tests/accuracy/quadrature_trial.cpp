// SPDX-License-Identifier: BSD-3-Clause
/// Prints a table of docs/accuracy.md: how often the bi-hemispherical reflectance of random grooves is farther
/// off than its error estimate, or than the tolerance.
///
///     vcavity_trial [--scenes N] [--seed S] [--only KIND] [--worst]
///     vcavity_trial --limits
///
/// A scene is a groove, a material, a model of polarisation and a tolerance. "Off" is measured against the same
/// quadrature asked for four digits more; scenes whose error estimate is then still above the tolerance say
/// nothing, and are counted. Narrow grooves have apertures from 0.001° to 20°, those of n < 1 from 0.3°; wide ones from
/// 20° to 180°. With --worst, the scenes that are farthest off in units of their estimate follow.
///
/// With --limits another table: for ten digits of some materials, how many evaluations of the facet they take at
/// apertures from 0.001° to 180°, and where the limit of evaluations leaves an estimate above the tolerance.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vcavity/vcavity.hpp>
#include <vector>

namespace {

using namespace vcavity;

struct Scene {
  double aperture_deg, n, k;
  int model;
};

/// Random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  double logarithmic(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

 private:
  std::mt19937_64 engine_;
};

struct Kind {
  const char* name;
  void (*material)(Random&, Scene&);
  double from_deg, to_deg;  ///< apertures
  double share;             ///< of the scenes asked for: the kinds that take long have fewer
};

void metal(Random& random, Scene& scene) {
  scene.n = random.logarithmic(0.05, 30);
  scene.k = random.logarithmic(0.4, 90);
}
void glass(Random& random, Scene& scene) {
  scene.n = 1 + random.logarithmic(0.003, 4);
  scene.k = random.between(0, 1) < 0.5 ? 0 : random.logarithmic(1e-6, 0.1);
}
void rarer(Random& random, Scene& scene) {
  scene.n = random.between(0.3, 0.999);
  scene.k = 0;
}
void absorbing_rarer(Random& random, Scene& scene) {
  scene.n = random.between(0.4, 0.995);
  scene.k = random.logarithmic(3e-5, 0.1);
}

constexpr Kind kinds[] = {
    {"metals", metal, 20, 180, 1},
    {"glasses", glass, 20, 180, 1},
    {"n < 1", rarer, 20, 180, 0.4},
    {"n < 1, absorbing", absorbing_rarer, 20, 180, 0.05},
    {"metals, narrow", metal, 0.001, 20, 0.1},
    {"glasses, narrow", glass, 0.001, 20, 0.2},
    {"n < 1, narrow", rarer, 0.3, 20, 0.01},
    {"n < 1, absorbing, narrow", absorbing_rarer, 0.3, 20, 0.01},
};

Scene random_scene(Random& random, const Kind& kind) {
  Scene scene{};
  const bool is_narrow = kind.to_deg < 90;
  scene.aperture_deg =
      is_narrow ? random.logarithmic(kind.from_deg, kind.to_deg) : random.between(kind.from_deg, kind.to_deg);
  kind.material(random, scene);
  scene.model = static_cast<int>(random.between(0, 3));
  return scene;
}

Integral<double> reflectance(const Scene& scene, double tolerance) {
  const Cavity<double> cavity(radians(scene.aperture_deg));
  const Conductor<double> facet(scene.n, scene.k);
  if (scene.model == 0) return bihemispherical_reflectance(cavity, facet, tolerance);
  if (scene.model == 1) return bihemispherical_reflectance(cavity, separately_polarized(facet), tolerance);
  return bihemispherical_reflectance(cavity, polarized(facet), tolerance);
}

/// The same for panels that are tilted by 20°, or by a third of what is possible.
Integral<double> tilted_reflectance(const Scene& scene, double tolerance) {
  const double aperture = radians(scene.aperture_deg);
  const AsymmetricGroove<double> groove(aperture, std::min(radians(20.0), (pi<double>() - aperture) / 6));
  return bihemispherical_reflectance(groove, Conductor<double>(scene.n, scene.k), tolerance);
}

/// Prints a row for a material and a model.
template <class Reflectance>
void print_limits(const Scene& material, const char* model, const std::vector<double>& apertures_deg,
                  const Reflectance& reflectance_of) {
  constexpr double tolerance = 1e-10;
  constexpr long long many = 300'000;
  long long most = 0;
  double most_at = 0, largest = 0;
  std::string above, missed;
  const auto list = [](std::string& names, double aperture_deg) {
    std::ostringstream name;
    name << (names.empty() ? "" : ", ") << aperture_deg;
    names += name.str();
  };
  for (const double aperture_deg : apertures_deg) {
    Scene scene = material;
    scene.aperture_deg = aperture_deg;
    const Integral<double> integral = reflectance_of(scene, tolerance);
    if (integral.evaluations > most) {
      most = integral.evaluations;
      most_at = aperture_deg;
    }
    if (integral.error > tolerance) {
      list(missed, aperture_deg);
      largest = std::max(largest, integral.error);
    } else if (integral.evaluations > many) {
      list(above, aperture_deg);
    }
  }
  std::cout << "| " << material.n << " + " << material.k << "i | " << model << " | " << most << " | "
            << most_at << " | " << (above.empty() ? "none" : above) << " | "
            << (missed.empty() ? "none" : missed) << " | ";
  if (missed.empty())
    std::cout << "– |" << std::endl;
  else
    std::cout << std::setprecision(2) << largest << std::setprecision(6) << " |" << std::endl;
}

void print_all_limits() {
  std::cout << "| n + ik | polarisation | most evaluations | at (°) | more than 300,000 at (°) | estimate "
               "above 1e-10 at "
               "(°) | the largest |\n|---|---|---|---|---|---|---|\n";
  // Where 180° is no multiple of the aperture, rays of most bounces end inside the range of u: that takes more.
  const std::vector<double> apertures_deg{0.001, 0.0017, 0.003, 0.007, 0.01, 0.017, 0.03, 0.07, 0.1,
                                          0.17,  0.3,    0.7,   1,     1.7,  3,     4.3,  7,    10,
                                          14,    20,     30,    45,    60,   90,    120,  150,  180};
  for (const Scene& material :
       {Scene{0, 1.0003, 0, 0}, Scene{0, 1.5, 0, 0}, Scene{0, 4.15, 0.043, 0}, Scene{0, 2.9, 3, 0},
        Scene{0, 0.96, 6.7, 0}, Scene{0, 0.1249, 3.3391, 0}, Scene{0, 30, 90, 0}, Scene{0, 0.25, 100, 0},
        Scene{0, 0.987667, 0, 0}, Scene{0, 0.7, 0, 0}, Scene{0, 0.3, 0, 0}, Scene{0, 0.95, 0.01, 0},
        Scene{0, 0.7, 0.001, 0}, Scene{0, 0.05, 0.0001, 0}}) {
    constexpr const char* models[] = {"none", "separate", "full"};
    for (int model = 0; model < 3; ++model) {
      Scene scene = material;
      scene.model = model;
      print_limits(scene, models[model], apertures_deg, reflectance);
    }
  }
  std::vector<double> tilted_deg;
  for (const double aperture_deg : apertures_deg)
    if (aperture_deg >= 0.1 && aperture_deg < 180) tilted_deg.push_back(aperture_deg);
  for (const Scene& material : {Scene{0, 1.5, 0, 0}, Scene{0, 0.1249, 3.3391, 0}, Scene{0, 0.7, 0, 0}})
    print_limits(material, "none; unequal panels, from 0.1°", tilted_deg, tilted_reflectance);
}

struct Result {
  Scene scene;
  double off, estimate, tolerance;
};

struct Counts {
  long scenes = 0, above_estimate = 0, above_tolerance = 0, promised_less = 0, unknown = 0;
  double evaluations = 0;
  long long most_evaluations = 0;
};

Counts trial(const Kind& kind, double tolerance, int scenes, unsigned seed, std::vector<Result>& results) {
  Random random(seed);
  Counts counts;
  for (int i = 0; i < scenes; ++i) {
    const Scene scene = random_scene(random, kind);
    constexpr double finer = 1e-4, finest = 3e-14;
    const Integral<double> exact = reflectance(scene, std::max(tolerance * finer, finest));
    if (exact.error > tolerance) {
      ++counts.unknown;
      continue;
    }
    const Integral<double> integral = reflectance(scene, tolerance);
    const double off = std::abs(integral.value - exact.value);
    ++counts.scenes;
    // What the finer computation does not know is no fault of the coarser one.
    if (off > integral.error + exact.error) ++counts.above_estimate;
    if (off > tolerance + exact.error) ++counts.above_tolerance;
    if (integral.error > tolerance) ++counts.promised_less;
    counts.evaluations += static_cast<double>(integral.evaluations);
    counts.most_evaluations = std::max(counts.most_evaluations, integral.evaluations);
    results.push_back({scene, off, integral.error, tolerance});
  }
  return counts;
}

}  // namespace

int main(int argc, char** argv) {
  int scenes = 50;
  unsigned seed = 1;
  bool worst = false, limits = false;
  std::string only;
  CLI::App program("Tries the error estimate of the bi-hemispherical reflectance on random scenes");
  program
      .add_option("--scenes", scenes,
                  "of a tolerance and each kind that takes no time, fewer of the others (default 50)")
      ->check(CLI::PositiveNumber);
  program.add_option("--seed", seed, "of the random numbers (default 1)");
  program.add_option("--only", only, "a single kind of scenes, such as \"metals, narrow\"");
  program.add_flag("--worst", worst, "print the scenes that are farthest off in units of their estimate");
  program.add_flag("--limits", limits, "print instead what ten digits take at all apertures");
  CLI11_PARSE(program, argc, argv);

  if (limits) {
    print_all_limits();
    return 0;
  }
  std::vector<Result> results;
  long all = 0, above_estimate = 0, above_tolerance = 0;
  std::cout << "| material, groove | tolerance | scenes | above the estimate | above the tolerance | "
               "estimate above the "
               "tolerance | not known finer | evaluations, mean | most |\n"
               "|---|---|---|---|---|---|---|---|---|\n";
  for (const Kind& kind : kinds)
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      ++seed;
      if (!only.empty() && only != kind.name) continue;
      const int of_kind = std::max(static_cast<int>(std::lround(kind.share * scenes)), 1);
      const Counts counts = trial(kind, tolerance, of_kind, seed, results);
      std::cout << "| " << kind.name << " | " << tolerance << " | " << counts.scenes << " | "
                << counts.above_estimate << " | " << counts.above_tolerance << " | " << counts.promised_less
                << " | " << counts.unknown << " | "
                << std::llround(counts.evaluations / static_cast<double>(std::max(counts.scenes, 1L)))
                << " | " << counts.most_evaluations << " |" << std::endl;
      all += counts.scenes;
      above_estimate += counts.above_estimate;
      above_tolerance += counts.above_tolerance;
    }
  std::cout << "\n"
            << all << " scenes, " << above_estimate << " above the estimate, " << above_tolerance
            << " above the tolerance\n";
  if (!worst) return 0;
  constexpr std::size_t shown = 10;
  const auto first = results.begin(),
             last = first + static_cast<std::ptrdiff_t>(std::min(shown, results.size()));
  std::partial_sort(first, last, results.end(),
                    [](const Result& a, const Result& b) { return a.off * b.estimate > b.off * a.estimate; });
  std::cout << "\nFarthest off:\n" << std::setprecision(17);
  for (auto result = first; result != last; ++result)
    std::cout << "aperture " << result->scene.aperture_deg << "°, n " << result->scene.n << ", k "
              << result->scene.k << ", model " << result->scene.model << ", tolerance " << result->tolerance
              << ": off " << result->off << ", estimate " << result->estimate << '\n';
}
