// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A V-groove with matte panels: each reflects the share ρ, its albedo, of the light that falls on it, equally bright
/// from all sides (Lambert).
///
/// Light within the aperture, |θ'| ≤ α/2, reaches all of both panels, and the result is in closed form: the reflectance
/// is 1 − (1−ρ)H², the same from all such directions, with H(α, ρ) of `InterreflectionKernel`; so are the BRDF of two
/// such directions and the bi-hemispherical reflectance. Beyond the aperture a part of one panel alone is lit or seen,
/// from s₀ = sin(|θ'| − α/2)/sin(|θ'| + α/2) to the rim, and one quadrature remains, that of `PanelExchange`; its error
/// is measured against H.
///
/// With G(s) the radiosity that constant light gains by interreflection, G = 1 + ρ∫KG dt, unit diffuse light makes the
/// panels as bright as 1 − (1−ρ)G; the reflectance of a direction is the mean of that over the part that it sees
/// (Helmholtz). Panels of different albedo: what has crossed the groove an even number of times is on the panel where
/// it started, the rest on the other.
///
/// When not to use it: for a matte base under a smooth interface (paint, glazed ceramic, plastic). The interface
/// reflects like a mirror, differently at every angle, and keeps light inside; none of this is in the model. For matte
/// panels with a constant specular part see lambertian_specular.hpp. Apertures down to 1e-5 have been tried.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "vcavity/conventions.hpp"
#include "vcavity/hemisphere/integral.hpp"
#include "vcavity/matte/interreflection_kernel.hpp"
#include "vcavity/matte/panel_exchange.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity {

namespace detail {

/// @throws std::invalid_argument unless all components of an albedo are in [0, 1]
template <class Value>
void check_albedo(const Value& albedo) {
  for (std::size_t i = 0; i < component_count(albedo); ++i) {
    const auto& rho = component(albedo, i);
    if (rho >= scalar_t<Value>(0) && rho <= scalar_t<Value>(1)) continue;
    throw_invalid_argument("the albedo of a matte panel must lie in [0, 1], not ", rho);
  }
}

/// Where the light of a direction first meets the panels.
template <class Real>
struct Footprint {
  Real on_one;  ///< the share that meets panel one
  Real on_two;
  Real start;          ///< s₀: it is spread evenly over [s₀, 1]
  Real length;         ///< 1 − s₀, with all its digits
  bool on_all = true;  ///< whether the direction is within the aperture

  /// @param e direction towards the light or the viewer, e.z ≥ 0
  Footprint(const Cavity<Real>& cavity, const Vec3<Real>& e) {
    using std::abs;
    const Real across = abs(e.y) * cavity.cos_half();
    const Real along = at_least(e.z, cavity.least_up()) * cavity.sin_half();  // so inverse lengths are finite
    if (across <= along) {
      const Real tilt = e.y * cavity.cos_half() / along;
      on_one = (Real(1) + tilt) / Real(2);
      on_two = (Real(1) - tilt) / Real(2);
      start = Real(0);
      length = Real(1);
      return;
    }
    on_all = false;
    on_one = e.y > Real(0) ? Real(1) : Real(0);
    on_two = Real(1) - on_one;
    length = Real(2) * along / (across + along);
    start = Real(1) - length;
  }
};

/// A function of the place on a panel, given by polynomials in x = −ln s on the panels of `PanelGrid` and constant
/// below its last one.
template <class Real>
class PanelFunction {
 public:
  PanelFunction(const PanelGrid<Real>& grid, const std::vector<Real>& values, const Real& at_apex)
      : breaks_(grid.breaks()), at_apex_(at_apex), apex_width_(grid.apex_width()) {
    // f ds = f e^{−x} dx
    std::vector<Real> densities = values;
    for (std::size_t i = 0; i < densities.size(); ++i) densities[i] *= grid.positions()[i];
    coefficients_ = grid.polynomials(densities);
    Real sum(0);
    for (std::size_t panel = 0; panel + 1 < breaks_.size(); ++panel) {
      before_.push_back(sum);
      for (std::size_t i = 0; i < order; ++i)
        sum += grid.weights()[panel * order + i] * values[panel * order + i];
    }
    before_.push_back(sum);
  }

