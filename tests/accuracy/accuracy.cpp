// SPDX-License-Identifier: BSD-3-Clause
/// Prints the table of docs/accuracy.md, the largest error of every function that a search can find, and
/// draws its figures.

#include <CLI/CLI.hpp>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "accuracy/error_plots.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/worst_arguments.hpp"
#include "accuracy/worst_case.hpp"

namespace {

using namespace vcavity::test;

struct Options {
  int samples = 20000;
  int steps = 20000;
  unsigned seed = 1;
  std::string function;
  std::string type;
  std::string worst_arguments;
  std::string plots;
};

template <class Real>
std::string described(const std::vector<std::string>& names, const std::vector<Real>& values) {
  std::ostringstream text;
  text << std::setprecision(4);
  for (std::size_t i = 0; i < values.size(); ++i)
    text << (i == 0 ? "" : ", ") << names[i] << " = " << values[i];
  return text.str();
}

/// The search, its table and the file of worst arguments, as they grow.
class Report {
 public:
  explicit Report(const Options& options) : options_(options) {
    rows_ << "# Arguments of the largest errors, written by: vcavity_accuracy --samples " << options.samples
          << " --steps " << options.steps << " --seed " << options.seed << '\n';
    std::cout << "| function | type | worst error (ε) | bound (ε) | condition there | at |\n"
                 "|---|---|---|---|---|---|\n";
  }

  /// Searches for the worst arguments of a function and prints them.
  template <class Real>
  void add(const Subject<Real>& subject) {
    if (!options_.function.empty() && options_.function != subject.name) return;
    if (!options_.type.empty() && options_.type != type_name<Real>()) return;
    Random random(options_.seed);
    const WorstCase<Real> worst = find_worst_case(subject, options_.samples, options_.steps, random);
    const Error& error = worst.error;
    std::cout << "| " << subject.name << " | " << type_name<Real>() << " | " << std::setprecision(3)
              << error.epsilons << " | " << error.bound << " | " << error.condition << " | "
              << described(subject.argument_names, worst.arguments) << " |" << std::endl;
    write_row(rows_, subject, worst.arguments);
    within_bounds_ = within_bounds_ && error.share() <= 1;
  }

  std::string rows() const { return rows_.str(); }
  bool within_bounds() const { return within_bounds_; }

 private:
  const Options& options_;
  std::ostringstream rows_;
  bool within_bounds_ = true;
};

/// Whether every error found is within its bound.
bool search(const Options& options) {
  Report report(options);
  const auto in_float = all_subjects<float>();
  const auto in_double = all_subjects<double>();
  const auto in_long_double = all_subjects<long double>();
  for (std::size_t i = 0; i < in_double.size(); ++i) {
    report.add(in_float[i]);
    report.add(in_double[i]);
    report.add(in_long_double[i]);
  }
  if (!options.worst_arguments.empty()) {
    std::ofstream file(options.worst_arguments);
    file << report.rows();
    if (!file.flush()) throw std::runtime_error("cannot write '" + options.worst_arguments + "'");
  }
  return report.within_bounds();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Searches for the largest error of every function of vcavity and prints a Markdown table, or draws\n"
      "figures. Exits with 1 if an error exceeds its bound.");
  app.add_option("--samples", options.samples, "random arguments per function and type")
      ->capture_default_str();
  app.add_option("--steps", options.steps, "steps of climbing from the worst of them")->capture_default_str();
  app.add_option("--seed", options.seed, "of the random numbers")->capture_default_str();
  app.add_option("--function", options.function, "only the function of this name in the table");
  app.add_option("--type", options.type, "only this number type")
      ->check(CLI::IsMember({"float", "double", "long double"}));
  app.add_option("--worst-arguments", options.worst_arguments, "file to write the worst arguments to");
  app.add_option("--plots", options.plots, "instead of searching, draw the figures into this folder")
      ->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    if (options.plots.empty()) return search(options) ? 0 : 1;
    write_error_plots(options.plots);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "vcavity_accuracy: " << error.what() << '\n';
    return 1;
  }
}
