// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The exchange of light between the equal panels of a groove, discretised: for light that does not fill them evenly.
///
/// Method. A Nyström method on the places of `PanelGrid`. Where a panel of its quadrature is long against its distance
/// from the place that it lights, its integral is taken in pieces.
///
/// The aperture plays its part here alone; each pair of albedos then costs a factorisation, see
/// lambertian_cavity.hpp. For panels of unequal length see asymmetric_lambertian.hpp.
/// Good to some 1e-12 in double and long double, 1e-5 in float; what is achieved is measured against the closed form of
/// interreflection_kernel.hpp.

#include <cstddef>
#include <vector>

#include "vcavity/groove/cavity.hpp"
#include "vcavity/matte/panel_grid.hpp"
#include "vcavity/matte/strip_kernel.hpp"
#include "vcavity/numbers/linear_system.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// The exchange matrix of a groove with panels of unit width.
template <class Real>
class PanelExchange {
 public:
  explicit PanelExchange(const Cavity<Real>& cavity)
      : cavity_(cavity), grid_(cavity.aperture()), kernel_(cavity), matrix_(grid_.x().size()), squared_(0) {
    for (const Real& s : grid_.positions()) from_apex_.push_back(kernel_.below(s, grid_.apex_width()));
    kernel_.fill_block(matrix_, 0, grid_, 0, grid_, Real(0));
    squared_ = matrix_ * matrix_;
  }

  const Cavity<Real>& cavity() const { return cavity_; }

  /// The places on either panel.
  const PanelGrid<Real>& grid() const { return grid_; }

  /// What the apex region of the other panel, at radiosity 1, sends to the nodes.
  const std::vector<Real>& from_apex() const { return from_apex_; }

  /// The matrix of f ↦ ∫ K(s, t) f(t) dt between the nodes.
  const SquareMatrix<Real>& matrix() const { return matrix_; }

  /// Its square: the light that has crossed the groove twice.
  const SquareMatrix<Real>& squared() const { return squared_; }

  /// The mean of K(s, t) over t in [from, 1], with all its digits as `from` tends to 1.
  /// @param s,from in [0, 1], not both 0
  Real mean_kernel(const Real& s, const Real& from) const { return kernel_.mean(s, from, Real(1)); }

  /// The mean of K over [a, 1] on one panel and [b, 1] on the other.
  /// @param a,b in [0, 1)
  Real mean_kernel_of_strips(const Real& a, const Real& b) const {
    return kernel_.mean_of_strips(a, Real(1), b, Real(1));
  }

 private:
  Cavity<Real> cavity_;
  PanelGrid<Real> grid_;
  StripKernel<Real> kernel_;
  std::vector<Real> from_apex_;
  SquareMatrix<Real> matrix_;
  SquareMatrix<Real> squared_;
};

}  // namespace vcavity
