// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "cli/program.hpp"
#include "support/catch.hpp"

namespace {

const std::string cost = "cost --material 0.1249+3.3391i --aperture 60";

/// The cells of a row of a Markdown table.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream row(line);
  std::string cell;
  std::getline(row, cell, '|');
  while (std::getline(row, cell, '|')) {
    const auto begin = cell.find_first_not_of(' ');
    result.push_back(begin == cell.npos ? "" : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
  }
  return result;
}

}  // namespace

TEST_CASE("the cost of accuracy fits on a screen of 45 lines and 100 columns") {
  const std::vector<std::string> screen = lines_of(run(cost).out);
  CHECK(screen.size() > 30);
  CHECK(screen.size() <= 45);
  for (const std::string& line : screen) {
    CAPTURE(line);
    CHECK(line.size() <= 100);
  }
}

TEST_CASE("the whole table shows each method of the reflectance with the errors that it is known for") {
  std::map<std::string, std::vector<double>> errors;
  for (const std::string& line : lines_of(run(cost + " --all").out)) {
    if (line.starts_with("| **Bi-hemispherical, effects")) break;
    if (line.starts_with("|--")) continue;
    const std::vector<std::string> row = cells(line);
    if (row.size() == 6 && !row[3].empty() && row[0] != "method") errors[row[0]].push_back(std::stod(row[2]));
  }
  CHECK(errors.at("the paper's midpoint rule").size() == 5);
  CHECK(errors.at("the paper's midpoint rule").back() > 1e-6);
  CHECK(errors.at("adaptive").size() == 7);
  CHECK(errors.at("adaptive").back() < 1e-14);
  CHECK(errors.at("Gauss between kinks").front() > 1e-6);
  CHECK(errors.at("Gauss between kinks").back() < 1e-12);
#ifdef VCAVITY_TRACED_REFLECTANCE
  // A hundred times the rays, a tenth of the error; from 32 runs each known to about an eighth.
  const std::vector<double>& traced = errors.at("Embree ray tracer");
  REQUIRE(traced.size() == 3);
  CHECK(traced.front() < 0.02);
  CHECK(traced.back() < traced.front() / 5);
  CHECK(traced.back() > traced.front() / 20);
#endif
}

TEST_CASE(
    "the error of the BRDF of a rough surface falls with the bounce limit, that of random walks with the "
    "rays") {
  std::map<std::string, std::vector<double>> errors;
  for (const std::string& line :
       lines_of(run("cost --material 0.1249+3.3391i --distribution beckmann --roughness 0.5 --all").out)) {
    const std::vector<std::string> row = cells(line);
    if (row.size() == 5 && !row[3].empty() && row[0] != "method" && !line.starts_with("|--"))
      errors[row[0]].push_back(std::stod(row[2]));
  }
  const std::vector<double>& limits = errors.at("closed form");
  REQUIRE(limits.size() == 8);
  CHECK(limits.front() > 1e-2);
  CHECK(limits[3] < 1e-6);
  const std::vector<double>& walks = errors.at("random walks, explicit grooves");
  REQUIRE(walks.size() == 3);
  CHECK(walks.back() < walks.front());
  CHECK(errors.at("albedo table").front() < 1e-3);
}
