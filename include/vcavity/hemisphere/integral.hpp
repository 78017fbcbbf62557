// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a quadrature returns.

#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// An integral, and how it was obtained.
template <class Value>
struct Integral {
  Value value;  ///< the integral
  scalar_t<Value>
      error;  ///< estimate of the absolute error, from the fall of the Legendre series of the integrand
  long long evaluations;  ///< number of evaluations of the facet reflectance
};

}  // namespace vcavity