  /// Its value at the distance s from the apex.
  Real at(const Real& s) const {
    using std::log;
    if (!(s > apex_width_)) return at_apex_;
    const Real x = std::max(Real(0), Real(-log(s)));
    const std::size_t panel = panel_of(x);
    const Real y = share_of(panel, x);
    Real sum(0);
    for (std::size_t k = order; k-- > 0;) sum = sum * y + coefficients_[panel * order + k];
    return sum / s;
  }

  /// Its mean from 1 − length to the rim.
  Real mean(const Real& length) const {
    using std::log1p;
    if (!(length > Real(0))) return at(Real(1));
    const Real start = Real(1) - length;
    if (!(start > apex_width_)) return (before_.back() + at_apex_ * (apex_width_ - start)) / length;
    const Real x = -log1p(Real(-length));
    const std::size_t panel = panel_of(x);
    const Real y = share_of(panel, x);
    Real sum(0);
    for (std::size_t k = order; k-- > 0;)
      sum = sum * y + coefficients_[panel * order + k] / Real(static_cast<int>(k) + 1);
    return (before_[panel] + (breaks_[panel + 1] - breaks_[panel]) * y * sum) / length;
  }

  /// The largest difference of two polynomials of f ds/dx where they meet, which says how well they follow it.
  Real largest_jump() const {
    using std::abs;
    Real largest(0);
    for (std::size_t panel = 0; panel + 2 < breaks_.size(); ++panel) {
      Real end(0);
      for (std::size_t k = 0; k < order; ++k) end += coefficients_[panel * order + k];
      largest = std::max(largest, Real(abs(end - coefficients_[(panel + 1) * order])));
    }
    return largest;
  }

  /// Its mean over the whole panel.
  Real mean() const { return before_.back() + at_apex_ * apex_width_; }

 private:
  static constexpr std::size_t order = PanelGrid<Real>::order;

  std::size_t panel_of(const Real& x) const {
    const auto next = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, x);
    return static_cast<std::size_t>(next - breaks_.begin()) - 1;
  }
  Real share_of(std::size_t panel, const Real& x) const {
    return (x - breaks_[panel]) / (breaks_[panel + 1] - breaks_[panel]);
  }

  std::vector<Real> breaks_;
  std::vector<Real> coefficients_;
  std::vector<Real> before_;  // the integral from the rim to the beginning of each panel
  Real at_apex_;
  Real apex_width_;
};

/// 1 − bi-hemispherical reflectance of panels of different albedo.
template <class Real>
Real hemispherical_absorptance(const CrossingGain<Real>& crossings, const Real& sin_half, const Real& one,
                               const Real& two) {
  const Real even = Real(1) + one * two * crossings.twice;
  // What diffuse light would leave behind on panels that it reached evenly, less what the groove keeps from the apex.
  const auto half = [&](const Real& own, const Real& other) {
    return (Real(1) - own) * (even - other * crossings.twice) -
           (Real(1) - other) * (Real(1) - own) * crossings.odd;
  };
  return (half(one, two) + half(two, one)) / (Real(2) * sin_half);
}

/// Interreflection between two panels at one wavelength.
template <class Real>
class PanelInterreflection {
 public:
  PanelInterreflection(const InterreflectionKernel<Real>& kernel, const PanelExchange<Real>& exchange,
                       const Real& albedo_one, const Real& albedo_two)
      : PanelInterreflection(kernel, exchange, albedo_one, albedo_two,
                             light_in_groove(exchange, Real(albedo_one * albedo_two))) {}

  /// The share that a panel absorbs of light that has started evenly on both, at the distance s from the apex; 1 −
  /// radiosity under unit diffuse light.
  Real absorbed(Panel panel, const Real& s) const { return combined(panel, even_.at(s), odd_.at(s)); }

  /// 1 − reflectance for light on a footprint, and the error of the quadrature.
  Integral<Real> absorptance(const Footprint<Real>& light) const {
    if (light.on_all)
      return {light.on_one * combined(Panel::one, mean_even(), crossings_.odd) +
                  light.on_two * combined(Panel::two, mean_even(), crossings_.odd),
              Real(0), 0};
    const Panel lit = light.on_one > Real(0) ? Panel::one : Panel::two;
    return {combined(lit, even_.mean(light.length), odd_.mean(light.length)),
            combined(lit, even_error_, odd_error_), nodes_};
  }

