// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Matte panels of unequal slope: sawtooth ridges whose panels reflect by Lambert's law.
///
/// Method. Where the panels are not of one length the integral equation has no closed form that we know of. It is solved
/// on the places of `PanelGrid`, those of the longer panel being dense opposite the rim of the shorter one as well, for
/// what the panels absorb, b = 1 − radiosity under unit diffuse light:
///
///     b_one = 1 − ρ_one + ρ_one ∫ K b_two dt,   and the same with the panels exchanged.
///
/// With V the share of the light of a place that passes the other panel, the bi-hemispherical reflectance is 1 less the
/// mean of V b over the panels, and that of a direction 1 less the mean of b over what it sees (Helmholtz). Light that
/// has crossed the groove once is in closed form (Hottel's crossed strings), what comes after it is what K spreads
/// smoothly.
///
/// Errors are estimated from the balance of energy, from what the equation says at the rims, and from how well the
/// polynomials meet. From a degree on those of reflectances are some 1e-13 in double and long double, 1e-5 in float; the
/// BRDF between strips of a narrow groove, which nearly white panels send to and fro, is less exact, as
/// `brdf_error` tells.
///
/// When not to use it: for equal panels `LambertianCavity` is exact and faster. Each wavelength costs the solution of a
/// system of 200 to 800 equations.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "vcavity/groove/asymmetric_groove.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/matte/lambertian_cavity.hpp"
#include "vcavity/matte/panel_grid.hpp"
#include "vcavity/matte/strip_kernel.hpp"
#include "vcavity/numbers/linear_system.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity {

/// What the shape alone determines of a groove with matte panels of unequal slope, to be shared by all wavelengths. Lengths
/// are in those of the longer panel.
template <class Real>
class AsymmetricLambertianGeometry {
 public:
  explicit AsymmetricLambertianGeometry(const AsymmetricGroove<Real>& groove)
      : groove_(groove),
        kernel_(groove.bisected()),
        lengths_(relative_lengths(groove)),
        opening_(groove.opening() / std::max(groove.length(Panel::one), groove.length(Panel::two))),
        grids_{PanelGrid<Real>(groove.aperture(), Real(log_ratio(1))),
               PanelGrid<Real>(groove.aperture(), Real(log_ratio(0)))},
        matrix_(grids_[0].x().size() + grids_[1].x().size()) {
    const std::size_t n = grids_[0].x().size();
    kernel_.fill_block(matrix_, 0, grids_[0], n, grids_[1], log_ratio(0));
    kernel_.fill_block(matrix_, n, grids_[1], 0, grids_[0], log_ratio(1));
    for (const std::size_t panel : {0u, 1u}) {
      const std::size_t other = 1 - panel;
      for (const Real& s : grids_[panel].positions()) {
        const Real place = s * lengths_[panel];
        from_apex_[panel].push_back(kernel_.below(place, Real(grids_[other].apex_width() * lengths_[other])));
        passing_[panel].push_back(kernel_.passing(place, lengths_[other]));
      }
    }
  }

  const AsymmetricGroove<Real>& groove() const { return groove_; }
  const StripKernel<Real>& kernel() const { return kernel_; }
  const Real& length(std::size_t panel) const { return lengths_[panel]; }
  const Real& opening() const { return opening_; }
  const PanelGrid<Real>& grid(std::size_t panel) const { return grids_[panel]; }

  /// The matrix of f ↦ ∫ K(s, t) f(t) dt; the nodes of panel one come first.
  const SquareMatrix<Real>& matrix() const { return matrix_; }

  /// What the apex region of the other panel, at radiosity 1, sends to the nodes of this one.
  const std::vector<Real>& from_apex(std::size_t panel) const { return from_apex_[panel]; }

  /// The share of the light of each node that passes the other panel.
  const std::vector<Real>& passing(std::size_t panel) const { return passing_[panel]; }

 private:
  static std::array<Real, 2> relative_lengths(const AsymmetricGroove<Real>& groove) {
    const Real& one = groove.length(Panel::one);
    const Real& two = groove.length(Panel::two);
    const Real longer = std::max(one, two);
    return {one / longer, two / longer};
  }

