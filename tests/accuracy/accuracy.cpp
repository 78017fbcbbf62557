// SPDX-License-Identifier: BSD-3-Clause
/// Prints the table of docs/accuracy.md: the largest error of every function that a search can find.

#include <CLI/CLI.hpp>
#include <fstream>
#include <functional>
#include <future>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "accuracy/subjects.hpp"

namespace {

using namespace vcavity::test;

struct Options {
  int samples = 20000;
  int steps = 20000;
  unsigned seed = 1;
  std::string worst_arguments;
};

template <class Real>
std::string described(const std::vector<std::string>& names, const std::vector<Real>& values) {
  std::ostringstream text;
  text << std::setprecision(4);
  for (std::size_t i = 0; i < values.size(); ++i)
    text << (i == 0 ? "" : ", ") << names[i] << " = " << values[i];
  return text.str();
}

/// What the search found in one number type.
struct Findings {
  std::string table;
  std::string rows;  ///< of the file of worst arguments
  bool within_bounds = true;
};

template <class Real>
Findings measure(const Options& options) {
  Findings findings;
  std::ostringstream table;
  std::ostringstream rows;
  for (const Subject<Real>& subject : all_subjects<Real>()) {
    Random random(options.seed);
    const WorstCase<Real> worst = find_worst_case(subject, options.samples, options.steps, random);
    const Error& error = worst.error;
    table << "| " << subject.name << " | " << type_name<Real>() << " | " << std::setprecision(3)
          << error.epsilons << " | " << error.bound << " | " << error.condition << " | "
          << described(subject.argument_names, worst.arguments) << " |\n";
    write_row(rows, subject, worst.arguments);
    findings.within_bounds = findings.within_bounds && error.share() <= 1;
  }
  findings.table = table.str();
  findings.rows = rows.str();
  return findings;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Searches for the largest error of every function of vcavity and prints a Markdown table.\n"
      "Exits with 1 if an error exceeds its bound.");
  app.add_option("--samples", options.samples, "random arguments per function and type")
      ->capture_default_str();
  app.add_option("--steps", options.steps, "steps of climbing from the worst of them")->capture_default_str();
  app.add_option("--seed", options.seed, "of the random numbers")->capture_default_str();
  app.add_option("--worst-arguments", options.worst_arguments, "file to write the worst arguments to");
  CLI11_PARSE(app, argc, argv);

  std::vector<std::future<Findings>> searches;
  searches.push_back(std::async(std::launch::async, measure<float>, std::cref(options)));
  searches.push_back(std::async(std::launch::async, measure<double>, std::cref(options)));
  searches.push_back(std::async(std::launch::async, measure<long double>, std::cref(options)));

  std::ostringstream rows;
  rows << "# Arguments of the largest errors, written by: vcavity_accuracy --samples " << options.samples
       << " --steps " << options.steps << " --seed " << options.seed << '\n';
  std::cout << "| function | type | worst error (ε) | bound (ε) | condition there | at |\n"
               "|---|---|---|---|---|---|\n";
  bool within_bounds = true;
  for (std::future<Findings>& search : searches) {
    const Findings findings = search.get();
    std::cout << findings.table << std::flush;
    rows << findings.rows;
    within_bounds = within_bounds && findings.within_bounds;
  }
  if (!options.worst_arguments.empty()) {
    std::ofstream file(options.worst_arguments);
    file << rows.str();
    if (!file.flush()) {
      std::cerr << "cannot write " << options.worst_arguments << '\n';
      return 1;
    }
  }
  return within_bounds ? 0 : 1;
}
