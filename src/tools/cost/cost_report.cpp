// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cost/cost_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <vcavity/vcavity.hpp>

#include "tools/colour/colour_difference.hpp"
#include "tools/cost/traced_reflectance.hpp"
#include "tools/maps/disc_map.hpp"
#include "tools/materials/facet.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

constexpr int map_size = 24;  // some hundred directions

std::string count(const char* what, int number) {
  std::string text = what;
  return text.append(" ").append(std::to_string(number));
}

/// The value of `tolerance` as a setting.
std::string power_of_ten(int exponent) {
  std::string text = "tolerance 1e";
  return text.append(std::to_string(exponent));
}

/// The bi-hemispherical reflectance in long double, in the model of `wrap`.
template <class Wrap>
double reference(double aperture_deg, const RefractiveIndex& index, Wrap&& wrap) {
  using Real = long double;
  const Cavity<Real> cavity(radians(static_cast<Real>(aperture_deg)));
  const Conductor<Real> facet(static_cast<Real>(index.n), static_cast<Real>(index.k));
  return static_cast<double>(bihemispherical_reflectance(cavity, wrap(facet), Real(1e-17L)).value);
}

/// Midpoint rule over the directions alone.
template <class Facet>
double midpoint_over_directions(const Cavity<double>& cavity, const Facet& facet, int polar) {
  const double step = pi<double>() / 2 / polar;
  double sum = 0;
  for (int i = 0; i < polar; ++i) {
    const double theta = (i + 0.5) * step;
    double ring = 0;
    for (int j = 0; j < 2 * polar; ++j)
      ring += directional_reflectance(cavity, direction(theta, (j + 0.5) * pi<double>() / polar), facet);
    sum += std::cos(theta) * std::sin(theta) * ring;
  }
  return sum * step / polar;
}

/// Gauss–Legendre rules of a fixed order between the kinks.
template <class Facet>
double gauss_between_kinks(const Cavity<double>& cavity, const Facet& facet, int order) {
  const auto nodes = gauss_legendre<double>(static_cast<std::size_t>(order));
  const auto angles = kinks(cavity);
  const double quarter = pi<double>() / 4;
  double sum = 0;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    const double half = (angles[i + 1] - angles[i]) / 2;
    for (const auto& across : nodes) {
      const double theta = angles[i] + half * (1 + across.x);
      for (const auto& along : nodes) {
        const double psi = quarter * (1 + along.x);
        const double cos_psi = std::cos(psi);
        const Vec3<double> e{std::sin(psi), cos_psi * std::sin(theta), cos_psi * std::cos(theta)};
        sum += half * across.weight * quarter * along.weight * std::cos(theta) * cos_psi * cos_psi *
               directional_reflectance(cavity, e, facet);
      }
    }
  }
  return 4 / pi<double>() * sum;
}

/// The mean of random rays of diffuse light.
template <class Facet>
double monte_carlo(const Cavity<double>& cavity, const Facet& facet, int rays, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  double sum = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec3<double> e = direction(std::acos(std::sqrt(unit(random))), 2 * pi<double>() * unit(random));
    sum += ray_reflectance(cavity, e, 2 * unit(random) - 1, facet);
  }
  return sum / rays;
}

/// The error of a typical run, from several seeds; that of a single one would be a matter of luck.
template <class Estimate>
double typical_error(double expected, Estimate&& estimate) {
  constexpr int runs = 32;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const double error = estimate(seed) - expected;
    squares += error * error;
  }
  return std::sqrt(squares / runs);
}

#ifdef VCAVITY_TRACED_REFLECTANCE
void add_tracer(CostSection& section, double aperture, const RefractiveIndex& index, double expected) {
  const DiffuseTracer trace = diffuse_tracer(aperture, {index.n, index.k});
  for (const int rays : {100, 1'000, 10'000}) {
    const double error = typical_error(expected, [&](std::uint64_t seed) { return trace(rays, seed).mean; });
    long long reflections = 0;
    // Another seed for each repeat: the processor would learn the ways of equal rays.
    std::uint64_t repeat = 0;
    const double seconds = median_seconds([&] { reflections = trace(rays, ++repeat).reflections; });
    section.rows.push_back({"Embree ray tracer", count("rays", rays), error, seconds, reflections});
  }
}
#else
void add_tracer(CostSection&, double, const RefractiveIndex&, double) {}
#endif