  /// ln of the length of the other panel over that of this one.
  Real log_ratio(std::size_t panel) const {
    using std::log;
    return log(lengths_[1 - panel] / lengths_[panel]);
  }

  AsymmetricGroove<Real> groove_;
  StripKernel<Real> kernel_;
  std::array<Real, 2> lengths_;
  Real opening_;
  std::array<PanelGrid<Real>, 2> grids_;
  SquareMatrix<Real> matrix_;
  std::array<std::vector<Real>, 2> from_apex_;
  std::array<std::vector<Real>, 2> passing_;
};

namespace detail {

/// Where the light of a direction first meets panels of unequal slope.
template <class Real>
struct AsymmetricFootprint {
  std::array<Real, 2> share;   ///< of the light that meets the panel
  std::array<Real, 2> length;  ///< the part that is lit, from the rim on, over the length of the panel

  /// @param e unit vector away from the surface, e.z ≥ 0
  AsymmetricFootprint(const AsymmetricLambertianGeometry<Real>& geometry, const Vec3<Real>& e) {
    const Cavity<Real>& bisected = geometry.groove().bisected();
    const auto onto_panels = [&](const Vec3<Real>& v) {
      const Vec3<Real> turned = geometry.groove().to_bisector(v);
      const Real across = turned.y * bisected.cos_half();
      const Real along = turned.z * bisected.sin_half();
      return std::array<Real, 2>{geometry.length(0) * (along + across),
                                 geometry.length(1) * (along - across)};
    };
    std::array<Real, 2> onto = onto_panels(e);
    // Light along the groove counts as what it is the limit of, light from above.
    if (!(std::max(onto[0], onto[1]) > Real(0))) onto = onto_panels({Real(0), Real(0), Real(1)});
    length = {Real(1), Real(1)};
    for (const std::size_t panel : {0u, 1u})
      if (onto[1 - panel] < Real(0)) {
        share[panel] = Real(1);
        share[1 - panel] = Real(0);
        length[panel] = std::min(Real(geometry.opening() * e.z / onto[panel]), Real(1));
        return;
      }
    share[0] = onto[0] / (onto[0] + onto[1]);
    share[1] = onto[1] / (onto[0] + onto[1]);
  }
};

/// Values at the nodes of both panels, and at the apex.
template <class Real>
struct OnPanels {
  std::array<std::vector<Real>, 2> at;
  std::array<Real, 2> at_apex;
};

/// Interreflection between panels of unequal length at one wavelength.
template <class Real>
class UnequalPanels {
 public:
  using Geometry = AsymmetricLambertianGeometry<Real>;
  using Footprint = AsymmetricFootprint<Real>;

  UnequalPanels(const Geometry& geometry, const Real& albedo_one, const Real& albedo_two)
      : albedos_{albedo_one, albedo_two},
        factors_(system(geometry)),
        absorbed_(solution(geometry, evenly_absorbed(geometry))),
        functions_{PanelFunction<Real>(geometry.grid(0), absorbed_.at[0], absorbed_.at_apex[0]),
                   PanelFunction<Real>(geometry.grid(1), absorbed_.at[1], absorbed_.at_apex[1])} {
    using std::abs;
    std::array<Real, 2> all, out;  // ∫ b ds and ∫ V b ds
    for (const std::size_t panel : {0u, 1u}) {
      all[panel] = geometry.length(panel) * functions_[panel].mean();
      out[panel] = passing_sum(geometry, panel, absorbed_);
    }
    Real error(0), jump(0);
    for (const std::size_t panel : {0u, 1u}) {
      const std::size_t other = 1 - panel;
      // The equation, integrated over the panel with the exact integral of K.
      const Real balance =
          (Real(1) - albedos_[panel]) * geometry.length(panel) + albedos_[panel] * (all[other] - out[other]);
      const Real at_rim = Real(1) - albedos_[panel] + albedos_[panel] * crossed_to_rim(geometry, panel);
      const Real found = functions_[panel].at(Real(1));
      error =
          std::max({error, Real(abs(balance - all[panel]) / geometry.opening()), Real(abs(at_rim - found))});
      jump = std::max(jump, functions_[panel].largest_jump());
    }
    // Diffuse light needs the nodes alone, single directions what the polynomials say between them.
    error_ = safety() * (std::max(error, jump) + rounding());
    bihemispherical_ = {(out[0] + out[1]) / geometry.opening(), safety() * (error + rounding()), nodes()};
  }