  /// What light and viewer that both see a strip of a panel exchange beyond the first crossing, for all pairs of strips
  /// that begin at the `starts`: ρ₁ρ₂ times the mean radiosity after two or more, even and odd, numbers of crossings.
  void exchange_strips(const PanelExchange<Real>& exchange, const std::vector<Real>& starts,
                       std::vector<Real>& even, std::vector<Real>& odd) const {
    const std::size_t n = exchange.grid().positions().size();
    std::vector<std::vector<Real>> kernels;
    for (const Real& start : starts) kernels.push_back(after_one_crossing(exchange, start));
    for (const std::vector<Real>& kernel : kernels) {
      const std::vector<Real> once = factors_.solve(kernel);
      const std::vector<Real> twice = exchange.matrix() * once;
      for (const std::vector<Real>& viewer : kernels) {
        Real even_sum(0), odd_sum(0);
        for (std::size_t i = 0; i < n; ++i) {
          even_sum += exchange.grid().weights()[i] * viewer[i] * once[i];
          odd_sum += exchange.grid().weights()[i] * viewer[i] * twice[i];
        }
        even.push_back(product_ * even_sum);
        odd.push_back(product_ * odd_sum);
      }
    }
  }

  /// π/(2 sin(α/2)) times the BRDF, and its error.
  Integral<Real> exchanged(const PanelExchange<Real>& exchange, const Footprint<Real>& light,
                           const Footprint<Real>& viewer) const {
    const bool closed = light.on_all && viewer.on_all;
    Means means{mean_even(), crossings_.odd, Real(0), Real(0)};
    if (!light.on_all && !viewer.on_all) {
      means = means_of_strips(exchange, light, viewer);
    } else if (!closed) {
      const Real& length = light.on_all ? viewer.length : light.length;
      means = {even_.mean(length), odd_.mean(length), even_error_, odd_error_};
    }
    const Real same = one_ * light.on_one * viewer.on_one + two_ * light.on_two * viewer.on_two;
    const Real other = product_ * (light.on_one * viewer.on_two + light.on_two * viewer.on_one);
    return {same * means.even + other * means.odd, same * means.even_error + other * means.odd_error,
            closed ? 0 : nodes_};
  }

 private:
  /// Radiosity at the nodes after even and odd numbers of crossings, of light that starts evenly.
  struct Light {
    std::vector<Real> even, odd;
    Real even_at_apex, odd_at_apex;
    LuFactors<Real> factors;
  };
  struct Means {
    Real even, odd, even_error, odd_error;
  };

  PanelInterreflection(const InterreflectionKernel<Real>& kernel, const PanelExchange<Real>& exchange,
                       const Real& albedo_one, const Real& albedo_two, Light light)
      : one_(albedo_one),
        two_(albedo_two),
        product_(albedo_one * albedo_two),
        crossings_(kernel.crossings(product_)),
        even_(exchange.grid(), light.even, light.even_at_apex),
        odd_(exchange.grid(), light.odd, light.odd_at_apex),
        factors_(std::move(light.factors)),
        nodes_(static_cast<long long>(light.even.size())) {
    using std::abs;
    // What is wrong with the mean over the panel, or at the rim, may be wrong with a part of it.
    const auto error = [](const PanelFunction<Real>& found, const Real& mean, const Real& at_rim) {
      return safety() * (abs(found.mean() - mean) + abs(found.at(Real(1)) - at_rim) + rounding() * at_rim);
    };
    even_error_ = error(even_, mean_even(), crossings_.even_at_rim);
    odd_error_ = error(odd_, crossings_.odd, crossings_.odd_at_rim);
  }

  static Real rounding() { return Real(64) * std::numeric_limits<Real>::epsilon(); }

  /// Errors of parts of a panel that were measured are less than this multiple of that of the whole.
  static Real safety() { return Real(8); }

