// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/dispersion_formula.hpp"

#include <cassert>
#include <cmath>

namespace vcavity::tools {
namespace {

/// Coefficients numbered from 1, as in the published formulas.
class Coefficients {
 public:
  explicit Coefficients(std::span<const double> values) : values_(values) {}

  double operator[](std::size_t i) const { return i <= values_.size() ? values_[i - 1] : 0; }

  /// Sum of term(C_i, C_{i+1}) for i = first, first + 2, ... Terms of zero strength are left out: their other
  /// coefficient is often absent as well, and would make them 0/0.
  template <class Term>
  double sum_of_pairs(std::size_t first, Term term) const {
    double sum = 0;
    for (std::size_t i = first; i <= values_.size(); i += 2) {
      if ((*this)[i] != 0) sum += term((*this)[i], (*this)[i + 1]);
    }
    return sum;
  }

 private:
  std::span<const double> values_;
};

/// How many coefficients make up the term that begins with C_first.
std::size_t term_width(int formula, std::size_t first) {
  switch (formula) {
    case 4:
      return first < 10 ? 4 : 2;
    case 7:
      return 1;
    case 8:
      return first == 2 ? 2 : 1;
    case 9:
      return first == 2 ? 2 : 3;
    default:
      return 2;
  }
}

double square(double x) {
  return x * x;
}

}  // namespace

std::optional<std::size_t> most_coefficients(int formula) {
  switch (formula) {
    case 1:
    case 2:
    case 3:
    case 4:
      return 17;
    case 5:
    case 6:
      return 11;
    case 7:
    case 9:
      return 6;
    case 8:
      return 4;
    default:
      return std::nullopt;
  }
}

std::optional<std::size_t> incomplete_term(int formula, std::span<const double> coefficients) {
  const std::size_t count = coefficients.size();
  std::size_t first = 2;
  while (first + term_width(formula, first) <= count + 1) first += term_width(formula, first);
  if (first <= count && coefficients[first - 1] != 0) return first;
  return std::nullopt;
}

double index_from_formula(int formula, std::span<const double> coefficients, double wavelength_um) {
  const Coefficients c(coefficients);
  const double l = wavelength_um;
  const double l2 = l * l;
  const auto power = [l](double strength, double exponent) { return strength * std::pow(l, exponent); };

  switch (formula) {
    case 1:
      return std::sqrt(1 + c[1] +
                       c.sum_of_pairs(2, [l2](double b, double l0) { return b * l2 / (l2 - square(l0)); }));
    case 2:
      return std::sqrt(1 + c[1] + c.sum_of_pairs(2, [l2](double b, double l0_squared) {
        return b * l2 / (l2 - l0_squared);
      }));
    case 3:
      return std::sqrt(c[1] + c.sum_of_pairs(2, power));
    case 4: {
      const auto resonance = [&](std::size_t i) {
        return c[i] == 0 ? 0 : power(c[i], c[i + 1]) / (l2 - std::pow(c[i + 2], c[i + 3]));
      };
      return std::sqrt(c[1] + resonance(2) + resonance(6) + c.sum_of_pairs(10, power));
    }
    case 5:
      return c[1] + c.sum_of_pairs(2, power);
    case 6:
      return 1 + c[1] + c.sum_of_pairs(2, [l2](double b, double pole) { return b / (pole - 1 / l2); });
    case 7: {
      const double q = l2 - 0.028;
      return c[1] + c[2] / q + c[3] / square(q) + c[4] * l2 + c[5] * square(l2) + c[6] * l2 * square(l2);
    }
    case 8: {
      // x = (n^2 - 1) / (n^2 + 2)
      const double resonance = c[2] == 0 ? 0 : c[2] * l2 / (l2 - c[3]);
      const double x = c[1] + resonance + c[4] * l2;
      return std::sqrt((1 + 2 * x) / (1 - x));
    }
    case 9: {
      const double pole = c[2] == 0 ? 0 : c[2] / (l2 - c[3]);
      const double line = c[4] == 0 ? 0 : c[4] * (l - c[5]) / (square(l - c[5]) + c[6]);
      return std::sqrt(c[1] + pole + line);
    }
    default:
      assert(false && "formula out of range");
      return std::nan("");
  }
}

}  // namespace vcavity::tools