std::vector<Vec3<double>> map_directions() {
  std::vector<Vec3<double>> result;
  for (int row = 0; row < map_size; ++row)
    for (int column = 0; column < map_size; ++column)
      if (const auto e = pixel_direction(column, row, map_size)) result.push_back(*e);
  return result;
}

/// A value for each direction.
template <class Reflectance>
std::vector<double> map_of(const std::vector<Vec3<double>>& directions, Reflectance&& reflectance) {
  std::vector<double> values;
  for (const Vec3<double>& e : directions) values.push_back(static_cast<double>(reflectance(e)));
  return values;
}

/// The reference of a map, in the model of `wrap`.
template <class Wrap>
std::vector<double> map_in_long_double(const std::vector<Vec3<double>>& directions, double aperture_deg,
                                       const RefractiveIndex& index, Wrap&& wrap) {
  const Cavity<long double> cavity(radians(static_cast<long double>(aperture_deg)));
  const auto facet = wrap(Conductor<long double>(index.n, index.k));
  return map_of(directions, [&](const Vec3<double>& e) {
    return unpolarized_reflectance(cavity, Vec3<long double>(e), facet);
  });
}

Cavity<float> in_float(const Cavity<double>& cavity) {
  return Cavity<float>(std::min(static_cast<float>(cavity.aperture()), pi<float>()));
}

/// The straight line through the logarithms of error and time: log error = intercept − exponent · log time.
struct PowerLaw {
  double exponent;
  double intercept;
};

PowerLaw power_law(const CostSection& section, const std::string& method) {
  double points = 0, sum_t = 0, sum_e = 0, sum_tt = 0, sum_te = 0;
  for (const Measurement& row : section.rows) {
    if (row.method != method || !(row.error > 0)) continue;
    const double t = std::log(row.seconds), e = std::log(row.error);
    points += 1;
    sum_t += t;
    sum_e += e;
    sum_tt += t * t;
    sum_te += t * e;
  }
  const double spread = points * sum_tt - sum_t * sum_t;
  if (points < 2 || !(spread > 0)) return {0, 0};
  const double slope = (points * sum_te - sum_t * sum_e) / spread;
  return {-slope, (sum_e - slope * sum_t) / points};
}

}  // namespace