  /// E = 1 + p K²E and O = K E.
  static Light light_in_groove(const PanelExchange<Real>& exchange, const Real& product) {
    const std::size_t n = exchange.grid().positions().size();
    SquareMatrix<Real> system(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        system[i][j] = (i == j ? Real(1) : Real(0)) - product * exchange.squared()[i][j];
    const Real cos_half = exchange.cavity().cos_half();
    const Real to_apex = cos_half * cos_half;
    const Real even_at_apex = Real(1) / (Real(1) - product * to_apex * to_apex);
    const Real odd_at_apex = to_apex * even_at_apex;
    const std::vector<Real>& once = exchange.from_apex();
    const std::vector<Real> twice = exchange.matrix() * once;
    std::vector<Real> right(n);
    for (std::size_t i = 0; i < n; ++i)
      right[i] = Real(1) + product * (odd_at_apex * once[i] + even_at_apex * twice[i]);
    LuFactors<Real> factors(std::move(system));
    std::vector<Real> even = factors.solve(std::move(right));
    std::vector<Real> odd = exchange.matrix() * even;
    for (std::size_t i = 0; i < n; ++i) odd[i] += even_at_apex * once[i];
    return {std::move(even), std::move(odd), even_at_apex, odd_at_apex, std::move(factors)};
  }

  Real mean_even() const { return Real(1) + product_ * crossings_.twice; }

  /// What a panel absorbs of light that has started evenly on both.
  Real combined(Panel panel, const Real& even, const Real& odd) const {
    const Real& own = panel == Panel::one ? one_ : two_;
    const Real& other = panel == Panel::one ? two_ : one_;
    return (Real(1) - own) * even + own * (Real(1) - other) * odd;
  }

  /// Light on a strip alone that has crossed the groove an odd number of times, at the nodes.
  struct Strip {
    std::vector<Real> kernel;  // after one crossing
    std::vector<Real> odd;
    Real error;
  };

  static std::vector<Real> after_one_crossing(const PanelExchange<Real>& exchange, const Real& start) {
    std::vector<Real> result;
    for (const Real& s : exchange.grid().positions()) result.push_back(exchange.mean_kernel(s, start));
    return result;
  }

  Strip light_from_strip(const PanelExchange<Real>& exchange, const Footprint<Real>& footprint) const {
    using std::abs;
    std::vector<Real> kernel = after_one_crossing(exchange, footprint.start);
    std::vector<Real> odd = factors_.solve(kernel);
    // Its mean is also that over the strip of light that starts evenly: the kernel is symmetric.
    Real mean(0);
    for (std::size_t i = 0; i < odd.size(); ++i) mean += exchange.grid().weights()[i] * odd[i];
    const Real error = abs(mean - odd_.mean(footprint.length));
    // A strip is more easily missed than the panel: measured errors are up to twelve times as large as this one.
    return {std::move(kernel), std::move(odd), Real(4) * safety() * error + odd_error_};
  }

  /// The means for light and viewer that both see a part of one panel only.
  Means means_of_strips(const PanelExchange<Real>& exchange, const Footprint<Real>& light,
                        const Footprint<Real>& viewer) const {
    const Strip in = light_from_strip(exchange, light);
    const Strip out = light_from_strip(exchange, viewer);
    const std::vector<Real> even = exchange.matrix() * in.odd;
    Real even_sum(0), odd_sum(0);
    for (std::size_t i = 0; i < even.size(); ++i) {
      const Real weight = exchange.grid().weights()[i] * out.kernel[i];
      even_sum += weight * in.odd[i];
      odd_sum += weight * even[i];
    }
    const Real error = product_ * (in.error + out.error);
    return {Real(1) / std::max(light.length, viewer.length) + product_ * even_sum,
            exchange.mean_kernel_of_strips(light.start, viewer.start) + product_ * odd_sum, error, error};
  }

  Real one_, two_, product_;
  CrossingGain<Real> crossings_;
  PanelFunction<Real> even_, odd_;
  LuFactors<Real> factors_;  // of 1 − p K²
  long long nodes_;
  Real even_error_, odd_error_;
};

}  // namespace detail

/// What the aperture alone determines of a matte groove, to be shared by all wavelengths.
template <class Real>
struct LambertianGeometry {
  explicit LambertianGeometry(const Cavity<Real>& cavity) : kernel(cavity), exchange(cavity) {}

  InterreflectionKernel<Real> kernel;
  PanelExchange<Real> exchange;
};