  /// The share that a panel absorbs at a place, 1 − radiosity under unit diffuse light.
  /// @param s distance from the apex over the length of the panel
  Real absorbed(Panel panel, const Real& s) const { return functions_[panel == Panel::one ? 0 : 1].at(s); }

  /// 1 − bi-hemispherical reflectance.
  const Integral<Real>& bihemispherical_absorptance() const { return bihemispherical_; }

  /// 1 − reflectance for light on a footprint.
  Integral<Real> absorptance(const Footprint& light) const {
    Real sum(0);
    for (const std::size_t panel : {0u, 1u})
      if (light.share[panel] > Real(0))
        sum += light.share[panel] * functions_[panel].mean(light.length[panel]);
    return {sum, error_, nodes()};
  }

  /// The BRDF.
  Integral<Real> brdf(const Geometry& geometry, const Footprint& light, const Footprint& viewer) const {
    const StripKernel<Real>& kernel = geometry.kernel();
    // Light that has not crossed the groove, and light that has once.
    Real sum(0);
    for (const std::size_t panel : {0u, 1u}) {
      const std::size_t other = 1 - panel;
      const Real share = albedos_[panel] * light.share[panel];
      if (share * viewer.share[panel] > Real(0))
        sum += share * viewer.share[panel] /
               (geometry.length(panel) * std::max(light.length[panel], viewer.length[panel]));
      if (share * albedos_[other] * viewer.share[other] > Real(0))
        sum += share * albedos_[other] * viewer.share[other] *
               kernel.mean_of_strips(start(geometry, panel, light), geometry.length(panel),
                                     start(geometry, other, viewer), geometry.length(other));
    }
    const OnPanels<Real> received = after_one_crossing(geometry, light);
    const OnPanels<Real> seen = after_one_crossing(geometry, viewer);
    const OnPanels<Real> bright = solution(geometry, reflected_by_panels(received));
    for (const std::size_t panel : {0u, 1u}) {
      const PanelGrid<Real>& grid = geometry.grid(panel);
      Real on_panel = grid.apex_width() * seen.at_apex[panel] * bright.at_apex[panel];
      for (std::size_t i = 0; i < grid.x().size(); ++i)
        on_panel += grid.weights()[i] * seen.at[panel][i] * bright.at[panel][i];
      sum += geometry.length(panel) * on_panel;
    }
    const Real scale = geometry.opening() / pi<Real>();
    const OnPanels<Real> from_viewer = solution(geometry, reflected_by_panels(seen));
    const Real error = error_of_light(geometry, light, bright, seen) +
                       error_of_light(geometry, viewer, from_viewer, received);
    return {scale * sum, scale * (safety() * error + error_ * sum), nodes()};
  }

 private:
  static Real rounding() { return Real(64) * std::numeric_limits<Real>::epsilon(); }

  /// Errors of parts of a panel that were measured are less than this multiple of that of the whole.
  static Real safety() { return Real(8); }

  long long nodes() const { return static_cast<long long>(absorbed_.at[0].size() + absorbed_.at[1].size()); }

  /// Where the part of a panel that is lit or seen begins.
  static Real start(const Geometry& geometry, std::size_t panel, const Footprint& footprint) {
    return geometry.length(panel) * (Real(1) - footprint.length[panel]);
  }

  /// f ↦ f − ρ ∫ K f dt.
  SquareMatrix<Real> system(const Geometry& geometry) const {
    const std::size_t first = geometry.grid(0).x().size();
    SquareMatrix<Real> result(geometry.matrix().size());
    for (std::size_t i = 0; i < result.size(); ++i)
      for (std::size_t j = 0; j < result.size(); ++j)
        result[i][j] = (i == j ? Real(1) : Real(0)) - albedos_[i < first ? 0 : 1] * geometry.matrix()[i][j];
    return result;
  }

