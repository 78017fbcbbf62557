// SPDX-License-Identifier: BSD-3-Clause
/// The bounds of docs/accuracy.md: at the worst arguments that long searches have found, and in a short
/// search of its own.

#include <algorithm>
#include <fstream>
#include <string>

#include "accuracy/bounds.hpp"
#include "accuracy/long_ways.hpp"
#include "accuracy/subjects.hpp"
#include "accuracy/worst_arguments.hpp"
#include "accuracy/worst_case.hpp"
#include "support/catch.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// Checks the errors at the arguments in a file, and returns for how many.
template <class Real>
std::size_t check_rows(const std::string& name) {
  std::ifstream file(VCAVITY_TEST_DATA "/" + name);
  REQUIRE(file);
  const auto subjects = all_subjects<Real>();
  std::size_t checked = 0;
  for (const Row& row : read_rows(file)) {
    if (row.type != type_name<Real>()) continue;
    const auto subject = std::find_if(subjects.begin(), subjects.end(),
                                      [&](const auto& candidate) { return candidate.name == row.function; });
    CAPTURE(row.function, row.type);
    REQUIRE(subject != subjects.end());
    REQUIRE(row.arguments.size() == subject->argument_names.size());
    const std::vector<Real> arguments(row.arguments.begin(), row.arguments.end());
    const Error error = error_of(*subject, arguments);
    CAPTURE(error.condition);
    CHECK(error.epsilons <= error.bound);
    ++checked;
  }
  return checked;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("errors stay within their bounds at the worst arguments ever found", "",
                        HardwareReals) {
  CHECK(check_rows<TestType>("worst_arguments.csv") == all_subjects<TestType>().size());
  CHECK(check_rows<TestType>("former_failures.csv") >= 1);
}

TEMPLATE_LIST_TEST_CASE("a short search finds no error beyond its bound", "", HardwareReals) {
  using Real = TestType;
  for (const Subject<Real>& subject : all_subjects<Real>()) {
    Random random(20261122);
    const WorstCase<Real> worst = find_worst_case(subject, 1000, 1000, random);
    CAPTURE(subject.name, worst.arguments, worst.error.condition);
    CHECK(worst.error.epsilons <= worst.error.bound);
    CHECK_FALSE(subject.actual(worst.arguments).empty());
  }
}

TEMPLATE_LIST_TEST_CASE("after 18 000 bounces the errors are within their bounds", "", HardwareReals) {
  using Real = TestType;
  LongWayErrors errors;
  vcavity::test::detail::follow(Vec3<Real>{Real(0), Real(0), Real(1)}, errors);
  REQUIRE(errors.cosine.size() >= 18000);
  CHECK(*std::max_element(errors.cosine.begin(), errors.cosine.end()) <= direction_bound);
  for (std::size_t j = 0; j < errors.throughput.size(); ++j)
    REQUIRE(errors.throughput[j] <= product_bound(static_cast<int>(j) + 1));
  // Without compensation the same recurrence drifts.
  CHECK(*std::max_element(errors.plain_turn.begin(), errors.plain_turn.end()) > direction_bound);
}
