// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/colour_difference.hpp"

#include <cmath>
#include <numbers>

namespace vcavity::tools {
namespace {

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}
double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

double square(double x) {
  return x * x;
}

/// sqrt(C^7 / (C^7 + 25^7)): 0 for grey, 1 for vivid colours.
double vividness(double chroma) {
  const double chroma_7 = std::pow(chroma, 7);
  return std::sqrt(chroma_7 / (chroma_7 + std::pow(25.0, 7)));
}

/// The hue angle, in degrees from 0 to 360.
double hue(double a, double b) {
  const double angle = degrees(std::atan2(b, a));
  return angle < 0 ? angle + 360 : angle;
}

}  // namespace

double delta_e_2000(const Lab& first, const Lab& second) {
  // Eq. 2-7: a* is stretched where colours are nearly grey.
  const double mean_chroma_ab = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const double stretch = 1 + (1 - vividness(mean_chroma_ab)) / 2;
  const double a_1 = stretch * first.a;
  const double a_2 = stretch * second.a;
  const double c_1 = std::hypot(a_1, first.b);
  const double c_2 = std::hypot(a_2, second.b);
  const double h_1 = hue(a_1, first.b);
  const double h_2 = hue(a_2, second.b);

  // Eq. 8-11. The turn from one hue to the other comes from the vector product, not from the difference of
  // the angles: only so are opposite colours half a turn apart in spite of rounding. The hue of a grey does
  // not matter, delta_h is 0.
  double turn = degrees(std::atan2(a_1 * second.b - a_2 * first.b, a_1 * a_2 + first.b * second.b));
  if (std::abs(turn) == 180) turn = std::copysign(180, h_2 - h_1);
  const double delta_l = second.lightness - first.lightness;
  const double delta_c = c_2 - c_1;
  const double delta_h = 2 * std::sqrt(c_1 * c_2) * std::sin(radians(turn / 2));

  // Eq. 12-14.
  const double mean_l = (first.lightness + second.lightness) / 2;
  const double mean_c = (c_1 + c_2) / 2;
  const double mean_h = std::fmod(h_1 + turn / 2 + 360, 360);

  // Eq. 15-21: weights, and the rotation term that couples chroma and hue in the blue.
  const double t = 1 - 0.17 * std::cos(radians(mean_h - 30)) + 0.24 * std::cos(radians(2 * mean_h)) +
                   0.32 * std::cos(radians(3 * mean_h + 6)) - 0.20 * std::cos(radians(4 * mean_h - 63));
  const double s_l = 1 + 0.015 * square(mean_l - 50) / std::sqrt(20 + square(mean_l - 50));
  const double s_c = 1 + 0.045 * mean_c;
  const double s_h = 1 + 0.015 * mean_c * t;
  const double rotation = 30 * std::exp(-square((mean_h - 275) / 25));
  const double r_t = -std::sin(radians(2 * rotation)) * 2 * vividness(mean_c);

  // Eq. 22.
  const double l = delta_l / s_l;
  const double c = delta_c / s_c;
  const double h = delta_h / s_h;
  return std::sqrt(square(l) + square(c) + square(h) + r_t * c * h);
}

}  // namespace vcavity::tools
