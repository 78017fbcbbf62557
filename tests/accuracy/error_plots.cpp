// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy/error_plots.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vcavity/vcavity.hpp>
#include <vector>

#include "accuracy/long_ways.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/textbook_fresnel.hpp"
#include "tools/images/plot.hpp"

namespace vcavity::test {
namespace {

using tools::Axis;
using tools::Plot;
using tools::Series;

constexpr double least_shown = 0.1;  // ε; smaller errors are drawn there

/// |actual/exact − 1| in ε of `Real`, but at least what is shown.
template <class Real, class Actual>
double relative_error(const Actual& actual, const Digits50& exact) {
  const Digits50 error = abs(Digits50(Digits50(actual) / exact - 1));
  return std::max(least_shown, static_cast<double>(Digits50(error / Digits50(epsilon<Real>()))));
}

/// The larger of the last point of a curve and a new one.
void extend(Series& series, double x, double y) {
  if (!series.x.empty() && series.x.back() == x) {
    series.y.back() = std::max(series.y.back(), y);
  } else {
    series.x.push_back(x);
    series.y.push_back(y);
  }
}

Series line(const std::string& name) {
  return {name, {}, {}, Series::Look::line};
}

Plot error_plot(const std::string& title, const std::string& x_label, const std::string& y_label) {
  Plot plot;
  plot.title = title;
  plot.x = {x_label, Axis::Scale::logarithmic, std::nullopt};
  plot.y = {y_label, Axis::Scale::logarithmic, std::nullopt};
  plot.height = 400;
  return plot;
}

void write(const std::filesystem::path& file, const std::vector<Plot>& plots) {
  tools::AtomicFile target(file);
  tools::write_plots(target, plots);
  target.commit();
}

/// Reflectance of unpolarised light as textbooks have it, in the arithmetic of `Real`.
template <class Real>
Real textbook_reflectance(const Real& n, const Real& cos_i) {
  const Real cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (n * n));
  const Real r_s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
  const Real r_p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
  return (r_s * r_s + r_p * r_p) / 2;
}

/// Error of the reflectance of glass in float against its contrast n − 1.
Plot contrast_plot() {
  Plot plot = error_plot("Fresnel reflectance in float: weak contrast", "n − 1",
                         "largest relative error (ε = 1.2e-7)");
  plot.footnote = "Largest error at 200 angles up to 87° in each tenth of a decade.";
  Series textbook = line("textbook formula of n");
  Series rounding = line("rounding n, then exact");
  Series from_n = line("Dielectric(n)");
  Series from_contrast = line("Dielectric::from_contrast(n − 1)");
  Random random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  const auto exact = [](const Digits50& contrast, float cosine) {
    return TextbookFresnel<Digits50>(contrast, 0, cosine).reflectance();
  };
  for (int tenth = -90; tenth < 20; ++tenth)
    for (int i = 0; i < 200; ++i) {
      const float contrast = std::pow(10.0f, (static_cast<float>(tenth) + unit(random)) / 10);
      const float cosine = 0.05f + 0.95f * unit(random);
      const float n = 1 + contrast;
      const Digits50 wanted = exact(contrast, cosine);
      const Digits50 possible = exact(Digits50(n) - 1, cosine);
      const double x = std::pow(10, (tenth + 0.5) / 10);
      extend(from_contrast, x,
             relative_error<float>(Dielectric<float>::from_contrast(contrast)(cosine), wanted));
      extend(rounding, x, relative_error<float>(possible, wanted));
      if (n == 1) continue;
      extend(textbook, x, relative_error<float>(textbook_reflectance(n, cosine), possible));
      extend(from_n, x, relative_error<float>(Dielectric<float>(n)(cosine), possible));
    }
  plot.series = {textbook, rounding, from_n, from_contrast};
  return plot;
}

/// The largest errors up to each bounce as a line; some twenty points in a decade will do.
Series curve(const std::vector<double>& errors, const std::string& name) {
  Series series = line(name);
  for (double j = 1; j < static_cast<double>(errors.size()); j = std::ceil(j * 1.12))
    extend(series, j, std::max(least_shown, errors[static_cast<std::size_t>(j) - 1]));
  extend(series, static_cast<double>(errors.size()), std::max(least_shown, errors.back()));
  return series;
}

/// Error of cosines and throughputs against the number of bounces.
std::vector<Plot> bounces_plots() {
  const auto in_float = errors_on_long_ways<float>();
  const auto in_double = errors_on_long_ways<double>();
  const auto in_long_double = errors_on_long_ways<long double>();
  Plot cosines = error_plot("Cosines of incidence in a groove of 0.01°", "", "largest error (ε)");
  cosines.series = {curve(in_float.plain_turn, "float, plain addition"),
                    curve(in_double.plain_turn, "double, plain addition"), curve(in_float.cosine, "float"),
                    curve(in_double.cosine, "double"), curve(in_long_double.cosine, "long double")};
  Plot throughputs =
      error_plot("Throughput with n = 0.25 + 100i", "number of bounces", "largest relative error (ε)");
  throughputs.series = {curve(in_float.throughput, "float"), curve(in_double.throughput, "double"),
                        curve(in_long_double.throughput, "long double")};
  std::ostringstream footnote;
  footnote << std::setprecision(3) << "Largest errors up to each bounce among " << long_ways
           << " rays, in the plane across the groove and beside it. At the last bounce, in float, double and "
              "long double: cosines "
           << in_float.cosine.back() << ", " << in_double.cosine.back() << ", "
           << in_long_double.cosine.back() << " ε; throughput " << in_float.throughput.back() << ", "
           << in_double.throughput.back() << ", " << in_long_double.throughput.back() << " ε.";
  throughputs.footnote = footnote.str();
  return {cosines, throughputs};
}

/// The subject of that name.
template <class Real>
Subject<Real> subject_named(const std::string& name) {
  const auto subjects = groove_subjects<Real>();
  return *std::find_if(subjects.begin(), subjects.end(),
                       [&](const Subject<Real>& subject) { return subject.name == name; });
}

/// The error of a subject of silver grooves towards grazing incidence.
template <class Real>
Series towards_grazing(const Subject<Real>& subject, const std::string& name) {
  Series series = line(name);
  Random random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int quarter = -32; quarter <= 7; ++quarter)
    for (int i = 0; i < 50; ++i) {
      const double elevation_deg = std::pow(10, quarter / 4.0);
      const double phi = (i % 4 == 0 ? 1 : unit(random)) * pi<double>() / 2;
      const double e_z = std::sin(radians(elevation_deg)), across = std::cos(radians(elevation_deg));
      const double aperture = i % 5 == 0 ? pi<double>() : radians(10 + 170 * unit(random));
      std::vector<Real> arguments{static_cast<Real>(aperture),
                                  static_cast<Real>(across * std::sin(phi)),
                                  static_cast<Real>(across * std::cos(phi)),
                                  static_cast<Real>(e_z),
                                  Real(0.1249L),
                                  Real(3.3391L)};
      subject.repair(arguments);
      extend(series, elevation_deg, std::max(least_shown, error_of(subject, arguments).epsilons));
    }
  return series;
}

