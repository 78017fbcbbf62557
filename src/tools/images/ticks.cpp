// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string_view>

namespace vcavity::tools {
namespace {

// A tick this close to an end of the axis, in steps, is on the axis: the ends carry rounding errors.
constexpr double end_tolerance = 1e-9;

// Axes within these magnitudes have plain numbers, others a power of ten.
constexpr double smallest_plain = 1e-3;
constexpr double largest_plain = 1e6;

std::string with_true_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

std::string power_of_ten(int exponent) {
  static constexpr std::array<std::string_view, 10> superscript{"⁰", "¹", "²", "³", "⁴",
                                                                "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += superscript[static_cast<std::size_t>(digit - '0')];
  return text;
}

// mantissa · 10^exponent. The numbers on one axis, of which `largest` is the magnitude, share their decimals
// and power of ten.
std::string label(long long mantissa, int exponent, double largest) {
  if (mantissa == 0) return "0";
  const bool plain = largest >= smallest_plain && largest < largest_plain;
  const int power = plain ? 0 : static_cast<int>(std::floor(std::log10(largest)));
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", std::max(0, power - exponent),
                static_cast<double>(mantissa) * std::pow(10.0, exponent - power));
  return with_true_minus(text.data()) + (plain ? "" : "·" + power_of_ten(power));
}

std::size_t labelled(const std::vector<Tick>& ticks) {
  return static_cast<std::size_t>(
      std::count_if(ticks.begin(), ticks.end(), [](auto& t) { return !t.label.empty(); }));
}

// Powers of ten, every `stride`-th with a label; the rest and, where every power has a label, 2..9 times them
// are minor.
std::vector<Tick> decades(double low, double high, int first, int last, int stride) {
  std::vector<Tick> ticks;
  for (int exponent = first; exponent <= last; ++exponent)
    for (int digit = 1; digit <= (stride == 1 ? 9 : 1); ++digit) {
      const double value = digit * std::pow(10.0, exponent);
      if (value < low * (1 - end_tolerance) || value > high * (1 + end_tolerance)) continue;
      ticks.push_back({value, digit == 1 && exponent % stride == 0 ? power_of_ten(exponent) : ""});
    }
  return ticks;
}

std::vector<Tick> ones_twos_fives(double low, double high, int first, int last) {
  std::vector<Tick> ticks;
  for (int exponent = first; exponent <= last; ++exponent)
    for (const int digit : {1, 2, 5}) {
      const double value = digit * std::pow(10.0, exponent);
      if (value >= low * (1 - end_tolerance) && value <= high * (1 + end_tolerance))
        ticks.push_back({value, label(digit, exponent, value)});
    }
  return ticks;
}

}  // namespace

std::vector<Tick> linear_ticks(double low, double high, int most) {
  if (!(low < high) || !std::isfinite(high - low))
    throw std::invalid_argument("an axis needs a finite range, not " + std::to_string(low) + " to " +
                                std::to_string(high));
  int exponent = static_cast<int>(std::floor(std::log10((high - low) / most)));
  for (;; ++exponent)
    for (const int digit : {1, 2, 5}) {
      const double step = digit * std::pow(10.0, exponent);
      const double first = std::ceil(low / step - end_tolerance);
      const double last = std::floor(high / step + end_tolerance);
      if (last - first + 1 > most) continue;
      std::vector<Tick> ticks;
      for (double i = first; i <= last; ++i)
        ticks.push_back(
            {i * step, label(std::llround(i) * digit, exponent, std::max(std::abs(low), std::abs(high)))});
      return ticks;
    }
}

std::vector<Tick> log_ticks(double low, double high, int most) {
  if (!(low > 0 && low < high) || !std::isfinite(high))
    throw std::invalid_argument("a logarithmic axis needs a positive range, not " + std::to_string(low) +
                                " to " + std::to_string(high));
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  int stride = 1;
  while (labelled(decades(low, high, first, last, stride)) > static_cast<std::size_t>(most)) ++stride;
  std::vector<Tick> ticks = decades(low, high, first, last, stride);
  if (labelled(ticks) >= 2) return ticks;
  ticks = ones_twos_fives(low, high, first, last);
  return ticks.size() >= 2 ? ticks : linear_ticks(low, high, most);
}

}  // namespace vcavity::tools