CostSection cost_of_integrals(double aperture_deg, const RefractiveIndex& index) {
  const Cavity<double> cavity(radians(aperture_deg));
  const std::vector<double> expected{reference(aperture_deg, index, [](const auto& facet) { return facet; })};
  CostSection section{"Bi-hemispherical reflectance", "absolute error", {}};
  with_facet(index, [&](const auto& facet) {
    const auto add = [&](const char* method, const std::string& setting, auto&& compute) {
      section.rows.push_back(measure(method, setting, facet, expected, [&](const auto& counted) {
        return std::vector<double>{compute(counted)};
      }));
    };
    for (const int steps : {8, 16, 32, 64, 96})
      add("the paper's midpoint rule", count("steps", steps), [&](const auto& f) {
        return paper_method::bihemispherical_reflectance(cavity, f, steps, steps, 2 * steps);
      });
    for (const int rays : {1'000, 10'000, 100'000}) {
      std::uint64_t repeat = 0;  // as for the tracer
      add("Monte Carlo", count("rays", rays),
          [&](const auto& f) { return monte_carlo(cavity, f, rays, ++repeat); });
      section.rows.back().error = typical_error(
          expected.front(), [&](std::uint64_t seed) { return monte_carlo(cavity, facet, rays, seed); });
    }
    add_tracer(section, cavity.aperture(), index, expected.front());
    for (const int steps : {8, 16, 32, 64, 128, 256})
      add("exact position, midpoint", count("steps", steps),
          [&](const auto& f) { return midpoint_over_directions(cavity, f, steps); });
    for (const int order : {2, 3, 4, 6, 8, 12, 16, 24})
      add("Gauss between kinks", count("order", order),
          [&](const auto& f) { return gauss_between_kinks(cavity, f, order); });
    for (const int exponent : {-2, -4, -6, -8, -10, -12, -14})
      add("adaptive", power_of_ten(exponent), [&](const auto& f) {
        return bihemispherical_reflectance(cavity, f, std::pow(10.0, exponent)).value;
      });
  });
  return section;
}

CostSection cost_of_effects(double aperture_deg, const RefractiveIndex& index) {
  constexpr double tolerance = 1e-10;
  const Cavity<double> cavity(radians(aperture_deg));
  const std::vector<double> full{
      reference(aperture_deg, index, [](const auto& facet) { return polarized(facet); })};
  const std::vector<double> paper{reference(aperture_deg, index, [](const auto& facet) { return facet; })};
  CostSection section{
      "Bi-hemispherical, effects", "absolute error; models against full, others against none", {}};
  with_facet(index, [&](const auto& facet) {
    for (const Polarization model : {Polarization::none, Polarization::separate, Polarization::full})
      with_polarization(model, facet, [&](const auto& in_model) {
        section.rows.push_back(measure("polarization", name_of(model), in_model, full, [&](const auto& f) {
          return std::vector<double>{bihemispherical_reflectance(cavity, f, tolerance).value};
        }));
      });
    constexpr int most_shown = 6;
    for (int most = 1; most <= std::min(cavity.max_bounces(), most_shown); ++most)
      section.rows.push_back(measure("at most", count("bounces", most), facet, paper, [&](const auto& f) {
        return std::vector<double>{bihemispherical_reflectance(cavity, f, tolerance, most).value};
      }));
  });
  const Cavity<float> narrow = in_float(cavity);
  const Conductor<float> facet(static_cast<float>(index.n), static_cast<float>(index.k));
  section.rows.push_back(measure("precision", "float, to 1e-6", facet, paper, [&](const auto& f) {
    return std::vector<double>{static_cast<double>(bihemispherical_reflectance(narrow, f, 1e-6f).value)};
  }));
  section.rows.push_back(
      measure("precision", "double, to 1e-6", Conductor<double>(index.n, index.k), paper, [&](const auto& f) {
        return std::vector<double>{bihemispherical_reflectance(cavity, f, 1e-6).value};
      }));
  return section;
}

CostSection cost_of_map(double aperture_deg, const RefractiveIndex& index) {
  const std::vector<Vec3<double>> directions = map_directions();
  const Cavity<double> cavity(radians(aperture_deg));
  const std::vector<double> expected =
      map_in_long_double(directions, aperture_deg, index, [](const auto& facet) { return facet; });
  std::string title = "Map of ";
  CostSection section{
      title.append(std::to_string(directions.size())).append(" directions"), "largest absolute error", {}};
  with_facet(index, [&](const auto& facet) {
    for (const int positions : {16, 64, 256, 1024})
      section.rows.push_back(measure(
          "the paper's midpoint rule", count("positions", positions), facet, expected, [&](const auto& f) {
            return map_of(directions, [&](const Vec3<double>& e) {
              return paper_method::directional_reflectance(cavity, e, f, positions);
            });
          }));
    section.rows.push_back(measure("closed form", "double", facet, expected, [&](const auto& f) {
      return map_of(directions, [&](const Vec3<double>& e) { return directional_reflectance(cavity, e, f); });
    }));
  });
  const Cavity<float> narrow = in_float(cavity);
  const Conductor<float> facet(static_cast<float>(index.n), static_cast<float>(index.k));
  section.rows.push_back(measure("closed form", "float", facet, expected, [&](const auto& f) {
    return map_of(directions,
                  [&](const Vec3<double>& e) { return directional_reflectance(narrow, Vec3<float>(e), f); });
  }));
  return section;
}

CostSection cost_of_polarization(double aperture_deg, const RefractiveIndex& index) {
  const std::vector<Vec3<double>> directions = map_directions();
  const Cavity<double> cavity(radians(aperture_deg));
  const std::vector<double> expected =
      map_in_long_double(directions, aperture_deg, index, [](const auto& facet) { return polarized(facet); });
  CostSection section{"Map, polarisation", "largest absolute error against full", {}};
  with_facet(index, [&](const auto& facet) {
    for (const Polarization model : {Polarization::none, Polarization::separate, Polarization::full})
      with_polarization(model, facet, [&](const auto& in_model) {
        section.rows.push_back(
            measure("polarization", name_of(model), in_model, expected, [&](const auto& f) {
              return map_of(directions,
                            [&](const Vec3<double>& e) { return unpolarized_reflectance(cavity, e, f); });
            }));
      });
  });
  return section;
}

CostSection cost_of_wavelengths(double aperture_deg, const Material& material) {
  constexpr int low_nm = 400;
  constexpr int high_nm = 700;
  CostSection section{"Map, colours", "largest CIEDE2000 against steps of 1 nm", {}};
  if (material.constant() || material.range().min_um * 1000 > low_nm ||
      material.range().max_um * 1000 < high_nm)
    return section;
  const std::vector<Vec3<double>> directions = map_directions();
  const auto mapper = [&](int step_nm) {
    std::vector<double> wavelengths_nm;
    for (int nm = low_nm; nm <= high_nm; nm += step_nm) wavelengths_nm.push_back(nm);
    MapRequest request{{material, aperture_deg}, wavelengths_nm,       map_size, all_bounces,
                       Quantity::reflectance,    Spectrum::colour_only};
    request.colour_grid = ColourGrid::as_given;  // the cost of the grid is what is measured
    return DiscMapper(std::move(request));
  };
  const DiscMapper finest = mapper(1);
  std::vector<Lab> expected;
  for (const Vec3<double>& e : directions) expected.push_back(to_lab(finest.colour(e), finest.white()));
  const auto add = [&](const std::string& setting, auto&& colour, const Xyz& white) {
    double error = 0;
    for (std::size_t i = 0; i < directions.size(); ++i)
      error = std::max(error, delta_e_2000(to_lab(colour(directions[i]), white), expected[i]));
    const double seconds = median_seconds([&] {
      for (const Vec3<double>& e : directions) colour(e);
    });
    section.rows.push_back({"wavelengths", setting, error, seconds, 0});
  };
  for (const int step_nm : {5, 10, 20}) {
    const DiscMapper coarse = mapper(step_nm);
    add(
        std::to_string(step_nm).append(" nm"), [&](const Vec3<double>& e) { return coarse.colour(e); },
        coarse.white());
  }
  // What renderers do: one wavelength for each primary, and its reflectance taken for the component.
  constexpr double primaries_nm[] = {610, 550, 465};
  glm::dvec3 n, k;
  for (int i = 0; i < 3; ++i) {
    const RefractiveIndex index = material.at(primaries_nm[i]);
    n[i] = index.n;
    k[i] = index.k;
  }
  const Cavity<double> cavity(radians(aperture_deg));
  const Conductor<glm::dvec3> rgb(n, k);
  add(
      "610, 550, 465 nm",
      [&](const Vec3<double>& e) {
        const glm::dvec3 reflectance = directional_reflectance(cavity, e, rgb);
        return from_linear_srgb({reflectance.x, reflectance.y, reflectance.z});
      },
      from_linear_srgb({1, 1, 1}));
  return section;
}

CostSection cost_of_surface(const SurfaceDescription& surface, double wavelength_nm) {
  CostSection section{
      "bi-hemispherical reflectance", "absolute error of the reflectance, against a tolerance of 1e-11", {}};
  const auto made = make_surface(surface, wavelength_nm, {Polarization::none, all_bounces});
  const double expected = made->bihemispherical(1e-11).value;
  for (const int exponent : {-2, -4, -6, -8, -10}) {
    Integral<double> result{};
    const double seconds = median_seconds([&] { result = made->bihemispherical(std::pow(10, exponent)); });
    section.rows.push_back({"quadrature of the surface", power_of_ten(exponent),
                            std::abs(result.value - expected), seconds, result.evaluations});
  }
  return section;
}

CostSection cost_of_polarization(const SurfaceDescription& surface, double wavelength_nm) {
  CostSection section{"models of polarisation, map of directions",
                      "largest absolute error of a reflectance, against full",
                      {}};
  const std::vector<Vec3<double>> directions = map_directions();
  const auto reflectances = [&](const Surface& made) {
    std::vector<double> result;
    for (const Vec3<double>& e : directions) result.push_back(made.reflectance(e).unpolarized);
    return result;
  };
  const auto made = [&](Polarization model) {
    return make_surface(surface, wavelength_nm, {model, all_bounces});
  };
  const std::vector<double> expected = reflectances(*made(Polarization::full));
  for (const Polarization model : {Polarization::none, Polarization::separate, Polarization::full}) {
    const auto of_model = made(model);
    std::vector<double> found;
    const double seconds = median_seconds([&] { found = reflectances(*of_model); });
    double error = 0;
    for (std::size_t i = 0; i < found.size(); ++i) error = std::max(error, std::abs(found[i] - expected[i]));
    section.rows.push_back(
        {name_of(model), count("directions", static_cast<int>(directions.size())), error, seconds, 0});
  }
  return section;
}

double seconds_of_first_method(const CostSection& section, double error) {
  const PowerLaw law = power_law(section, section.rows.front().method);
  if (!(law.exponent > 0) || !(error > 0)) return std::numeric_limits<double>::infinity();
  return std::exp((law.intercept - std::log(error)) / law.exponent);
}

double convergence_exponent(const CostSection& section, const std::string& method) {
  return power_law(section, method).exponent;
}

}  // namespace vcavity::tools