/// Error of directional reflectance and absorptance against the angle above the horizon.
Plot grazing_plot() {
  Plot plot = error_plot("Silver grooves towards grazing incidence", "90° − θ in degrees",
                         "largest error in units of max(ε, change/2)");
  plot.footnote = "Largest error for 50 pairs of aperture and azimuth at each angle.";
  const auto reflectance = subject_named<float>("directional reflectance");
  const auto absorptance = subject_named<float>("directional absorptance");
  Subject<float> difference = absorptance;
  difference.actual = [=](const std::vector<float>& a) -> Results<float> {
    return {{0, 1 - reflectance.actual(a).at(0)}};
  };
  plot.series = {towards_grazing(difference, "1 − reflectance, float"),
                 towards_grazing(reflectance, "reflectance, float"),
                 towards_grazing(subject_named<double>("directional reflectance"), "reflectance, double"),
                 towards_grazing(absorptance, "absorptance, float"),
                 towards_grazing(subject_named<double>("directional absorptance"), "absorptance, double")};
  return plot;
}

}  // namespace

void write_error_plots(const std::filesystem::path& folder) {
  write(folder / "accuracy_contrast.svg", {contrast_plot()});
  write(folder / "accuracy_bounces.svg", bounces_plots());
  write(folder / "accuracy_grazing.svg", {grazing_plot()});
}

}  // namespace vcavity::test