  /// What the panels take of light of which each place receives as much.
  OnPanels<Real> evenly_absorbed(const Geometry& geometry) const {
    OnPanels<Real> result;
    for (const std::size_t panel : {0u, 1u}) {
      result.at_apex[panel] = Real(1) - albedos_[panel];
      result.at[panel].assign(geometry.grid(panel).x().size(), result.at_apex[panel]);
    }
    return result;
  }

  /// f = source + ρ ∫ K f dt.
  OnPanels<Real> solution(const Geometry& geometry, const OnPanels<Real>& source) const {
    const Real cos_half = geometry.groove().bisected().cos_half();
    const Real to_apex = cos_half * cos_half;
    OnPanels<Real> result;
    for (const std::size_t panel : {0u, 1u})
      result.at_apex[panel] =
          (source.at_apex[panel] + albedos_[panel] * to_apex * source.at_apex[1 - panel]) /
          (Real(1) - albedos_[0] * albedos_[1] * to_apex * to_apex);
    std::vector<Real> right;
    for (const std::size_t panel : {0u, 1u})
      for (std::size_t i = 0; i < source.at[panel].size(); ++i)
        right.push_back(source.at[panel][i] +
                        albedos_[panel] * result.at_apex[1 - panel] * geometry.from_apex(panel)[i]);
    const std::vector<Real> found = factors_.solve(std::move(right));
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(source.at[0].size());
    result.at = {std::vector<Real>(found.begin(), middle), std::vector<Real>(middle, found.end())};
    return result;
  }

  OnPanels<Real> reflected_by_panels(OnPanels<Real> light) const {
    for (const std::size_t panel : {0u, 1u}) {
      light.at_apex[panel] *= albedos_[panel];
      for (Real& value : light.at[panel]) value *= albedos_[panel];
    }
    return light;
  }

  /// What the places of the panels receive of the light that a footprint of unit flux has sent across the groove.
  OnPanels<Real> after_one_crossing(const Geometry& geometry, const Footprint& light) const {
    OnPanels<Real> result;
    for (const std::size_t panel : {0u, 1u}) {
      const std::size_t other = 1 - panel;
      const Real share = albedos_[other] * light.share[other];
      const Real from = start(geometry, other, light);
      const auto received = [&](const Real& s) {
        return share > Real(0) ? Real(share * geometry.kernel().mean(s, from, geometry.length(other)))
                               : Real(0);
      };
      const PanelGrid<Real>& grid = geometry.grid(panel);
      for (const Real& s : grid.positions())
        result.at[panel].push_back(received(Real(s * geometry.length(panel))));
      result.at_apex[panel] = received(Real(grid.apex_width() * geometry.length(panel)));
    }
    return result;
  }

  /// ∫ V f ds over a panel: what of the light that leaves it passes the other one.
  static Real passing_sum(const Geometry& geometry, std::size_t panel, const OnPanels<Real>& light) {
    const PanelGrid<Real>& grid = geometry.grid(panel);
    Real sum = grid.apex_width() * geometry.kernel().passing(Real(0), geometry.length(1 - panel)) *
               light.at_apex[panel];
    for (std::size_t i = 0; i < grid.x().size(); ++i)
      sum += grid.weights()[i] * geometry.passing(panel)[i] * light.at[panel][i];
    return geometry.length(panel) * sum;
  }

  /// ∫ K b dt at the rim of a panel, from the nodes of the other.
  Real crossed_to_rim(const Geometry& geometry, std::size_t panel) const {
    using std::log;
    const std::size_t other = 1 - panel;
    const PanelGrid<Real>& grid = geometry.grid(other);
    const Real ratio = log(geometry.length(other) / geometry.length(panel));
    Real sum =
        geometry.kernel().below(geometry.length(panel), Real(grid.apex_width() * geometry.length(other))) *
        absorbed_.at_apex[other];
    for (std::size_t i = 0; i < grid.x().size(); ++i)
      sum += grid.weights()[i] / grid.positions()[i] *
             geometry.kernel().per_logarithm(Real(ratio - grid.x()[i])) * absorbed_.at[other][i];
    return sum;
  }

