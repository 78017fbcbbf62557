// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <complex>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// ∫ f over [−1, 1] by a Gauss–Legendre rule in a variable.
template <class Real, class Function>
Real integral(const Substitution& variable, std::size_t order, const Function& f) {
  Real sum(0);
  for (const auto& node : gauss_legendre<Real>(order)) {
    const auto [x, slope] = variable.at(node.x);
    sum += node.weight * slope * f(x);
  }
  return sum;
}

/// The real part of √(x − c − id), in closed form.
double blurred_root(double x, double centre, double width) {
  return std::sqrt(std::complex<double>(x - centre, -width)).real();
}

/// Its integral over [−1, 1].
double integral_of_blurred_root(double centre, double width) {
  const auto primitive = [&](double x) {
    return 2.0 / 3 * std::pow(std::complex<double>(x - centre, -width), 1.5);
  };
  return (primitive(1) - primitive(-1)).real();
}

}  // namespace

TEMPLATE_LIST_TEST_CASE(
    "a substitution about a branch point keeps the ends of the range, and its slope is a derivative", "",
    HardwareReals) {
  using Real = TestType;
  for (const double centre : {-1.5, 0.0, 0.3, 1.0})
    for (const double width : {1e-4, 0.1, 3.0}) {
      const Substitution variable = SinhSubstitution(centre, width);
      const Real rounding = Real(64) * epsilon<Real>();
      CHECK(std::abs(variable.at(Real(-1))[0] + Real(1)) < rounding);
      CHECK(std::abs(variable.at(Real(1))[0] - Real(1)) < rounding);
      const Real step = std::cbrt(epsilon<Real>());
      const auto [x, slope] = variable.at(Real(0.2));
      const Real rise = variable.at(Real(0.2) + step)[0] - variable.at(Real(0.2) - step)[0];
      CHECK(rise / (Real(2) * step) == Approx(slope).epsilon(static_cast<double>(Real(500) * step * step)));
    }
}

TEST_CASE("a pair of square roots next to the real axis is smooth in a variable of its own") {
  for (const double width : {1e-2, 1e-4, 1e-6})
    for (const double centre : {0.0, 0.4, -0.97}) {
      const double exact = integral_of_blurred_root(centre, width);
      const auto f = [&](double x) { return blurred_root(x, centre, width); };
      CAPTURE(width, centre);
      CHECK(std::abs(integral<double>(SinhSubstitution(centre, width), 32, f) - exact) < 1e-11);
      CHECK(std::abs(integral<double>(SineSubstitution(1), 32, f) - exact) > 1e-7);
    }
}

TEST_CASE("points of a substitution about a branch point are found again, on either sheet of the root") {
  const SinhSubstitution variable(0.2, 0.05);
  const auto x_of = [](const std::complex<double>& u) {
    const double low = std::asinh(-1.2 / 0.05), high = std::asinh(0.8 / 0.05);
    return 0.2 + 0.05 * std::sinh(0.5 * (low + high) + 0.5 * (high - low) * u);
  };
  for (const std::complex<double> x : {std::complex<double>(0.1, 0.3), {0.9, 0.0}, {-2.0, 0.7}}) {
    const std::complex<double> u = variable.inverse(x), other = variable.inverse_on_other_sheet(x);
    CHECK(std::abs(x_of(u) - x) < 1e-13);
    CHECK(std::abs(x_of(other) - x) < 1e-13);
    CHECK(std::abs(u - other) > 0.1);
  }
}
