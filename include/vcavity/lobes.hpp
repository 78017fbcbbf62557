// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Lobes: where the light of one direction goes.
///
/// Rays of one direction that meet the same panel first and bounce equally often leave in one direction with
/// one throughput. They are a lobe, and a direction has at most four. The weight of a lobe, its fraction of
/// the opening, is known in closed form, so the integral over the position (Eq. 20) needs no quadrature.
///
/// Method. Let f_j be the fraction of the opening whose rays meet a given panel first and bounce at least j
/// times, and t = |e_y|/e_z = |tan θ'|. For directions within the aperture, |θ'| < α/2, light reaches both
/// panels directly and
///
///     f_j = clamp(c_j, 0, c_1) / (2 e_z sin(α/2)),   c_j = e · N^(j);
///
/// beyond, only the panel that faces the light is met first and
///
///     f_j = clamp( sin(jα/2)/sin(α/2) · (cos((j−1)α/2) − t sin((j−1)α/2)), 0, 1 ),
///
/// a product that keeps its digits as e_z → 0. The weight of the lobe of j bounces is f_j − f_{j+1}.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>

#include "bounces.hpp"
#include "cavity.hpp"
#include "turning_vector.hpp"
#include "value.hpp"

namespace vcavity {

/// Pass as the largest number of bounces to follow them all.
inline constexpr int all_bounces = std::numeric_limits<int>::max();

/// Light that leaves the groove in one direction.
template <class Real, class Value>
struct Lobe {
  Panel first_panel;     ///< the panel met first
  int bounces;           ///< number of reflections
  Real weight;           ///< fraction of the opening, (0, 1]; the weights of a direction add up to 1
  Value throughput;      ///< product of the facet reflectances along the way
  Vec3<Real> direction;  ///< direction in which the light travels after its last bounce
};

/// Up to four lobes, without allocation.
template <class Real, class Value>
class Lobes {
 public:
  void push_back(const Lobe<Real, Value>& lobe) {
    assert(size_ < 4);
    lobes_[size_++] = lobe;
  }
  std::size_t size() const { return size_; }
  const Lobe<Real, Value>& operator[](std::size_t i) const { return lobes_[i]; }
  const Lobe<Real, Value>* begin() const { return lobes_.data(); }
  const Lobe<Real, Value>* end() const { return lobes_.data() + size_; }

 private:
  std::array<Lobe<Real, Value>, 4> lobes_;
  std::size_t size_ = 0;
};

/// A fraction of the opening below this is the rounding error of a direction at a change of the bounce count;
/// it is counted with its neighbour.
template <class Real>
Real negligible_fraction() {
  return Real(4) * std::numeric_limits<Real>::epsilon();
}

/// The series f_j of one first panel, advanced in step with its `PanelImages`.
template <class Real>
class ReachedFractions {
 public:
  /// @param e direction towards the light, e.z ≥ 0
  /// @param images at the first bounce
  ReachedFractions(const Cavity<Real>& cavity, const Vec3<Real>& e, const PanelImages<Real>& images)
      : opening_(Real(2) * e.z * cavity.sin_half()),
        sine_(cavity.sin_half()),
        e_z_(e.z),
        fan_(cavity.cos_half(), cavity.sin_half(), cavity.sin_half(), cavity.versine_half()),
        slope_(e.z, largest(e.y), cavity.sin_half(), cavity.versine_half()) {
    const Panel facing = e.y < Real(0) ? Panel::two : Panel::one;
    const bool is_facing = images.panel() == facing;
    const Real other_normal = e.z * cavity.sin_half() - largest(e.y) * cavity.cos_half();
    both_lit_ = other_normal > negligible_fraction<Real>() * opening_;
    const Real beyond_rim = both_lit_ ? Real(other_normal / opening_) : Real(0);
    first_ = is_facing ? Real(Real(1) - beyond_rim) : beyond_rim;
  }

  /// f_1: the fraction of the opening whose rays meet this panel first.
  const Real& first() const { return first_; }