  /// What may be wrong with light from a footprint that has crossed the groove twice or more, where a viewer sees it. A
  /// strip is more easily missed than the panel.
  Real error_of_light(const Geometry& geometry, const Footprint& light, const OnPanels<Real>& bright,
                      const OnPanels<Real>& seen) const {
    Real error = Real(4) * imbalance(geometry, light, bright);
    for (const std::size_t panel : {0u, 1u}) {
      const PanelFunction<Real> found(geometry.grid(panel), bright.at[panel], bright.at_apex[panel]);
      const PanelFunction<Real> weight(geometry.grid(panel), seen.at[panel], seen.at_apex[panel]);
      error += safety() * found.largest_jump() * geometry.length(panel) * weight.mean();
    }
    return error;
  }

  /// What is wrong with the balance of light from a footprint that has crossed the groove twice or more: what leaves the
  /// groove of it is, by Helmholtz, in what the footprint has of diffuse light that has crossed as often.
  Real imbalance(const Geometry& geometry, const Footprint& light, const OnPanels<Real>& bright) const {
    using std::abs;
    Real expected(0);
    for (const std::size_t panel : {0u, 1u})
      if (light.share[panel] > Real(0))
        expected += light.share[panel] * (Real(1) - functions_[panel].mean(light.length[panel]) -
                                          albedos_[panel] * mean_passing(geometry, panel, light));
    return abs(passing_sum(geometry, 0, bright) + passing_sum(geometry, 1, bright) - expected);
  }

  /// The mean of V over the part of a panel that is lit.
  static Real mean_passing(const Geometry& geometry, std::size_t panel, const Footprint& light) {
    const StripKernel<Real>& kernel = geometry.kernel();
    const Real& rim = geometry.length(panel);
    const Real& other_rim = geometry.length(1 - panel);
    const Real from = start(geometry, panel, light);
    return (Real(1) + (rim + from - Real(2) * other_rim * kernel.cosine()) /
                          (kernel.distance(rim, other_rim) + kernel.distance(from, other_rim))) /
           Real(2);
  }

  std::array<Real, 2> albedos_;
  LuFactors<Real> factors_;
  OnPanels<Real> absorbed_;  // b
  std::array<PanelFunction<Real>, 2> functions_;
  Real error_;
  Integral<Real> bihemispherical_;
};

}  // namespace detail

/// A V-groove with panels of different slope, infinitely long, whose panels reflect by Lambert's law.
/// @tparam Real number type of the geometry
/// @tparam Value of an albedo and a reflectance: a number, a `glm::vec` of colours, a `Pack` of wavelengths
template <class Real, class Value = Real>
class AsymmetricLambertianCavity {
 public:
  /// @param groove its shape
  /// @param albedo_one,albedo_two ρ of panels one (y < 0) and two, in [0, 1]
  /// @throws std::invalid_argument when a component of an albedo is out of range
  AsymmetricLambertianCavity(const AsymmetricGroove<Real>& groove, const Value& albedo_one,
                             const Value& albedo_two)
      : AsymmetricLambertianCavity(std::make_shared<const AsymmetricLambertianGeometry<Real>>(groove),
                                   albedo_one, albedo_two) {}

  /// The same for another albedo or wavelength: the geometry is not computed again.
  /// @param geometry not null
  /// @param albedo_one,albedo_two ρ of panels one and two, in [0, 1]
  AsymmetricLambertianCavity(std::shared_ptr<const AsymmetricLambertianGeometry<Real>> geometry,
                             const Value& albedo_one, const Value& albedo_two)
      : geometry_(std::move(geometry)) {
    detail::check_albedo(albedo_one);
    detail::check_albedo(albedo_two);
    for (std::size_t i = 0; i < component_count(albedo_one); ++i)
      panels_.emplace_back(*geometry_, Real(component(albedo_one, i)), Real(component(albedo_two, i)));
  }

