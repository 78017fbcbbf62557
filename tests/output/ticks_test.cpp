// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/ticks.hpp"

#include <random>

#include "support/catch.hpp"

using namespace vcavity::tools;
using Labels = std::vector<std::string>;

namespace {

Labels labels(const std::vector<Tick>& ticks) {
  Labels result;
  for (const auto& tick : ticks)
    if (!tick.label.empty()) result.push_back(tick.label);
  return result;
}

}  // namespace

TEST_CASE("linear ticks are round numbers with the decimals they need") {
  CHECK(labels(linear_ticks(0, 1, 6)) == Labels{"0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(labels(linear_ticks(380, 780, 6)) == Labels{"400", "500", "600", "700"});
  CHECK(labels(linear_ticks(-0.1, 0.1, 5)) == Labels{"−0.10", "−0.05", "0", "0.05", "0.10"});
  CHECK(labels(linear_ticks(0.9583, 0.9591, 5)) == Labels{"0.9584", "0.9586", "0.9588", "0.9590"});
}

TEST_CASE("an end that rounding has moved by a hair keeps its tick") {
  CHECK(labels(linear_ticks(0, 0.1 + 0.2, 4)) == Labels{"0", "0.1", "0.2", "0.3"});
  CHECK(labels(linear_ticks(0.1 + 0.2, 0.6, 4)) == Labels{"0.3", "0.4", "0.5", "0.6"});
  CHECK(labels(linear_ticks(-0.1 - 0.2, 0, 4)) == Labels{"−0.3", "−0.2", "−0.1", "0"});
  CHECK(labels(linear_ticks(0, 3 * 1.1, 4)) == Labels{"0", "1", "2", "3"});
  CHECK(labels(linear_ticks(0, 1 - 1e-13, 6)).back() == "1.0");
}

TEST_CASE("a short range far from zero keeps plain numbers") {
  CHECK(labels(linear_ticks(0.958302, 0.958306, 3)) == Labels{"0.958302", "0.958304", "0.958306"});
}

TEST_CASE("very large and very small ticks carry a power of ten") {
  CHECK(labels(linear_ticks(0, 3e-7, 4)) == Labels{"0", "1·10⁻⁷", "2·10⁻⁷", "3·10⁻⁷"});
  CHECK(labels(linear_ticks(0, 2.5e-6, 6)) ==
        Labels{"0", "0.5·10⁻⁶", "1.0·10⁻⁶", "1.5·10⁻⁶", "2.0·10⁻⁶", "2.5·10⁻⁶"});
  CHECK(labels(linear_ticks(0, 4e6, 3)) == Labels{"0", "2·10⁶", "4·10⁶"});
}

TEST_CASE("logarithmic ticks label as many powers of ten as there is room for") {
  CHECK(labels(log_ticks(1e-3, 1e3, 10)) == Labels{"10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹", "10²", "10³"});
  CHECK(labels(log_ticks(1e-3, 1e3, 4)) == Labels{"10⁻²", "10⁰", "10²"});
  CHECK(log_ticks(1, 100, 5).size() == 19);
}

TEST_CASE("short logarithmic ranges still get labels") {
  CHECK(labels(log_ticks(0.15, 6, 8)) == Labels{"0.2", "0.5", "1", "2", "5"});
  CHECK(labels(log_ticks(1.2, 1.8, 4)) == Labels{"1.2", "1.4", "1.6", "1.8"});
}

TEST_CASE("ticks stay within the axis, ascend, and respect the limit") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-12, 8), position(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const double span = std::pow(10, exponent(random)), low = span * 10 * position(random), high = low + span;
    const int most = 2 + i % 9;
    const auto ticks = linear_ticks(low, high, most);
    CAPTURE(low, high, most);
    REQUIRE(ticks.size() <= static_cast<std::size_t>(most));
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      CHECK(ticks[k].value >= low - 1e-6 * span);
      CHECK(ticks[k].value <= high + 1e-6 * span);
      if (k > 0) CHECK(ticks[k].value > ticks[k - 1].value);
    }
  }
}

TEST_CASE("axes without an extent are refused") {
  CHECK_THROWS_AS(linear_ticks(1, 1, 5), std::invalid_argument);
  CHECK_THROWS_AS(linear_ticks(0, INFINITY, 5), std::invalid_argument);
  CHECK_THROWS_AS(linear_ticks(NAN, 1, 5), std::invalid_argument);
  CHECK_THROWS_AS(log_ticks(0, 1, 5), std::invalid_argument);
  CHECK_THROWS_AS(log_ticks(2, 1, 5), std::invalid_argument);
}
