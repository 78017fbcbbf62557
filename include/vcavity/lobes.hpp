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

/// The series f_j of one first panel, advanced in step with its `PanelImages`.
template <class Real>
class ReachedFractions {
 public:
  /// @param e direction towards the light, e.z ≥ 0
  /// @param images at the first bounce
  ReachedFractions(const Cavity<Real>& cavity, const Vec3<Real>& e, const PanelImages<Real>& images)
      : sine_(cavity.sin_half()),
        cosine_(cavity.cos_half()),
        e_z_(e.z),
        first_normal_(images.normal_component()) {
    const Real across = largest(e.y);
    const Panel facing = e.y < Real(0) ? Panel::two : Panel::one;
    if (across * cosine_ < e_z_ * sine_) {
      lit_ = Lit::both_panels;
    } else {
      lit_ = images.panel() == facing ? Lit::this_panel : Lit::other_panel;
      fan_ = {cosine_, sine_};
      slope_ = {e_z_, across};
    }
  }

  /// f_1: the fraction of the opening whose rays meet this panel first.
  Real first() const {
    switch (lit_) {
      case Lit::both_panels:
        return first_normal_ / (Real(2) * e_z_ * sine_);
      case Lit::this_panel:
        return Real(1);
      default:
        return Real(0);
    }
  }

  /// Steps from f_j to f_{j+1}.
  /// @param images at bounce j + 1
  /// @return f_{j+1}
  Real advance(const PanelImages<Real>& images) {
    if (lit_ == Lit::both_panels)
      return at_least(at_most(images.normal_component(), first_normal_), Real(0)) / (Real(2) * e_z_ * sine_);
    fan_ = rotated(fan_);
    slope_ = rotated(slope_);
    if (!(slope_.x > Real(0))) return Real(0);
    return at_most(Real(fan_.y / sine_ * (slope_.x / e_z_)), Real(1));
  }

 private:
  /// Which panels light reaches directly.
  enum class Lit { both_panels, this_panel, other_panel };

  /// A vector turned by α/2.
  Vec2<Real> rotated(const Vec2<Real>& v) const {
    return {v.x * cosine_ - v.y * sine_, v.y * cosine_ + v.x * sine_};
  }

  Real sine_;
  Real cosine_;
  Real e_z_;
  Real first_normal_;
  Lit lit_;
  Vec2<Real> fan_{};    // cos(jα/2), sin(jα/2)
  Vec2<Real> slope_{};  // e_z cos((j−1)α/2) − |e_y| sin((j−1)α/2), and its companion
};

/// Calls `visit` with every lobe of a direction; the loop behind `lobes` and `directional_reflectance`.
///
/// A fraction of the opening smaller than 4 ε is the rounding error of a direction at a change of the bounce
/// count. It is counted with its neighbour, so no such lobe appears.
///
/// @param e direction towards the light, or towards the viewer under diffuse light; e.z ≥ 0
/// @param facet facet reflectance, a function of the cosine of the angle of incidence
/// @param most_bounces lobes of more bounces are left out
/// @param visit called as visit(images at the last bounce, weight, throughput)
template <class Real, FacetReflectance<Real> Facet, class Visit>
void for_each_lobe(const Cavity<Real>& cavity, const Vec3<Real>& e, const Facet& facet, int most_bounces,
                   Visit&& visit) {
  using Value = value_t<Facet, Real>;
  using Scalar = scalar_t<Value>;
  assert(e.z >= Real(0));
  const Real rounding = Real(4) * std::numeric_limits<Real>::epsilon();
  const int most = std::min(most_bounces, cavity.max_bounces());

  for (const Panel first : {Panel::one, Panel::two}) {
    PanelImages<Real> images(cavity, e, first);
    ReachedFractions<Real> fractions(cavity, e, images);
    Value throughput(1);
    Real reached = fractions.first();
    if (reached < rounding) continue;
    for (;;) {
      // Once nothing is left, counting on costs no more Fresnel evaluations.
      if (largest(throughput) >= std::numeric_limits<Scalar>::min())
        throughput = throughput * reflect(facet, images);
      PanelImages<Real> next_images = images;
      next_images.advance();
      Real next = images.bounce() < cavity.max_bounces() ? fractions.advance(next_images) : Real(0);
      if (next < rounding) next = Real(0);
      if (reached - next < rounding)
        next = reached;
      else
        visit(images, Real(reached - next), throughput);
      if (!(next > Real(0)) || images.bounce() >= most) break;
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