  const AsymmetricGroove<Real>& groove() const { return geometry_->groove(); }
  const std::shared_ptr<const AsymmetricLambertianGeometry<Real>>& geometry() const { return geometry_; }

  /// Diffuse light in, all reflected light out.
  Value bihemispherical_reflectance() const {
    return value_of_components<Value>(
        [&](std::size_t i) { return Real(1) - panels_[i].bihemispherical_absorptance().value; });
  }

  /// Estimate of its absolute error, the largest of all components.
  Real bihemispherical_error() const {
    Real error(0);
    for (const auto& panels : panels_) error = std::max(error, panels.bihemispherical_absorptance().error);
    return error;
  }

  /// Directional-hemispherical reflectance for light from `e`; by Helmholtz reciprocity also the
  /// hemispherical-directional one, seen from there in diffuse light.
  /// @param e unit vector away from the surface, e.z ≥ 0
  Value directional_reflectance(const Vec3<Real>& e) const {
    const detail::AsymmetricFootprint<Real> light(*geometry_, e);
    return value_of_components<Value>(
        [&](std::size_t i) { return Real(1) - panels_[i].absorptance(light).value; });
  }

  /// Estimate of the absolute error of `directional_reflectance`, the largest of all components.
  Real directional_error(const Vec3<Real>& e) const {
    const detail::AsymmetricFootprint<Real> light(*geometry_, e);
    Real error(0);
    for (const auto& panels : panels_) error = std::max(error, panels.absorptance(light).error);
    return error;
  }

  /// 1 − directional reflectance, with the digits that it keeps where the albedo is close to 1.
  Value directional_absorptance(const Vec3<Real>& e) const {
    const detail::AsymmetricFootprint<Real> light(*geometry_, e);
    return value_of_components<Value>([&](std::size_t i) { return panels_[i].absorptance(light).value; });
  }

  /// Bidirectional reflectance distribution function, per steradian, symmetric in its arguments; infinite where both
  /// graze the surface from the same side.
  /// @param light,viewer unit vectors away from the surface, z ≥ 0
  Value brdf(const Vec3<Real>& light, const Vec3<Real>& viewer) const {
    const detail::AsymmetricFootprint<Real> in(*geometry_, light), out(*geometry_, viewer);
    return value_of_components<Value>(
        [&](std::size_t i) { return panels_[i].brdf(*geometry_, in, out).value; });
  }

  /// Estimate of the absolute error of `brdf`, the largest of all components.
  Real brdf_error(const Vec3<Real>& light, const Vec3<Real>& viewer) const {
    const detail::AsymmetricFootprint<Real> in(*geometry_, light), out(*geometry_, viewer);
    Real error(0);
    for (const auto& panels : panels_) error = std::max(error, panels.brdf(*geometry_, in, out).error);
    return error;
  }

  /// Radiosity along a panel under diffuse light of unit irradiance on the opening.
  /// @param panel which panel
  /// @param s distance from the apex over the length of that panel, in [0, 1]; 1 is the rim
  Value radiosity(Panel panel, const Real& s) const {
    return value_of_components<Value>([&](std::size_t i) { return Real(1) - panels_[i].absorbed(panel, s); });
  }

 private:
  std::shared_ptr<const AsymmetricLambertianGeometry<Real>> geometry_;
  std::vector<detail::UnequalPanels<Real>> panels_;
};

/// Bi-hemispherical reflectance of a groove with matte panels of unequal slope.
template <class Real, class Value>
Value bihemispherical_reflectance(const AsymmetricLambertianCavity<Real, Value>& cavity) {
  return cavity.bihemispherical_reflectance();
}

/// Directional reflectance R(θ, φ) of a groove with matte panels of unequal slope.
template <class Real, class Value>
Value directional_reflectance(const AsymmetricLambertianCavity<Real, Value>& cavity, const Vec3<Real>& e) {
  return cavity.directional_reflectance(e);
}

}  // namespace vcavity