/// Bi-hemispherical reflectance of a groove with matte panels: diffuse light in, all reflected light out. In closed
/// form; nearly all its digits are right, however small the albedo or the aperture.
///
/// @param kernel of the groove; it serves all wavelengths
/// @param albedo ρ in [0, 1]; a number, colours or a `Pack` of wavelengths
/// @throws std::invalid_argument when a component of the albedo is out of range
template <class Real, class Value>
Value bihemispherical_reflectance(const InterreflectionKernel<Real>& kernel, const Value& albedo) {
  detail::check_albedo(albedo);
  return value_of_components<Value>(
      [&](std::size_t i) { return kernel.gain(Real(component(albedo, i))).bihemispherical; });
}

/// The same for panels of different albedos, to an absolute error of some ε/sin(α/2).
/// @param kernel of the aperture
/// @param albedo_one,albedo_two of the two panels, in [0, 1]
template <class Real, class Value>
Value bihemispherical_reflectance(const InterreflectionKernel<Real>& kernel, const Value& albedo_one,
                                  const Value& albedo_two) {
  detail::check_albedo(albedo_one);
  detail::check_albedo(albedo_two);
  return value_of_components<Value>([&](std::size_t i) {
    const Real one(component(albedo_one, i)), two(component(albedo_two, i));
    if (one == two) return kernel.gain(one).bihemispherical;
    return Real(1) - detail::hemispherical_absorptance(kernel.crossings(Real(one * two)),
                                                       kernel.cavity().sin_half(), one, two);
  });
}

/// A symmetrical V-groove, infinitely long, whose panels reflect by Lambert's law.
/// @tparam Real number type of the geometry
/// @tparam Value of an albedo and a reflectance: a number, a `glm::vec` of colours, a `Pack` of wavelengths
template <class Real, class Value = Real>
class LambertianCavity {
 public:
  /// @param cavity the groove
  /// @param albedo ρ of both panels, in [0, 1]
  /// @throws std::invalid_argument when a component of an albedo is out of range
  LambertianCavity(const Cavity<Real>& cavity, const Value& albedo)
      : LambertianCavity(cavity, albedo, albedo) {}

  /// @param cavity the groove
  /// @param albedo_one,albedo_two of panels one (y < 0) and two
  LambertianCavity(const Cavity<Real>& cavity, const Value& albedo_one, const Value& albedo_two)
      : LambertianCavity(std::make_shared<const LambertianGeometry<Real>>(cavity), albedo_one, albedo_two) {}

  /// The same for another albedo or wavelength: the geometry is not computed again.
  /// @param geometry not null
  /// @param albedo_one ρ of panel one, in [0, 1]
  /// @param albedo_two ρ of panel two, in [0, 1]
  LambertianCavity(std::shared_ptr<const LambertianGeometry<Real>> geometry, const Value& albedo_one,
                   const Value& albedo_two)
      : geometry_(std::move(geometry)), albedo_one_(albedo_one), albedo_two_(albedo_two) {
    detail::check_albedo(albedo_one);
    detail::check_albedo(albedo_two);
    bihemispherical_ = vcavity::bihemispherical_reflectance(geometry_->kernel, albedo_one, albedo_two);
    for (std::size_t i = 0; i < component_count(albedo_one); ++i) {
      const Real one(component(albedo_one, i)), two(component(albedo_two, i));
      gains_.push_back(geometry_->kernel.gain(one));
      panels_.emplace_back(geometry_->kernel, geometry_->exchange, one, two);
    }
  }

  const Cavity<Real>& cavity() const { return geometry_->kernel.cavity(); }
  const std::shared_ptr<const LambertianGeometry<Real>>& geometry() const { return geometry_; }
  const Value& albedo(Panel panel) const { return panel == Panel::one ? albedo_one_ : albedo_two_; }

  /// Diffuse light in, all reflected light out.
  Value bihemispherical_reflectance() const { return bihemispherical_; }

  /// Directional-hemispherical reflectance for light from `e`; by Helmholtz reciprocity also the
  /// hemispherical-directional one, seen from there in diffuse light.
  /// @param e unit vector away from the surface, e.z ≥ 0
  Value directional_reflectance(const Vec3<Real>& e) const {
    const detail::Footprint<Real> footprint(cavity(), e);
    return value_of_components<Value>([&](std::size_t i) {
      if (footprint.on_all && component(albedo_one_, i) == component(albedo_two_, i))
        return gains_[i].reflectance;
      return Real(1) - panels_[i].absorptance(footprint).value;
    });
  }

