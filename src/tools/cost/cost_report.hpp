// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What accuracy costs in time, measured on this machine.

#include <string>
#include <vector>

#include "tools/cost/measurement.hpp"
#include "tools/materials/material.hpp"
#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// Measurements that answer one question.
struct CostSection {
  std::string title;
  std::string error;  ///< what the error is one of, and against which reference
  std::vector<Measurement> rows;
};

/// Ways to one bi-hemispherical reflectance: the paper's midpoint rule, the same with the exact integral over
/// the position, Monte Carlo, the Embree ray tracer where that is built, Gauss quadrature between the kinks,
/// adaptive to a tolerance. The reference is the adaptive one in long double, to 1e-17.
CostSection cost_of_integrals(double aperture_deg, const RefractiveIndex& index);

/// Effects in the same value: models of polarisation, cut-offs, float.
CostSection cost_of_effects(double aperture_deg, const RefractiveIndex& index);

/// Ways to a map: the reflectance in some hundred directions, the error that of the worst.
CostSection cost_of_map(double aperture_deg, const RefractiveIndex& index);

/// Models of polarisation in the same map; the reference is the full one.
CostSection cost_of_polarization(double aperture_deg, const RefractiveIndex& index);

/// Colour of a map by the number of wavelengths, against steps of 1 nm.
/// @return without rows where the material is not known from 400 to 700 nm, or has no colour
CostSection cost_of_wavelengths(double aperture_deg, const Material& material);

/// The bi-hemispherical reflectance of any surface: its quadrature at one tolerance after the other. The reference is the
/// same quadrature to 1e-11.
CostSection cost_of_surface(const SurfaceDescription& surface, double wavelength_nm);

/// Models of polarisation in the reflectance of any surface in some hundred directions; the reference is the full one.
CostSection cost_of_polarization(const SurfaceDescription& surface, double wavelength_nm);

/// Seconds that the first method of a section would take for an error, extrapolated along the straight line
/// through its logarithms; infinite if it does not converge.
double seconds_of_first_method(const CostSection& section, double error);

/// The exponent p of a method whose error falls like time^-p; 0 if that is not what it does.
double convergence_exponent(const CostSection& section, const std::string& method);

}  // namespace vcavity::tools
