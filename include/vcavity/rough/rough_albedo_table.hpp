// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A table of the directional albedo of a rough surface, for renderers and maps that ask for it again and again.
///
/// Method. Nodes at equal steps of √cos θ, which crowd where the facets begin to reflect more, and of the azimuth;
/// cubic Lagrange interpolation between them. A distribution that is found isotropic needs one azimuth only. The
/// albedo is the same on opposite sides of the surface, so azimuths go over half a turn.
///
/// When not to use it: where errors of 1e-3 matter; `directional_albedo` has an error estimate.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcavity/rough/elliptic_slopes.hpp"
#include "vcavity/rough/rough_albedo.hpp"

namespace vcavity {

template <class Value>
class RoughAlbedoTable {
 public:
  using Real = scalar_t<Value>;

  /// @param distribution of the grooves
  /// @param facet facet reflectance
  /// @param tolerance absolute error of a node to aim at, > 0; interpolation adds to it
  /// @param max_bounces light that needs more bounces is lost
  /// @throws std::invalid_argument when the tolerance is not a positive number
  template <SlopeDistribution Distribution, FacetReflectance<scalar_t<Distribution>> Facet>
  RoughAlbedoTable(const Distribution& distribution, const Facet& facet, const Real& tolerance,
                   int max_bounces = all_bounces) {
    const auto albedo = [&](const Real& height, const Real& azimuth) {
      using std::cos;
      using std::sin;
      using std::sqrt;
      const Real across = sqrt(at_least(Real(Real(1) - height * height), Real(0)));
      return directional_albedo(distribution,
                                Vec3<Real>{across * Real(sin(azimuth)), across * Real(cos(azimuth)), height},
                                facet, tolerance, max_bounces)
          .value;
    };
    columns_ = looks_isotropic(distribution) ? 1 : most_columns;
    for (std::size_t column = 0; column < columns_; ++column)
      for (std::size_t row = 0; row < rows; ++row) {
        const Real root = Real(static_cast<int>(row)) / Real(static_cast<int>(rows - 1));
        values_.push_back(albedo(
            root * root, pi<Real>() * Real(static_cast<int>(column)) / Real(static_cast<int>(columns_))));
      }
  }

  /// The albedo.
  /// @param e unit vector away from the surface, e.z ≥ 0
  Value operator()(const Vec3<Real>& e) const {
    using std::atan2;
    using std::sqrt;
    const Cubic along(Real(static_cast<int>(rows - 1)) * Real(sqrt(at_most(at_least(e.z, Real(0)), Real(1)))),
                      rows);
    if (columns_ == 1) return column_value(0, along);
    Real turn = atan2(e.x, e.y) / pi<Real>();
    if (turn < Real(0)) turn += Real(1);
    const Real position = turn * Real(static_cast<int>(columns_));
    const auto before = static_cast<std::size_t>(position);
    const auto weights = Cubic::weights(position - Real(static_cast<int>(before)) + Real(1));
    Value sum(0);
    for (std::size_t i = 0; i < 4; ++i)
      sum = sum + scaled(weights[i], column_value((before + columns_ + i - 1) % columns_, along));
    return sum;
  }

 private:
  static constexpr std::size_t rows = 17;
  static constexpr std::size_t most_columns = 12;

  /// Four nodes of a row of them, and their weights.
  struct Cubic {
    std::size_t first;
    std::array<Real, 4> weight;

    Cubic(const Real& position, std::size_t nodes) {
      auto before = static_cast<std::size_t>(position);
      before = before < 1 ? 1 : before > nodes - 3 ? nodes - 3 : before;
      first = before - 1;
      weight = weights(position - Real(static_cast<int>(first)));
    }

    /// @param x where, with the nodes at 0, 1, 2 and 3
    static std::array<Real, 4> weights(const Real& x) {
      const Real a = x, b = x - Real(1), c = x - Real(2), d = x - Real(3);
      return {-b * c * d / Real(6), a * c * d / Real(2), -a * b * d / Real(2), a * b * c / Real(6)};
    }
  };

  /// Whether facets of one slope are equally frequent at some azimuths.
  template <class Distribution>
  static bool looks_isotropic(const Distribution& distribution) {
    const auto density = [&](const Real& x, const Real& y) {
      return distribution.density(detail::unit_vector(x, y, Real(1)));
    };
    for (const Real& slope : {Real(0.05), Real(0.3), Real(1)}) {
      const Real along = density(slope, Real(0));
      const Real close = Real(1e-3) * along;
      if (largest(Real(density(Real(0), slope) - along)) > close) return false;
      const Real both = slope * Real(0.6), rest = slope * Real(0.8);
      if (largest(Real(density(both, rest) - along)) > close) return false;
    }
    return true;
  }

  Value column_value(std::size_t column, const Cubic& along) const {
    Value sum(0);
    for (std::size_t i = 0; i < 4; ++i)
      sum = sum + scaled(along.weight[i], values_[column * rows + along.first + i]);
    return sum;
  }

  std::size_t columns_;
  std::vector<Value> values_;  // a column for each azimuth
};

}  // namespace vcavity
