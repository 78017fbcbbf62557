// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The nine dispersion formulas of the refractiveindex.info database.
///
/// Source: M. N. Polyanskiy, "Dispersion formulas",
/// https://refractiveindex.info/download/dispersion_formulas.pdf; the database: Sci. Data 11, 94 (2024).

#include <cstddef>
#include <optional>
#include <span>

namespace vcavity::tools {

/// Most coefficients that a formula takes; nothing if there is no formula of that number.
std::optional<std::size_t> most_coefficients(int formula);

/// The number of the coefficient (2 for C2) that is the strength of an incomplete term: it is not 0, but the
/// list ends before the other coefficients of its term, such as the resonance wavelength. Nothing if all
/// terms are complete. A list cut short by mistake would give a plausible, wrong index.
std::optional<std::size_t> incomplete_term(int formula, std::span<const double> coefficients);

/// The refractive index n given by a dispersion formula.
/// @param formula 1 Sellmeier, 2 Sellmeier with squared resonances given, 3 polynomial, 4 the database's own, 5 Cauchy,
/// 6 gases, 7 Herzberger, 8 retro, 9 exotic
/// @param coefficients C1, C2, ... ; absent ones are 0
/// @param wavelength_um vacuum wavelength, > 0
/// @return n; NaN or infinity where the formula has no real value
double index_from_formula(int formula, std::span<const double> coefficients, double wavelength_um);

}  // namespace vcavity::tools