  /// Steps from f_j to f_{j+1}.
  /// @param images at bounce j + 1
  /// @return f_{j+1}
  Real advance(const PanelImages<Real>& images) {
    if (both_lit_) return at_least(at_most(Real(images.normal_component() / opening_), first_), Real(0));
    fan_.turn();
    slope_.turn();
    if (!(slope_.x() > Real(0))) return Real(0);
    return at_most(Real(fan_.y() / sine_ * (slope_.x() / e_z_)), Real(1));
  }

 private:
  Real opening_;  // the width of the opening as the light sees it
  Real sine_;
  Real e_z_;
  bool both_lit_;  // whether light reaches both panels directly
  Real first_;
  TurningVector<Real> fan_;    // cos(jα/2), sin(jα/2)
  TurningVector<Real> slope_;  // e_z cos((j−1)α/2) − |e_y| sin((j−1)α/2), and its companion
};

/// What to do with light of which nothing is left, its throughput being below the smallest normal number.
enum class DarkLight {
  followed,  ///< to its last bounce, though without any more Fresnel evaluations
  merged     ///< into one lobe that ends where the light does
};

/// Calls `visit` with every lobe of a direction; the loop behind `lobes` and `directional_reflectance`.
///
/// A fraction of the opening below `negligible_fraction` is the rounding error of a direction at a change of
/// the bounce count. It is counted with its neighbour, so no such lobe appears.
///
/// @param e direction towards the light, or towards the viewer under diffuse light; e.z ≥ 0
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param most_bounces lobes of more bounces are left out
/// @param visit called as visit(images at the last bounce, weight, throughput)
template <class Real, FacetReflectance<Real> Facet, class Visit>
void for_each_lobe(const Cavity<Real>& cavity, const Vec3<Real>& e, const Facet& facet, int most_bounces,
                   Visit&& visit, DarkLight dark_light = DarkLight::followed) {
  using Value = value_t<Facet, Real>;
  using Scalar = scalar_t<Value>;
  assert(e.z >= Real(0));
  const int most = std::min(most_bounces, cavity.max_bounces());
  if (most < 1) return;

  for (const Panel first : {Panel::one, Panel::two}) {
    PanelImages<Real> images(cavity, e, first);
    ReachedFractions<Real> fractions(cavity, e, images);
    Value throughput(1);
    Real reached = fractions.first();
    while (reached > Real(0)) {
      if (largest(throughput) >= std::numeric_limits<Scalar>::min()) {
        throughput = throughput * reflect(facet, images);
      } else if (dark_light == DarkLight::merged) {
        visit(images, reached, throughput);
        break;
      }
      PanelImages<Real> next_images = images;
      next_images.advance();
      Real next = images.bounce() < cavity.max_bounces() ? fractions.advance(next_images) : Real(0);
      if (next < negligible_fraction<Real>()) next = Real(0);
      if (reached - next < negligible_fraction<Real>())
        next = reached;
      else
        visit(images, Real(reached - next), throughput);
      if (images.bounce() >= most) break;
      reached = next;
      images = next_images;
    }
  }
}

/// The lobes of a direction, at most four.
///
/// @param e direction towards the light, e.z ≥ 0. By reciprocity also the direction towards a viewer of the
/// groove in
///          diffuse light; then `-direction` of a lobe is where its light comes from.
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param most_bounces lobes of more bounces are left out
template <class Real, FacetReflectance<Real> Facet>
Lobes<Real, value_t<Facet, Real>> lobes(const Cavity<Real>& cavity, const Vec3<Real>& e, const Facet& facet,
                                        int most_bounces = all_bounces) {
  using Value = value_t<Facet, Real>;
  Lobes<Real, Value> result;
  for_each_lobe(
      cavity, e, facet, most_bounces,
      [&](const PanelImages<Real>& last, const Real& weight, const Value& throughput) {
        const Panel first = last.bounce() % 2 == 1 ? last.panel() : opposite(last.panel());
        result.push_back({first, last.bounce(), weight, throughput, last.exit_direction(cavity, e)});
      });
  return result;
}

}  // namespace vcavity
