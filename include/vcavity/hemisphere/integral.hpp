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

namespace detail {

/// The estimate of the error of a part of the light, which is at most all of it, also where the estimate is no number.
template <class Scalar>
Scalar at_most_all_light(const Scalar& error) {
  return error <= Scalar(1) ? error : Scalar(1);
}

}  // namespace detail

}  // namespace vcavity