  /// Estimate of the absolute error of `directional_reflectance`, the largest of all components. Within the aperture,
  /// where there is no quadrature, it is 0: only rounding is left.
  Real directional_error(const Vec3<Real>& e) const {
    const detail::Footprint<Real> footprint(cavity(), e);
    Real error(0);
    for (const auto& panels : panels_) error = std::max(error, panels.absorptance(footprint).error);
    return error;
  }

  /// 1 − directional reflectance, with the digits that it keeps where the albedo is close to 1.
  Value directional_absorptance(const Vec3<Real>& e) const {
    const detail::Footprint<Real> footprint(cavity(), e);
    return value_of_components<Value>([&](std::size_t i) { return panels_[i].absorptance(footprint).value; });
  }

  /// Bidirectional reflectance distribution function, per steradian. Symmetric in its arguments. Infinite where both
  /// graze the surface from the same side, as that of any relief.
  /// @param light,viewer unit vectors away from the surface, z ≥ 0
  Value brdf(const Vec3<Real>& light, const Vec3<Real>& viewer) const {
    const detail::Footprint<Real> in(cavity(), light), out(cavity(), viewer);
    const Real scale = Real(2) * cavity().sin_half() / pi<Real>();
    return value_of_components<Value>(
        [&](std::size_t i) { return scale * panels_[i].exchanged(geometry_->exchange, in, out).value; });
  }

  /// Estimate of the absolute error of `brdf`, the largest of all components; 0 where both directions are within the
  /// aperture.
  Real brdf_error(const Vec3<Real>& light, const Vec3<Real>& viewer) const {
    const detail::Footprint<Real> in(cavity(), light), out(cavity(), viewer);
    Real error(0);
    for (const auto& panels : panels_)
      error = std::max(error, panels.exchanged(geometry_->exchange, in, out).error);
    return Real(2) * cavity().sin_half() / pi<Real>() * error;
  }

  /// For renderers, which cannot solve equations for each pair of directions: what two directions beyond the aperture
  /// exchange by two or more crossings, in units of the BRDF π/(2 sin(α/2)), per albedo of the panel that is seen (even)
  /// or of both (odd).
  struct StripExchange {
    std::vector<Value> even, odd;  ///< a row for each length of light, a column for each of the viewer
  };

  /// @param lengths 1 − s₀ of the directions, in [0, 1]
  StripExchange exchange_strips(const std::vector<Real>& lengths) const {
    std::vector<Real> starts;
    for (const Real& length : lengths) starts.push_back(Real(1) - length);
    const std::size_t pairs = lengths.size() * lengths.size();
    StripExchange result{std::vector<Value>(pairs, Value(0)), std::vector<Value>(pairs, Value(0))};
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      std::vector<Real> even, odd;
      panels_[i].exchange_strips(geometry_->exchange, starts, even, odd);
      for (std::size_t pair = 0; pair < pairs; ++pair) {
        component(result.even[pair], i) = static_cast<scalar_t<Value>>(even[pair]);
        component(result.odd[pair], i) = static_cast<scalar_t<Value>>(odd[pair]);
      }
    }
    return result;
  }

  /// Radiosity along a panel under diffuse light of unit irradiance on the opening: what leaves a place in all
  /// directions.
  /// @param s distance from the apex, in [0, 1]; 1 is the rim
  /// @param panel which panel
  Value radiosity(Panel panel, const Real& s) const {
    return value_of_components<Value>([&](std::size_t i) { return Real(1) - panels_[i].absorbed(panel, s); });
  }

 private:
  std::shared_ptr<const LambertianGeometry<Real>> geometry_;
  Value albedo_one_, albedo_two_, bihemispherical_;
  std::vector<InterreflectionGain<Real>> gains_;
  std::vector<detail::PanelInterreflection<Real>> panels_;
};

/// Bi-hemispherical reflectance of a groove with matte panels.
template <class Real, class Value>
const Value& bihemispherical_reflectance(const LambertianCavity<Real, Value>& cavity) {
  return cavity.bihemispherical_reflectance();
}

/// Directional reflectance R(θ, φ) of a groove with matte panels.
template <class Real, class Value>
Value directional_reflectance(const LambertianCavity<Real, Value>& cavity, const Vec3<Real>& e) {
  return cavity.directional_reflectance(e);
}

}  // namespace vcavity
