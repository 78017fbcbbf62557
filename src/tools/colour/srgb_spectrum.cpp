// SPDX-License-Identifier: BSD-3-Clause
#include "tools/colour/srgb_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "tools/colour/spectral_weights.hpp"

namespace vcavity::tools {
namespace {

glm::dvec3 vector_of(const LinearRgb& colour) {
  return {colour.r, colour.g, colour.b};
}

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The wavelength in a variable from −1 to 1.
double place_of(double wavelength_nm) {
  return (wavelength_nm - 570) / 210;
}

double sigmoid(double p) {
  return 0.5 + p / (2 * std::sqrt(1 + p * p));
}

/// Finds the coefficients of a colour.
class Fit {
 public:
  Fit() {
    for (int nm = 360; nm <= 780; nm += 5) wavelengths_nm_.push_back(nm);
    const SpectralWeights weights(wavelengths_nm_, Illuminant::d65, Observer::cie_1931_2deg);
    for (const Xyz& weight : weights.weights()) rgb_.push_back(vector_of(to_linear_srgb(weight)));
    for (const glm::dvec3& weight : rgb_) white_ += weight;
  }

  /// The colour of a spectrum. A perfect reflector is made exactly white, which rounded matrices miss by 1e-4.
  /// @param slopes receives the derivatives by the coefficients
  glm::dvec3 colour(const glm::dvec3& coefficients, glm::dmat3& slopes) const {
    glm::dvec3 sum(0.0);
    slopes = glm::dmat3(0.0);
    for (std::size_t i = 0; i < rgb_.size(); ++i) {
      const double x = place_of(wavelengths_nm_[i]);
      const double p = coefficients.x + x * (coefficients.y + x * coefficients.z);
      const glm::dvec3 weight = rgb_[i] / white_;
      sum += sigmoid(p) * weight;
      const glm::dvec3 slope = weight * (0.5 * std::pow(1 + p * p, -1.5));
      slopes[0] += slope;
      slopes[1] += x * slope;
      slopes[2] += x * x * slope;
    }
    return sum;
  }

  /// Improves coefficients by the method of Levenberg and Marquardt until the colour is met or comes no closer.
  /// @return the largest difference that is left
  double improve(glm::dvec3& coefficients, const glm::dvec3& target) const {
    constexpr int most_steps = 200;
    constexpr double close_enough = 1e-10;
    double damping = 1e-6;
    glm::dmat3 slopes, trial_slopes;
    glm::dvec3 difference = colour(coefficients, slopes) - target;
    for (int step = 0; step < most_steps && largest(difference) > close_enough; ++step) {
      const glm::dmat3 normal = glm::transpose(slopes) * slopes;
      glm::dmat3 damped = normal;
      for (int i = 0; i < 3; ++i) damped[i][i] += damping * normal[i][i];
      const glm::dvec3 trial = coefficients - glm::inverse(damped) * (glm::transpose(slopes) * difference);
      const glm::dvec3 trial_difference = colour(trial, trial_slopes) - target;
      if (glm::dot(trial_difference, trial_difference) < glm::dot(difference, difference)) {
        coefficients = trial;
        difference = trial_difference;
        slopes = trial_slopes;
        damping = std::max(damping / 10, 1e-12);
      } else {
        damping = damping * 10 + 1e-12;
      }
    }
    return largest(difference);
  }

 private:
  std::vector<double> wavelengths_nm_;
  std::vector<glm::dvec3> rgb_;
  glm::dvec3 white_{0.0};
};

}  // namespace

SrgbSpectrum::SrgbSpectrum(const LinearRgb& colour) {
  const glm::dvec3 target = vector_of(colour);
  if (target.x == target.y && target.y == target.z) {
    grey_ = true;
    grey_reflectance_ = target.x;
    return;
  }
  // From a grey towards the colour: saturated ones are not found from afar.
  constexpr int stages = 20;
  const glm::dvec3 grey(0.5);
  const Fit fit;
  glm::dvec3 coefficients(0.0);
  for (int stage = 1; stage <= stages; ++stage)
    error_ = fit.improve(coefficients, grey + (static_cast<double>(stage) / stages) * (target - grey));
  coefficients_ = {coefficients.x, coefficients.y, coefficients.z};
}

double SrgbSpectrum::at(double wavelength_nm) const {
  if (grey_) return grey_reflectance_;
  const double x = place_of(wavelength_nm);
  return sigmoid(coefficients_[0] + x * (coefficients_[1] + x * coefficients_[2]));
}

}  // namespace vcavity::tools
